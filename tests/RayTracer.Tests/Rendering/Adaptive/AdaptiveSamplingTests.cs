using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Tests.Rendering;

/// <summary>Covers `SamplePlanner`, `DecidingSamples` and `PlannedRender`.</summary>
[Trait("Category", "Thorough")]
public class AdaptiveSamplingTests
{
    // Left: an even sky. Right: lamps far smaller than pixels, so that independent samples differ much.
    private const string Lamps = """
        {
          "camera": { "projection": "orthographic", "position": [0, 0, 5], "lookAt": [0, 0, 0], "viewSize": 4 },
          "render": { "integrator": "report", "width": 32, "height": 16, "samplesPerPixel": 1024, "sampler": "independent", "seed": SEED },
          "background": [0.2, 0.2, 0.2],
          "shapes": [ { "type": "plane", "point": [2, 0, 0], "normal": [0, 0, 1], "size": [4, 4], "material":
            { "type": "luminaire", "multiplier": 1, "color": { "type": "checker", "scale": [64, 64], "even": [0, 0, 0], "odd": [2, 1, 4] } } } ]
        }
        """;

    private static readonly SampleGoal s_goal = new() { IsAdaptive = true, MeanSamples = 64, MostSamples = 1024 };

    [Theory]
    [InlineData(1, 1024)]
    [InlineData(2, 64)]
    [InlineData(5, 256)]
    public void Adaptive_films_are_the_same_to_the_bit_however_they_are_computed(int threads, int stream)
    {
        Scene scene = LampsWith(1);
        Film film = Render(scene, s_goal, new() { Threads = threads, StreamSize = stream }).Film;
        Assert.Equal(Render(scene, s_goal, new() { Threads = 1, StreamSize = 1000 }).Film.ComputeHash(), film.ComputeHash());
    }

    [Fact]
    public void Every_pixel_is_what_it_is_in_a_plain_picture_of_so_many_samples()
    {
        Scene scene = LampsWith(1);
        (Film film, SamplePlan plan) = Render(scene, s_goal);
        Assert.True(plan.Most >= 4 * plan.Fewest);
        foreach (int samples in plan.Samples.Distinct())
        {
            Film plain = new(film.Width, film.Height);
            new RTracer(scene, new() { Samples = new(0, samples) }).Render(plain);
            int compared = 0;
            for (int y = 0; y < film.Height; y++)
            {
                for (int x = 0; x < film.Width; x++)
                {
                    if (film.SampleCount(x, y) == samples)
                    {
                        Assert.Equal((plain.Mean(x, y), plain.SampleVariance(x, y)), (film.Mean(x, y), film.SampleVariance(x, y)));
                        compared++;
                    }
                }
            }

            Assert.True(compared > 0);
        }
    }

    [Fact]
    public void Samples_go_where_the_error_is_and_no_more_are_taken_than_there_may_be()
    {
        (Film film, SamplePlan plan) = Render(LampsWith(1), s_goal);
        Assert.Equal(plan.TotalSamples, film.TotalSamples);
        Assert.InRange(plan.TotalSamples + plan.Statistics.Paths, 0.8 * 64 * film.Width * film.Height, 64.0 * film.Width * film.Height);
        Assert.True(film.SampleCount(28, 8) >= 4 * film.SampleCount(3, 8));
        Assert.Equal((uint)plan.Most, Counts(film).Max());
        Assert.Equal((uint)plan.Fewest, Counts(film).Min());
    }

    [Fact]
    public void Expected_errors_are_those_that_pictures_have()
    {
        // The error of a mean of independent samples is known: half of each pixel of the right half shines.
        (Film film, SamplePlan plan) = Render(LampsWith(2), s_goal with { Error = 0.05, MeanSamples = 1024 });
        Assert.InRange(plan.Error, 0.04, 0.05);
        double sum = 0;
        double floor = ((3.5 / 3) + 0.2) / 20;
        for (int y = 0; y < film.Height; y++)
        {
            for (int x = film.Width / 2; x < film.Width; x++)
            {
                double relative = ((1 + 0.25 + 4) / 3 / film.SampleCount(x, y)) / ((3.5 / 3) + floor) / ((3.5 / 3) + floor);
                sum += relative;
            }
        }

        Assert.InRange(Math.Sqrt(sum / film.Width / film.Height) / plan.Error, 0.85, 1.15);
    }

    [Fact]
    public void A_noise_goal_without_adaptive_sampling_gives_the_plain_picture()
    {
        Scene scene = LampsWith(3);
        SamplePlan plan = new SamplePlanner(scene, new(), new() { Error = 0.1, MeanSamples = 1024, MostSamples = 1024 }).Plan();
        Assert.Equal(plan.Fewest, plan.Most);
        Assert.InRange(plan.Error, 0.05, 0.1);
        Film film = new(32, 16);
        new PlannedRender(scene, new(), plan).Render(film);
        Film plain = new(32, 16);
        new RTracer(scene, new() { Samples = new(0, plan.Most) }).Render(plain);
        Assert.Equal(plain.ComputeHash(), film.ComputeHash());
    }

    [Fact]
    public void The_noise_of_light_that_comes_from_the_lamps_counts()
    {
        SampleGoal goal = new() { Error = 0.08, MeanSamples = 4096, MostSamples = 4096 };
        SamplePlan plan = new SamplePlanner(LitFloor(1), new(), goal).Plan();
        Assert.InRange(plan.Most, 17, 4095);
        Film[] films = [.. Enumerable.Range(2, 2).Select(seed => new RTracer(LitFloor(seed), new() { Samples = new(0, plan.Most) }).Render().Film)];
        double mean = Pixels(films[0]).Average(p => p.Mean.G);
        double difference = Pixels(films[0]).Zip(Pixels(films[1]), (a, b) => ((double)a.Mean.G - b.Mean.G) / mean).Average(d => d * d);
        Assert.InRange(double.Sqrt(difference / 2) / 1.1 / plan.Error, 0.5, 1.8);
    }

    [Fact]
    public void Who_is_short_of_time_decides_by_the_first_look()
    {
        SampleGoal goal = new() { Error = 0.001, MeanSamples = 512, MostSamples = 512 };
        SamplePlan whole = new SamplePlanner(LampsWith(3), new(), goal).Plan();
        SamplePlan hasty = new SamplePlanner(LampsWith(3), new(), goal) { IsShortOfTime = () => true }.Plan();

        Assert.True(whole.Statistics.Paths >= 2 * hasty.Statistics.Paths, $"{whole.Statistics.Paths} and {hasty.Statistics.Paths} deciding paths");
        Assert.True(hasty.TotalSamples > 0);
    }

    [Theory]
    [InlineData(false)]
    [InlineData(true)]
    public void A_decision_that_was_broken_off_anywhere_is_gone_on_with(bool hasLight)
    {
        SampleGoal goal = new() { Error = 0.02, MeanSamples = 4096, MostSamples = 4096 };
        Scene scene = hasLight ? LitFloor(3) : LampsWith(3);
        SamplePlan plan = new SamplePlanner(scene, new(), goal).Plan();
        List<DecidingState> states = [];
        Assert.Equal(plan.Samples, new SamplePlanner(scene, new(), goal) { Keep = states.Add }.Plan().Samples);
        Assert.Equal([0, 8, 16], states.Select(s => s.Film.SampleCount(0, 0)).Distinct().Take(3).Select(n => (int)n));
        Assert.Contains(states, s => s.Samples < s.Target);
        foreach (DecidingState state in states)
        {
            SamplePlan resumed = new SamplePlanner(scene, new(), goal) { Begun = state }.Plan();
            Assert.Equal(plan.Samples, resumed.Samples);
            Assert.Equal(plan.Error, resumed.Error);
            Assert.Equal(plan.Statistics.Paths - (state.Samples * state.Film.Width), resumed.Statistics.Paths);
        }

        Assert.Throws<ArgumentException>(() => new SamplePlanner(scene, new(), goal) { Begun = new(new(1, 2), 8, 8) }.Plan());
    }

    [Fact]
    public void A_goal_out_of_reach_takes_all_samples_and_says_so()
    {
        SamplePlan plan = new SamplePlanner(LampsWith(3), new(), new() { Error = 0.001, MeanSamples = 32, MostSamples = 32 }).Plan();
        Assert.Equal((32, 32), (plan.Fewest, plan.Most));
        Assert.True(plan.Error > 0.01);
    }

    [Fact]
    public void Adaptive_pictures_are_expected_to_be_what_plain_ones_are()
    {
        // Pictures of one pixel, an eighth of which shines. Samples that decided on their own number would make it darker: where none of the first
        // meets a lamp, no more would be taken.
        int seeds = TestSettings.Scale(512, 4096);
        ImageSamples adaptive = new(1, 1);
        ImageSamples plain = new(1, 1);
        SampleGoal goal = new() { IsAdaptive = true, Error = 0.3, MeanSamples = 256, MostSamples = 1024 };
        HashSet<int> numbers = [];
        for (int i = 0; i < seeds; i++)
        {
            (Film film, SamplePlan plan) = Render(SinglePixel(1 + i), goal, new() { Threads = 1 });
            adaptive.Add(film);
            numbers.Add(plan.Most);
            plain.Add(new RTracer(SinglePixel(100001 + i), new() { Threads = 1, Samples = new(0, 128) }).Render().Film);
        }

        Assert.True(numbers.Count >= 4);
        BlockTest test = BlockTest.Compare(adaptive, plain);
        ErrorBudget.Transport.Check(test.P, $"adaptive sampling: {test}");
    }

    [Fact]
    public void A_cancelled_picture_has_as_many_samples_of_each_pixel_as_its_passes_came_to()
    {
        Scene scene = LampsWith(1);
        SamplePlan plan = new SamplePlanner(scene, new() { Threads = 1 }, s_goal).Plan();
        Film film = new(32, 16);
        using CancellationTokenSource source = new();
        RenderStatistics statistics = new PlannedRender(scene, new() { Threads = 1 }, plan).Render(film, new Watcher(source), source.Token);
        Assert.True(statistics.Cancelled);
        Assert.InRange(film.TotalSamples, 1, plan.TotalSamples - 1);
        Assert.NotEqual(plan.Most, statistics.SamplesPerPixel);
        Film whole = new(32, 16);
        new PlannedRender(scene, new(), plan.UpTo(statistics.SamplesPerPixel)).Render(whole);
        Assert.Equal(whole.ComputeHash(), film.ComputeHash());
    }

    private static (Film Film, SamplePlan Plan) Render(Scene scene, SampleGoal goal, RenderOptions? options = null)
    {
        options ??= new();
        SamplePlan plan = new SamplePlanner(scene, options, goal).Plan();
        Film film = new(scene.Render.Width, scene.Render.Height);
        RenderStatistics statistics = new PlannedRender(scene, options, plan).Render(film);
        Assert.Equal(plan.TotalSamples + plan.Statistics.Paths, statistics.Paths);
        return (film, plan);
    }

    private static IEnumerable<uint> Counts(Film film) => Pixels(film).Select(p => p.Samples);

    private static IEnumerable<(uint Samples, Rgb Mean)> Pixels(Film film) =>
        Enumerable.Range(0, film.Height).SelectMany(y => Enumerable.Range(0, film.Width).Select(x => (film.SampleCount(x, y), film.Mean(x, y))));

    // An evenly lit floor, whose light all comes from the lamp: the camera's paths find none.
    private static Scene LitFloor(int seed) => TestScenes.Build($$"""
        {
          "camera": { "projection": "orthographic", "position": [0, 5, 0], "lookAt": [0, 0, 0], "up": [0, 0, 1], "viewSize": 1 },
          "render": { "integrator": "light", "width": 32, "height": 16, "samplesPerPixel": 4096, "sampler": "independent", "seed": {{seed + (TestSettings.Seed * 1_000_000L)}} },
          "shapes": [ { "type": "disk", "center": [0, 0, 0], "normal": [0, 1, 0], "radius": 1.2, "material": { "type": "diffuse", "color": [0.5, 0.5, 0.5] } } ],
          "lights": [ { "type": "directional", "direction": [0, -1, 0], "irradiance": [2, 2, 2] } ]
        }
        """);

    private static Scene LampsWith(int seed) => TestScenes.Build(Lamps.Replace("SEED", $"{seed + (TestSettings.Seed * 1_000_000L)}", StringComparison.Ordinal));

    private static Scene SinglePixel(int seed) => TestScenes.Build($$"""
        {
          "camera": { "projection": "orthographic", "position": [0, 0, 5], "lookAt": [0, 0, 0], "viewSize": 4 },
          "render": { "integrator": "report", "width": 1, "height": 1, "samplesPerPixel": 1024, "sampler": "independent", "seed": {{seed + (TestSettings.Seed * 1_000_000L)}} },
          "shapes": [ { "type": "plane", "point": [0, 0, 0], "normal": [0, 0, 1], "size": [4, 4], "material": { "type": "luminaire", "multiplier": 1, "color":
            { "type": "checker", "scale": [2, 2], "even": [0, 0, 0], "odd": { "type": "checker", "scale": [4, 4], "even": [0, 0, 0], "odd":
              { "type": "checker", "scale": [8, 8], "even": [0, 0, 0], "odd": [1, 1, 1] } } } } } ]
        }
        """);

    private sealed class Watcher(CancellationTokenSource source) : IProgress<RenderProgress>
    {
        public void Report(RenderProgress value)
        {
            if (value.Fraction > 0.5)
            {
                source.Cancel();
            }
        }
    }
}
