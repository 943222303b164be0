using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Tests.Rendering;

public class RTracerTests
{
    private static readonly Scene s_scene = TestScenes.BuildEverything();
    private static readonly string s_hash = Render(new() { Threads = 1 }).ComputeHash();

    public static TheoryData<int, int, int> Ways() => new()
    {
        { 1, 0, 64 }, { 2, 0, 1024 }, { 7, 0, 1024 }, { 2, 8, 1024 }, { 1, 17, 256 }, { 3, 64, 2048 }, { 1, 5, 16 },
    };

    [Theory]
    [MemberData(nameof(Ways))]
    public void Films_are_the_same_to_the_bit_however_they_are_computed(int threads, int tile, int stream) =>
        Assert.Equal(s_hash, Render(new() { Threads = threads, TileSize = tile, StreamSize = stream }).ComputeHash());

    [Theory]
    [InlineData("jittered")]
    [InlineData("regular")]
    [InlineData("independent")]
    public void Every_sampler_keeps_the_bits(string sampler)
    {
        Scene scene = TestScenes.BuildEverything(sampler);
        string one = Render(new() { Threads = 1, TileSize = 8 }, scene).ComputeHash();
        Assert.Equal(one, Render(new() { Threads = 2, TileSize = 64 }, scene).ComputeHash());
        Assert.NotEqual(s_hash, one);
    }

    [Fact]
    public void Sample_ranges_into_one_film_or_merged_in_any_order_give_the_whole()
    {
        Film resumed = new(48, 32);
        Film[] parts = [new(48, 32), new(48, 32), new(48, 32)];
        SampleRange[] ranges = [new(0, 5), new(5, 6), new(6, 16)];
        for (int i = 0; i < 3; i++)
        {
            new RTracer(s_scene, new() { Samples = ranges[i] }).Render(resumed);
            new RTracer(s_scene, new() { Samples = ranges[i] }).Render(parts[i]);
        }

        Assert.Equal(s_hash, resumed.ComputeHash());
        Film merged = new(48, 32);
        merged.Merge(parts[2]);
        merged.Merge(parts[0]);
        Assert.NotEqual(s_hash, merged.ComputeHash());
        merged.Merge(parts[1]);
        Assert.Equal(s_hash, merged.ComputeHash());
    }

    [Fact]
    public void Crops_are_parts_of_the_whole()
    {
        Film whole = Render(new());
        Film left = new(48, 32);
        new RTracer(s_scene, new() { Crop = new(0, 0, 20, 32) }).Render(left);
        Assert.Equal(0u, left.SampleCount(20, 10));
        Assert.Equal(whole.Mean(19, 10), left.Mean(19, 10));
        new RTracer(s_scene, new() { Crop = new(20, 0, 28, 32) }).Render(left);
        Assert.Equal(whole.ComputeHash(), left.ComputeHash());
    }

    [Fact]
    public void Statistics_count_what_was_traced()
    {
        (Film film, RenderStatistics statistics) = new RTracer(s_scene).Render();
        Assert.Equal(48 * 32 * 16, statistics.Paths);
        Assert.Equal(statistics.Paths, film.TotalSamples);
        Assert.True(statistics.ClosestHitRays > statistics.Paths);
        Assert.True(statistics.ShadowRays > 0);
        Assert.Equal(statistics.ClosestHitRays + statistics.ShadowRays, statistics.Rays);
        Assert.Equal(0, statistics.NonFiniteSamples);
        Assert.False(statistics.Cancelled);
    }

    [Fact]
    public void Progress_rises_to_the_end_pass_by_pass()
    {
        List<RenderProgress> reports = [];
        new RTracer(s_scene, new() { TileSize = 8, Threads = 1, ShortestPass = TimeSpan.Zero }).Render(new Report(reports.Add));
        Assert.Equal(1, reports[^1].Fraction);
        Assert.True(reports.Zip(reports.Skip(1)).All(p => p.First.PathsDone < p.Second.PathsDone && p.First.Rays <= p.Second.Rays));
        (int Pass, int Samples)[] passes = [(1, 0), (2, 1), (3, 2), (4, 4), (5, 8)];
        Assert.Equal(passes.SelectMany(p => Enumerable.Repeat(p, 24)), reports.Select(r => (r.Pass, r.SamplesDone)));
    }

    [Fact]
    public void Wrong_films_crops_and_samples_are_refused()
    {
        Assert.Throws<ArgumentException>(() => new RTracer(s_scene).Render(new Film(10, 10)));
        Assert.Throws<ArgumentException>(() => new RTracer(s_scene, new() { Crop = new(40, 0, 9, 5) }).Render());
        Assert.Throws<ArgumentException>(() => new RTracer(s_scene, new() { Samples = new(0, 17) }).Render());
        Assert.Throws<ArgumentException>(() => new RTracer(s_scene, new() { Samples = new(4, 4) }).Render());
    }

    [Theory]
    [InlineData(-1, 0, 1024)]
    [InlineData(0, -1, 1024)]
    [InlineData(0, 65, 1024)]
    [InlineData(0, 0, 0)]
    [InlineData(0, 0, int.MaxValue)]
    public void Options_out_of_range_are_refused(int threads, int tile, int stream) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new RTracer(s_scene, new() { Threads = threads, TileSize = tile, StreamSize = stream }).Render());

    [Theory]
    [InlineData(256, 4, 16)]
    [InlineData(4, -1, 16)]
    [InlineData(4, 4, 0)]
    [InlineData(4, 4, (1 << 24) + 1)]
    public void Descriptions_made_by_programs_are_checked_too(int diffuse, int specular, int samples)
    {
        SceneBuilder builder = new((_, _) => throw new NotSupportedException());
        Assert.Null(builder.Build(new() { Render = new() { MaxDiffuseDepth = diffuse, MaxSpecularDepth = specular, SamplesPerPixel = samples } }));
        Assert.Contains("must be from", builder.Complaints[0].Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Lights_too_large_or_too_bright_to_compute_with_are_refused()
    {
        SceneBuilder builder = new((_, _) => throw new NotSupportedException());
        LuminaireMaterialDescription bright = new() { Color = new SolidTextureDescription { Color = new(1e10f, 1, 1) }, Multiplier = 3e38f };
        builder.Build(new() { Lights = [new PlaneDescription { Size = new(1e20f, 1e20f), Material = new LuminaireMaterialDescription() }] });
        builder.Build(new() { Lights = [new SphereDescription { Material = bright }] });
        Assert.Contains(builder.Complaints, c => c.Message.Contains("area", StringComparison.Ordinal));
        Assert.Contains(builder.Complaints, c => ReferenceEquals(c.Subject, bright));
    }

    [Theory]
    [InlineData(float.NaN, 0f)]
    [InlineData(0f, float.NaN)]
    public void Paths_that_are_not_numbers_are_counted_and_not_passed_off_as_background(float weight, float direction)
    {
        SceneBuilder builder = new((_, _) => throw new NotSupportedException());
        Scene scene = builder.Build(new()
        {
            Render = new() { Width = 16, Height = 16, SamplesPerPixel = 1 },
            Background = Rgb.White,
            Shapes = [new SphereDescription { Center = new(0, 0.5f, 0), Material = new FaultyDescription { Weight = weight, Direction = direction } }],
        })!;
        RenderStatistics statistics = new RTracer(scene).Render().Statistics;
        Assert.Equal(statistics.ClosestHitRays - statistics.Paths, statistics.NonFiniteSamples);
        Assert.True(statistics.NonFiniteSamples > 0);
    }

    private sealed record FaultyDescription : MaterialDescription
    {
        public float Weight { get; init; }

        public float Direction { get; init; }

        public override Material Build(SceneBuilder builder) => new Faulty(Weight, Direction);
    }

    private sealed class Faulty(float weight, float direction) : Material
    {
        public override MaterialTraits Traits { get; } = new() { Specular = SpecularLobe.Delta };

        public override void Scatter(in SurfaceW surface, RayTracer.Sampling.VertexSamples samples, out ScatterW scatter)
        {
            scatter.Direction = surface.Facing + (Vec3W)new System.Numerics.Vector3(direction);
            scatter.Weight = new Rgb(1, 1 + weight, 1);
            scatter.Specular = MaskW.All;
            scatter.Delta = MaskW.None;
            scatter.Absorbed = MaskW.None;
        }
    }

    [Fact]
    public void The_first_bad_samples_are_named_whatever_the_threads()
    {
        IReadOnlyList<BadSample> Bad(int threads)
        {
            Scene scene = TestScenes.Build(TestScenes.Everything.Replace("SAMPLER", "sobol", StringComparison.Ordinal)
                .Replace("\"skyblue\"", "[3e38, 3e38, 3e38]", StringComparison.Ordinal)
                .Replace("\"ambient\": [0.02, 0.02, 0.05]", "\"ambient\": [3e38, 3e38, 3e38]", StringComparison.Ordinal));
            return new RTracer(scene, new() { Threads = threads, TileSize = 8 }).Render().Statistics.BadSamples;
        }

        IReadOnlyList<BadSample> one = Bad(1);
        Assert.Equal(RenderStatistics.MaxBadSamples, one.Count);
        Assert.Equal(one.Order(), one);
        Assert.Equal(one.Select(b => (b.X, b.Y, b.Sample)), Bad(3).Select(b => (b.X, b.Y, b.Sample)));
    }

    [Fact]
    public void Depth_limits_end_paths()
    {
        string json = TestScenes.Everything.Replace("SAMPLER", "sobol", StringComparison.Ordinal);
        Scene none = TestScenes.Build(json.Replace("\"samplesPerPixel\": 16", "\"samplesPerPixel\": 16, \"maxDiffuseDepth\": 0, \"maxSpecularDepth\": 0", StringComparison.Ordinal));
        RenderStatistics statistics = new RTracer(none).Render().Statistics;
        Assert.Equal(statistics.Paths, statistics.ClosestHitRays);
    }

    [Fact]
    public void A_white_sphere_in_a_white_world_is_white()
    {
        Scene scene = TestScenes.Build("""
            { "camera": { "position": [0, 0, 3], "lookAt": [0, 0, 0] }, "render": { "integrator": "report", "width": 32, "height": 32, "samplesPerPixel": 4 }, "background": [1, 1, 1],
              "shapes": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "diffuse", "color": [1, 1, 1] } } ] }
            """);
        Film film = new RTracer(scene).Render().Film;
        for (int i = 0; i < 32; i++)
        {
            Assert.Equal(Rgb.White, film.Mean(i, 16));
        }
    }

    [Fact]
    public void A_glass_ball_in_a_white_world_is_all_but_invisible()
    {
        Scene scene = TestScenes.Build("""
            { "camera": { "position": [0, 0, 3], "lookAt": [0, 0, 0] }, "render": { "integrator": "report", "width": 32, "height": 32, "samplesPerPixel": 16, "maxSpecularDepth": 64 }, "background": [1, 1, 1],
              "shapes": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "dielectric" } } ] }
            """);
        Film film = new RTracer(scene).Render().Film;
        for (int i = 0; i < 32; i++)
        {
            Assert.Equal(1, film.Mean(i, 16).G, 4);
        }
    }

    [Theory]
    [InlineData("cone")]
    [InlineData("surface")]
    public void Light_from_a_sphere_is_what_the_closed_form_says(string sampling)
    {
        // A sphere of radiance L and radius r, wholly above the horizon, gives the irradiance π L (r/d)² cos θ.
        Scene scene = TestScenes.Build($$"""
            { "camera": { "position": [0, 4, 0.001], "lookAt": [0, 0, 0], "fieldOfView": 60 },
              "render": { "integrator": "report", "width": 16, "height": 16, "samplesPerPixel": 1024, "maxDiffuseDepth": 0, "sphereLightSampling": "{{sampling}}" },
              "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.5, 0.5, 0.5] } } ],
              "lights": [ { "type": "sphere", "center": [6, 5, 0], "radius": 1, "material": { "type": "luminaire", "multiplier": 10 } } ] }
            """);
        Film film = new RTracer(scene).Render().Film;
        double half = 4 * Math.Tan(Math.PI / 6);
        for (int x = 0; x < 16; x++)
        {
            double expected = 0;
            const int steps = 64;
            for (int i = 0; i < steps * steps; i++)
            {
                double px = half * (((x + ((i % steps) + 0.5) / steps) / 8) - 1);
                double pz = half * (((8 + ((i / steps) + 0.5) / steps) / 8) - 1);
                double d2 = ((6 - px) * (6 - px)) + 25 + (pz * pz);
                expected += 0.5 * 10 / d2 * (5 / Math.Sqrt(d2)) / (steps * steps);
            }

            double tolerance = sampling == "cone" ? 2e-4 : 0.02;
            Assert.InRange(film.Mean(x, 8).R, expected * (1 - tolerance), expected * (1 + tolerance));
        }
    }

    private static Film Render(RenderOptions options, Scene? scene = null) => new RTracer(scene ?? s_scene, options).Render().Film;

    private sealed class Report(Action<RenderProgress> action) : IProgress<RenderProgress>
    {
        void IProgress<RenderProgress>.Report(RenderProgress value) => action(value);
    }
}
