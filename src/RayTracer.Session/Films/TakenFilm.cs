using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>A copy of the film that the view renders, so that rendering goes on meanwhile.</summary>
/// <param name="Film">The copy.</param>
/// <param name="Shown">The scene that it shows.</param>
/// <param name="Samples">One more than the last sample that all pixels have.</param>
/// <param name="Rest">The samples that some pixels have and others lack; null where all have the same samples.</param>
internal sealed record TakenFilm(Film Film, ViewportScene Shown, int Samples, Slice? Rest)
{
    /// <summary>Takes a copy.</summary>
    public static TakenFilm Of(Film film, ViewportScene shown, int samples, Slice? rest)
    {
        Film copy = FilmBudget.Create(film.Width, film.Height, film.Planes);
        copy.Merge(film);
        return new(copy, shown, samples, rest);
    }

    /// <summary>Renders what some pixels lack, so that all have the same samples.</summary>
    /// <returns>The samples that they have then.</returns>
    public SampleRange Complete(CancellationToken cancellation)
    {
        if (Rest is not { } rest)
        {
            return new(Shown.First, Samples);
        }

        RenderStatistics done = new RTracer(Shown.Scene, new() { Threads = Shown.Settings.Threads, Crop = rest.Area, Samples = rest.Samples })
            .Render(Film, null, cancellation);
        return done.Cancelled ? throw new OperationCanceledException() : new(Shown.First, rest.Samples.End);
    }
}
