namespace RayTracer.Rendering;

/// <summary>
/// Renders a picture whose pixels have the numbers of samples that a plan says, in passes as <see cref="RTracer"/>. Each pixel is what it
/// is in a plain picture with that many samples, to the bit.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="options">The options of the computation.</param>
/// <param name="plan">The plan.</param>
public sealed class PlannedRender(Scene scene, RenderOptions options, SamplePlan plan)
{
    /// <summary>Renders.</summary>
    /// <param name="film">An empty film of the scene's size.</param>
    /// <param name="progress">Takes how far the picture is, the plan's samples included; may be null.</param>
    /// <param name="cancellation">Ends the work after the pixels under way. The film has the samples of all complete passes then: as many
    /// of each pixel as that comes to (<see cref="RenderStatistics.SamplesPerPixel"/>), or as the plan says where that is less.</param>
    /// <returns>What was done for the picture and the plan.</returns>
    public RenderStatistics Render(Film film, IProgress<RenderProgress>? progress = null, CancellationToken cancellation = default)
    {
        int threads = options.Threads > 0 ? options.Threads : Environment.ProcessorCount;
        PassCell cell = new(new(0, 0, film.Width, film.Height));
        PassLoop loop = new(scene, options, film, [cell], pass => Cut(cell, pass, threads))
        {
            Threads = threads,
            LargestItem = PixelRenderer.LargestList,
            TotalPaths = plan.TotalSamples + plan.Statistics.Paths,
            Before = plan.Statistics,
        };
        return plan.Add(loop.Render(new(0, plan.Most), progress, cancellation));
    }

    // Pixels that get the same number of samples go together.
    private List<PassItem> Cut(PassCell cell, SampleRange pass, int threads)
    {
        List<PassItem> items = [];
        foreach (int end in plan.Samples.Where(s => s > pass.First).Select(s => Math.Min(s, pass.End)).Distinct().Order())
        {
            SampleRange samples = new(pass.First, end);
            int[] pixels = Pixels(count => Math.Min(count, pass.End) == end, cell.Area.Width);
            int length = PixelRenderer.ListLength(pixels.Length, samples.Count, threads);
            for (int first = 0; first < pixels.Length; first += length)
            {
                items.Add(new(cell, default, pixels.AsMemory(first, Math.Min(length, pixels.Length - first)), samples));
            }
        }

        return items;
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
