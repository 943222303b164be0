using System.Globalization;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>The names of files of frames.</summary>
public static class FrameFiles
{
    /// <summary>Returns whether a job is of more than one picture.</summary>
    public static bool AreSeveral(RenderJob job) =>
        job.Frames is { } frames && (frames.Count > 1 || job.Outputs.Any(o => IsNumbered(o) || IsAnimated(o, frames)));

    /// <summary>Returns whether a job writes an animated PNG, among others.</summary>
    public static bool MakeAnimation(RenderJob job) => job.Frames is not null && job.Outputs.Any(o => IsAnimated(o, job.Frames));

    /// <summary>Returns whether a name has a place for a frame's number.</summary>
    public static bool IsNumbered(string path) => path.Contains('#', StringComparison.Ordinal);

    /// <summary>Returns whether a file takes all frames as an animated PNG.</summary>
    public static bool IsAnimated(string path, FrameRange? frames) => AnimatedPng.IsNamed(path)
        || (frames is { Count: > 1 } && path.EndsWith(".png", StringComparison.OrdinalIgnoreCase) && !IsNumbered(path));
}

/// <summary>The outcome of a frame.</summary>
/// <param name="Number">Its number.</param>
/// <param name="Which">Which of how many it is, in words.</param>
/// <param name="Result">The result of its rendering; null where the frame existed already.</param>
/// <param name="Files">Its files.</param>
/// <param name="IsNoisy">True if it was there already, and is noisier than wanted.</param>
public sealed record RenderedFrame(int Number, string Which, JobResult? Result, IReadOnlyList<string> Files, bool IsNoisy);

/// <summary>
/// Renders frames of an animation one after the other, each to its own file, or all into an animated PNG. What was rendered before, of the
/// same scene with the same
/// options, is left as it is: so a run that was stopped continues where it was.
/// </summary>
/// <param name="job">The job to render.</param>
/// <param name="watch">Takes what there is to report.</param>
public sealed class FrameRun(RenderJob job, IJobWatch watch)
{
    private const string KeptEnding = ".frames";
    private readonly FrameRange _frames = job.Frames!;

    // All frames have one exposure, so that none flickers.
    private readonly Lazy<Exposure?> _exposure = new(() => FirstExposure(job));
    private readonly Dictionary<(string Path, bool Raw), Picture> _pictures = [];
    private readonly List<RenderedFrame> _done = [];
    private readonly string[] _animated = [.. job.Outputs.Where(o => FrameFiles.IsAnimated(o, job.Frames))];
    private readonly List<string> _written = [];
    private AnimatedPng? _animation;

    /// <summary>The frames that are there.</summary>
    public IReadOnlyList<RenderedFrame> Done => _done;

    /// <summary>The animated PNGs that were written.</summary>
    public IReadOnlyList<string> Animations => _written;

    /// <summary>Renders all that is missing.</summary>
    /// <param name="render">Carries out the job of a frame; says what it came to, and whether others may follow.</param>
    /// <param name="report">Takes each frame that is there.</param>
    /// <returns>True if all frames were rendered and all animated PNGs were written.</returns>
    public bool Run(Func<RenderJob, JobRun, (JobResult? Result, bool GoesOn)> render, Action<RenderedFrame> report)
    {
        Array.ForEach(_animated, JobFiles.CheckFolder);
        try
        {
            if (KeptFolder is { } folder)
            {
                Directory.CreateDirectory(folder);
            }

            return Share().ToArray() is var frames
                && frames.All(frame => Frame(frame, $"{_done.Count + 1} of {frames.Length}", render, report)) && WriteAnimation();
        }
        finally
        {
            if (KeptFolder is { } folder && _done.Count > 0 && _written.Count < _animated.Length)
            {
                watch.Warn($"the {_done.Count} frames so far are kept in '{folder}': the same command resumes them");
            }

            ClearFolder();
        }
    }

    // The frames of an animated PNG are files too, so that a stopped run resumes with them: PNGs that were asked for, or else files in a
    // folder beside it.
    private string? KeptPattern => _animated.Length == 0 ? null : PngFrames ?? Path.Combine(KeptFolder!, "####.png");

    private string? KeptFolder => _animated.Length > 0 && PngFrames is null ? _animated[0] + KeptEnding : null;

    private string? PngFrames => job.Outputs.Except(_animated).FirstOrDefault(o => o.EndsWith(".png", StringComparison.OrdinalIgnoreCase));

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

    // Every N-th frame: neighbours take equally long, so that the parts do too.
    private IEnumerable<int> Share() =>
        job.Part is { } part ? _frames.Numbers.Where((_, i) => i % part.Count == part.Number - 1) : _frames.Numbers;

    private bool Frame(
        int frame, string which, Func<RenderJob, JobRun, (JobResult? Result, bool GoesOn)> render, Action<RenderedFrame> report)
    {
        RenderJob one = One(frame);
        if (one.Outputs.Count > 0 && Describe(one) is { } scene && AreThere(one, scene))
        {
            Add(frame, scene.Render);
            Report(new(frame, which, null, Asked(one.Outputs, one), one.Outputs.Any(o => IsNoisy(o, scene, one))));
            return true;
        }

        (JobResult? result, bool goesOn) = render(one, new JobRun(one, watch) { ReadPicture = ReadPicture });
        if (result is { Statistics.Cancelled: false })
        {
            Report(new(frame, which, result, Asked(result.Files, one), false));
            if (KeptPattern is { } pattern && result.Files.Contains(FrameRange.Name(pattern, frame)))
            {
                Add(frame, result.Scene.Render);
            }
        }

        return goesOn;

        void Report(RenderedFrame done)
        {
            _done.Add(done);
            report(done);
        }
    }

    // Without what is only kept for the animation.
    private static IReadOnlyList<string> Asked(IReadOnlyList<string> files, RenderJob one) => [.. files.Where(f => f != one.Kept)];

    private RenderJob One(int frame)
    {
        string[] files = [.. job.Outputs.Except(_animated).Select(o => FrameRange.Name(o, frame))];
        string? kept = KeptFolder is null ? null : FrameRange.Name(KeptPattern!, frame);
        return job with { Frames = new(frame, frame, 1), Part = null, Outputs = kept is null ? files : [.. files, kept], Kept = kept, IsOfSequence = true, Writing = job.Writing with { Exposure = _exposure.Value } };
    }

    // Of the first frame of all, where pictures decide on it, found out by few samples of few pixels: so each run and each part that
    // renders some of the frames comes to the same.
    private static Exposure? FirstExposure(RenderJob job)
    {
        const int Width = 160, Samples = 16;
        RenderJob first = job with { Frames = new(job.Frames!.First, job.Frames.First, 1) };
        Exposure asked = (first.Describe() is { } described ? job.Writing.For(described.Render) : job.Writing).Exposure ?? default;
        if (asked.Rule == ExposureRule.Stops)
        {
            return job.Writing.Exposure;
        }

        SceneDescription Small(SceneDescription scene) => scene with
        {
            Render = scene.Render with
            {
                Width = Width,
                Height = Math.Max(1, (int)((long)Width * scene.Render.Height / scene.Render.Width)),
                SamplesPerPixel = Samples,
            },
        };
        return first.Load(Small).Scene is { } scene
            ? asked.StopsFor(new RTracer(scene, new() { Threads = job.Threads }).Render().Film) : job.Writing.Exposure;
    }

    private SceneDescription? Describe(RenderJob one)
    {
        SceneDescription? scene = one.Describe();
        return scene is null ? null : new SampleDecision(one).Widen(scene);
    }

    private bool AreThere(RenderJob one, SceneDescription scene)
    {
        PictureFiles files = new(one);
        return files.All.All(o => IsThere(o, scene, one)) && (one.Layers.Count == 0 || LayersAreThere(one, scene, files));
    }

    // Their names are those of the lights, which only the scene itself knows.
    private bool LayersAreThere(RenderJob one, SceneDescription scene, PictureFiles files)
    {
        if (one.Load(_ => scene, ReadPicture).Scene is not { } built)
        {
            return false;
        }

        try
        {
            files.Add(LightPathAovFilm.NamesOf(built, one.Layers));
            return files.All.All(o => IsThere(o, scene, one));
        }
        catch (ArgumentException)
        {
            // Rendering it says what is wrong.
            return false;
        }
    }

    private static bool IsThere(string path, SceneDescription scene, RenderJob one) => !FilmFile.IsNamed(path)
        ? FinishedPicture.Is(path, one, scene)
        : FinishedPicture.IsFilm(path, one, scene, one.Time is not null || one.Noise is not null ? null : Shares.Of(one, scene.Render));

    // A film that has all the samples that there may be would have liked to have more.
    private static bool IsNoisy(string path, SceneDescription scene, RenderJob one) =>
        one.Noise is not null && (FilmFile.IsNamed(path) ? FilmFile.ReadHeader(path).Wanted.End >= scene.Render.SamplesPerPixel : FinishedPicture.IsNoisy(path));

    private void Add(int frame, RenderDescription render)
    {
        if (KeptPattern is not { } pattern)
        {
            return;
        }

        double rate = job.FramesPerSecond ?? render.FramesPerSecond / _frames.Step;
        _animation ??= new(PictureTexts.Of(job.Command), 1 / rate);
        try
        {
            _animation.Add(File.ReadAllBytes(FrameRange.Name(pattern, frame)));
        }
        catch (ArgumentException e)
        {
            throw new JobException(e.Message.Split(" (Parameter '")[0].TrimEnd('.'), e);
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
            }
            catch (ImageWriteException e)
            {
                watch.Fail(e.Message.TrimEnd('.'));
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
}
