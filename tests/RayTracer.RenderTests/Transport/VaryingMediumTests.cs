using System.Globalization;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Spectra;

namespace RayTracer.RenderTests.Transport;

/// <summary>
/// Media that vary, against closed forms and against even ones.
/// Covers `VaryingFlights` and `ShadowFlights`.
/// </summary>
[Trait("Category", "Thorough")]
public sealed class VaryingMediumTests : IDisposable
{
    private const string Box = "\"box\": [[-1, -1, -1], [1, 1, 1]]";
    private static readonly int s_seeds = TestSettings.Scale(16, 96);
    private static readonly System.Collections.Concurrent.ConcurrentDictionary<bool, ImageSamples> s_flakes = new();
    private readonly string _folder = Directory.CreateTempSubdirectory("raytracer-").FullName;

    public void Dispose() => Directory.Delete(_folder, recursive: true);

    [Theory]
    [InlineData("[2, 2, 2]", "[0.8, 0.8, 0.8]", 1, 0.5)]
    [InlineData("[0.5, 2, 6]", "[0.9, 0.6, 0.3]", 1, 0)]
    [InlineData("[3, 0, 1]", "[1, 0.5, 0.5]", 3, -0.4)]
    [InlineData("[1, 2, 4]", "[0, 0, 0]", 3, 0)]
    public void A_grid_of_equal_numbers_is_an_even_medium(string extinction, string albedo, int channels, double anisotropy)
    {
        // Half of the numbers' majorants lie above them: beside each cell is one of twice the density, outside of the shape.
        string file = Grid("even.vol", 16, 16, 32, (_, _, z) => z is >= 8 and < 24 ? 0.5f : 1, channels);
        string medium = $"\"albedo\": {albedo}, \"anisotropy\": {anisotropy.ToString(CultureInfo.InvariantCulture)}";
        string varying = $$"""{ "extinction": {{extinction}}, {{medium}}, "density": { "file": "{{file}}", "box": [[-1, -1, -2], [1, 1, 2]] } }""";
        string twice = string.Join(", ", extinction.Trim('[', ']').Split(", ").Select(e => (double.Parse(e, CultureInfo.InvariantCulture) / 2).ToString(CultureInfo.InvariantCulture)));
        string even = $$"""{ "extinction": [{{twice}}], {{medium}} }""";
        ImageSamples one = SceneRuns.RenderText(Lit(even), s_seeds);
        ImageSamples other = SceneRuns.RenderText(Lit(varying), s_seeds, firstSeed: 1000);
        foreach ((int x, int y) in new[] { (0, 0), (8, 0), (0, 8), (8, 8) })
        {
            for (int channel = 0; channel < 3; channel++)
            {
                (BlockEstimate a, BlockEstimate b) = (one.Estimate(new(x, y, 8, 8), channel), other.Estimate(new(x, y, 8, 8), channel));
                ErrorBudget.Analytic.Check(BlockTest.Welch(a, b), $"block {x}, {y}, channel {channel}: {a.Mean} ± {Math.Sqrt(a.Variance)}, {b.Mean} ± {Math.Sqrt(b.Variance)}");
            }
        }
    }

    [Theory]
    [InlineData("[4, 0.5, 0.5]", "[0, 0, 0]")]
    [InlineData("[3, 1.5, 2.6]", "[0.3, -0.2, 0]")]
    public void Light_through_a_density_that_grows_evenly_is_weakened_by_its_mean(string from, string at)
    {
        // Linear along x, so that what counts is the density in the middle of the way through the box: the corners are cut off, where it is not.
        string file = Grid("ramp.vol", 64, 4, 4, (x, _, _) => (x + 0.5f) / 32, 1);
        double[] origin = Numbers(from), target = Numbers(at);
        (double enters, double leaves, double[] direction) = Ways(origin, target);
        double middle = origin[0] + (direction[0] * (enters + leaves) / 2);
        double depth = (leaves - enters) * (1 + middle);
        string shape = $$"""{ "type": "box", "a": [-0.95, -0.95, -0.95], "b": [0.95, 0.95, 0.95], "material": { "type": "invisible", "interior": { "extinction": [0.5, 1, 0], "density": { "file": "{{file}}", {{Box}} } } } }""";
        ImageSamples images = SceneRuns.RenderText($$"""
            { "camera": { "position": {{from}}, "lookAt": {{at}}, "fieldOfView": 1e-3 },
              "render": { "width": 8, "height": 8, "samplesPerPixel": 64, "integrator": "volPath" }, "background": [1, 1, 1], "shapes": [ {{shape}} ] }
            """, s_seeds);
        Check(images, [Math.Exp(-0.5 * depth), Math.Exp(-depth), 1]);
    }

    [Fact]
    public void Shadows_are_as_dark_as_the_density_on_the_way_says()
    {
        string file = Grid("ramp.vol", 4, 64, 4, (_, y, _) => (y + 0.5f) / 32, 1);
        const string scene = """
            { "camera": { "position": [3, 0.5, 0], "lookAt": [0, 0, 0], "fieldOfView": 0.001 },
              "render": { "width": 4, "height": 4, "samplesPerPixel": 64, "integrator": "volPath", "maxDepth": 2 },
              "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [1, 1, 1] } } SHAPE ],
              "lights": [ { "type": "directional", "direction": [0, -1, 0], "irradiance": [3.14159265, 3.14159265, 3.14159265] } ] }
            """;
        string shape = $$""", { "type": "box", "a": [-0.5, 1, -0.5], "b": [0.5, 3, 0.5], "material": { "type": "invisible", "interior": { "extinction": [0.5, 1, 0.1], "density": { "file": "{{file}}", "box": [[-1, 1, -1], [1, 3, 1]] } } } }""";
        Check(SceneRuns.RenderText(scene.Replace("SHAPE", shape, StringComparison.Ordinal), s_seeds), [Math.Exp(-1), Math.Exp(-2), Math.Exp(-0.2)]);
    }

    [Fact]
    public void Deep_shadows_of_uneven_clouds_keep_their_mean()
    {
        // Layers of twice the density and of none: no cell has a least extinction, and little light is left for what ends at random.
        string file = Grid("layers.vol", 4, 32, 4, (_, y, _) => y % 2 * 2, 3);
        string scene = $$"""
            { "camera": { "position": [3, 0.5, 0], "lookAt": [0, 0, 0], "fieldOfView": 0.001 },
              "render": { "width": 8, "height": 8, "samplesPerPixel": 64, "integrator": "volPath", "maxDepth": 2 },
              "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [1, 1, 1] } },
                { "type": "box", "a": [-0.5, 1, -0.5], "b": [0.5, 3, 0.5], "material": { "type": "invisible", "interior": { "extinction": [2, 1.5, 2.5],
                  "density": { "file": "{{file}}", "box": [[-1, 1, -1], [1, 3, 1]], "interpolation": "nearest" } } } } ],
              "lights": [ { "type": "directional", "direction": [0, -1, 0], "irradiance": [3.14159265, 3.14159265, 3.14159265] } ] }
            """;
        Check(SceneRuns.RenderText(scene, s_seeds), [Math.Exp(-4), Math.Exp(-3), Math.Exp(-5)]);
    }

    [Theory]
    [InlineData("[3, 3, 3]", 1, "\"anisotropy\": 0.6")]
    [InlineData("[0.5, 2, 8]", 1, "\"anisotropy\": 0")]
    [InlineData("[4, 2, 1]", 3, "\"anisotropy\": -0.3")]
    [InlineData("[4, 2, 1]", 1, "\"phase\": { \"shape\": \"mix\", \"first\": { \"shape\": \"rayleigh\" }, \"second\": { \"shape\": \"table\", \"values\": [1, 0, 5] }, \"weightGrid\": { \"size\": [1, 2, 1], \"values\": [0, 2], \"box\": [[-1, -1, -1], [1, 1, 1]] } }")]
    [InlineData("[6, 3, 2]", 1, "\"phase\": { \"shape\": \"sggx\", \"matrixGrid\": { \"size\": [1, 2, 1, 6], \"values\": [0.9, 0.3, 0.15, 0.2, -0.1, 0.05, 0.04, 0.04, 1, 0, 0, 0], \"box\": [[-1, -1, -1], [1, 1, 1]] } }")]
    public void What_only_scatters_is_not_seen_in_an_even_light(string extinction, int channels, string scattering)
    {
        string file = Grid("clouds.vol", 9, 7, 11, Uneven, channels);
        string medium = $$"""{ "extinction": {{extinction}}, "albedo": [1, 1, 1], {{scattering}}, "density": { "file": "{{file}}", {{Box}} } }""";
        Check(SceneRuns.RenderText(Ball(medium, "[1, 1, 1]"), s_seeds), [1, 1, 1]);
    }

    [Theory]
    [InlineData("[3, 3, 3]", "[1.5, 1.5, 1.5]", "[0.5, 0.5, 0.5]", 1)]
    [InlineData("[0.5, 2, 8]", "[0.25, 0.4, 8]", "[0.5, 0.8, 0]", 1)]
    [InlineData("[4, 2, 1]", "[4, 2, 1]", "[0, 0, 0]", 3)]
    public void What_shines_as_much_as_it_absorbs_is_not_seen_in_an_even_light(string extinction, string emission, string albedo, int channels)
    {
        string file = Grid("clouds.vol", 9, 7, 11, Uneven, channels);
        string medium = $$"""{ "extinction": {{extinction}}, "albedo": {{albedo}}, "emission": {{emission}}, "density": { "file": "{{file}}", {{Box}} } }""";
        Check(SceneRuns.RenderText(Ball(medium, "[1, 1, 1]"), s_seeds), [1, 1, 1]);
    }

    [Theory]
    [InlineData("[0, 0, 0]", "")]
    [InlineData("[1e-6, 1e-6, 1e-6]", "")]
    [InlineData("[0, 0, 0]", ", \"emissionGrid\": GRID")]
    public void A_flame_without_smoke_is_as_bright_as_what_is_on_the_way(string extinction, string grid)
    {
        // As where light is weakened: the density in the middle of the way counts, or of the other grid, everywhere its mean.
        (string ramp, string two) = (Grid("ramp.vol", 64, 4, 4, (x, _, _) => (x + 0.5f) / 32, 1), Grid("two.vol", 2, 2, 2, (_, _, _) => 2, 1));
        (double enters, double leaves, double[] direction) = Ways([3, 1.5, 2.6], [0.3, -0.2, 0]);
        double depth = (leaves - enters) * (grid.Length > 0 ? 2 : 4 + (direction[0] * (enters + leaves) / 2));
        string medium = $$"""{ "extinction": {{extinction}}, "emission": [0.5, 1, 0], "density": { "file": "{{ramp}}", {{Box}} }{{grid.Replace("GRID", $$"""{ "file": "{{two}}", {{Box}} }""", StringComparison.Ordinal)}} }""";
        ImageSamples images = SceneRuns.RenderText($$"""
            { "camera": { "position": [3, 1.5, 2.6], "lookAt": [0.3, -0.2, 0], "fieldOfView": 1e-3 },
              "render": { "width": 8, "height": 8, "samplesPerPixel": 64, "integrator": "volPath" },
              "shapes": [ { "type": "box", "a": [-0.95, -0.95, -0.95], "b": [0.95, 0.95, 0.95], "material": { "type": "invisible", "interior": {{medium}} } } ] }
            """, s_seeds);
        Check(images, [0.5 * depth, depth, 0]);
    }

    // Light that is scattered once: means of quarters of the picture, from 2,048 samples of Mitsuba 3.9.1 a pixel (volpath), with their standard errors. What it scatters more often does not
    // follow its own phase function: a medium of albedo 1 in an even light of 1 has a mean of 0.78 there.
    [Theory]
    [InlineData(false, 0, 0, 0.044375115, 0.000131)]
    [InlineData(false, 8, 0, 0.042702258, 0.000145)]
    [InlineData(false, 0, 8, 0.045555338, 0.000167)]
    [InlineData(false, 8, 8, 0.022840606, 0.000108)]
    [InlineData(true, 0, 0, 0.042367544, 0.000138)]
    [InlineData(true, 8, 0, 0.036294222, 0.0001)]
    [InlineData(true, 0, 8, 0.046542112, 0.000131)]
    [InlineData(true, 8, 8, 0.031327367, 0.0001)]
    public void Flakes_scatter_light_once_as_in_Mitsuba(bool vary, int x, int y, double theirs, double error)
    {
        string medium = vary
            ? $$"""
              "extinction": [3, 3, 3], "density": { "size": [4, 1, 1], "values": [1, 0.25, 0.5, 1], {{Box}} },
              "phase": { "shape": "sggx", "matrixGrid": { "size": [1, 2, 1, 6], "values": [0.9, 0.3, 0.15, 0.2, -0.1, 0.05, 0.04, 0.04, 1, 0, 0, 0], {{Box}} } }
              """
            : """ "extinction": [2, 2, 2], "phase": { "shape": "sggx", "matrix": [0.9, 0.3, 0.15, 0.2, -0.1, 0.05] } """;
        BlockEstimate ours = s_flakes.GetOrAdd(vary, _ => SceneRuns.RenderText($$"""
            { "camera": { "position": [2, 1.5, 4], "lookAt": [0, 0, 0], "fieldOfView": 30 },
              "render": { "width": 16, "height": 16, "samplesPerPixel": 16, "integrator": "volPath", "maxDepth": 2 },
              "lights": [ { "type": "directional", "direction": [1, -1, -0.5], "irradiance": [3, 3, 3] } ],
              "shapes": [ { "type": "box", "a": [-1, -1, -1], "b": [1, 1, 1], "material": { "type": "invisible", "interior": { "albedo": [0.9, 0.8, 0.6], {{medium}} } } } ] }
            """, s_seeds)).Estimate(new(x, y, 8, 8), 0);
        double slack = 4.5 * Math.Sqrt(ours.Variance + (error * error));
        Assert.True(double.Abs(ours.Mean - theirs) < slack, $"{ours.Mean}, but {theirs} of Mitsuba, allowed {slack}");
        Assert.True(slack < 0.1 * theirs, $"a slack of {slack} shows nothing");
    }

    // Of one temperature and density, B(T) · emission · (1 − e^(−extinction · way))/extinction; offset and scale bring the numbers to 1,500 K.
    [Theory]
    [InlineData("[1500, 1500]", "")]
    [InlineData("[17.5, 17.5]", ", \"temperatureOffset\": 2.5, \"temperatureScale\": 100")]
    [InlineData("[100, 100]", "")]
    public void What_glows_has_the_colour_of_its_temperature(string temperatures, string numbers)
    {
        string medium = $$"""
            { "extinction": [0.4, 0.8, 1.2], "emission": [20, 100, 1000], "density": { "size": [2, 1, 1], "values": [1, 1], {{Box}} },
              "temperatureGrid": { "size": [2, 1, 1], "values": {{temperatures}}, {{Box}} }{{numbers}} }
            """;
        ImageSamples images = SceneRuns.RenderText(Ball(medium, "[0, 0, 0]").Replace("\"fieldOfView\": 30", "\"fieldOfView\": 1e-3", StringComparison.Ordinal), s_seeds);
        RgbW color = BlackBody.Color(temperatures == "[100, 100]" ? 0f : 1500f);
        double Seen(double emission, double extinction) => emission * (1 - Math.Exp(-extinction * 2)) / extinction;
        Check(images, [Seen(20, 0.4) * color.R[0], Seen(100, 0.8) * color.G[0], Seen(1000, 1.2) * color.B[0]]);
    }

    [Fact]
    public void No_path_is_brighter_than_its_channels_together_are_at_first()
    {
        string file = Grid("clouds.vol", 9, 7, 11, Uneven, 3);
        string medium = $$"""{ "extinction": [0.5, 2, 8], "albedo": [1, 1, 1], "density": { "file": "{{file}}", {{Box}} } }""";
        string scene = Ball(medium, "[1, 1, 1]").Replace("\"volPath\"", "\"volPath\", \"rouletteDepth\": 30000", StringComparison.Ordinal);
        ImageSamples images = SceneRuns.RenderText(scene, 2);
        Assert.All(Enumerable.Range(0, images.Count), i => Assert.All(Enumerable.Range(0, 3 * images.Width * images.Height), at => Assert.InRange(images.Value(i, at), 0, 3.001f)));
    }

    [Fact]
    public void Of_media_that_overlap_the_innermost_counts()
    {
        // Straight through a ball that only weakens green within one that only weakens red: the inner one takes the place of the outer.
        string file = Grid("even.vol", 2, 2, 2, (_, _, _) => 1, 1);
        string Medium(string extinction) => $$"""{ "type": "invisible", "interior": { "extinction": {{extinction}}, "density": { "file": "{{file}}", {{Box}} } } }""";
        ImageSamples images = SceneRuns.RenderText($$"""
            { "camera": { "position": [0, 0, 4], "lookAt": [0, 0, 0], "fieldOfView": 1e-3 },
              "render": { "width": 8, "height": 8, "samplesPerPixel": 64, "integrator": "volPath" }, "background": [1, 1, 1],
              "shapes": [ { "type": "sphere", "center": [0, 0, 0], "radius": 0.9, "material": {{Medium("[1, 0, 0]")}} },
                { "type": "sphere", "center": [0, 0, 0], "radius": 0.4, "material": {{Medium("[0, 2, 0]")}} } ] }
            """, s_seeds);
        Check(images, [Math.Exp(-1), Math.Exp(-1.6), 1]);
    }

    private static float Uneven(int x, int y, int z) => ((x * 7) + (y * 5) + (z * 3)) % 11 is var n && n < 4 ? 0 : n / 8f;

    private static double[] Numbers(string vector) => [.. vector.Trim('[', ']').Split(',').Select(n => double.Parse(n, CultureInfo.InvariantCulture))];

    // Where a ray to a point enters and leaves the box of the shape.
    private static (double Enters, double Leaves, double[] Direction) Ways(double[] from, double[] at)
    {
        double length = Math.Sqrt(Enumerable.Range(0, 3).Sum(i => (at[i] - from[i]) * (at[i] - from[i])));
        double[] direction = [.. Enumerable.Range(0, 3).Select(i => (at[i] - from[i]) / length)];
        (double Near, double Far)[] slabs = [.. Enumerable.Range(0, 3).Where(i => direction[i] != 0).Select(i => ((-0.95 - from[i]) / direction[i], (0.95 - from[i]) / direction[i]))];
        return (slabs.Max(s => Math.Min(s.Near, s.Far)), slabs.Min(s => Math.Max(s.Near, s.Far)), direction);
    }

    private static void Check(ImageSamples images, double[] expected)
    {
        for (int channel = 0; channel < 3; channel++)
        {
            BlockEstimate all = images.Estimate(new(0, 0, images.Width, images.Height), channel);
            double slack = 1e-4 + (6 * Math.Sqrt(all.Variance));
            Assert.True(Math.Sqrt(all.Variance) < 0.01, $"channel {channel} has a noise of {Math.Sqrt(all.Variance)}, which shows nothing");
            Assert.InRange(all.Mean, expected[channel] - slack, expected[channel] + slack);
        }
    }

    private static string Ball(string medium, string background) => $$"""
        { "camera": { "position": [0, 0, 4], "lookAt": [0, 0, 0], "fieldOfView": 30 },
          "render": { "width": 16, "height": 16, "samplesPerPixel": 16, "integrator": "volPath" }, "background": {{background}},
          "shapes": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "invisible", "interior": {{medium}} } } ] }
        """;

    private static string Lit(string medium) => $$"""
        { "camera": { "position": [0, 0.5, 4], "lookAt": [0, 0, 0], "fieldOfView": 36 },
          "render": { "width": 16, "height": 16, "samplesPerPixel": 16, "integrator": "volPath", "maxDepth": 24 }, "background": [0.3, 0.4, 0.5],
          "shapes": [ { "type": "box", "a": [-0.9, -0.9, -0.9], "b": [0.9, 0.9, 0.9], "material": { "type": "invisible", "interior": {{medium}} } },
            { "type": "plane", "point": [0, -1, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.7, 0.6, 0.5] } },
            { "type": "sphere", "center": [-1, 2, 1.5], "radius": 0.4, "material": { "type": "luminaire", "multiplier": 12 } } ] }
        """;

    private string Grid(string name, int x, int y, int z, Func<int, int, int, float> value, int channels) => TestVolumes.Write(
        Path.Combine(_folder, name), TestVolumes.Vol(x, y, z, (i, j, k) => [.. Enumerable.Repeat(value(i, j, k), channels)]));
}
