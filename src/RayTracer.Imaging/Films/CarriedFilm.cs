using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// Films in any file that carries one: film files (<see cref="FilmFile"/>), and OpenEXR images with the sums as layers
/// (<see cref="FilmExr"/>).
/// </summary>
internal static class CarriedFilm
{
    private static readonly Lock s_reading = new();

    /// <summary>Returns whether a file is named as a film, or is an image that carries one.</summary>
    public static bool Is(string path) => FilmFile.IsNamed(path) || FilmExr.Is(path);

    /// <inheritdoc cref="FilmFile.ReadHeader"/>
    public static FilmHeader ReadHeader(string path) => FilmExr.IsImage(path) ? FilmExr.ReadHeader(path) : FilmFile.ReadHeader(path);

    /// <inheritdoc cref="FilmFile.Read(string)"/>
    public static (FilmHeader Header, Film Film) Read(string path)
    {
        InputFiles.Add(path);
        return FilmExr.IsImage(path) ? FilmExr.Read(path) : FilmFile.Read(path);
    }

    /// <inheritdoc cref="FilmFile.AddTo"/>
    public static FilmHeader AddTo(string path, Film film, params Lock[] adding)
    {
        InputFiles.Add(path);
        if (!FilmExr.IsImage(path))
        {
            return FilmFile.AddTo(path, film, adding);
        }

        // One after another: each takes the memory of a film meanwhile.
        lock (s_reading)
        {
            (FilmHeader header, Film more) = FilmExr.Read(path);
            if ((more.Width, more.Height) != (film.Width, film.Height))
            {
                throw new ArgumentException($"it has {more.Width}×{more.Height} pixels, not {film.Width}×{film.Height}", nameof(film));
            }

            FilmFile.PlanesFor(film, header);
            Int128[] sums = new Int128[more.Width * (Film.BytesPerPixel / 16)];
            Int128[][] planes = [.. film.Planes.Select(p => new Int128[more.Width * p.Sums.Count])];
            uint[] counts = new uint[more.Width];
            for (int y = 0; y < more.Height; y++)
            {
                more.ReadSums(y, sums, counts);
                lock (adding.Length > 0 ? adding[y % adding.Length] : s_reading)
                {
                    film.AddSums(y, sums, counts);
                    for (int i = 0; i < planes.Length; i++)
                    {
                        more.ReadPlane(film.Planes[i], y, planes[i]);
                        film.AddPlane(film.Planes[i], y, planes[i]);
                    }
                }
            }

            return header;
        }
    }

    /// <summary>The header of a film that shall come to hold more samples than it does; null where there is no such film.</summary>
    /// <param name="path">The file.</param>
    public static FilmHeader? Unfinished(string path)
    {
        try
        {
            FilmHeader header = ReadHeader(path);
            return header.Samples.Count > 0 && !header.IsComplete ? header : null;
        }
        catch (PictureException)
        {
            // No film, or none that could be resumed.
            return null;
        }
    }
}
