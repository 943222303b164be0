namespace RayTracer.RenderTests.Analytic;

/// <summary>
/// Light that falls on a matt floor straight from a source, against its closed form: every pixel of a small picture of the
/// floor sees another distance and angle.
/// </summary>
[Trait("Category", "Thorough")]
public class DirectLightTests
{
    private const int Edge = 4;
    private const double Albedo = 0.5;
    private static readonly Vec3D s_up = new(0, 1, 0);
    private static readonly LensModel s_camera = new(new(0, 3, 0.25), new(0, 0, 0), s_up, 30, Edge, Edge, Edge);

    public static TheoryData<string, double, double, double, double> Spheres()
    {
        TheoryData<string, double, double, double, double> data = [];
        foreach (string sampling in new[] { "cone", "surface" })
        {
            data.Add(sampling, 6, 5, 0, 1);
            data.Add(sampling, 2.2, 1.5, 1, 1.2);
            data.Add(sampling, 0.5, 40, -20, 0.05);
            data.Add(sampling, 3, 0.3, -1, 1);
            data.Add(sampling, -2.5, -0.4, 0.5, 0.9);
        }

        return data;
    }

    [Theory]
    [MemberData(nameof(Spheres))]
    public void A_sphere_lights_the_floor_by_the_part_of_its_cone_above_the_horizon(string sampling, double x, double y, double z, double radius)
    {
        string light = $$"""{ "type": "sphere", "center": {{new Vec3D(x, y, z)}}, "radius": {{radius}}, "material": { "type": "luminaire", "multiplier": 10 } }""";
        Check($"sphere light at {x}, {y}, {z}, sampled by {sampling}", Render(light, sampling), (p, _) => 10 * Irradiance.FromSphere(p, s_up, new(x, y, z), radius));
    }

    [Fact]
    public void A_sphere_well_above_the_horizon_lights_by_the_square_of_radius_over_distance()
    {
        // The quadrature itself, against π (r/d)² cos θ.
        foreach (double angle in new[] { 0, 0.3, 1.1 })
        {
            Vec3D center = new(5 * Math.Sin(angle), 5 * Math.Cos(angle), 0);
            Assert.Equal(Math.PI * 0.16 * Math.Cos(angle), Irradiance.FromSphere(default, s_up, center, 2), 9);
        }
    }

    [Theory]
    [InlineData("cone")]
    [InlineData("surface")]
    public void A_textured_sphere_lights_as_a_plain_one_of_its_colour(string sampling)
    {
        const string light = """
            { "type": "sphere", "center": [2.2, 1.5, 1], "radius": 1.2, "material": { "type": "luminaire", "multiplier": 10, "color": { "type": "checker", "even": [1, 0.5, 0.25], "odd": [1, 0.5, 0.25] } } }
            """;
        Check("textured sphere light", Render(light, sampling), (p, channel) => 10 * Math.Pow(0.5, channel) * Irradiance.FromSphere(p, s_up, new(2.2, 1.5, 1), 1.2));
    }

    [Theory]
    [InlineData("cone", 1)]
    [InlineData("surface", 1)]
    [InlineData("cone", 4.5)]
    public void A_sphere_that_shines_by_a_power_of_the_cosine_lights_by_2_over_the_power_plus_2(string sampling, double exponent)
    {
        // Across its disk the cosine is √(1 − sin²/sin² of the rim), whose powers integrate to 2/(n + 2) of the whole.
        string light = $$"""{ "type": "sphere", "center": [2.2, 1.8, 1], "radius": 0.8, "material": { "type": "luminaire", "multiplier": 10, "exponent": {{exponent}} } }""";
        Check($"sphere light of exponent {exponent}", Render(light, sampling), (p, _) =>
        {
            Vec3D to = new Vec3D(2.2, 1.8, 1) - p;
            return 10 * Math.PI * 0.64 / to.Dot(to) * to.Unit.Y * 2 / (exponent + 2);
        });
    }

    [Theory]
    [InlineData(2.0, 3.0, 1.0, -1.0, -2.0, 0.0)]
    [InlineData(-1.0, 2.0, -2.0, 0.3, -1.0, 0.6)]
    [InlineData(0.0, 30.0, 5.0, 0.0, -1.0, 0.0)]
    [InlineData(2.5, 0.2, 0.0, -1.0, 0.0, 0.0)]
    [InlineData(-1.5, -0.3, 1.5, 1.0, 0.2, -1.0)]
    public void A_rectangle_lights_the_floor_by_Lamberts_sum_over_its_edges(double x, double y, double z, double nx, double ny, double nz)
    {
        (Vec3D center, Vec3D normal) = (new(x, y, z), new(nx, ny, nz));
        Vec3D[] corners = Corners(center, normal, 2, 1.5, 0, 1);
        Check(
            $"rectangle light at {center}",
            Render($$"""{ "type": "plane", "point": {{center}}, "normal": {{normal}}, "size": [2, 1.5], "material": { "type": "luminaire", "multiplier": 5 } }"""),
            (p, _) => 5 * Irradiance.FromPolygon(p, s_up, corners));
    }

    [Fact]
    public void Each_half_of_a_two_coloured_rectangle_lights_in_its_own_colour()
    {
        (Vec3D center, Vec3D normal) = (new(1.2, 1.5, 1.0), new(-1, -1, -0.5));
        Check(
            "two-coloured rectangle light",
            Render($$"""
                { "type": "plane", "point": {{center}}, "normal": {{normal}}, "size": [2, 1.5], "material": { "type": "luminaire", "multiplier": 5,
                  "color": { "type": "checker", "scale": [2, 1], "even": [1, 0, 0.5], "odd": [0, 1, 0.5] } } }
                """),
            (p, channel) => channel switch
            {
                0 => 5 * Irradiance.FromPolygon(p, s_up, Corners(center, normal, 2, 1.5, 0, 0.5)),
                1 => 5 * Irradiance.FromPolygon(p, s_up, Corners(center, normal, 2, 1.5, 0.5, 1)),
                _ => 2.5 * Irradiance.FromPolygon(p, s_up, Corners(center, normal, 2, 1.5, 0, 1)),
            });
    }

    [Theory]
    [InlineData(1.9, 0.7, -0.9, 0.8)]
    [InlineData(2.5, 0.4, 1.0, 1.5)]
    [InlineData(-3.0, 20.0, 5.0, 4.0)]
    public void A_level_disk_lights_the_floor_by_its_closed_form(double x, double y, double z, double radius) => Check(
        $"disk light at {x}, {y}, {z}",
        Render($$"""{ "type": "disk", "center": {{new Vec3D(x, y, z)}}, "normal": [0, -1, 0], "radius": {{radius}}, "material": { "type": "luminaire", "multiplier": 5 } }"""),
        (p, _) => 5 * Irradiance.FromLevelDisk(p, new(x, y, z), radius));

    [Theory]
    [InlineData(1.5, 1.2, -0.4)]
    [InlineData(-1.6, 1.6, -1.2)]
    [InlineData(-2.5, -0.3, 1.8)]
    public void A_box_lights_the_floor_by_the_faces_that_are_seen(double x, double y, double z)
    {
        (Vec3D low, Vec3D size) = (new(x, y, z), new(0.7, 0.9, 0.5));
        (Vec3D a, Vec3D b, Vec3D c) = (new(size.X, 0, 0), new(0, size.Y, 0), new(0, 0, size.Z));
        (Vec3D Corner, Vec3D U, Vec3D V)[] faces = [(low, c, b), (low + a, b, c), (low, a, c), (low + b, c, a), (low, b, a), (low + c, a, b)];
        double FromFaces(Vec3D p) => faces.Where(f => f.U.Cross(f.V).Dot(p - f.Corner) > 0)
            .Sum(f => Irradiance.FromPolygon(p, s_up, f.Corner, f.Corner + f.U, f.Corner + f.U + f.V, f.Corner + f.V));
        Check(
            $"box light at {x}, {y}, {z}",
            Render($$"""{ "type": "box", "a": {{low}}, "b": {{low + size}}, "material": { "type": "luminaire", "multiplier": 5 } }"""),
            (p, _) => 5 * FromFaces(p));
    }

    [Theory]
    [InlineData(2.0)]
    [InlineData(0.2)]
    public void A_triangle_lights_the_floor_by_Lamberts_sum_over_its_edges_part_by_part(double height)
    {
        (Vec3D a, Vec3D b, Vec3D c) = (new(2, height - 0.5, 1.5), new(1.5, height + 1, 0), new(2.2, height, -1.5));

        // u, which goes from 0 at a to 1 at b, parts the colours halfway.
        (Vec3D ab, Vec3D bc) = ((a + b) * 0.5, (b + c) * 0.5);
        string light = $$"""
            { "type": "triangle", "a": {{a}}, "b": {{b}}, "c": {{c}}, "material": { "type": "luminaire", "multiplier": 5,
              "color": { "type": "checker", "scale": [2, 1], "even": [1, 0, 0.5], "odd": [0, 1, 0.5] } } }
            """;
        Assert.True((b - a).Cross(c - a).Dot(a) < 0, "its front must face the floor");
        Check($"triangle light at {a}", Render(light), (p, channel) => channel switch
        {
            0 => 5 * Irradiance.FromPolygon(p, s_up, a, ab, bc, c),
            1 => 5 * Irradiance.FromPolygon(p, s_up, ab, b, bc),
            _ => 2.5 * Irradiance.FromPolygon(p, s_up, a, b, c),
        });
    }

    [Theory]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(7.5)]
    [InlineData(40)]
    public void A_spot_lights_by_its_power_of_the_cosine(double exponent)
    {
        (Vec3D center, Vec3D normal) = (new(0.8, 2, 0.6), new(-0.3, -1, -0.1));
        (Vec3D right, Vec3D top) = Axes(normal);
        Check(
            $"spot of exponent {exponent}",
            Render($$"""{ "type": "plane", "point": {{center}}, "normal": {{normal}}, "size": [0.6, 0.3], "material": { "type": "luminaire", "multiplier": 30, "exponent": {{exponent}} } }"""),
            (p, _) => 30 * Irradiance.FromSpot(p, s_up, center, right * 0.6, top * 0.3, exponent));
    }

    [Fact]
    public void The_radiance_seen_is_colour_times_multiplier_times_the_power_of_the_cosine()
    {
        foreach (double degrees in new[] { 0, 20, 60, 85 })
        {
            (double sin, double cos) = Math.SinCos(degrees * Math.PI / 180);
            ImageSamples images = SceneRuns.RenderText($$"""
                { "camera": { "position": {{new Vec3D(5 * sin, 5 * cos, 0)}}, "lookAt": [0, 0, 0], "up": [0, 0, 1], "fieldOfView": 0.001 },
                  "render": { "integrator": "report", "width": 1, "height": 1, "samplesPerPixel": 4 },
                  "lights": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "size": [1, 1], "material": { "type": "luminaire", "color": [1, 0.5, 0], "multiplier": 3, "exponent": 2.5 } } ] }
                """, 2);
            Rgb(images, 3 * Math.Pow(cos, 2.5), 4);
        }

        static void Rgb(ImageSamples images, double expected, int digits)
        {
            float[] pixel = images.Mean().Pixels;
            Assert.Equal([expected, expected / 2, 0], pixel.Select(p => Math.Round(p, digits)), (a, b) => Math.Abs(a - b) < 2e-4);
        }
    }

    [Fact]
    public void Nothing_shines_backwards()
    {
        ImageSamples images = Render("""
            { "type": "plane", "point": [1, 2, 0], "normal": [0, 1, 0], "size": [1, 1], "material": { "type": "luminaire" } },
            { "type": "triangle", "a": [-2, 2, 1], "b": [-1, 2, 1], "c": [-2, 2, 0], "material": { "type": "luminaire" } }
            """);
        Assert.All(images.Mean().Pixels, p => Assert.Equal(0, p));
    }

    [Fact]
    public void A_lit_floor_is_dark_where_a_shadow_falls()
    {
        // Seen from each point of the floor, the rectangle hides the tiny light or does not.
        ImageSamples images = Render("""
            { "type": "sphere", "center": [0, 1000, 0], "radius": 0.001, "material": { "type": "luminaire", "multiplier": 1e12 } },
            { "type": "plane", "point": [0.3, 20, 0.2], "normal": [0, -1, 0], "size": [0.5, 0.7], "material": { "type": "luminaire", "multiplier": 0 } }
            """, samples: 256);

        // Rays from so far away spread by a fiftieth on their way.
        const double scale = 1000.0 / 980;
        (double X, double Y)[] shadow = [.. new (double X, double Z)[] { (-0.25, -0.35), (0.25, -0.35), (0.25, 0.35), (-0.25, 0.35) }
            .Select(c => s_camera.Project(new((0.3 + c.X) * scale, 0, (0.2 + c.Z) * scale)))];
        Closed.Check(
            "shadow of a rectangle",
            images,
            (x, y, _) => (1 - Polygon.Coverage(shadow, x, y)) * Albedo * Quadrature.Pixel(x, y, (px, py) => Fall(s_camera.Floor(px, py))),
            pixelTolerance: 2e-3);

        static double Fall(Vec3D p)
        {
            Vec3D to = new Vec3D(0, 1000, 0) - p;
            return 1e6 / to.Dot(to) * to.Unit.Y;
        }
    }

    [Theory]
    [InlineData("")]
    [InlineData(""", { "type": "mesh", "positions": [[50, 0, 0], [51, 0, 0], [50, 1, 0]], "triangles": [[0, 1, 2]] }""")]
    public void A_point_light_lights_the_floor_by_the_cosine_over_the_squared_distance(string beside) => Check(
        "point light",
        Render($$"""{ "type": "point", "position": [1, 1.5, -0.5], "intensity": [4, 2, 1] }""", samples: 64, beside: beside),
        (p, channel) => Math.Pow(2, 2 - channel) * FromPoint(p, new(1, 1.5, -0.5)));

    [Fact]
    public void A_spot_light_lights_the_floor_by_its_angle_to_the_axis() => Check(
        "spot light",
        Render("""{ "type": "spot", "position": [0.5, 2, 0], "direction": [-0.5, -2, 0], "intensity": [4, 2, 1], "cutoffAngle": 60, "beamWidth": 0 }"""),
        (p, channel) =>
        {
            Vec3D to = p - new Vec3D(0.5, 2, 0);
            double angle = Math.Acos(to.Unit.Dot(new Vec3D(-0.5, -2, 0).Unit));
            return Math.Pow(2, 2 - channel) * FromPoint(p, new(0.5, 2, 0)) * (1 - (angle * 3 / Math.PI));
        });

    [Theory]
    [InlineData("")]
    [InlineData(""", { "type": "mesh", "positions": [[50, 0, 0], [51, 0, 0], [50, 1, 0]], "triangles": [[0, 1, 2]] }""")]
    [InlineData(""", { "type": "instance", "of": { "type": "torus", "center": [50, 1, 0], "radius": 1 } }""")]
    public void A_directional_light_lights_the_floor_by_the_cosine(string beside) => Check(
        "directional light",
        Render("""{ "type": "directional", "direction": [3, -4, 0], "irradiance": [4, 2, 1] }""", samples: 64, beside: beside),
        (_, channel) => Math.Pow(2, 2 - channel) * 0.8);

    // All kinds of things that rays meet, between the floor and a light infinitely far away.
    [Theory]
    [InlineData("""{ "type": "sphere", "center": [0, 9, 0], "radius": 5 }""")]
    [InlineData("""{ "type": "box", "a": [-5, 8, -5], "b": [5, 9, 5] }""")]
    [InlineData("""{ "type": "cylinder", "bottom": [0, 8, 0], "top": [0, 9, 0], "radius": 5 }""")]
    [InlineData("""{ "type": "cone", "bottom": [0, 8, 0], "top": [0, 9, 0], "radius": 5 }""")]
    [InlineData("""{ "type": "torus", "center": [0, 1e3, 0], "axis": [1, 0, 0], "radius": 8, "tubeRadius": 7.5 }""")]
    [InlineData("""{ "type": "disk", "center": [0, 1e6, 0], "normal": [0, 1, 0], "radius": 5 }""")]
    [InlineData("""{ "type": "plane", "point": [0, 9, 0], "normal": [0, 1, 0] }""")]
    [InlineData("""{ "type": "rectangle", "corner": [-5, 9, -5], "edgeU": [0, 0, 10], "edgeV": [10, 0, 0] }""")]
    [InlineData("""{ "type": "triangle", "a": [-50, 9, -50], "b": [-50, 9, 50], "c": [50, 9, 0] }""")]
    [InlineData("""{ "type": "mesh", "positions": [[-50, 1e6, -50], [-50, 1e6, 50], [50, 1e6, 0]], "triangles": [[0, 1, 2]] }""")]
    [InlineData("""{ "type": "instance", "of": { "type": "sphere", "center": [0, 9, 0], "radius": 5 }, "transform": [{ "scale": [2, 1, 1] }] }""")]
    public void Nothing_is_too_far_away_to_hide_a_directional_light(string between) => Check(
        between, Render("""{ "type": "directional", "irradiance": [4, 2, 1] }""", samples: 16, beside: ", " + between), (_, _) => 0);

    private static double FromPoint(Vec3D p, Vec3D light) => (light - p).Unit.Y / (light - p).Dot(light - p);

    private static (Vec3D Right, Vec3D Top) Axes(Vec3D normal)
    {
        Vec3D right = (Math.Abs(normal.Unit.Y) > 0.9999 ? new Vec3D(0, 0, -1) : s_up).Cross(normal).Unit;
        return (right, normal.Unit.Cross(right));
    }

    // Corners of the part of a rectangle between two values of u.
    private static Vec3D[] Corners(Vec3D center, Vec3D normal, double width, double height, double u0, double u1)
    {
        (Vec3D right, Vec3D top) = Axes(normal);
        (Vec3D left, Vec3D end, Vec3D half) = (right * (width * (u0 - 0.5)), right * (width * (u1 - 0.5)), top * (height / 2));
        return [center + left - half, center + end - half, center + end + half, center + left + half];
    }

    private static ImageSamples Render(string lights, string sampling = "cone", int samples = 1024, string beside = "") => SceneRuns.RenderText($$"""
        { "camera": { "position": [0, 3, 0.25], "lookAt": [0, 0, 0], "fieldOfView": 30 },
          "render": { "integrator": "report", "width": {{Edge}}, "height": {{Edge}}, "samplesPerPixel": {{samples}}, "maxDiffuseDepth": 0, "sphereLightSampling": "{{sampling}}" },
          "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.5, 0.5, 0.5] } }{{beside}} ],
          "lights": [ {{lights}} ] }
        """, TestSettings.Scale(24, 96));

    private static void Check(string what, ImageSamples images, Func<Vec3D, int, double> irradiance) => Closed.Check(
        what, images, (x, y, channel) => Albedo / Math.PI * Quadrature.Pixel(x, y, (px, py) => irradiance(s_camera.Floor(px, py), channel)));
}
