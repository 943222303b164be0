using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>Which samples of a picture a job renders: all, a range of them (<c>--samples</c>), or one of several equal parts (<c>--part</c>).</summary>
public static class Shares
{
    /// <summary>The samples to render.</summary>
    /// <exception cref="JobException">The picture has no such samples.</exception>
    public static SampleRange Of(RenderJob job, RenderDescription render)
    {
        int total = render.SamplesPerPixel;
        if (job.Samples is { } range)
        {
            return range.End <= total ? range
                : throw new JobException(JobFault.Request, $"--samples {FilmHeader.Text(range)}: the pixels have only samples 0 to {total - 1} (--spp)");
        }

        if (job.Part is not { } part)
        {
            return new(0, total);
        }

        return part.Count <= total
            ? Part(part.Number, part.Count, total)
            : throw new JobException(JobFault.Request, $"--part {part.Number}/{part.Count}: {total} samples make at most {total} parts");
    }

    /// <summary>One of several equal parts of some samples.</summary>
    /// <param name="number">Which, from 1.</param>
    /// <param name="count">Of how many.</param>
    /// <param name="total">How many samples there are.</param>
    public static SampleRange Part(int number, int count, int total) => new((int)((number - 1L) * total / count), (int)((long)number * total / count));
}
