using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Films (<see cref="FilmFile"/>), of which the picture is read; none is written to them.</summary>
public sealed class FilmFormat : ImageFormat
{
    /// <inheritdoc/>
    public override string Name => "film";

    /// <inheritdoc/>
    public override string FileName => "a film";

    /// <inheritdoc/>
    public override IReadOnlyList<string> Extensions => [];

    /// <inheritdoc/>
    public override bool Matches(ReadOnlySpan<byte> head) => head.StartsWith(FilmFile.Signature);

    /// <inheritdoc/>
    public override Picture Read(ReadOnlySpan<byte> file, bool raw)
    {
        using MemoryStream stream = new(file.ToArray(), writable: false);
        Film film = FilmFile.Read(stream).Film;
        float[] pixels = new float[checked(3L * film.Width * film.Height)];
        for (int y = 0; y < film.Height; y++)
        {
            film.ReadRow(y, pixels.AsSpan(3 * film.Width * y, 3 * film.Width));
        }

        return new(film.Width, film.Height, pixels);
    }
}
