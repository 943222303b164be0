using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;

namespace RayTracer.Tests.Rendering;

/// <summary>Samples that share their camera's rays: which do, that it only saves work, and that the mean stays. Covers `Splitting`, `Stages` and `VertexSamples`.</summary>
public class SplittingTests
{
    // A mirror and a coat beside matt things, below two lamps: some groups share the points of the lights, and some do not.
    private const string Room = """
        {
          "camera": { "position": [0, 1.5, 6], "lookAt": [0, 0.8, 0], "fieldOfView": 40 },
          "render": { "width": 12, "height": 9, "samplesPerPixel": 64, RENDER },
          "background": [0.2, 0.3, 0.4],
          "shapes": [
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.7, 0.6, 0.5] } },
            { "type": "sphere", "center": [-1.2, 0.8, 0], "radius": 0.8, "material": { "type": "diffuseSpecular", "diffuse": { "type": "diffuse", "color": [0.2, 0.5, 0.7] } } },
            { "type": "sphere", "center": [1.2, 0.8, 0], "radius": 0.8, "material": { "type": "conductor" } },
            { "type": "sphere", "center": [0, 4, 1], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 12 } },
            { "type": "sphere", "center": [2, 3, 2], "radius": 0.2, "material": { "type": "luminaire", "color": [1, 0.4, 0.2], "multiplier": 30 } }
          ]
        }
        """;

    public static TheoryData<string> Renders { get; } = new(
        "\"integrator\": \"path\", \"maxDepth\": 5",
        "\"integrator\": \"path\", \"maxDepth\": 5, \"splitting\": 7, \"filter\": { \"shape\": \"gaussian\" }",
        "\"integrator\": \"path\", \"sampler\": \"jittered\"",
        "\"integrator\": \"report\", \"sampler\": \"jittered\"",
        "\"integrator\": \"report\", \"splitting\": 16");

    [Theory]
    [MemberData(nameof(Renders))]
    public void Samples_are_the_same_together_and_each_by_itself(string render)
    {
        Scene scene = Build(render);
        Assert.NotNull(scene.Splitting);
        (Film together, RenderStatistics counts) = new RTracer(scene).Render();

        // An observer has each sample followed by itself.
        Film alone = new(together.Width, together.Height);
        RenderStatistics all = new RTracer(scene, new() { Layers = new(alone, scene, [LightPathAov.Direct]) }).Render(alone);
        Assert.Equal(alone.ComputeHash(), together.ComputeHash());
        Assert.Equal(all.Paths, counts.Paths);
        Assert.InRange(counts.ClosestHitRays, 0, all.ClosestHitRays - (scene.Render.Width * scene.Render.Height * 16));

        // In parts that divide those that share a ray.
        Film parts = new(together.Width, together.Height);
        foreach ((int first, int end) in new[] { (0, 1), (1, 17), (17, 18), (18, 35), (35, 64) })
        {
            parts.Merge(new RTracer(scene, new() { Samples = new(first, end) }).Render().Film);
        }

        Assert.Equal(together.ComputeHash(), parts.ComputeHash());
    }

    [Theory]
    [MemberData(nameof(Renders))]
    public void The_mean_is_that_of_samples_with_rays_of_their_own(string render)
    {
        const int seeds = 16;
        Scene[] scenes = [Build(render), Build(render, s => s with { Splitting = 1 })];
        Assert.Null(scenes[1].Splitting);
        double[][] means = [.. scenes.Select(scene => Enumerable.Range(0, seeds).Select(seed =>
        {
            Film film = new RTracer(scene.Guided(null, scene.Render with { Seed = seed })).Render().Film;
            return Enumerable.Range(0, film.Width * film.Height).Average(i => (double)film.Mean(i % film.Width, i / film.Width).G);
        }).ToArray())];
        double[] mean = [.. means.Select(m => m.Average())];
        double deviation = Math.Sqrt(means.Zip(mean, (m, middle) => m.Sum(v => (v - middle) * (v - middle))).Sum() / (seeds * (seeds - 1)));
        Assert.InRange((mean[0] - mean[1]) / deviation, -4, 4);
    }

    [Fact]
    public void Rays_and_their_samples_are_numbered_alike_up_to_the_most_samples()
    {
        foreach (int ways in new[] { 2, 3, 4, 7, 64 })
        {
            Splitting splitting = Splitting.Of(ways, SamplerKind.Sobol, new SobolSampler(1 << 24))!;
            int[] samples = [0, 1, 15, 16, 17, 16 + ways - 1, 16 + ways, 1000, .. Enumerable.Range((1 << 24) - 200, 200), .. Enumerable.Range((1 << 23) - 100, 200)];
            foreach (int sample in samples)
            {
                int ray = splitting.RayOf(sample);
                Assert.Equal((uint)ray, splitting.RayOf((UIntW)(uint)sample)[0]);
                uint first = splitting.FirstOf((UIntW)(uint)ray)[0];
                Assert.InRange(sample, (int)first, (int)first + (sample < 16 ? 0 : ways - 1));
                Assert.Equal(sample < 16 || sample == (int)first ? sample == (int)first : sample - (int)first < ways, splitting.Has((UIntW)(uint)ray, sample - (int)first).Any);
                Assert.InRange(splitting.EndOf(sample), sample, sample + ways - 1);
                Assert.Equal(sample < 17 ? sample : (int)splitting.FirstOf((UIntW)(uint)splitting.RayOf(sample + ways - 1))[0], splitting.EndOf(sample));
            }
        }
    }

    [Theory]
    [InlineData(8, 4, 4)]
    [InlineData(10, 4, 4)]
    [InlineData(12, 9, 9)]
    [InlineData(12, 8, 4)]
    [InlineData(6, 4, 1)]
    [InlineData(9, 4, 1)]
    public void A_grid_of_samples_is_one_of_rays_with_a_grid_of_samples_each(int side, int ways, int expected) =>
        Assert.Equal(expected, Splitting.Of(ways, SamplerKind.Jittered, new JitteredSampler(side * side))?.Ways ?? 1);

    [Theory]
    [InlineData("\"integrator\": \"path\", \"splitting\": 1", "")]
    [InlineData("\"integrator\": \"path\", \"maxDepth\": 2", "")]
    [InlineData("\"integrator\": \"direct\"", "")]
    [InlineData("\"integrator\": \"report\", \"maxDiffuseDepth\": 0", "")]
    [InlineData("\"integrator\": \"vcm\"", "")]
    [InlineData("\"integrator\": \"path\", \"sampler\": \"independent\"", "")]
    [InlineData("\"integrator\": \"path\", \"shutter\": [0, 1]", "{ \"type\": \"sphere\", \"radius\": 0.1, \"center\": [0, 1, 0], \"motion\": [{ \"time\": 0 }, { \"time\": 1, \"transform\": { \"translate\": [1, 0, 0] } }] },")]
    [InlineData("\"integrator\": \"path\"", "{ \"type\": \"mesh\", \"positions\": [[0, 1, 0], [1, 1, 0], [0, 2, 0]], \"triangles\": [[0, 1, 2]] },")]
    [InlineData("\"integrator\": \"path\"", "{ \"type\": \"sphere\", \"center\": [0, 1, 0], \"radius\": 0.1, \"material\": { \"type\": \"dielectric\", \"glass\": \"bk7\" } },")]
    public void Each_sample_has_a_ray_of_its_own_where_the_noise_comes_from_the_ray(string render, string shape) =>
        Assert.Null(TestScenes.Build(Room.Replace("RENDER", render, StringComparison.Ordinal).Replace("\"shapes\": [", "\"shapes\": [" + shape, StringComparison.Ordinal)).Splitting);

    private static Scene Build(string render, Func<RenderDescription, RenderDescription>? change = null)
    {
        Scene scene = TestScenes.Build(Room.Replace("RENDER", render, StringComparison.Ordinal));
        return change is null ? scene : scene.Guided(null, change(scene.Render));
    }
}
