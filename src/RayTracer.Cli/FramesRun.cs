using System.Diagnostics;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>
/// Renders frames of an animation one after the other, each to its own file, or all into an animated PNG. What was rendered before, of the same scene with the same
/// options, is left as it is: so a run that was stopped goes on where it was.
/// </summary>
/// <param name="request">What was asked for.</param>
/// <param name="overrides">Puts the options of the command line into the scene.</param>
/// <param name="streams">Where to write.</param>
internal sealed class FramesRun(RenderRequest request, Func<SceneDescription, SceneDescription> overrides, Streams streams)
{
    private const string KeptEnding = ".frames";
    private readonly FrameRange _frames = request.Frames!;
    private readonly Dictionary<(string Path, bool Raw), Picture> _pictures = [];
    private readonly List<RenderedFrame> _done = [];
    private readonly string[] _animated = [.. request.Outputs.Where(o => IsAnimated(o, request.Frames!))];
    private readonly List<string> _written = [];
    private AnimatedPng? _animation;

    /// <summary>Whether a request is for more than one picture.</summary>
    public static bool Is(RenderRequest request) =>
        request.Frames is { } frames && (frames.Count > 1 || request.Outputs.Any(o => o.Contains('#', StringComparison.Ordinal) || IsAnimated(o, frames)));

    /// <summary>Whether a request is for an animated PNG, among others.</summary>
    public static bool MakesAnimation(RenderRequest request) => request.Frames is { } frames && request.Outputs.Any(o => IsAnimated(o, frames));

    /// <summary>What cannot go together with several frames; null where all is well.</summary>
    public static string? Contradiction(RenderRequest request) => !Is(request) ? null : request switch
    {
        { Pixel: not null } => "--pixel prints one picture's numbers: give one frame",
        { Checkpoint: not null } => "--checkpoint is for one picture: of several frames, finished ones are kept anyway, and the same command renders the others",
        { Preview: true } => "--preview shows one picture: give one frame",
        { Outputs.Count: 0, Json: false } => "where to? Give -o frame-####.png",
        _ when request.Outputs.FirstOrDefault(o => !o.Contains('#', StringComparison.Ordinal) && !IsAnimated(o, request.Frames!)) is { } single =>
            $"-o {single}: {request.Frames!.Count} frames need as many files: put #### where their numbers should go",
        { Part: { } part } when part.Count > request.Frames!.Count => $"--part {part.Number}/{part.Count}: with --frames, frames are divided among parts, and {request.Frames.Count} frames make at most {request.Frames.Count} parts",
        { Denoise: true } or { Aovs.Count: > 0 } or { Layers.Count: > 0 } when request.Outputs.Count > 0 && request.Outputs.All(o => IsAnimated(o, request.Frames!)) =>
            $"{(request.Denoise ? "--denoise" : "--aov")} writes images beside every frame, and only an animated PNG is written: give -o frame-####.png too",
        { Part: not null } when MakesAnimation(request) => "an animated PNG has all frames: leave --part out",
        _ => null,
    };

    /// <summary>Renders all that is missing.</summary>
    /// <returns>One of <see cref="ExitStatus"/>.</returns>
    public int Run()
    {
        Stopwatch total = Stopwatch.StartNew();
        foreach (string path in _animated)
        {
            ImageOutputs.CheckFolder(path);
        }

        int status;
        try
        {
            if (KeptFolder is { } folder)
            {
                Directory.CreateDirectory(folder);
            }

            status = Frames();
        }
        finally
        {
            ClearFolder();
        }

        if (request.Json)
        {
            WriteJson(total.Elapsed.TotalSeconds);
        }

        return status;
    }

    private int Frames()
    {
        int status = ExitStatus.Fine;
        int[] frames = [.. Share()];
        foreach (int frame in frames)
        {
            status = Math.Max(status, Frame(frame, $"{_done.Count + 1} of {frames.Length}"));
            if (status is not (ExitStatus.Fine or ExitStatus.Noisy))
            {
                // A preview that is there is worth more than one that breaks off.
                if (KeptFolder is { } folder && _done.Count > 0)
                {
                    streams.Warn($"the {_done.Count} frames so far are kept in '{folder}': the same command resumes them");
                }

                return status;
            }
        }

        return WriteAnimation() ? status : ExitStatus.InputOutput;
    }

    // The frames of an animated PNG are files too, so that a run that was stopped goes on with them: PNGs that were asked for, or else files in a folder beside it.
    private string? KeptPattern => _animated.Length == 0 ? null : PngFrames ?? Path.Combine(KeptFolder!, "####.png");

    private string? KeptFolder => _animated.Length > 0 && PngFrames is null ? _animated[0] + KeptEnding : null;

    private string? PngFrames => request.Outputs.Except(_animated).FirstOrDefault(o => o.EndsWith(".png", StringComparison.OrdinalIgnoreCase));

    // When the animation is whole, its frames have done their service; else only a folder without any goes.
    private void ClearFolder()
    {
        if (KeptFolder is not { } folder || !Directory.Exists(folder))
        {
            return;
        }

        try
        {
            foreach (string file in _written.Count == _animated.Length ? Share().Select(f => FrameRange.Name(KeptPattern!, f)) : [])
            {
                File.Delete(file);
                AtomicFile.Sweep(file, DateTime.UtcNow);
            }

            if (!Directory.EnumerateFileSystemEntries(folder).Any())
            {
                Directory.Delete(folder);
            }
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException)
        {
            // They stay: that harms nobody.
        }
    }

    private static bool IsAnimated(string path, FrameRange frames) => AnimatedPng.IsNamed(path)
        || (frames.Count > 1 && path.EndsWith(".png", StringComparison.OrdinalIgnoreCase) && !path.Contains('#', StringComparison.Ordinal));

    // Every N-th frame: neighbours take equally long, so that the parts do too.
    private IEnumerable<int> Share() => request.Part is { } part ? _frames.Numbers.Where((_, i) => i % part.Count == part.Number - 1) : _frames.Numbers;

    private int Frame(int frame, string which)
    {
        RenderRequest one = One(frame);
        if (one.Outputs.Count > 0 && Describe(one) is { } scene && AreThere(one, scene))
        {
            Add(frame, scene.Render);
            _done.Add(new(frame, null, Asked(one.Outputs, one)));
            Say($"frame {frame} ({which}): exists already");
            return one.Outputs.Any(o => IsNoisy(o, scene, one)) ? ExitStatus.Noisy : ExitStatus.Fine;
        }

        int status = new RenderRun(one, overrides, streams)
        {
            ReadPicture = ReadPicture,
            Done = (outcome, written) =>
            {
                if (!outcome.Statistics.Cancelled)
                {
                    IReadOnlyList<string> files = Asked(written, one);
                    _done.Add(new(frame, outcome, files));
                    Say($"frame {frame} ({which}): {outcome.Seconds:F2} s{string.Concat(files.Select(w => $", {w}"))}");
                    if (KeptPattern is { } pattern && written.Contains(FrameRange.Name(pattern, frame)))
                    {
                        Add(frame, outcome.Scene.Render);
                    }
                }
            },
        }.Run();
        if (status == ExitStatus.Scene)
        {
            streams.Fail($"these errors are at frame {frame}");
        }

        return status;
    }

    // Without what is only kept for the animation.
    private static IReadOnlyList<string> Asked(IReadOnlyList<string> files, RenderRequest one) => [.. files.Where(f => f != one.Kept)];

    private RenderRequest One(int frame)
    {
        string[] files = [.. request.Outputs.Except(_animated).Select(o => FrameRange.Name(o, frame))];
        string? kept = KeptFolder is null ? null : FrameRange.Name(KeptPattern!, frame);
        return request with
        {
            Frames = new(frame, frame, 1),
            Part = null,
            Outputs = kept is null ? files : [.. files, kept],
            Kept = kept,
            Quiet = true,
            Json = false,
            IsOfSequence = true,
            OverrideWords = [.. request.OverrideWords, "--frames", $"{frame}"],
            CommandText = Shell.Command([.. Words(), "--frames", $"{frame}", .. files.SelectMany(f => new[] { "-o", f })]),
        };
    }

    // The command without what does not change a frame's picture.
    private IEnumerable<string> Words()
    {
        string[] onlyHere = ["--quiet", "--json", "--verbose"];
        string[] onlyHereWithValue = ["--frames", "--fps", "--part", "--threads", "-o", "--output"];
        string[] words = Shell.Words(request.CommandText)[1..];
        for (int i = 0; i < words.Length; i++)
        {
            if (onlyHereWithValue.Contains(words[i]))
            {
                i++;
            }
            else if (!onlyHere.Contains(words[i]))
            {
                yield return words[i];
            }
        }
    }

    private SceneDescription? Describe(RenderRequest one) =>
        SceneLoader.Describe(one.ScenePath, s => new NoiseRequest(one).Widen(overrides(s)), one.Settings, one.Frame);

    private bool AreThere(RenderRequest one, SceneDescription scene)
    {
        AovOutputs aovs = new(one);
        return one.Outputs.Concat(aovs.Files).All(o => IsThere(o, scene, one)) && (one.Layers.Count == 0 || LayersAreThere(one, scene, aovs));
    }

    // Their names are those of the lights, which only the scene itself knows.
    private bool LayersAreThere(RenderRequest one, SceneDescription scene, AovOutputs aovs)
    {
        SceneLoadResult result = SceneFile.Load(one.ScenePath, _ => scene, ReadPicture, one.Settings, one.Frame);
        if (result.Scene is null)
        {
            return false;
        }

        try
        {
            aovs.Add(Rendering.LightLayerFilm.NamesOf(result.Scene, one.Layers));
            return aovs.Files.All(o => IsThere(o, scene, one));
        }
        catch (ArgumentException)
        {
            // Rendering it says what is wrong.
            return false;
        }
    }

    private static bool IsThere(string path, SceneDescription scene, RenderRequest one)
    {
        if (!FilmFile.IsNamed(path))
        {
            return FinishedPicture.Is(path, ContentHash.OfPicture(scene, one.ScenePath, one.Area), one.CommandText);
        }

        bool isOpen = one.Time is not null || one.Noise is not null;
        return FinishedPicture.IsFilm(path, ContentHash.Of(scene, one.ScenePath, one.Area), isOpen ? null : SampleShares.Of(one, scene.Render));
    }

    // A film that has all the samples that there may be would have liked to have more.
    private static bool IsNoisy(string path, SceneDescription scene, RenderRequest one) =>
        one.Noise is not null && (FilmFile.IsNamed(path) ? FilmFile.ReadHeader(path).Wanted.End >= scene.Render.SamplesPerPixel : FinishedPicture.IsNoisy(path));

    private void Add(int frame, RenderDescription render)
    {
        if (KeptPattern is not { } pattern)
        {
            return;
        }

        double rate = request.FramesPerSecond ?? render.FramesPerSecond / _frames.Step;
        _animation ??= new([new("Software", CommandLine.Version), new("Command", request.CommandText)], 1 / rate);
        try
        {
            _animation.Add(File.ReadAllBytes(FrameRange.Name(pattern, frame)));
        }
        catch (ArgumentException e)
        {
            throw new CommandException(ExitStatus.Scene, e.Message.Split(" (Parameter '")[0].TrimEnd('.'));
        }
    }

    private bool WriteAnimation()
    {
        bool good = true;
        foreach (string path in _animation is null ? [] : _animated)
        {
            try
            {
                _animation!.Write(path);
                _written.Add(path);
                Say($"wrote {path}, {_animation.Count} frames");
            }
            catch (ImageWriteException e)
            {
                streams.Fail(e.Message.TrimEnd('.'));
                good = false;
            }
        }

        return good;
    }

    // Once for all frames.
    private Picture ReadPicture(string path, bool raw)
    {
        if (!_pictures.TryGetValue((path, raw), out Picture? picture))
        {
            _pictures.Add((path, raw), picture = ImageFile.Read(path, raw));
        }

        return picture;
    }

    private void Say(string line)
    {
        if (!request.Quiet && !request.Json)
        {
            streams.Output.WriteLine(line);
        }
    }

    private void WriteJson(double seconds) => JsonText.Write(streams, json =>
    {
        json.WriteStartArray("frames");
        foreach (RenderedFrame frame in _done)
        {
            json.WriteStartObject();
            json.WriteNumber("frame", frame.Number);
            json.WriteBoolean("rendered", frame.Outcome is not null);
            if (frame.Outcome is { } outcome)
            {
                json.WriteNumber("renderSeconds", outcome.Seconds);
                json.WriteString("filmHash", outcome.Hash);
            }

            json.WriteStartArray("outputs");
            foreach (string path in frame.Files)
            {
                json.WriteStringValue(path);
            }

            json.WriteEndArray();
            json.WriteEndObject();
        }

        json.WriteEndArray();
        json.WriteStartArray("outputs");
        foreach (string path in _written)
        {
            json.WriteStringValue(path);
        }

        json.WriteEndArray();
        json.WriteNumber("totalSeconds", seconds);
    });

    /// <summary>What became of a frame.</summary>
    /// <param name="Number">Its number.</param>
    /// <param name="Outcome">What its rendering came to; null where it was there already.</param>
    /// <param name="Files">Its files.</param>
    private sealed record RenderedFrame(int Number, RenderOutcome? Outcome, IReadOnlyList<string> Files);
}
