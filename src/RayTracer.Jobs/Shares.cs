using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>
/// The part of a picture that a job renders: all pixels or a rectangle of them; all samples, a range of them (<c>--samples</c>), or one of
/// several equal
/// parts (<c>--part</c>).
/// </summary>
internal static class Shares
{
    /// <summary>The samples to render.</summary>
    /// <exception cref="JobException">The picture has no such samples.</exception>
    public static SampleRange Of(RenderJob job, RenderDescription render)
    {
        int total = render.SamplesPerPixel;
        if (job.Samples is { } range)
        {
            return range.End <= total ? range
                : throw new JobException(
                    JobFault.Request, $"--samples {FilmHeader.Text(range)}: the pixels have only samples 0 to {total - 1} (--spp)");
        }

        if (job.Part is not { } part)
        {
            return new(0, total);
        }

        return part.Count <= total
            ? Part(part.Number, part.Count, total)
            : throw new JobException(JobFault.Request, $"--part {part.Number}/{part.Count}: {total} samples make at most {total} parts");
    }

    /// <summary>Returns how a job's part of the picture is computed.</summary>
    /// <exception cref="JobException">The picture has no such pixels or samples.</exception>
    internal static RenderOptions Options(RenderJob job, RenderDescription render)
    {
        if (job.Pixel is { } p && (p.X >= render.Width || p.Y >= render.Height))
        {
            throw Misplaced($"--pixel {p.X},{p.Y}", render);
        }

        if (job.Crop is { } c && (c.Width < 1 || c.Height < 1 || c.X > render.Width - c.Width || c.Y > render.Height - c.Height))
        {
            throw Misplaced($"--crop {c.X},{c.Y},{c.Width},{c.Height}", render);
        }

        if (job.Sample >= render.SamplesPerPixel)
        {
            throw new JobException(
                JobFault.Request, $"--sample {job.Sample}: the pixels have only samples 0 to {render.SamplesPerPixel - 1}");
        }

        return new()
        {
            Threads = job.Threads,
            Crop = job.Pixel is var (x, y) ? new(x, y, 1, 1) : job.Crop,
            Samples = job.Sample is { } sample ? new(sample, sample + 1) : Of(job, render),
        };
    }

    private static JobException Misplaced(string option, RenderDescription render) =>
        new(JobFault.Request, $"{option}: is not within the picture of {render.Width}×{render.Height} pixels");

    /// <summary>One of several equal parts of some samples.</summary>
    public static SampleRange Part(int number, int count, int total) =>
        new((int)((number - 1L) * total / count), (int)((long)number * total / count));
}
