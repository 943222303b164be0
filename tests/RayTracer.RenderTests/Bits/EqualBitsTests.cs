using RayTracer.Rendering;

namespace RayTracer.RenderTests.Bits;

/// <summary>
/// The same film, to the bit, and the same counts, however the work is divided and on whatever machine.
/// Covers `RTracer`, `Film`, `Wavefront` and `LightPass`.
/// </summary>
[Trait("Category", "Thorough")]
public class EqualBitsTests
{
    private static readonly string[] s_scenes = [.. BitScenes.Report, .. BitScenes.Samplers, .. BitScenes.Splitting, BitScenes.Hills, BitScenes.DispersingShadows, .. BitScenes.Meshes, .. BitScenes.Lights, .. BitScenes.Varying];

    public static TheoryData<string> Scenes() => new(s_scenes);

    public static TheoryData<string> ScenesAndLightPaths() => new([.. s_scenes, .. BitScenes.LightPaths]);

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Any_number_of_threads_gives_the_same_bits_and_counts(string name)
    {
        Scene scene = BitScenes.Load(name);
        (Film one, RenderStatistics counts) = new RTracer(scene, new() { Threads = 1, TileSize = 64 }).Render();
        foreach (int threads in new[] { 1, 2, 3, 7 })
        {
            using Rendezvous all = new(threads);
            (Film film, RenderStatistics statistics) = new RTracer(scene, new() { Threads = threads, TileSize = 8 }).Render(all);
            Assert.Equal(threads, all.Threads);
            AssertSame(one, film, $"{threads} threads");
            AssertSame(counts, statistics);
        }
    }

    [Theory]
    [MemberData(nameof(ScenesAndLightPaths))]
    public void Tiles_and_streams_of_any_size_give_the_same_bits_and_counts(string name)
    {
        Scene scene = BitScenes.Load(name);
        (Film one, RenderStatistics counts) = new RTracer(scene, new() { Threads = 1 }).Render();
        foreach ((int tile, int stream) in new[] { (1, 1), (3, 7), (5, 64), (16, 1000), (33, 4096), (64, 65536), (0, 17) })
        {
            (Film film, RenderStatistics statistics) = new RTracer(scene, new() { TileSize = tile, StreamSize = stream }).Render();
            AssertSame(one, film, $"tiles of {tile}, streams of {stream}");
            AssertSame(counts, statistics);
        }
    }

    [Theory]
    [MemberData(nameof(ScenesAndLightPaths))]
    public void Parts_of_samples_and_pixels_merged_in_random_order_are_the_whole(string name)
    {
        Scene scene = BitScenes.Load(name);
        Film whole = new RTracer(scene).Render().Film;
        Random random = new(TestSettings.Seed);
        for (int round = 0; round < TestSettings.Scale(3, 20); round++)
        {
            RenderOptions[] parts = [.. Parts(random, scene)];
            random.Shuffle(parts);
            Film merged = new(whole.Width, whole.Height, whole.Planes);
            foreach (RenderOptions part in parts)
            {
                // Some go to films of their own, some add to what there is.
                if (random.Next(2) == 0)
                {
                    new RTracer(scene, part).Render(merged);
                }
                else
                {
                    merged.Merge(new RTracer(scene, part).Render().Film);
                }
            }

            AssertSame(whole, merged, $"{parts.Length} parts");
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void A_cancelled_rendering_is_completed_by_the_samples_that_it_lacks(int threads)
    {
        Scene scene = SceneRuns.Load(ProjectFolder.PathOf("scenes", "report", "scene2.json"), d => d with { Render = d.Render with { Width = 32, Height = 32, SamplesPerPixel = 144 } });
        Film whole = new RTracer(scene).Render().Film;
        foreach (double part in new[] { 0.0, 0.3, 0.5, 0.95 })
        {
            Film film = new(32, 32);
            using CancellationTokenSource source = new();
            RenderStatistics statistics = new RTracer(scene, new() { Threads = threads, TileSize = 8 }).Render(film, new CancelAt(part, source), source.Token);

            // One thread stops right there. Of several, others may have finished all that was left before one that was held up could say how far it is.
            Assert.True(statistics.Cancelled || threads > 1);
            Assert.Equal(statistics.Cancelled, statistics.SamplesPerPixel < 144);
            Assert.Equal(statistics.Paths, film.TotalSamples);
            Assert.Equal(32 * 32 * statistics.SamplesPerPixel, film.TotalSamples);
            if (statistics.Cancelled)
            {
                new RTracer(scene, new() { Samples = new(statistics.SamplesPerPixel, 144) }).Render(film);
            }

            AssertSame(whole, film, $"cancelled at {part}");
        }
    }

    [Fact]
    public void A_rendering_cancelled_before_it_began_leaves_the_film_empty()
    {
        Film film = new(64, 64);
        RenderStatistics statistics = new RTracer(BitScenes.Load("report/scene1")).Render(film, cancellation: new(canceled: true));
        Assert.True(statistics.Cancelled);
        Assert.Equal(0, film.TotalSamples);
        Assert.Equal(0, statistics.Rays);
        Assert.Equal(new Film(64, 64).ComputeHash(), film.ComputeHash());
    }

    [Theory]
    [InlineData("background", 3e38f)]
    [InlineData("ambient", 3e38f)]
    [InlineData("background", 1e8f)]
    public void Samples_that_are_not_finite_or_too_bright_are_the_same_ones_whatever_the_threads(string what, float value)
    {
        // Sums over bounces overflow here and there, or are clamped.
        Scene scene = SceneRuns.Load(
            ProjectFolder.PathOf("scenes", "report", "scene2.json"),
            d => (what == "ambient" ? d with { Ambient = new(value, value, value) } : d with { Background = new(value, value, value), Ambient = new(value, 0, 0) })
                with
            { Render = d.Render with { Width = 32, Height = 32, SamplesPerPixel = 4 } });
        (Film one, RenderStatistics counts) = new RTracer(scene, new() { Threads = 1, TileSize = 64 }).Render();
        Assert.True(counts.NonFiniteSamples + counts.ClampedSamples > 0);
        Assert.Equal(Math.Min(counts.NonFiniteSamples, RenderStatistics.MaxBadSamples), counts.BadSamples.Count);
        Assert.Equal(counts.Paths, one.TotalSamples + counts.NonFiniteSamples);
        foreach (int threads in new[] { 2, 7 })
        {
            using Rendezvous all = new(threads);
            (Film film, RenderStatistics statistics) = new RTracer(scene, new() { Threads = threads, TileSize = 5, StreamSize = 100 }).Render(all);
            AssertSame(one, film, $"{threads} threads");
            AssertSame(counts, statistics);
        }
    }

    [Fact]
    public void Every_seed_is_another_picture()
    {
        string[] hashes = [.. new long[] { 0, 1, 2, 3, 4294967295 }.Select(seed => new RTracer(SceneRuns.Load(
            ProjectFolder.PathOf("scenes", "report", "scene2.json"),
            d => d with { Render = d.Render with { Width = 16, Height = 16, SamplesPerPixel = 1, Seed = seed } })).Render().Film.ComputeHash())];
        Assert.Distinct(hashes);
    }

    // The picture cut into two to four strips, each with its samples cut into ranges.
    private static IEnumerable<RenderOptions> Parts(Random random, Scene scene)
    {
        int[] columns = [0, .. Enumerable.Range(0, random.Next(1, 4)).Select(_ => random.Next(1, scene.Render.Width)).Distinct().Order(), scene.Render.Width];
        foreach ((int left, int right) in columns.Zip(columns.Skip(1)))
        {
            int last = scene.Render.SamplesPerPixel;
            int[] cuts = [0, .. Enumerable.Range(0, random.Next(3)).Select(_ => random.Next(1, last)).Distinct().Order(), last];
            foreach ((int first, int end) in cuts.Zip(cuts.Skip(1)))
            {
                yield return new()
                {
                    Crop = new(left, 0, right - left, scene.Render.Height),
                    Samples = new(first, end),
                    Threads = random.Next(1, 4),
                    TileSize = random.Next(65),
                    StreamSize = random.Next(1, 3000),
                };
            }
        }
    }

    private static void AssertSame(Film expected, Film film, string how)
    {
        if (expected.ComputeHash() == film.ComputeHash())
        {
            return;
        }

        int different = Enumerable.Range(0, film.Width * film.Height).Count(i => !SamePixel(expected, film, i % film.Width, i / film.Width));
        Assert.Fail($"With {how}, {different} pixels differ; {film.TotalSamples} samples instead of {expected.TotalSamples}.");
    }

    private static bool SamePixel(Film a, Film b, int x, int y) =>
        a.SampleCount(x, y) == b.SampleCount(x, y) && a.Mean(x, y) == b.Mean(x, y) && a.SampleVariance(x, y).Equals(b.SampleVariance(x, y));

    private static void AssertSame(RenderStatistics expected, RenderStatistics statistics)
    {
        Assert.Equal(expected.BadSamples.Select(b => (b.X, b.Y, b.Sample)), statistics.BadSamples.Select(b => (b.X, b.Y, b.Sample)));
        Assert.Equal(expected with { BadSamples = [] }, statistics with { BadSamples = [] });
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
