using System.Globalization;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Jobs;

/// <summary>Frames of an animation: 7, 0..239 or, every second one, 0..239:2.</summary>
/// <param name="First">The first.</param>
/// <param name="Last">The last may be less than a step before it.</param>
/// <param name="Step">The distance from one frame to the next.</param>
public sealed record FrameRange(int First, int Last, int Step)
{
    private const int Largest = 9_999_999;

    /// <summary>The number of frames.</summary>
    public int Count => ((Last - First) / Step) + 1;

    /// <summary>The frames in their order.</summary>
    public IEnumerable<int> Numbers => Enumerable.Range(0, Count).Select(i => First + (i * Step));

    /// <summary>A file's name with a frame's number in place of its last signs #, with zeros before it.</summary>
    public static string Name(string pattern, int frame)
    {
        int end = pattern.LastIndexOf('#') + 1;
        int first = end;
        while (first > 0 && pattern[first - 1] == '#')
        {
            first--;
        }

        return end == 0 ? pattern
            : pattern[..first] + frame.ToString(CultureInfo.InvariantCulture).PadLeft(end - first, '0') + pattern[end..];
    }

    /// <summary>As it is typed.</summary>
    public override string ToString() => First == Last ? $"{First}" : Step == 1 ? $"{First}..{Last}" : $"{First}..{Last}:{Step}";

    /// <summary>Reads what <see cref="ToString"/> writes.</summary>
    /// <exception cref="FormatException">It is none.</exception>
    public static FrameRange Parse(string word)
    {
        string[] parts = word.Split(':');
        string[] ends = parts[0].Split("..");
        int step = 1;
        bool good = parts.Length <= 2 && ends.Length <= 2 && int.TryParse(ends[0], NumberStyles.None, CultureInfo.InvariantCulture, out _)
            && (parts.Length == 1 || (int.TryParse(parts[1], NumberStyles.None, CultureInfo.InvariantCulture, out step) && step > 0));
        if (!good || !int.TryParse(ends[0], NumberStyles.None, CultureInfo.InvariantCulture, out int first)
            || !int.TryParse(ends[^1], NumberStyles.None, CultureInfo.InvariantCulture, out int last) || last < first)
        {
            throw new FormatException($"expected frames, from 0, as in 7, 0..239 or 0..239:2, not {Quotation.Of(word)}");
        }

        return last <= Largest ? new(first, last, step)
            : throw new FormatException($"frames are numbered up to {Largest}, but {last} is larger");
    }
}
