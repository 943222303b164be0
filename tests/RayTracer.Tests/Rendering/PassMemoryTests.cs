using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>What passes cost in memory, measured while no other test runs. Covers `PassLoop`.</summary>
[Collection(MeasuredMemory.Name)]
public class PassMemoryTests
{
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
}
