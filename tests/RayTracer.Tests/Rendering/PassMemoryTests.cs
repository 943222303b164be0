using System.Runtime.CompilerServices;
using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>What passes cost in memory, measured while no other test runs. Covers `PassLoop`.</summary>
[Collection(MeasuredMemory.Name)]
public class PassMemoryTests
{
    [Theory]
    [InlineData("path")]
    [InlineData("light")]
    [InlineData("bidirectional")]
    [InlineData("photons")]
    [InlineData("vcm")]
    public void Nothing_of_a_rendering_is_kept_when_it_is_over(string integrator)
    {
        List<WeakReference> scenes = [.. Enumerable.Range(0, 8).Select(_ => Rendered(integrator))];

        // Registers and stacks of threads may hold the last one for a while.
        for (int i = 0; i < 20 && scenes.Count(s => s.IsAlive) > 1; i++)
        {
            Thread.Sleep(10);
            GC.Collect();
            GC.WaitForPendingFinalizers();
        }

        Assert.InRange(scenes.Count(s => s.IsAlive), 0, 1);
    }

    [Fact]
    public void What_is_taken_back_costs_32_bytes_a_pixel()
    {
        const int edge = 1024;
        Scene scene = TestScenes.Build(TestScenes.Everything.Replace("SAMPLER", "sobol", StringComparison.Ordinal)
            .Replace("\"width\": 48, \"height\": 32", $"\"width\": {edge}, \"height\": {edge}", StringComparison.Ordinal)
            .Replace("\"samplesPerPixel\": 16", "\"samplesPerPixel\": 2", StringComparison.Ordinal));
        Film film = new(edge, edge);

        // All that is allocated on the way, each thread's room for its paths included.
        const long others = 4 << 20;
        long before = GC.GetTotalAllocatedBytes(precise: true);
        new RTracer(scene, new() { Threads = 1, Samples = new(0, 2) }).Render(film);
        Assert.InRange(GC.GetTotalAllocatedBytes(precise: true) - before, 0, (32L * edge * edge) + others);

        // Layers of light have room for the latest pass in what they take anyway.
        before = GC.GetTotalAllocatedBytes(precise: true);
        LightPathAovFilm layers = new(film, scene, [LightPathAov.Direct, LightPathAov.Indirect]);
        long taken = GC.GetTotalAllocatedBytes(precise: true) - before;
        Assert.InRange(taken, LightPathAovFilm.Bytes([LightPathAov.Direct, LightPathAov.Indirect], scene), (2L * 48 * edge * edge) + others);
    }

    [MethodImpl(MethodImplOptions.NoInlining)]
    private static WeakReference Rendered(string integrator)
    {
        Scene scene = TestScenes.Build($$"""
            { "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0] },
              "render": { "integrator": "{{integrator}}", "width": 16, "height": 16, "samplesPerPixel": 4 },
              "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "diffuse" } }],
              "lights": [{ "type": "sphere", "center": [0, 3, 3], "radius": 0.5, "material": { "type": "luminaire" } }] }
            """);
        new RTracer(scene, new() { Threads = 2 }).Render();
        return new(scene);
    }
}
