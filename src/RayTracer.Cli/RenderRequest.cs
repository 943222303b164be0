using System.Globalization;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>A film from a file, to which samples are added.</summary>
/// <param name="Header">What the file says of it.</param>
/// <param name="Film">The film.</param>
/// <param name="Path">The file.</param>
internal sealed record ResumedFilm(FilmHeader Header, Film Film, string Path);

/// <summary>What <c>raytracer render</c> was asked for.</summary>
internal sealed record RenderRequest
{
    /// <summary>The scene file, as its user named it.</summary>
    public required string ScenePath { get; init; }

    /// <summary>The files to write.</summary>
    public required IReadOnlyList<string> Outputs { get; init; }

    /// <summary>How PNGs are written; the metadata is added later.</summary>
    public required ImageWriteOptions Writing { get; init; }

    /// <summary>Number of threads.</summary>
    public required int Threads { get; init; }

    /// <summary>x, y, width and height of the part to render; null for all.</summary>
    public int[]? Crop { get; init; }

    /// <summary>The part to render; null for all.</summary>
    public Tile? Area => Crop is [var left, var top, var width, var height] ? new(left, top, width, height) : null;

    /// <summary>x and y of the only pixel to render; null for all.</summary>
    public int[]? Pixel { get; init; }

    /// <summary>The only sample to render; null for all.</summary>
    public long? Sample { get; init; }

    /// <summary>The auxiliary images to write.</summary>
    public IReadOnlyList<AuxiliaryImage> Aovs { get; init; } = [];

    /// <summary>The layers of light to write.</summary>
    public IReadOnlyList<LightLayer> Layers { get; init; } = [];

    /// <summary>Whether a denoised picture is written too.</summary>
    public bool Denoise { get; init; }

    /// <summary>The relative error at which to stop; null to take all samples.</summary>
    public double? Noise { get; init; }

    /// <summary>Whether samples are spent where the error is.</summary>
    public bool Adaptive { get; init; }

    /// <summary>Whether the number of samples was given.</summary>
    public bool HasSamples { get; init; }

    /// <summary>The samples to render; null for all.</summary>
    public SampleRange? Samples { get; init; }

    /// <summary>Which of how many equal parts of the samples to render, from 1; null for all.</summary>
    public (int Number, int Count)? Part { get; init; }

    /// <summary>The frames to render; null for the scene as it is written.</summary>
    public FrameRange? Frames { get; init; }

    /// <summary>The only frame to render; null for the scene as it is written.</summary>
    public int? Frame => Frames is { Count: 1 } frames ? frames.First : null;

    /// <summary>Whether the picture is one of several frames, which are not written before they are whole.</summary>
    public bool IsOfSequence { get; init; }

    /// <summary>The output that is a frame kept for an animated PNG, and has no images beside it; null where there is none.</summary>
    public string? Kept { get; init; }

    /// <summary>How many frames of an animated PNG are shown a second; null for what the scene says.</summary>
    public double? FramesPerSecond { get; init; }

    /// <summary>After which time to stop; null for never.</summary>
    public TimeSpan? Time { get; init; }

    /// <summary>Whether a film is given samples for some time, and shall count as whole with as many as there will be.</summary>
    public bool IsOpenEnded { get; init; }

    /// <summary>Where the film is written now and then; null for nowhere.</summary>
    public string? Checkpoint { get; init; }

    /// <summary>How long at least between two of them.</summary>
    public TimeSpan CheckpointInterval { get; init; }

    /// <summary>The film that samples are added to; null for a new one.</summary>
    public ResumedFilm? Resumed { get; init; }

    /// <summary>What has been done to decide on the number of samples (<see cref="DecisionCheckpoint"/>); null to begin anew.</summary>
    public ResumedFilm? Decision { get; init; }

    /// <summary>Whether it goes on from the checkpoint that there is.</summary>
    public bool Resume { get; init; }

    /// <summary>Whether the film must hold whole ranges of samples whenever the rendering stops.</summary>
    public bool NeedsPasses => Time is not null || Checkpoint is not null || Resumed is not null || Preview || Outputs.Any(Writing.TakesFilm);

    /// <summary>Whether nothing but errors and warnings is printed.</summary>
    public bool Quiet { get; init; }

    /// <summary>Whether the stages are told.</summary>
    public bool Verbose { get; init; }

    /// <summary>Whether the picture is shown in the terminal meanwhile.</summary>
    public bool Preview { get; init; }

    /// <summary>Whether a JSON object is printed.</summary>
    public bool Json { get; init; }

    /// <summary>The values that replace those of the scene file before it is read.</summary>
    public IReadOnlyList<SceneSetting> Settings { get; init; } = [];

    /// <summary>The words of the overrides that were given.</summary>
    public required IReadOnlyList<string> OverrideWords { get; init; }

    /// <summary>What a film says of its making: the overrides, and what decided on the number of its samples.</summary>
    public IReadOnlyList<string> FilmWords => [.. OverrideWords, .. Noise is { } noise ? ["--noise", noise.ToString(CultureInfo.InvariantCulture)] : Array.Empty<string>()];

    /// <summary>The whole command, as it is typed.</summary>
    public required string CommandText { get; init; }

    /// <summary>The request with the frame, if it is of one, among what replaces the scene's values.</summary>
    public RenderRequest WithFrameWords() => Frame is { } number ? this with { OverrideWords = [.. OverrideWords, "--frames", $"{number}"] } : this;

    /// <summary>The request with the film of its checkpoint, where there is one, to be gone on with.</summary>
    /// <exception cref="PictureException">It cannot be read.</exception>
    public RenderRequest WithCheckpoint()
    {
        if (!File.Exists(Checkpoint))
        {
            return this;
        }

        (FilmHeader header, Film film) = FilmFile.Read(Checkpoint);
        ResumedFilm resumed = new(header, film, Checkpoint);
        return DecisionCheckpoint.Is(header) ? this with { Decision = resumed } : this with { Resumed = resumed };
    }

    /// <summary>The command that follows one sample's path again.</summary>
    public string ReplayCommand(BadSample bad) =>
        Shell.Command(["render", ScenePath, "--pixel", $"{bad.X},{bad.Y}", "--sample", $"{bad.Sample}", .. OverrideWords]);
}
