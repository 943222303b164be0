using System.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Finds out how many samples the pixels of a picture shall have, before it is rendered, from <see cref="DecidingSamples"/>: they are
/// doubled wherever several times as many seem to be wanted as there are. docs/adaptive-sampling.md tells why so, and what it gains.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="options">The options of the computation; the crop is the part that counts.</param>
/// <param name="goal">The goal.</param>
public sealed class SamplePlanner(Scene scene, RenderOptions options, SampleGoal goal)
{
    private const int BlockEdge = 8;
    private const int AdaptiveCell = 2;
    private const int EvenCell = 4;
    private const int MostFirstSamples = 16;

    // How many times their own number deciding samples may foretell.
    private const int AdaptiveLead = 4;
    private const int EvenLead = 2;
    private readonly PixelRenderer _renderer = new(scene, options);

    /// <summary>
    /// Says whether time is so short that what was found so far must do, asked before deciding samples are doubled; null where there is
    /// time enough.
    /// </summary>
    public Func<bool>? IsShortOfTime { get; init; }

    /// <summary>The state to continue from; null to start from scratch. Not for adaptive pictures.</summary>
    public DecidingState? Begun { get; init; }

    /// <summary>
    /// Receives the progress of the decision, on the deciding thread; may be null. Not for adaptive pictures. What is reported has no
    /// part in the decision.
    /// </summary>
    public Action<DecidingState>? Keep { get; init; }

    /// <summary>Decides.</summary>
    /// <param name="progress">Told how far the picture is, of which this is the first part; may be null.</param>
    /// <param name="cancellation">Ends the work.</param>
    /// <exception cref="OperationCanceledException">It was cancelled.</exception>
    /// <exception cref="ArgumentException"><see cref="Begun"/> is of another picture.</exception>
    public SamplePlan Plan(IProgress<RenderProgress>? progress = null, CancellationToken cancellation = default)
    {
        Tile area = options.Crop ?? new(0, 0, scene.Render.Width, scene.Render.Height);
        Tile[] blocks = Tile.Cut(area, BlockEdge);
        int columns = ((area.Width - 1) / BlockEdge) + 1;

        // Samples that go where they are wanted are the camera's alone.
        IReadOnlyList<FilmPlane> planes = goal.IsAdaptive ? [] : FilmPlane.Needed(scene.Render.Integrator);
        DecidingSamples deciding = new(scene, blocks, goal.IsAdaptive ? AdaptiveCell : EvenCell, planes) { Keep = goal.IsAdaptive ? null : Keep };
        double budget = (double)goal.MeanSamples * area.Pixels;
        ProgressSum done = new(goal.Error is null ? (long)budget : 0, progress);
        int lead = goal.IsAdaptive ? AdaptiveLead : EvenLead;
        int first = FirstSamples();
        SampleAllocation allocation = new([.. blocks.Select(b => (double)b.Pixels)], goal, Math.Min(goal.MeanSamples, first));
        int[] all = [.. Enumerable.Range(0, blocks.Length)];
        if (Begun is not null)
        {
            deciding.Restore(Begun);
        }

        int level = Begun?.Target ?? (first / 2);
        deciding.Advance(_renderer, all, level, done.Add, cancellation);
        if (level < first)
        {
            deciding.Advance(_renderer, all, first, done.Add, cancellation);
        }

        while (true)
        {
            double[] variances = RelativeVariances(blocks, deciding);

            // One number of samples for all: what a single block of their mean variance would get.
            double[] deviations = goal.IsAdaptive ? Deviations(variances, columns) : [.. Enumerable.Repeat(double.Sqrt(allocation.Mean(variances)), blocks.Length)];

            // For one number of samples for all pixels, the budget is the picture's alone.
            int[] samples = allocation.Share(variances, deviations, goal.IsAdaptive ? budget - deciding.Total : budget);
            if (goal.Error is not null)
            {
                // The error falls with the root of the number of samples: what is expected of the picture, with those that decide.
                double picture = blocks.Select((b, i) => (double)b.Pixels * samples[i]).Sum();
                done.Expect((long)Math.Min(picture, budget) + deciding.Total);
            }

            ILookup<int, int> wanting = all.Where(i => samples[i] > lead * deciding.Level(i)).ToLookup(deciding.Level);
            if (wanting.Count == 0 || IsShortOfTime?.Invoke() == true)
            {
                return new(area, blocks, samples, double.Sqrt(allocation.Error(variances, samples)), _renderer.Statistics);
            }

            foreach (IGrouping<int, int> same in wanting.OrderBy(l => l.Key))
            {
                deciding.Advance(_renderer, [.. same], 2 * same.Key, done.Add, cancellation);
            }
        }
    }

    // A power of two, of which no more than a fourth goes into the first look.
    private int FirstSamples() => Math.Clamp(1 << BitOperations.Log2((uint)Math.Max(1, goal.MeanSamples / 4)), 2, MostFirstSamples);

    private static double[] RelativeVariances(Tile[] blocks, DecidingSamples deciding)
    {
        (double Brightness, double Variance)[] estimates = [.. blocks.Select((_, i) => deciding.Estimate(i))];
        double light = 0;
        double pixels = 0;
        for (int i = 0; i < blocks.Length; i++)
        {
            light += blocks[i].Pixels * Math.Max(0, estimates[i].Brightness);
            pixels += blocks[i].Pixels;
        }

        // Filters with negative lobes may make the dark negative.
        double floor = light / pixels / 10;
        return [.. estimates.Select(e => e.Variance == 0 ? 0 : Relative(e.Variance, Math.Max(0, e.Brightness) + floor))];

        static double Relative(double variance, double brightness) => variance / (brightness * brightness);
    }

    // What neighbours found counts too where it is more: rare bright paths are met in some of them at first.
    private static double[] Deviations(double[] variances, int columns)
    {
        int rows = variances.Length / columns;
        double[] deviations = new double[variances.Length];
        for (int i = 0; i < variances.Length; i++)
        {
            (int y, int x) = int.DivRem(i, columns);
            double sum = 0;
            int count = 0;
            for (int v = Math.Max(0, y - 1); v <= Math.Min(rows - 1, y + 1); v++)
            {
                for (int u = Math.Max(0, x - 1); u <= Math.Min(columns - 1, x + 1); u++, count++)
                {
                    sum += variances[(v * columns) + u];
                }
            }

            deviations[i] = double.Sqrt(Math.Max(variances[i], sum / count));
        }

        return deviations;
    }
}

/// <summary>
/// The progress of <see cref="SamplePlanner"/> in rendering the samples that decide, for pictures whose pixels all get the same number: it
/// can be resumed from there.
/// </summary>
/// <param name="Film">
/// A column for each deciding pixel. In the upper row, its samples when it was last decided that more are needed; in the lower row, all
/// that there are since.
/// </param>
/// <param name="Samples">The number of samples of each pixel in the lower row, those that came to no finite number included.</param>
/// <param name="Target">Their number when it is decided again.</param>
public sealed record DecidingState(Film Film, int Samples, int Target);
