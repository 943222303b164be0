using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Cli;

/// <summary>Which samples of a picture a command renders: all, a range of them (<c>--samples</c>), or one of several equal parts (<c>--part</c>).</summary>
internal static class SampleShares
{
    /// <summary>Reads a range with its last sample: 0..63.</summary>
    /// <exception cref="FormatException">It is none.</exception>
    public static SampleRange? Range(string word) =>
        word.Split("..") is [var first, var last] && int.TryParse(first, out int from) && int.TryParse(last, out int to) && from >= 0 && to >= from && to < int.MaxValue
            ? new(from, to + 1)
            : throw new FormatException("expected the first and the last sample, as in 0..63");

    /// <summary>Reads a part, from 1: 3/16.</summary>
    /// <exception cref="FormatException">It is none.</exception>
    public static (int Number, int Count)? Part(string word) =>
        word.Split('/') is [var first, var last] && int.TryParse(first, out int number) && int.TryParse(last, out int count) && number >= 1 && count >= number
            ? (number, count)
            : throw new FormatException("expected which part of how many, from 1, as in 3/16");

    /// <summary>The samples to render.</summary>
    /// <exception cref="CommandException">The picture has no such samples.</exception>
    public static SampleRange Of(RenderRequest request, RenderDescription render)
    {
        int total = render.SamplesPerPixel;
        if (request.Samples is { } range)
        {
            return range.End <= total ? range : throw new CommandException(
                ExitStatus.Usage, $"--samples {FilmHeader.Text(range)}: the pixels have only samples 0 to {total - 1} (--spp)");
        }

        if (request.Part is not { } part)
        {
            return new(0, total);
        }

        return part.Count <= total
            ? new((int)((part.Number - 1L) * total / part.Count), (int)((long)part.Number * total / part.Count))
            : throw new CommandException(ExitStatus.Usage, $"--part {part.Number}/{part.Count}: {total} samples make at most {total} parts");
    }
}
