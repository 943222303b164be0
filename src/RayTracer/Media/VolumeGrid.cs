using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>
/// Numbers at the points of a regular grid that fills a box: of one channel, of red, green and blue, or of the six of a symmetric matrix. Point i of n along an axis stands at (i + ½)/n of the
/// box.
/// </summary>
public sealed class VolumeGrid
{
    /// <summary>The most points along an axis.</summary>
    public const int MostPoints = 4096;

    /// <summary>The most numbers of a grid.</summary>
    public const long MostNumbers = 1L << 30;

    /// <summary>Makes a grid.</summary>
    /// <param name="width">Points along x.</param>
    /// <param name="height">Points along y.</param>
    /// <param name="depth">Points along z.</param>
    /// <param name="channels">1; 3 for red, green and blue; or 6 for xx, yy, zz, xy, xz and yz of a symmetric matrix.</param>
    /// <param name="values">The numbers, at least 0 but for matrices: channel by channel of each point, and points along x first, then y, then z.</param>
    /// <exception cref="ArgumentException">A size out of range, another count of numbers, or a number that is negative or none.</exception>
    public VolumeGrid(int width, int height, int depth, int channels, ReadOnlySpan<float> values)
    {
        if (SizeComplaint(width, height, depth, channels) is { } complaint)
        {
            throw new ArgumentException(complaint);
        }

        (Width, Height, Depth, Channels) = (width, height, depth, channels);
        if (values.Length != Numbers)
        {
            throw new ArgumentException($"A grid of {width}×{height}×{depth} points with {channels} channels needs {Numbers} numbers, not {values.Length}.", nameof(values));
        }

        foreach (float value in values)
        {
            if (!(value < float.PositiveInfinity && value >= (channels == 6 ? float.MinValue : 0)))
            {
                throw new ArgumentException($"it has the number {value}, but none may be {(channels == 6 ? "" : "negative or ")}infinite", nameof(values));
            }
        }

        Memory = new(Numbers);
        unsafe
        {
            values.CopyTo(new Span<float>(Memory.Pointer, values.Length));
        }
    }

    /// <summary>Points along x.</summary>
    public int Width { get; }

    /// <summary>Points along y.</summary>
    public int Height { get; }

    /// <summary>Points along z.</summary>
    public int Depth { get; }

    /// <summary>1, 3 for red, green and blue, or 6 for a symmetric matrix.</summary>
    public int Channels { get; }

    /// <summary>The map from the unit cube to the box that the file names; null where it names none.</summary>
    public Transform? Place { get; init; }

    /// <summary>The count of all numbers.</summary>
    public long Numbers => (long)Width * Height * Depth * Channels;

    /// <summary>The numbers, in the order in which they were given.</summary>
    public unsafe ReadOnlySpan<float> Values => new(Memory.Pointer, (int)Numbers);

    internal PinnedBuffer<float> Memory { get; }

    /// <summary>Says why there can be no grid of a size; null where there can.</summary>
    public static string? SizeComplaint(long width, long height, long depth, long channels)
    {
        bool isPossible = width is >= 1 and <= MostPoints && height is >= 1 and <= MostPoints && depth is >= 1 and <= MostPoints;
        return !isPossible ? $"a grid has from 1 to {MostPoints} points along each axis, not {width}×{height}×{depth}"
            : channels is not (1 or 3 or 6) ? $"a grid has 1, 3 or 6 channels, not {channels}"
            : width * height * depth * channels > MostNumbers ? $"a grid has at most {MostNumbers:N0} numbers, not {width * height * depth * channels:N0}"
            : null;
    }
}

/// <summary>A file of a grid that cannot be read; the message says what is wrong, for the user.</summary>
public sealed class VolumeException : Exception
{
    /// <summary>Says what is wrong.</summary>
    public VolumeException(string message) : base(message)
    {
    }

    /// <summary>Says what is wrong, and what caused it.</summary>
    public VolumeException(string message, Exception innerException) : base(message, innerException)
    {
    }

    /// <summary>An unnamed fault.</summary>
    public VolumeException()
    {
    }
}
