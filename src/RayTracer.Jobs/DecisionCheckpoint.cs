using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>
/// Keeps the samples that decide how many the picture shall have (<c>--noise</c>) in the file of <c>--checkpoint</c>, until there are
/// samples of the picture itself. The file is a film of
/// its own kind, known by its content: a <see cref="DecidingState"/>, whose target is the header's total. It wants more samples than that,
/// so that it never counts as whole.
/// </summary>
/// <param name="checkpoints">Writes them.</param>
/// <param name="picture">The header that the picture's film would have.</param>
/// <param name="goal">The goal of the decision, in words: decisions for another one are not resumed.</param>
public sealed class DecisionCheckpoint(Checkpoints checkpoints, FilmHeader picture, string goal)
{
    private const string Mark = "-deciding-";
    private readonly string _content = $"{picture.Content}{Mark}{goal}";
    private (Film Film, FilmHeader Header)? _latest;

    /// <summary>Returns whether a film holds samples that decide, and none of a picture.</summary>
    public static bool Is(FilmHeader header) => header.Content.Contains(Mark, StringComparison.Ordinal);

    /// <summary>The complaint about a film that holds none of a picture.</summary>
    public static JobException NoPicture(string path) =>
        new(JobFault.File, $"'{path}' holds no samples of the picture yet: it is being decided how many there shall be (--noise); \"raytracer resume {path}\" continues");

    /// <summary>Returns what has been decided before.</summary>
    /// <exception cref="JobException">The film is of another picture or another decision.</exception>
    public DecidingState Begun(HeldFilm film, RenderJob job, Description.SceneDescription scene)
    {
        FilmHeader header = OldFilms.Current(film.Header, scene, job.Scene, picture.Crop);
        return header is { Samples: [var held], Total: var target } && header.Content == _content ? new(film.Film, held.End, target)
            : throw LoadedJob.OtherScene(job.Scene);
    }

    /// <summary>Writes how far it has come, if it is time for it.</summary>
    public void Keep(DecidingState state)
    {
        FilmHeader header = picture with
        {
            Width = state.Film.Width,
            Height = state.Film.Height,
            Crop = null,
            Settings = [.. picture.Settings, .. JobOptions.Kept(
                new()
                {
                    Scene = "", Crop = picture.Crop, Halves = picture.Planes.Contains(FilmPlane.Half),
                    Writing = new() { Transparent = picture.Planes.Contains(FilmPlane.Alpha) },
                }, JobOptionUse.Pictures)],
            Planes = state.Film.Planes,
            Content = _content,
            Samples = [new(0, state.Samples)],
            Wanted = new(0, 2 * state.Target),
            Total = state.Target,
        };
        _latest = (state.Film, header);
        checkpoints.Offer(state.Film, header);
    }

    /// <summary>Writes how far it has come.</summary>
    public void WriteLatest()
    {
        if (_latest is var (film, header))
        {
            checkpoints.Write(film, header);
        }
    }
}
