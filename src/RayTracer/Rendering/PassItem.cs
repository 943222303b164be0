namespace RayTracer.Rendering;

/// <summary>A piece of a pass, which one thread renders.</summary>
/// <param name="cell">The cell that its pixels are in.</param>
/// <param name="tile">The pixels, unless there are single ones.</param>
/// <param name="pixels">The numbers of single pixels; nothing for those of the tile.</param>
/// <param name="samples">The samples of each pixel.</param>
internal sealed class PassItem(PassCell cell, Tile tile, ReadOnlyMemory<int> pixels, SampleRange samples)
{
    // Of the passes before.
    private readonly long _needed = cell.Planned;

    /// <summary>The number of pixels.</summary>
    public int Pixels => pixels.IsEmpty ? tile.Pixels : pixels.Length;

    /// <summary>The number of paths.</summary>
    public long Paths => (long)Pixels * samples.Count;

    /// <summary>True once the samples of all passes before have been handed over.</summary>
    public bool IsNext => cell.Has(_needed);

    /// <summary>Counts the pixels to those that will be handed over, when the pass has been cut.</summary>
    public void Plan() => cell.Planned += Pixels;

    /// <summary>Follows the paths.</summary>
    /// <exception cref="RenderFailedException">Something was thrown meanwhile, such as by a class of a plug-in.</exception>
    public void Follow(Wavefront worker, Film film, uint seed)
    {
        try
        {
            if (pixels.IsEmpty)
            {
                worker.Follow(film, tile, samples);
            }
            else
            {
                worker.Follow(film, pixels.Span, pixels, samples, seed);
            }
        }
        catch (Exception e)
        {
            throw new RenderFailedException(pixels.IsEmpty ? tile : Tile.Around(pixels.Span, film.Width), samples, e);
        }
    }

    /// <summary>Hands over what has been followed.</summary>
    /// <param name="worker">Has it.</param>
    /// <param name="isOfHalf">True if it is of <see cref="FilmPlane.Half"/>, and the film has that.</param>
    public void HandOver(Wavefront worker, bool isOfHalf)
    {
        worker.Accumulator.End(isOfHalf, cell);
        cell.Count(Pixels);
    }

    /// <summary>Takes back what was handed over.</summary>
    /// <param name="film">The film that it was handed over to.</param>
    /// <param name="isOfHalf">True if it is of <see cref="FilmPlane.Half"/>.</param>
    public void TakeBack(Film film, bool isOfHalf)
    {
        (int X, int Y, int Length) run;
        for (int pixel = 0; pixel < Pixels; pixel += run.Length)
        {
            run = PixelRuns.At(pixel, tile, pixels.Span, film.Width);
            cell.TakeBack(film, run, samples.Count, isOfHalf);
        }
    }

    /// <summary>Takes back what layers of light have of it.</summary>
    public void TakeBack(LightPathAovFilm layers) => layers.TakeBack(tile);
}
