namespace RayTracer.RenderTests.Analytic;

/// <summary>
/// Closed rooms, in which the radiance is a geometric series over the bounces: a lost fraction of energy, or one bounce more or
/// less than the depth limit says, changes every pixel.
/// Covers `ReportShader`, `DirectLight` and `DiffuseMaterial`.
/// </summary>
[Trait("Category", "Thorough")]
public class RoomTests
{
    private static readonly double[] s_albedo = [0.8, 0.5, 0.25];

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(7)]
    [InlineData(255)]
    public void Ambient_light_in_a_matt_room_adds_up_over_every_diffuse_bounce(int depth)
    {
        // Each of the depth + 1 hits adds ambient · albedo, times the albedos on the way: no chance in it.
        ImageSamples images = Room($"\"maxDiffuseDepth\": {depth}, \"maxSpecularDepth\": 0", "\"ambient\": [1, 1, 1],", Sphere("""{ "type": "diffuse", "color": [0.8, 0.5, 0.25] }"""));
        CheckExact(images, channel => Series(s_albedo[channel], depth) * s_albedo[channel]);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(3)]
    [InlineData(8)]
    public void Ambient_light_in_a_metal_room_adds_up_over_every_specular_bounce(int depth)
    {
        ImageSamples images = Room($"\"maxDiffuseDepth\": 0, \"maxSpecularDepth\": {depth}", "\"ambient\": [1, 1, 1],", Sphere("""{ "type": "phongMetal", "color": [0.8, 0.5, 0.25], "exponent": 1e6 }"""));
        CheckExact(images, channel => Series(s_albedo[channel], depth) * s_albedo[channel]);
    }

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(5)]
    public void Shining_mirrors_show_each_other_as_often_as_the_specular_depth_says(int depth)
    {
        // Each mirror shines and reflects; seen at a slant, the path goes to and fro between them.
        string Wall(int z, string shine, string color) => $$"""
            { "type": "plane", "point": [0, 0, {{z}}], "normal": [0, 0, {{-z}}], "size": [100, 100], "material": { "type": "luminaire", "color": {{shine}}, "material": { "type": "phongMetal", "color": {{color}}, "exponent": 1e6 } } }
            """;
        ImageSamples images = SceneRuns.RenderText(
            $$"""
            { "camera": { "position": [0, 0, 0], "lookAt": [0.3, 0.2, -1], "fieldOfView": 5 },
              "render": { "integrator": "report", "width": 4, "height": 4, "samplesPerPixel": 4, "maxDiffuseDepth": 0, "maxSpecularDepth": {{depth}} },
              "shapes": [ {{Wall(-1, "[1, 0, 3]", "[0.8, 0.5, 0.25]")}}, {{Wall(1, "[0, 2, 1]", "[0.5, 0.5, 0.9]")}} ] }
            """,
            2);
        (double[] nearShine, double[] nearColor) = ([1, 0, 3], [0.8, 0.5, 0.25]);
        (double[] farShine, double[] farColor) = ([0, 2, 1], [0.5, 0.5, 0.9]);
        CheckExact(images, channel =>
        {
            (double sum, double throughput) = (0, 1);
            for (int k = 0; k <= depth; k++)
            {
                sum += throughput * (k % 2 == 0 ? nearShine : farShine)[channel];
                throughput *= (k % 2 == 0 ? nearColor : farColor)[channel];
            }

            return sum;
        });
    }

    [Theory]
    [InlineData(0, "cone", 0.0)]
    [InlineData(1, "cone", 0.0)]
    [InlineData(2, "cone", 0.6)]
    [InlineData(4, "cone", 0.6)]
    [InlineData(4, "surface", 0.6)]
    [InlineData(30, "cone", 0.6)]
    public void A_lamp_in_a_matt_room_lights_it_bounce_by_bounce(int depth, string sampling, double lampAlbedo)
    {
        // From anywhere on the wall, the lamp takes up (r/R)² of the light's cosine-weighted sky, and shows its own reflection
        // of the wall's light; from the lamp, all is wall.
        const double part = 0.16;
        ImageSamples images = Room(
            $"\"maxDiffuseDepth\": {depth}, \"maxSpecularDepth\": 0, \"sphereLightSampling\": \"{sampling}\"",
            "",
            Sphere("""{ "type": "diffuse", "color": [0.8, 0.5, 0.25] }"""),
            $$"""{ "type": "sphere", "center": [0, 0, 0], "radius": 2, "material": { "type": "luminaire", "multiplier": 10, "material": { "type": "diffuse", "color": [{{lampAlbedo}}, {{lampAlbedo}}, {{lampAlbedo}}] } } }""");
        Closed.Check($"lamp in a matt room, {depth} bounces, {sampling}", images, (_, _, channel) =>
        {
            (double wall, double lamp) = (0, 0);
            for (int k = 0; k <= depth; k++)
            {
                // Light of the last bounce is direct light only.
                (wall, lamp) = (s_albedo[channel] * ((10 * part) + ((1 - part) * wall) + (part * lamp)), lampAlbedo * wall);
            }

            return wall;
        });
    }

    [Fact]
    public void In_a_box_of_shining_walls_every_wall_receives_all_their_light()
    {
        // The other walls fill the sky of any point of a wall, whose reflection so is albedo times their radiance.
        string Wall(string point, string normal) => $$"""
            { "type": "plane", "point": {{point}}, "normal": {{normal}}, "size": [2, 2], "material": { "type": "luminaire", "multiplier": 3, "material": { "type": "diffuse", "color": [0.8, 0.5, 0.25] } } }
            """;
        ImageSamples images = SceneRuns.RenderText(
            $$"""
            { "camera": { "position": [0, 0, 0.9], "lookAt": [0.1, 0.1, -1], "fieldOfView": 30 },
              "render": { "integrator": "report", "width": 4, "height": 4, "samplesPerPixel": 1024, "maxDiffuseDepth": 0 },
              "shapes": [ {{Wall("[1, 0, 0]", "[-1, 0, 0]")}}, {{Wall("[-1, 0, 0]", "[1, 0, 0]")}}, {{Wall("[0, 1, 0]", "[0, -1, 0]")}},
                {{Wall("[0, -1, 0]", "[0, 1, 0]")}}, {{Wall("[0, 0, 1]", "[0, 0, -1]")}}, {{Wall("[0, 0, -1]", "[0, 0, 1]")}} ] }
            """,
            TestSettings.Scale(24, 96));
        Closed.Check("box of shining walls", images, (_, _, channel) => 3 * (1 + s_albedo[channel]));
    }

    [Theory]
    [InlineData(0, 0.0)]
    [InlineData(1, 1.0)]
    [InlineData(3, 1.0)]
    public void A_background_lights_a_floor_through_one_bounce_but_for_what_stands_in_its_way(int depth, double bounced)
    {
        // A black sphere at the zenith of the floor's middle hides (r/d)² cos θ of the cosine-weighted sky.
        const int edge = 4;
        LensModel camera = new(new(0, 2, 6), new(0, 0, 0), new(0, 1, 0), 8, edge, edge, edge);
        ImageSamples images = SceneRuns.RenderText(
            $$"""
            { "camera": { "position": [0, 2, 6], "lookAt": [0, 0, 0], "fieldOfView": 8 },
              "render": { "integrator": "report", "width": {{edge}}, "height": {{edge}}, "samplesPerPixel": 1024, "maxDiffuseDepth": {{depth}} },
              "background": [1, 2, 4],
              "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.8, 0.5, 0.25] } },
                { "type": "sphere", "center": [0, 3, 0], "radius": 1.5, "material": { "type": "diffuse", "color": [0, 0, 0] } } ] }
            """,
            TestSettings.Scale(24, 96));
        Closed.Check($"sky past a black sphere, {depth} bounces", images, (x, y, channel) => bounced * s_albedo[channel] * Math.Pow(2, channel) * Quadrature.Pixel(x, y, (px, py) =>
        {
            Vec3D to = new Vec3D(0, 3, 0) - camera.Floor(px, py);
            return 1 - (2.25 / to.Dot(to) * to.Unit.Y);
        }));
    }

    [Theory]
    [InlineData(0, 0, 0.0)]
    [InlineData(0, 1, 1.0)]
    [InlineData(1, 0, 0.0)]
    [InlineData(255, 255, 1.0)]
    public void A_mirror_shows_the_background_within_the_specular_depth_whatever_the_diffuse_one(int diffuse, int specular, double seen)
    {
        ImageSamples images = SceneRuns.RenderText(
            $$"""
            { "camera": { "position": [0, 2, 6], "lookAt": [0, 0, 0], "fieldOfView": 8 },
              "render": { "integrator": "report", "width": 4, "height": 4, "samplesPerPixel": 4, "maxDiffuseDepth": {{diffuse}}, "maxSpecularDepth": {{specular}} },
              "background": [1, 2, 4],
              "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "phongMetal", "color": [0.8, 0.5, 0.25] } } ] }
            """,
            2);
        CheckExact(images, channel => seen * s_albedo[channel] * Math.Pow(2, channel));
    }

    [Fact]
    public void A_varnished_room_adds_ambient_light_by_reflectance_of_both_layers()
    {
        // Straight at the wall of a sphere, Schlick's reflectance is r0; no bounce follows.
        ImageSamples images = Room(
            "\"maxDiffuseDepth\": 0, \"maxSpecularDepth\": 0",
            "\"ambient\": [1, 1, 1],",
            Sphere("""{ "type": "diffuseSpecular", "r0": 0.2, "diffuse": { "type": "diffuse", "color": [0.8, 0.5, 0.25] }, "specular": { "type": "phongMetal", "color": [1, 0.5, 0] } }"""),
            camera: "\"position\": [0, 0, 0], \"lookAt\": [0.3, 0.2, -1], \"fieldOfView\": 1");
        CheckExact(images, channel => (0.8 * s_albedo[channel]) + (0.2 * (1 - (0.5 * channel))));
    }

    // 1 + r + … + r^terms.
    private static double Series(double r, int terms) => (1 - Math.Pow(r, terms + 1)) / (1 - r);

    private static string Sphere(string material) => $$"""{ "type": "sphere", "center": [0, 0, 0], "radius": 5, "material": {{material}} }""";

    private static ImageSamples Room(string render, string light, string wall, string lamp = "", string camera = "\"position\": [0, 3.5, 0], \"lookAt\": [1, 4, -5], \"fieldOfView\": 50") =>
        SceneRuns.RenderText(
            $$"""
            { "camera": { {{camera}} }, "render": { "integrator": "report", "width": 4, "height": 4, "samplesPerPixel": {{(lamp.Length > 0 ? 256 : 4)}}, {{render}} }, {{light}}
              "shapes": [ {{wall}}{{(lamp.Length > 0 ? ", " + lamp : "")}} ] }
            """,
            lamp.Length > 0 ? TestSettings.Scale(24, 96) : 2);

    // Where nothing is left to chance, every pixel is the closed form but for rounding.
    private static void CheckExact(ImageSamples images, Func<int, double> expected)
    {
        float[] pixels = images.Mean().Pixels;
        for (int i = 0; i < pixels.Length; i++)
        {
            double value = expected(i % 3);
            Assert.InRange(pixels[i], value * (1 - 1e-5), value * (1 + 1e-5));
        }
    }
}
