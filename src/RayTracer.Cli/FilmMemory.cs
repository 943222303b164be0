using System.Globalization;

namespace RayTracer.Cli;

/// <summary>How much memory films take.</summary>
internal static class FilmMemory
{
    // Four exact sums of 16 bytes, and a count of 4.
    private const long BytesPerPixel = (4 * 16) + 4;

    /// <summary>The largest number of pixels: the sums are in one array.</summary>
    public static long MaxPixels => Array.MaxLength / 4;

    /// <summary>Memory of a film in bytes.</summary>
    public static long Bytes(int width, int height) => BytesPerPixel * width * height;

    /// <summary>A number of bytes for people.</summary>
    public static string Text(long bytes)
    {
        string[] units = ["bytes", "KiB", "MiB", "GiB", "TiB"];
        double value = bytes;
        int unit = 0;
        for (; value >= 1024 && unit < units.Length - 1; unit++)
        {
            value /= 1024;
        }

        return string.Create(CultureInfo.InvariantCulture, $"{value:0.#} {units[unit]}");
    }
}
