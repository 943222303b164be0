using System.Globalization;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>The memory that films take.</summary>
public static class FilmMemory
{
    /// <summary>Memory of a film in bytes.</summary>
    /// <param name="width">Width in pixels.</param>
    /// <param name="height">Height in pixels.</param>
    /// <param name="planes">The planes beside its picture.</param>
    public static long Bytes(int width, int height, params IReadOnlyList<FilmPlane> planes) =>
        (Film.BytesPerPixel + (16L * planes.Sum(p => p.Sums.Count))) * width * height;

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
