using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>
/// The files that a job writes: its outputs and, beside those that hold no layers, auxiliary images, layers of light and denoised pictures.
/// </summary>
public sealed class PictureFiles
{
    private readonly RenderJob _job;
    private readonly HashSet<string> _taken;
    private readonly List<(string Path, AuxiliaryImage Image)> _images = [];
    private readonly List<(string Path, int Layer)> _layers = [];
    private readonly List<string> _denoised = [];
    private readonly List<string> _sheets = [];

    /// <summary>Lists the files whose names are known before the scene is.</summary>
    /// <exception cref="JobException">Two images would go to one file.</exception>
    public PictureFiles(RenderJob job)
    {
        _job = job;
        _taken = [.. job.Outputs.Select(Path.GetFullPath)];
        foreach (string output in Pictures)
        {
            _images.AddRange(job.Aovs.Distinct().Select(i => (Beside($"--aov {i.Name}", output, AovFiles.Beside(output, i.Name)), i)));
            if (job.Strategies)
            {
                _sheets.Add(Beside("--aov strategies", output, AovFiles.Beside(output, "strategies")));
            }

            if (job.Denoise)
            {
                _denoised.Add(Beside("--denoise", output, DenoisedFiles.Beside(output)));
            }
        }
    }

    /// <summary>All files.</summary>
    public IReadOnlyList<string> All => [.. _job.Outputs, .. _images.Select(f => f.Path), .. _denoised, .. _sheets, .. _layers.Select(l => l.Path)];

    /// <summary>The places of the denoised picture, as they are reported: files, and layers of files.</summary>
    public IEnumerable<string> Denoised =>
        Pictures.Select(o => $"{DenoisedFiles.Beside(o)} ({o} keeps its noise)")
            .Concat(_job.Outputs.Where(o => ImageFormat.Has(o, ImageFeatures.Layers)).Select(o => $"the layer \"denoised\" of {o}"));

    private string[] Checkpoint => _job.Checkpoint is { } file ? [file] : [];

    private IEnumerable<string> Written => All.Concat(Checkpoint);

    // Outputs that hold no layers.
    private IEnumerable<string> Pictures => _job.Outputs.Distinct()
        .Where(o => o != _job.Kept && Path.GetExtension(o).Length > 0 && !ImageFormat.Has(o, ImageFeatures.Layers) && !FilmFile.IsNamed(o));

    /// <summary>Finds out before the work whether the files and the checkpoint can be written after it.</summary>
    /// <exception cref="JobException">One cannot be written, or holds a film of an unfinished rendering.</exception>
    /// <exception cref="ImageWriteException">A folder is missing or closed to us, or has no room for another file.</exception>
    public void Check()
    {
        foreach (string path in Written)
        {
            JobFiles.CheckFilm(path);
        }

        if (!_job.IsOfSequence)
        {
            UnfinishedFilms.Check(_job.Outputs, (_job.Resumed ?? _job.Decision)?.Path);
        }
    }

    /// <summary>Finds out, once the scene is loaded, whether a file would replace one that the scene is read from.</summary>
    /// <exception cref="ImageWriteException">One would.</exception>
    public void CheckInputs() => Written.ToList().ForEach(AtomicFile.Check);

    /// <summary>Finds out whether a film knows what pictures of it shall lack.</summary>
    /// <param name="options">The options of their files.</param>
    /// <param name="planes">The film's planes.</param>
    /// <param name="path">Its file.</param>
    /// <exception cref="JobException">It does not.</exception>
    public static void CheckAlpha(ImageWriteOptions options, IReadOnlyList<FilmPlane> planes, string path)
    {
        if (options.Transparent && !planes.Contains(FilmPlane.Alpha))
        {
            throw new JobException(JobFault.File, $"'{path}' does not know which of its light is from behind everything: render it from scratch with --transparent");
        }
    }

    /// <summary>Lists the files of layers of light.</summary>
    /// <param name="layers">The layers' names.</param>
    /// <exception cref="JobException">Two images would go to one file, or one cannot be written.</exception>
    public void Add(IReadOnlyList<string> layers)
    {
        foreach (string output in Pictures)
        {
            for (int i = 0; i < layers.Count; i++)
            {
                string path = Beside($"--aov: the layer {layers[i]}", output, AovFiles.Beside(output, layers[i]));
                JobFiles.Check(path);
                _layers.Add((path, i));
            }
        }
    }

    /// <summary>Returns the details of writing the picture: its texts, and the layers that there are.</summary>
    /// <param name="result">The outcome of the job.</param>
    /// <param name="denoised">The denoised picture; null where there is none.</param>
    public ImageWriteOptions Options(JobResult result, Picture? denoised = null)
    {
        ImageWriteOptions writing = _job.Writing.For(result.Scene.Render).Exposed(result.Film);
        return writing with
        {
            Metadata = [.. PictureTexts.Of(_job, result), .. PictureTexts.OfTone(PictureTone.Text(writing))],
            ExrTexts = result.Auxiliary is { } named ? CryptomatteLayers.Texts(named) : [],
            ExrLayers =
            [
                .. result.Auxiliary is { } images ? AovFiles.Layers(images) : [],
                .. result.Light is { } light ? AovFiles.Layers(light) : [],
                .. result.Strategies is { } strategies ? AovFiles.Layers(strategies.Layers) : [],
                .. denoised is null ? [] : DenoisedFiles.Layers(TransparentRows.Of(denoised, result.Film, writing).Image),
            ],
        };
    }

    /// <summary>Writes all files; reports why those fail that cannot be written.</summary>
    /// <param name="result">The outcome of the job.</param>
    /// <param name="watch">Takes failures.</param>
    /// <returns>Those that were written.</returns>
    public IReadOnlyList<string> Write(JobResult result, IJobWatch watch)
    {
        Picture? denoised = result.Denoised?.Picture;
        ImageWriteOptions writing = Options(result, denoised);
        List<string> written = [.. JobFiles.Write(_job.Outputs, result.Film, result.Header, writing, watch)];
        void Write(IEnumerable<string> paths, IImageRows image, ImageWriteOptions options, params KeyValuePair<string, string>[] texts) =>
            written.AddRange(
                JobFiles.Write(paths, image, options with { ExrLayers = [], ExrTexts = [], Metadata = [.. options.Metadata, .. texts] }, watch));
        foreach ((string path, AuxiliaryImage kind) in result.Auxiliary is null ? [] : _images)
        {
            (IImageRows image, string range) = AovFiles.Rows(path, result.Auxiliary!, kind);
            Write([path], image, writing with { Exposure = 0, ToneMap = ToneMap.Clamp }, new("Aov", kind.Name), new("Range", range));
        }

        if (_sheets.Count > 0)
        {
            Write(_sheets, StrategySheet.Draw(result.Strategies!, writing.Exposed(result.Film)), writing with { Exposure = 0, ToneMap = ToneMap.Clamp }, new KeyValuePair<string, string>("Aov", "strategies"));
        }

        _layers.ForEach(l => Write(
            [l.Path], result.Light!.Image(l.Layer), writing, new KeyValuePair<string, string>("Layer", result.Light.Names[l.Layer])));
        if (denoised is not null)
        {
            (IImageRows image, ImageWriteOptions options) = TransparentRows.Of(denoised, result.Film, writing);
            Write(_denoised, image, options, new KeyValuePair<string, string>("Denoised", "yes"));
        }

        return written;
    }

    private string Beside(string option, string output, string path) => _taken.Add(Path.GetFullPath(path))
        ? path
        : throw new JobException(JobFault.Request, $"{option} writes to '{path}' beside '{output}', but another image goes there");
}
