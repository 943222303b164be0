using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>A job whose scene is loaded: what the stages of rendering share.</summary>
/// <param name="Job">The job.</param>
/// <param name="Scene">Its scene.</param>
/// <param name="Description">The description that the scene was built from.</param>
/// <param name="Options">The options of the computation.</param>
/// <param name="Progress">Takes the progress; may be null.</param>
/// <param name="Cancellation">Ends it early.</param>
internal sealed record LoadedJob(
    RenderJob Job, Scene Scene, SceneDescription Description, RenderOptions Options, IProgress<RenderProgress>? Progress, CancellationToken Cancellation)
{
    // The content of a scene with large models takes its time.
    private readonly Lazy<string> _content = new(() => ContentHash.Of(Description, Job.Scene, Options.Crop));

    /// <summary>The textbook edition's renderer; null where the fast one renders.</summary>
    public Textbook.Renderer? Textbook { get; init; }

    /// <summary>The samples to render.</summary>
    public SampleRange Samples => Options.Samples!.Value;

    /// <summary>The job with other samples; null for the same.</summary>
    public LoadedJob With(SampleRange? samples) => samples is null ? this : this with { Options = Options with { Samples = samples } };

    /// <summary>Returns the header of a film without samples.</summary>
    public FilmHeader NewHeader() => new()
    {
        Width = Scene.Render.Width,
        Height = Scene.Render.Height,
        Content = Edition.Content(Guidance.Content(_content.Value, Scene.Guide), Job.Edition),
        Samples = [],
        Wanted = Samples,
        Total = Job.Samples is null && Job.Part is null ? Samples.End : Scene.Render.SamplesPerPixel,
        Crop = Options.Crop,
        Scene = Path.GetFullPath(Job.Scene),
        Settings = Job.FilmSettings,
        Tone = PictureTone.Text(Job.Writing.For(Scene.Render)),
        Software = ProgramName.Text + Edition.Software(Job.Edition, Description),
        Planes = Job.Planes(Scene.Render.Integrator, Scene.HasMattes),
    };

    /// <summary>Returns the header of the film that is resumed, or of a new one.</summary>
    /// <exception cref="JobException">The resumed film is of another picture, or of other samples.</exception>
    public FilmHeader Header()
    {
        FilmHeader header = NewHeader();
        if (Job.Resumed is not { } film)
        {
            return header;
        }

        FilmHeader old = Current(film.Header);
        if (old.Content != header.Content)
        {
            throw OtherFilm(old);
        }

        bool isBegin = old.Samples is []
            || (old.Samples is [var held] && held.First == header.Wanted.First && held.End <= header.Wanted.End);
        return isBegin ? header with { Samples = old.Samples, Settings = header.Wanted == old.Wanted ? old.Settings : header.Settings }
            : throw new JobException(
            JobFault.File, $"'{film.Path}' holds samples {old.SamplesText}, which are not the first of the requested {FilmHeader.Text(header.Wanted)}");
    }

    /// <summary>Returns a header as this version writes it, where it is of this picture.</summary>
    public FilmHeader Current(FilmHeader film) => OldFilms.Current(film, Description, Job.Scene, Options.Crop);

    /// <summary>The complaint about a scene that a film is not of.</summary>
    public static JobException OtherScene(string path) =>
        new(JobFault.File, $"the film is not of '{path}': the scene, a file that it names, its settings, a plug-in or the program are others than they were");

    // The integrator with which the scene is the one of a film; null where no other makes it so.
    private Integrator? IntegratorOf(FilmHeader film) => Integrator.Known.All.FirstOrDefault(integrator =>
    {
        SceneDescription scene = Description with { Render = Description.Render with { Integrator = integrator } };
        return OldFilms.Current(film, scene, Job.Scene, Options.Crop).Content == ContentHash.Of(scene, Job.Scene, Options.Crop);
    });

    private JobException OtherFilm(FilmHeader header)
    {
        if (Edition.Complaint(header.Content, Job.Edition) is { } complaint)
        {
            return new(JobFault.File, complaint);
        }

        if (Guidance.Unguided(header.Content) == _content.Value)
        {
            return new(
                JobFault.File, Scene.Guide is null ? "the film was rendered with --guide: give that too" : Guidance.IsGuided(header.Content)
                    ? "the film was guided by what another version learned: render it from scratch" : "the film was rendered without --guide: leave that out");
        }

        if (IntegratorOf(header) is { } integrator)
        {
            return new(
                JobFault.File,
                $"the film was rendered by the {integrator.Name} integrator, but '{Job.Scene}' is rendered by {Scene.Render.Integrator.Name}: "
                + $"write \"integrator\": \"{integrator.Name}\" under \"render\" there to continue it");
        }

        RenderDescription render = Scene.Render;
        return !render.Sampler.DependsOnCount || render.SamplesPerPixel == header.Total ? OtherScene(Job.Scene) : new(
            JobFault.Request,
            $"--spp {render.SamplesPerPixel}: the places of the {render.Sampler.ToString().ToLowerInvariant()} sampler's samples depend on how many there are, "
            + $"so that a film of {header.Total} cannot be given more or fewer: render it from scratch, or with --sampler sobol");
    }
}
