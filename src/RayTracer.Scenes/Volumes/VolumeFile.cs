using RayTracer.Description;
using RayTracer.Media;

namespace RayTracer.Scenes;

/// <summary>Reads files of grids, by their extensions: those of Mitsuba, NanoVDB, and nothing but numbers.</summary>
public static class VolumeFile
{
    // The most that a file may hold, so that its numbers fit in one array.
    private const long MostBytes = (4 * VolumeGrid.MostNumbers) + (64L << 20);

    private static readonly Dictionary<string, GridFormat> s_formats =
        new(StringComparer.OrdinalIgnoreCase) { [".vol"] = GridFormat.Vol, [".nvdb"] = GridFormat.NanoVdb, [".raw"] = GridFormat.Raw };

    /// <summary>True where a path has an extension of grids; files of any other one are read as numbers, too.</summary>
    public static bool IsNamed(string path) => s_formats.ContainsKey(Path.GetExtension(path));

    /// <summary>Reads a grid.</summary>
    /// <param name="path">The file's path.</param>
    /// <param name="description">Which grid it is, and of a file without a header, its size.</param>
    /// <exception cref="VolumeException">Something is wrong with the file.</exception>
    /// <exception cref="IOException">It cannot be opened.</exception>
    public static VolumeGrid Read(string path, GridDescription description) =>
        Read(Bytes(path), s_formats.GetValueOrDefault(Path.GetExtension(path), GridFormat.Raw), description);

    private static byte[] Bytes(string path)
    {
        using FileStream stream = File.OpenRead(path);
        if (stream.Length > MostBytes)
        {
            throw new VolumeException($"it has {stream.Length:N0} bytes, but at most {MostBytes:N0} are read");
        }

        if (SceneBudget.Open?.TakeWork("a grid", stream.Length, stream.Length) is { } tooMuch)
        {
            throw new VolumeException(tooMuch);
        }

        if (stream.Length > Array.MaxLength)
        {
            throw new VolumeException($"it has {stream.Length:N0} bytes, but at most {Array.MaxLength:N0} are read");
        }

        byte[] bytes = new byte[stream.Length];
        stream.ReadExactly(bytes);
        return bytes;
    }

    /// <summary>True where a file is one of NanoVDB's that has a grid of floats of a name; false also where it cannot be read, which <see cref="Read(string, GridDescription)"/> reports.</summary>
    /// <param name="path">The file's path.</param>
    /// <param name="name">The name.</param>
    public static bool Has(string path, string name)
    {
        try
        {
            return NanoVdbReader.Has(Bytes(path), name);
        }
        catch (Exception e) when (e is VolumeException or IOException or UnauthorizedAccessException)
        {
            return false;
        }
    }

    /// <summary>Reads a grid from the bytes of a file.</summary>
    internal static VolumeGrid Read(ReadOnlySpan<byte> bytes, GridFormat format, GridDescription description)
    {
        if (format != GridFormat.Raw && description.Size.Count > 0)
        {
            throw new VolumeException("the file says its size itself: leave out \"size\"");
        }

        return format switch
        {
            GridFormat.Vol => VolReader.Read(bytes),
            GridFormat.NanoVdb => NanoVdbReader.Read(bytes, description.Name),
            _ => RawGridReader.Read(bytes, description),
        };
    }

    /// <summary>Makes a grid of numbers that a file has.</summary>
    internal static VolumeGrid Grid((long X, long Y, long Z) size, long channels, ReadOnlySpan<float> values, Numerics.Transform? place = null)
    {
        try
        {
            return new((int)size.X, (int)size.Y, (int)size.Z, (int)channels, values) { Place = place };
        }
        catch (ArgumentException e)
        {
            throw new VolumeException(e.Message.Split(" (Parameter", StringSplitOptions.None)[0], e);
        }
    }

    /// <summary>Checks a size that a file says, and counts its memory, before it is taken.</summary>
    internal static void Check((long X, long Y, long Z) size, long channels)
    {
        string? complaint = VolumeGrid.SizeComplaint(size.X, size.Y, size.Z, channels)
            ?? SceneBudget.Open?.Take($"a grid of {size.X}×{size.Y}×{size.Z} points", 2 * sizeof(float) * size.X * size.Y * size.Z * channels, 0);
        if (complaint is not null)
        {
            throw new VolumeException(complaint);
        }
    }
}

/// <summary>The formats of grids.</summary>
internal enum GridFormat
{
    /// <summary>Nothing but numbers.</summary>
    Raw,

    /// <summary>Mitsuba's.</summary>
    Vol,

    /// <summary>NanoVDB's.</summary>
    NanoVdb,
}
