using RayTracer.Rendering;

namespace RayTracer.RenderTests.Bits;

/// <summary>
/// Parts of pictures whose paths start at the lights, too: each part follows all light paths of its samples, of which only what falls into
/// it counts, and light paths that were followed for a pass that is broken off count nowhere.
/// Covers `LightPass`, `PassLoop` and `SplatSums`.
/// </summary>
public class LightPathBitsTests
{
    private const int Samples = 4;

    public static TheoryData<string> Scenes() => new(BitScenes.LightPaths);

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Any_number_of_threads_gives_the_same_bits(string name)
    {
        // Threads follow light paths by blocks, of which this picture has three.
        Scene scene = BitScenes.LoadCaustic(name, """ "width": 100, "height": 90, "samplesPerPixel": 1 """);
        string one = new RTracer(scene, new() { Threads = 1, TileSize = 64 }).Render().Film.ComputeHash();
        foreach (int threads in new[] { 2, 5 })
        {
            Assert.Equal(one, new RTracer(scene, new() { Threads = threads, TileSize = 3 }).Render().Film.ComputeHash());
        }
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Pixels_of_a_part_are_those_of_the_whole(string name)
    {
        Scene scene = BitScenes.Load(name);
        Film whole = new RTracer(scene).Render().Film;
        foreach (Tile part in new Tile[] { new(0, 0, 1, 1), new(9, 7, 1, 1), new(3, 5, 13, 9), new(21, 17, 1, 1) })
        {
            Film film = new RTracer(scene, new() { Crop = part }).Render().Film;
            for (int i = 0; i < whole.Width * whole.Height; i++)
            {
                (int x, int y) = (i % whole.Width, i / whole.Width);
                bool isPart = x >= part.X && x < part.X + part.Width && y >= part.Y && y < part.Y + part.Height;
                Assert.Equal(isPart ? whole.Mean(x, y) : default, film.Mean(x, y));
                Assert.Equal(isPart ? whole.SampleCount(x, y) : 0, film.SampleCount(x, y));
            }
        }
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Samples_in_two_runs_are_those_of_one(string name)
    {
        Scene scene = BitScenes.Load(name);
        Film whole = new RTracer(scene).Render().Film;
        Film late = new RTracer(scene, new() { Samples = new(2, Samples) }).Render().Film;
        late.Merge(new RTracer(scene, new() { Samples = new(0, 2) }).Render().Film);
        Assert.Equal(whole.ComputeHash(), late.ComputeHash());
    }

    [Theory]
    [MemberData(nameof(Scenes))]
    public void What_was_cancelled_is_completed_by_the_samples_that_it_lacks(string name)
    {
        Scene scene = BitScenes.Load(name);
        string whole = new RTracer(scene).Render().Film.ComputeHash();
        foreach (double part in new[] { 0, 0.3, 0.6, 0.9 })
        {
            Film film = new(scene.Render.Width, scene.Render.Height, FilmPlane.Needed(scene.Render.Integrator));
            using CancellationTokenSource source = new();
            RenderStatistics statistics = new RTracer(scene, new() { Threads = 1, TileSize = 8 }).Render(film, new CancelAt(part, source), source.Token);
            Assert.True(statistics.Cancelled);
            Assert.Equal((int)(part * Samples), statistics.SamplesPerPixel);
            new RTracer(scene, new() { Samples = new(statistics.SamplesPerPixel, Samples) }).Render(film);
            Assert.Equal(whole, film.ComputeHash());
        }
    }

    private sealed class CancelAt(double part, CancellationTokenSource source) : IProgress<RenderProgress>
    {
        public void Report(RenderProgress value)
        {
            if (value.Fraction >= part)
            {
                source.Cancel();
            }
        }
    }
}
