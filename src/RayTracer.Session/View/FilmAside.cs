using RayTracer.Jobs;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>
/// A copy of a picture that has taken a while: when another one has come in its place, as for somebody who looks around, and it is wanted again, it is resumed
/// instead of rendered from scratch. On the render loop's thread.
/// </summary>
internal sealed class FilmAside
{
    // From so many seconds of rendering on, a film is worth its memory; with so many times as many, it is copied again.
    private const double WorthSeconds = 2;
    private const double Growth = 1.25;

    // A film may take a third of the memory that there is, beside copies for saving.
    private const int Part = 12;
    private ViewportScene? _shown;
    private Film? _film;

    /// <summary>The samples of each pixel that the copy has.</summary>
    public int Samples { get; private set; }

    /// <summary>The seconds that they took.</summary>
    public double Seconds { get; private set; }

    /// <summary>Takes a copy, if it is time to, and if none is held of the same document that took longer.</summary>
    /// <param name="shown">What the film shows.</param>
    /// <param name="film">The film, all of whose pixels have the same samples.</param>
    /// <param name="samples">How many.</param>
    /// <param name="seconds">The seconds that they took.</param>
    public void Keep(ViewportScene shown, Film film, int samples, double seconds)
    {
        bool isOther = _shown?.Picture != shown.Picture;
        bool isDue = isOther ? _shown?.Good.Document != shown.Good.Document || seconds > Seconds : seconds > Growth * Seconds || samples >= shown.Samples;
        bool isAffordable = FilmMemory.Bytes(film.Width, film.Height, film.Planes) <= GC.GetGCMemoryInfo().TotalAvailableMemoryBytes / Part;
        if (seconds < WorthSeconds || !isDue || !isAffordable)
        {
            return;
        }

        if (_film?.Width == film.Width && _film.Height == film.Height && _film.Planes.SequenceEqual(film.Planes))
        {
            _film.Clear();
        }
        else
        {
            _film = new(film.Width, film.Height, film.Planes);
        }

        _film.Merge(film);
        (_shown, Samples, Seconds) = (shown, samples, seconds);
    }

    /// <summary>Puts the copy into a film without samples, if it is of the picture that is wanted.</summary>
    public bool TryResume(ViewportScene wanted, Film film)
    {
        bool isIt = _shown is { } shown && shown.Round == wanted.Round && shown.Area == wanted.Area && shown.First == wanted.First
            && shown.Good.Document == wanted.Good.Document && PictureView.IsSamePicture(shown, wanted) && Samples <= wanted.Samples;
        if (isIt)
        {
            film.Merge(_film!);
            _shown = wanted;
        }

        return isIt;
    }
}
