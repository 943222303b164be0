namespace RayTracer.RenderTests.Analytic;

/// <summary>
/// Where the camera shows things: the part of each pixel that a shining polygon covers, known exactly by similar triangles,
/// averaged over the points of the lens.
/// </summary>
[Trait("Category", "Thorough")]
public class CameraTests
{
    private const int Width = 12;
    private const int Height = 8;
    private static readonly Vec3D s_eye = new(3, 2, 5);
    private static readonly Vec3D s_target = new(0.5, 1, -1);
    private static readonly Vec3D s_up = new(0.2, 1, 0.1);

    [Theory]
    [InlineData("vertical", Width, Height, Height)]
    [InlineData("horizontal", Width, Height, Width)]
    [InlineData("smaller", Width, Height, Height)]
    [InlineData("larger", Width, Height, Width)]
    [InlineData("vertical", Height, Width, Width)]
    [InlineData("horizontal", Height, Width, Height)]
    [InlineData("smaller", Height, Width, Height)]
    [InlineData("larger", Height, Width, Width)]
    [InlineData("smaller", 9, 9, 9)]
    public void A_pinhole_projects_corners_to_their_pixels(string axis, int width, int height, int extent)
    {
        LensModel camera = new(s_eye, s_target, s_up, 50, extent, width, height);
        (double X, double Y)[] corners = [(1.3, 1.2), (width - 1.6, 2.7), (width * 0.4, height - 1.4)];

        // Corners at three depths: only a perspective projection puts straight edges between them.
        Vec3D[] triangle = [.. corners.Select((c, i) => camera.PointAt(c.X, c.Y, 4 + (2 * i)))];
        CheckCoverage($"triangle seen by a pinhole ({axis}, {width}×{height})", Render(axis, width, height, 50, triangle), (x, y) => Polygon.Coverage(corners, x, y));
    }

    [Fact]
    public void The_first_pixel_is_at_the_upper_left()
    {
        LensModel camera = new(s_eye, s_target, s_up, 50, Height, Width, Height);
        (double X, double Y)[] corners = [(0, 0), (0, 1), (2, 0)];
        CheckCoverage(
            "triangle in the upper left corner",
            Render("vertical", Width, Height, 50, [.. corners.Select(c => camera.PointAt(c.X, c.Y, 3))]),
            (x, y) => y > 0 ? 0 : x switch { 0 => 0.75, 1 => 0.25, _ => 0 });
    }

    [Theory]
    [InlineData(2.0)]
    [InlineData(120.0)]
    public void The_field_of_view_is_a_full_angle(double degrees)
    {
        // A triangle as wide as the picture, its tip at the middle of the upper edge.
        LensModel camera = new(s_eye, s_target, s_up, degrees, Height, Width, Height);
        (double X, double Y)[] corners = [(0, Height), (Width, Height), (Width / 2, 0)];
        CheckCoverage(
            $"triangle across {degrees} degrees",
            Render("vertical", Width, Height, degrees, [.. corners.Select(c => camera.PointAt(c.X, c.Y, 3))]),
            (x, y) => Polygon.Coverage(corners, x, y));
    }

    [Theory]
    [InlineData("disk", 2.5)]
    [InlineData("disk", 4.0)]
    [InlineData("disk", 9.0)]
    [InlineData("square", 2.5)]
    [InlineData("square", 9.0)]
    [InlineData("eyeJitter", 2.5)]
    [InlineData("eyeJitter", 9.0)]
    public void A_lens_blurs_by_its_shape_and_only_what_is_out_of_focus(string shape, double depth)
    {
        const double focus = 4;
        LensModel camera = new(s_eye, s_target, s_up, 50, Height, Width, Height, focus);
        Vec3D[] triangle = [camera.PointAt(1.3, 1.2, depth), camera.PointAt(10.4, 2.7, depth), camera.PointAt(5, 6.6, depth)];
        string lens = shape == "eyeJitter"
            ? """ "shape": "eyeJitter", "jitter": [3, 2, 0.9] """
            : $""" "shape": "{shape}", "apertureRadius": 1.5 """;
        CheckCoverage(
            $"triangle at {depth} through a lens ({shape}) in focus at {focus}",
            Render("vertical", Width, Height, 50, triangle, $$""", "lens": { {{lens}}, "focusDistance": {{focus}} }"""),
            Blurred(camera, shape, 1.5, triangle));
    }

    [Theory]
    [InlineData("disk")]
    [InlineData("square")]
    public void The_circle_of_confusion_is_evenly_bright_and_as_large_as_the_lens_equation_says(string shape)
    {
        // A speck at twice the distance in focus: blur on the plane in focus of half the aperture, here three pixels across.
        const double focus = 4;
        LensModel camera = new(s_eye, s_target, s_up, 50, Height, Width, Height, focus);
        double aperture = 3 * 2 * focus * Math.Tan(25 * Math.PI / 180) / Height;
        Vec3D[] speck = [camera.PointAt(6.4, 4 - (0.2 / 3), 2 * focus), camera.PointAt(6.6, 4 - (0.2 / 3), 2 * focus), camera.PointAt(6.5, 4 + (0.4 / 3), 2 * focus)];
        ImageSamples images = Render(
            "vertical", Width, Height, 50, speck, FormattableString.Invariant($$""", "lens": { "shape": "{{shape}}", "apertureRadius": {{aperture}}, "focusDistance": {{focus}} }"""),
            samples: 4096, radiance: 50);

        // Its area times its radiance is 1, spread evenly over a circle, or a square, of 1.5 pixels around it.
        CheckCoverage($"speck through a lens ({shape})", images, (x, y) => shape == "disk" ? OfDisk(x, y) : Overlap(x, 6.5) * Overlap(y, 4) / 9, tolerance: 3e-3);

        static double Overlap(int start, double middle, double half = 1.5) => Math.Max(0, Math.Min(start + 1, middle + half) - Math.Max(start, middle - half));

        static double OfDisk(int x, int y)
        {
            const int steps = 1000;
            return Enumerable.Range(0, steps).Sum(i => Overlap(x, 6.5, Math.Sqrt(Math.Max(0, 2.25 - Math.Pow(y + ((i + 0.5) / steps) - 4, 2))))) / steps / (Math.PI * 2.25);
        }
    }

    [Fact]
    public void Without_a_focus_distance_what_is_looked_at_is_sharp()
    {
        double depth = (s_target - s_eye).Length;
        LensModel camera = new(s_eye, s_target, s_up, 50, Height, Width, Height, depth);
        (double X, double Y)[] corners = [(1.3, 1.2), (10.4, 2.7), (5, 6.6)];
        CheckCoverage(
            "triangle in the plane looked at",
            Render("vertical", Width, Height, 50, [.. corners.Select(c => camera.PointAt(c.X, c.Y, depth))], """, "lens": { "apertureRadius": 0.5 }"""),
            (x, y) => Polygon.Coverage(corners, x, y));
    }

    // Mean over the lens of what each of its points would see.
    private static Func<int, int, double> Blurred(LensModel camera, string shape, double radius, Vec3D[] triangle)
    {
        double Seen(int x, int y, Vec3D shift) => Polygon.Coverage([.. triangle.Select(p => camera.Project(p, shift))], x, y);
        return (x, y) => shape switch
        {
            "disk" => Quadrature.Disk(24, (u, v) => Seen(x, y, (camera.Right * (u * radius)) + (camera.Up * (v * radius)))),
            "square" => Quadrature.Mean(-radius, radius, -radius, radius, 40, (u, v) => Seen(x, y, (camera.Right * u) + (camera.Up * v))),
            _ => Quadrature.Integrate(-0.45, 0.45, 8, w => Quadrature.Mean(-1.5, 1.5, -1, 1, 24, (u, v) => Seen(x, y, new(u, v, w)))) / 0.9,
        };
    }

    // The triangle's front, which shines, is turned to the eye.
    private static ImageSamples Render(string axis, int width, int height, double degrees, Vec3D[] triangle, string lens = "", int samples = 1024, double radiance = 1)
    {
        (Vec3D a, Vec3D b, Vec3D c) = (triangle[0], triangle[1], triangle[2]);
        (b, c) = (b - a).Cross(c - a).Dot(a - s_eye) < 0 ? (b, c) : (c, b);
        return SceneRuns.RenderText(
            FormattableString.Invariant($$"""
                { "camera": { "position": {{s_eye}}, "lookAt": {{s_target}}, "up": {{s_up}}, "fieldOfView": {{degrees}}, "fieldOfViewAxis": "{{axis}}"{{lens}} },
                  "render": { "integrator": "report", "width": {{width}}, "height": {{height}}, "samplesPerPixel": {{samples}} },
                  "lights": [ { "type": "triangle", "a": {{a}}, "b": {{b}}, "c": {{c}}, "material": { "type": "luminaire", "multiplier": {{radiance}} } } ] }
                """),
            TestSettings.Scale(24, 96));
    }

    private static void CheckCoverage(string what, ImageSamples images, Func<int, int, double> coverage, double tolerance = 1e-3)
    {
        double[,] expected = new double[images.Width, images.Height];
        for (int y = 0; y < images.Height; y++)
        {
            for (int x = 0; x < images.Width; x++)
            {
                expected[x, y] = coverage(x, y);
            }
        }

        Closed.Check(what, images, (x, y, _) => expected[x, y], tolerance);
    }
}
