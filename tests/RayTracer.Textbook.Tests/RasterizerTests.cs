namespace RayTracer.Textbook.Tests;

/// <summary>The rasterizer sees the triangles that rays see, shades their corners by the same law, and presses shadows where rays find them.</summary>
public class RasterizerTests
{
    private const int Width = 96;
    private const int Height = 64;
    private const double PixelSize = 1.0 / 80;
    private static readonly Vector s_eye = new(0.2, 1.4, 5);
    private static readonly Vector s_forward = new Vector(-0.05, -0.2, -1).Unit;
    private static readonly Vector s_right = Vector.Cross(s_forward, new(0, 1, 0)).Unit;
    private static readonly Vector s_up = Vector.Cross(s_right, s_forward);

    private static Matrix Camera => Matrix.Perspective(Width * PixelSize, Height * PixelSize, 0.05, 100).After(Matrix.View(s_eye, s_right, s_up, s_forward));

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void The_triangle_of_a_pixel_is_that_which_the_ray_through_its_middle_meets(bool cullsBackFaces)
    {
        // Many cross each other, and some reach behind the eye.
        Face[] faces = Soup(400, new(4, 3, 6));
        Rasterizer raster = new(Width, Height) { CullsBackFaces = cullsBackFaces };
        raster.Draw(faces, Camera);
        Face[] met = cullsBackFaces ? [.. faces.Select(f => Vector.Dot(f.Normal, s_eye - f.A) > 0 ? f : f with { A = default, B = default, C = new(0, 0, 1e-9) })] : faces;
        Scene scene = SceneOf(met);
        int different = 0;
        HashSet<int> seen = [];
        for (int pixel = 0; pixel < Width * Height; pixel++)
        {
            int expected = scene.Intersect(Middle(pixel), out Hit hit) ? hit.Index : -1;
            different += expected == raster.Visible[pixel] ? 0 : 1;
            seen.Add(expected);
        }

        Assert.True(seen.Count > 80, $"{seen.Count} triangles are seen");

        // Middles of pixels that lie on an edge but for rounding, and what is nearer than the near plane.
        Assert.InRange(different, 0, 2);
    }

    [Fact]
    public void Light_at_corners_is_Lambert_s_and_what_is_between_is_interpolated_in_space()
    {
        // A floor that runs far away: at each pixel the light is linear in space, though not in the picture.
        Face floor = new(new(-50, 0, 6), new(50, 0, 6), new(0, 0, -80), new(0.5, 0.6, 0.7));
        RasterLight parallel = new(new(0, 0.6, 0.8, 0), new(Math.PI));
        Rasterizer flat = new(Width, Height) { Lights = [parallel], Ambient = new(0.1) };
        flat.Draw([floor], Camera);
        Rasterizer shaded = new(Width, Height) { Lights = [new(new(0, 3, 0, 1), new(Math.PI))] };
        shaded.Draw([floor], Camera);
        Scene scene = SceneOf([floor]);
        double Corner(Vector p) => new Vector(0, 3, 0) - p is var to ? 0.5 * to.Unit.Y / Vector.Dot(to, to) : 0;
        int count = 0;
        for (int pixel = 0; pixel < Width * Height; pixel++)
        {
            if (scene.Intersect(Middle(pixel), out Hit hit) && flat.Visible[pixel] == 0)
            {
                count++;
                Assert.Equal(0.5 * (0.1 + 0.6), flat.Pixels[pixel].R, 9);

                // Barycentric coordinates of the point itself.
                double ofC = (6 - hit.Point.Z) / 86;
                double ofB = ((hit.Point.X + 50) - (50 * ofC)) / 100;
                double expected = ((1 - ofB - ofC) * Corner(floor.A)) + (ofB * Corner(floor.B)) + (ofC * Corner(floor.C));
                Assert.Equal(1, shaded.Pixels[pixel].R / expected, 6);
            }
        }

        Assert.True(count > 1000);
    }

    [Fact]
    public void The_painter_is_right_where_nothing_crosses_and_wrong_where_triangles_do()
    {
        Face near = new(new(-1, 0, 1), new(1, 0, 1), new(0, 2, 1), Rgb.White);
        Face far = new(new(-1, 0.5, 0), new(2, 0.5, 0), new(0, 2.5, 0), Rgb.White);
        Face across = new(new(-1, 1, 0), new(1, 1, 2), new(0, 1.8, 1), Rgb.White);
        Assert.Equal(0, Errors([near, far]));
        Assert.Equal(0, Errors([far, near]));
        Assert.InRange(Errors([near, across]), 20, Width * Height);

        int Errors(Face[] faces)
        {
            Rasterizer raster = new(Width, Height);
            Rasterizer painter = new(Width, Height) { IsPainter = true };
            raster.Draw(faces, Camera);
            painter.Draw(faces, Camera);
            return raster.Visible.Zip(painter.Visible).Count(p => p.First != p.Second);
        }
    }

    [Fact]
    public void Many_triangles_take_no_more_of_the_stack_than_few()
    {
        Rasterizer raster = new(Width, Height);
        raster.Draw(Soup(100_000, new(4, 3, 6)), Camera);
        Assert.DoesNotContain(-1, raster.Visible);
    }

    [Fact]
    public void Shadow_matrices_are_those_of_the_report()
    {
        Vector p = new(1.5, 0.8, -0.3);
        Homogeneous point = new(2, 3, 1, 1);
        Vector pressed = ProjectedShadow.On(new(0, 1, 0), 0, point).Of(p).Point;
        AssertNear(new(((point.Y * p.X) - (point.X * p.Y)) / (point.Y - p.Y), 0, ((point.Y * p.Z) - (point.Z * p.Y)) / (point.Y - p.Y)), pressed);
        Homogeneous parallel = new(0.6, 0.7, -0.2, 0);
        pressed = ProjectedShadow.On(new(0, 1, 0), 0, parallel).Of(p).Point;
        AssertNear(new(p.X - (p.Y * parallel.X / parallel.Y), 0, p.Z - (p.Y * parallel.Z / parallel.Y)), pressed);
    }

    [Theory]
    [InlineData(1.0)]
    [InlineData(0.0)]
    public void Projected_shadows_lie_where_rays_find_them(double w)
    {
        Face[] things = [.. Soup(60, new(2.5, 0.6, 2.5)).Select(f => f with { A = Up(f.A), B = Up(f.B), C = Up(f.C) })];
        Homogeneous light = w == 1 ? new(1, 4, 1, 1) : new(new Vector(0.5, 1, 0.3).Unit.X, new Vector(0.5, 1, 0.3).Unit.Y, new Vector(0.5, 1, 0.3).Unit.Z, 0);
        Face floor = new(new(-60, 0, 60), new(60, 0, 60), new(0, 0, -90), Rgb.White);
        Face[] shadows = [.. ProjectedShadow.Of(things, new(0, 1, 0), 0, light, lift: 1e-5)];
        Assert.Equal(things.Length, shadows.Length);
        Rasterizer raster = new(Width, Height);
        raster.Draw([floor, .. things, .. shadows], Camera);
        Scene scene = SceneOf([floor, .. things]);
        (int dark, int different) = (0, 0);
        for (int pixel = 0; pixel < Width * Height; pixel++)
        {
            if (scene.Intersect(Middle(pixel), out Hit hit) && hit.Index == 0)
            {
                Vector to = new Vector(light.X, light.Y, light.Z) - (w * hit.Point);
                bool isDark = !scene.IsFree(hit.Leave(to.Unit), w == 1 ? to.Length : double.PositiveInfinity);
                dark += isDark ? 1 : 0;
                different += isDark == raster.Visible[pixel] > things.Length ? 0 : 1;
            }
        }

        Assert.True(dark > 200, $"{dark} dark pixels");
        Assert.InRange(different, 0, dark / 100);

        static Vector Up(Vector v) => v + new Vector(0, 1, 0);
    }

    [Fact]
    public void Matrices_of_models_are_their_maps_and_products_go_one_after_the_other()
    {
        Transform map = Transform.Translation(new(1, 2, 3)).After(Transform.Rotation(new(1, 1, 0), 40)).After(Transform.Scaling(new(1, 2, 0.5)));
        Vector p = new(0.3, -0.7, 0.9);
        AssertNear(map.Point(p), Matrix.Model(map).Of(p).Point);
        AssertNear(Camera.Of(map.Point(p)).Point, Camera.After(Matrix.Model(map)).Of(p).Point);
    }

    private static void AssertNear(Vector expected, Vector actual) => Assert.Equal(0, (expected - actual).Length, 1e-9);

    private static Ray Middle(int pixel)
    {
        PerspectiveCamera camera = new(s_eye, s_forward, s_right, s_up, Width, Height, PixelSize, new Pinhole(), 1);
        return camera.RayThrough((pixel % Width) + 0.5, (pixel / Width) + 0.5, new IndependentSampler());
    }

    private static Scene SceneOf(Face[] faces) => new(
        new PerspectiveCamera(s_eye, s_forward, s_right, s_up, Width, Height, PixelSize, new Pinhole(), 1),
        [.. faces.Select(f => new Thing(new Triangle(f.A, f.B, f.C, default), new Diffuse(new Solid(Rgb.White))))], [], null, Rgb.Black);

    private static Face[] Soup(int count, Vector size)
    {
        IndependentSampler random = new(TestSettings.Seed);
        random.Begin(0, 0, 0);
        Vector Point(double scale) => new((random.Next() - 0.5) * 2 * scale * size.X, (random.Next() - 0.5) * 2 * scale * size.Y, (random.Next() - 0.5) * 2 * scale * size.Z);
        return [.. Enumerable.Range(0, count).Select(_ => Point(1)).Select(middle => new Face(middle + Point(0.2), middle + Point(0.2), middle + Point(0.2), Rgb.White))];
    }
}
