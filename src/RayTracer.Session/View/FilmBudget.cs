using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>Makes films only as large as there is memory for: a size that is mistyped must not take the machine down.</summary>
internal static class FilmBudget
{
    // Of the memory that there is, a film may take this part: copies are made for saving.
    private const int Part = 3;

    /// <summary>Makes a film.</summary>
    /// <exception cref="SessionException">It would be too large.</exception>
    public static Film Create(int width, int height, params IReadOnlyList<FilmPlane> planes)
    {
        long bytes = FilmMemory.Bytes(width, height, planes);
        if ((long)width * height > Film.MaxPixels || bytes > GC.GetGCMemoryInfo().TotalAvailableMemoryBytes / Part)
        {
            throw TooLarge(width, height, bytes, null);
        }

        try
        {
            return new(width, height, planes);
        }
        catch (OutOfMemoryException e)
        {
            throw TooLarge(width, height, bytes, e);
        }
    }

    private static SessionException TooLarge(int width, int height, long bytes, Exception? cause) =>
        new($"A picture of {width}×{height} pixels takes {bytes >> 20} MiB of memory, more than there is for it.", cause!);
}
