using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;
using RayTracer.Shapes;

namespace RayTracer.Tests.Rendering;

/// <summary>Passes over the picture: what a stop leaves is exactly the samples of those that are complete.</summary>
public class PassLoopTests
{
    private static readonly Scene s_scene = TestScenes.Build(TestScenes.Everything.Replace("SAMPLER", "sobol", StringComparison.Ordinal));

    // Bright enough that squares do not fit into 64 bits, and some sums are not finite.
    private static readonly Scene s_bright = TestScenes.Build(TestScenes.Everything.Replace("SAMPLER", "sobol", StringComparison.Ordinal)
        .Replace("\"skyblue\"", "[1e6, 3e38, 1e6]", StringComparison.Ordinal)
        .Replace("\"ambient\": [0.02, 0.02, 0.05]", "\"ambient\": [1e3, 3e38, 10]", StringComparison.Ordinal));

    [Theory]
    [InlineData(1, false)]
    [InlineData(3, false)]
    [InlineData(1, true)]
    [InlineData(3, true)]
    public void A_stop_in_any_pass_leaves_the_samples_of_those_before(int threads, bool isBright)
    {
        Scene scene = isBright ? s_bright : s_scene;
        foreach (int pass in new[] { 1, 2, 3, 4, 5 })
        {
            // The film holds other samples already, which stay.
            Film film = Of(scene, new(12, 16));
            RenderStatistics statistics = Stopped(scene, film, new() { TileSize = 8, Threads = threads, Samples = new(0, 12) }, pass);
            if (threads == 1)
            {
                Assert.Equal((true, pass == 1 ? 0 : 1 << (pass - 2)), (statistics.Cancelled, statistics.SamplesPerPixel));
            }

            int samples = statistics.SamplesPerPixel;
            Assert.Equal(samples < 12, statistics.Cancelled);
            Assert.Equal(samples * 48L * 32, statistics.Paths);
            Film expected = Of(scene, new(12, 16));
            expected.Merge(samples > 0 ? Of(scene, new(0, samples)) : new Film(48, 32));
            Assert.Equal(expected.ComputeHash(), film.ComputeHash());
        }
    }

    [Fact]
    public void A_bright_pass_after_a_dark_one_and_a_dark_one_after_it_are_taken_back_alike()
    {
        Film film = new(1, 1);
        SampleAccumulator accumulator = new(1);
        PassCell cell = new(new(0, 0, 1, 1));
        foreach (float value in new[] { 1f, 1e6f, float.NaN, 2f })
        {
            string before = film.ComputeHash();
            accumulator.Begin(film, new(0, 0, 1, 1), samples: 1);
            accumulator.Add(1, 0u, 0u, new(value, value, value));
            accumulator.End(cell: cell);
            string after = film.ComputeHash();
            cell.TakeBack(film, (0, 0, 1), 1, isOfHalf: false);
            Assert.Equal(before, film.ComputeHash());
            accumulator.End(cell: cell);
            Assert.Equal(after, film.ComputeHash());
        }

        cell.Free();
    }

    [Theory]
    [InlineData(1)]
    [InlineData(3)]
    public void Layers_of_light_are_taken_back_with_the_pass(int threads)
    {
        foreach (int pass in new[] { 1, 3, 5 })
        {
            Film film = new(48, 32);
            LightPathAovFilm layers = new(film, s_scene, Enum.GetValues<LightPathAov>());
            int samples = Stopped(s_scene, film, new() { TileSize = 8, Threads = threads, Layers = layers }, pass).SamplesPerPixel;
            LightPathAovFilm expected = new(film, s_scene, Enum.GetValues<LightPathAov>());
            if (samples > 0)
            {
                new RTracer(s_scene, new() { Layers = expected, Samples = new(0, samples) }).Render(new Film(48, 32));
            }

            Assert.All(Enumerable.Range(0, layers.Names.Count), i => Assert.Equal(expected.Content(i), layers.Content(i)));
        }
    }

    [Fact]
    public void Halves_of_the_samples_are_those_of_the_complete_passes_wherever_it_is_stopped()
    {
        foreach (int pass in new[] { 2, 3, 4, 6 })
        {
            Film film = new(48, 32, FilmPlane.Half);
            int samples = Stopped(s_scene, film, new() { TileSize = 8, Threads = 3 }, pass).SamplesPerPixel;
            Film whole = new(48, 32, FilmPlane.Half);
            new RTracer(s_scene, new() { Samples = new(0, Math.Max(samples, 1)) }).Render(whole);
            Assert.Equal(samples > 0 ? whole.ComputeHash() : new Film(48, 32, FilmPlane.Half).ComputeHash(), film.ComputeHash());
            Assert.Equal(samples * 48L * 32, film.TotalSamples);
        }
    }

    [Fact]
    public void Between_passes_the_film_is_whole_and_the_rendering_can_be_ended()
    {
        Film film = new(48, 32);
        List<(SampleRange Pass, string Hash)> seen = [];
        TimeSpan After(SampleRange pass)
        {
            seen.Add((pass, film.ComputeHash()));
            return pass.End == 8 ? TimeSpan.Zero : TimeSpan.FromHours(1);
        }

        RenderOptions options = new() { TileSize = 8, Threads = 3, AfterPass = After, ShortestPass = TimeSpan.Zero };
        RenderStatistics statistics = new RTracer(s_scene, options).Render(film);
        Assert.Equal((8, false), (statistics.SamplesPerPixel, statistics.Cancelled));
        Assert.Equal([new(0, 1), new(1, 2), new(2, 4), new(4, 8)], seen.Select(s => s.Pass));
        Assert.All(seen, s => Assert.Equal(Of(s_scene, new(0, s.Pass.End)).ComputeHash(), s.Hash));
    }

    [Fact]
    public void Passes_become_as_short_as_there_is_time_for()
    {
        List<int> passes = [];
        new RTracer(s_scene, new() { AfterPass = pass => Add(pass.Count) }).Render(new Film(48, 32));
        Assert.Equal(Enumerable.Repeat(1, 16), passes);

        TimeSpan Add(int count)
        {
            passes.Add(count);
            return TimeSpan.FromTicks(1);
        }
    }

    [Fact]
    public void Passes_that_are_quick_more_than_double_the_samples()
    {
        List<int> passes = [];
        new RTracer(s_scene, new() { AfterPass = pass => Add(pass.Count), ShortestPass = TimeSpan.FromHours(1) }).Render(new Film(48, 32));
        Assert.Equal([1, 15], passes);

        TimeSpan Add(int count)
        {
            passes.Add(count);
            return TimeSpan.FromHours(1);
        }
    }

    [Fact]
    public void No_pass_has_more_than_64_samples()
    {
        List<int> passes = [];
        Scene scene = TestScenes.Build(TestScenes.Everything.Replace("SAMPLER", "sobol", StringComparison.Ordinal)
            .Replace("\"samplesPerPixel\": 16", "\"samplesPerPixel\": 300", StringComparison.Ordinal));
        RenderOptions options = new() { Crop = new(0, 0, 4, 4), AfterPass = pass => Add(pass.Count), ShortestPass = TimeSpan.Zero };
        new RTracer(scene, options).Render(new Film(48, 32));
        Assert.Equal([1, 1, 2, 4, 8, 16, 32, 64, 64, 64, 44], passes);

        TimeSpan Add(int count)
        {
            passes.Add(count);
            return TimeSpan.FromHours(1);
        }
    }

    [Fact]
    public void A_thread_that_is_held_up_does_not_keep_others_from_later_passes()
    {
        using ManualResetEventSlim later = new();
        int held = 0;
        bool wasReached = false;
        Film film = new RTracer(s_scene, new() { TileSize = 8, Threads = 2, ShortestPass = TimeSpan.Zero }).Render(new Report(p =>
        {
            if (p.Pass >= 3)
            {
                later.Set();
            }
            else if (Interlocked.Exchange(ref held, 1) == 0)
            {
                wasReached = later.Wait(TimeSpan.FromMinutes(1));
            }
        })).Film;
        Assert.True(wasReached);
        Assert.Equal(Of(s_scene, new(0, 16)).ComputeHash(), film.ComputeHash());
    }

    [Fact]
    public void Samples_of_a_later_pass_wait_for_those_of_an_earlier_one()
    {
        // One thread is held up in the first pass. If the other came to the third one meanwhile, the stop there would take back the wrong
        // samples.
        using ManualResetEventSlim later = new();
        SceneBuilder builder = new((_, _) => throw new NotSupportedException());
        Scene scene = builder.Build(new()
        {
            Render = new() { Width = 48, Height = 32, SamplesPerPixel = 16, Integrator = Integrator.Report },
            Background = new(0.5f, 0.25f, 1),
            Shapes = [new SphereDescription { Material = new GateDescription { Gate = new(() => later.Wait(500)) } }],
        })!;
        Film film = new(48, 32);
        using CancellationTokenSource stop = new();
        int reports = 0;
        RenderOptions options = new() { TileSize = 8, Threads = 2, ShortestPass = TimeSpan.Zero };
        RenderStatistics statistics = new RTracer(scene, options).Render(film, new Report(p =>
        {
            if (p.Pass == 3 && Interlocked.Increment(ref reports) == 22)
            {
                stop.Cancel();
                later.Set();
            }
        }), stop.Token);
        later.Set();
        Assert.True(statistics.Cancelled);
        Assert.Equal(Of(scene, new(0, statistics.SamplesPerPixel)).ComputeHash(), film.ComputeHash());
    }

    private static Film Of(Scene scene, SampleRange samples)
    {
        Film film = new(scene.Render.Width, scene.Render.Height);
        new RTracer(scene, new() { Samples = samples }).Render(film);
        return film;
    }

    // Stops in the middle of a pass.
    private static RenderStatistics Stopped(Scene scene, Film film, RenderOptions options, int pass)
    {
        using CancellationTokenSource source = new();
        int reports = 0;
        return new RTracer(scene, options with { ShortestPass = TimeSpan.Zero }).Render(
            film, new Report(p => { if (p.Pass == pass && Interlocked.Increment(ref reports) == 5) { source.Cancel(); } }), source.Token);
    }

    private sealed record GateDescription : MaterialDescription
    {
        public required Lazy<bool> Gate { get; init; }

        public override Material Build(SceneBuilder builder) => new GateMaterial(Gate);
    }

    // Of the threads, only the first waits.
    private sealed class GateMaterial(Lazy<bool> gate) : Material
    {
        private int _passed;

        public override MaterialTraits Traits { get; } = new() { Specular = SpecularLobe.Delta };

        public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
        {
            if (Interlocked.Exchange(ref _passed, 1) == 0)
            {
                _ = gate.Value;
            }

            scatter.Direction = surface.Facing;
            scatter.Weight = Rgb.White;
            scatter.Specular = MaskW.All;
            scatter.Delta = MaskW.None;
            scatter.Absorbed = MaskW.None;
        }
    }

    private sealed class Report(Action<RenderProgress> action) : IProgress<RenderProgress>
    {
        void IProgress<RenderProgress>.Report(RenderProgress value) => action(value);
    }
}
