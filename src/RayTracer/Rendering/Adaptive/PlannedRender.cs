namespace RayTracer.Rendering;

/// <summary>
/// Renders a picture whose pixels have the numbers of samples that a plan says. Each pixel is what it is in a plain picture with that many
/// samples, to the bit.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="options">How to compute it.</param>
/// <param name="plan">The plan.</param>
public sealed class PlannedRender(Scene scene, RenderOptions options, SamplePlan plan)
{
    /// <summary>Renders.</summary>
    /// <param name="film">An empty film of the scene's size.</param>
    /// <param name="progress">Told how far the picture is, the plan's samples included; may be null.</param>
    /// <param name="cancellation">Ends the work after the pixels under way; all samples in the film are whole.</param>
    /// <returns>What was done for the picture and the plan.</returns>
    public RenderStatistics Render(Film film, IProgress<RenderProgress>? progress = null, CancellationToken cancellation = default)
    {
        PixelRenderer renderer = new(scene, options);
        ProgressSum done = new(plan.TotalSamples + plan.Statistics.Paths, progress, plan.Statistics.Paths, plan.Statistics.Rays);
        bool cancelled = false;
        try
        {
            int first = 0;
            foreach (int end in plan.Samples.Distinct().Order())
            {
                int[] pixels = Pixels(samples => samples >= end, film.Width);
                renderer.Render(film, pixels, pixels, new(first, end), (uint)scene.Render.Seed, done.Add, cancellation);
                first = end;
            }
        }
        catch (OperationCanceledException)
        {
            cancelled = true;
        }

        return plan.Add(renderer.Statistics) with { Cancelled = cancelled };
    }

    private int[] Pixels(Predicate<int> haveSamples, int width)
    {
        List<int> pixels = [];
        for (int i = 0; i < plan.Blocks.Count; i++)
        {
            Tile block = plan.Blocks[i];
            for (int pixel = 0; haveSamples(plan.Samples[i]) && pixel < block.Pixels; pixel++)
            {
                (int x, int y) = block.Pixel(pixel);
                pixels.Add((y * width) + x);
            }
        }

        return [.. pixels];
    }
}
