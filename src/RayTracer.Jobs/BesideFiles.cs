using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>The files that auxiliary images and denoised pictures are written to, beside outputs that hold no layers.</summary>
internal sealed class BesideFiles
{
    private readonly RenderJob _job;
    private readonly HashSet<string> _taken;
    private readonly List<(string Path, AuxiliaryImage Image)> _files = [];
    private readonly List<(string Path, int Layer)> _layers = [];
    private readonly List<string> _denoised = [];

    /// <summary>Lists the files whose names are known before the scene is.</summary>
    /// <exception cref="JobException">Two images would go to one file.</exception>
    public BesideFiles(RenderJob job)
    {
        _job = job;
        _taken = [.. job.Outputs.Select(Path.GetFullPath)];
        foreach (string output in Pictures)
        {
            foreach (AuxiliaryImage image in job.Aovs.Distinct())
            {
                _files.Add((Take($"--aov {image.Name}", output, AovFiles.Beside(output, image.Name)), image));
            }

            if (job.Denoise)
            {
                _denoised.Add(Take("--denoise", output, DenoisedFiles.Beside(output)));
            }
        }
    }

    /// <summary>The files.</summary>
    public IReadOnlyList<string> Files => [.. _files.Select(f => f.Path), .. _denoised, .. _layers.Select(l => l.Path)];

    // Outputs that hold no layers.
    private IEnumerable<string> Pictures =>
        _job.Outputs.Distinct().Where(o => o != _job.Kept && Path.GetExtension(o).Length > 0 && !ImageFormat.Has(o, ImageFeatures.Layers) && !FilmFile.IsNamed(o));

    /// <summary>Lists the files of layers of light.</summary>
    /// <param name="layers">The layers' names.</param>
    /// <exception cref="JobException">Two images would go to one file, or one cannot be written.</exception>
    public void Add(IReadOnlyList<string> layers)
    {
        foreach (string output in Pictures)
        {
            for (int i = 0; i < layers.Count; i++)
            {
                string path = Take($"--aov: the layer {layers[i]}", output, AovFiles.Beside(output, layers[i]));
                JobFiles.Check(path);
                _layers.Add((path, i));
            }
        }
    }

    /// <summary>Writes them; reports why those fail that cannot be written.</summary>
    /// <param name="film">The images; null where they are left out.</param>
    /// <param name="layers">The layers of light; null where there are none.</param>
    /// <param name="denoised">The denoised picture; null where there is none.</param>
    /// <param name="writing">How the picture is written.</param>
    /// <param name="watch">Takes failures.</param>
    /// <returns>Those that were written.</returns>
    public IReadOnlyList<string> Write(AovFilm? film, LightLayerFilm? layers, Picture? denoised, ImageWriteOptions writing, IJobWatch watch)
    {
        List<string> written = [];
        foreach ((string path, AuxiliaryImage kind) in film is null ? [] : _files)
        {
            (IImageRows image, string range) = AovFiles.Rows(path, film!, kind);
            KeyValuePair<string, string>[] texts = [.. writing.Metadata, new("Aov", kind.Name), new("Range", range)];
            ImageWriteOptions plain = writing with { Exposure = 0, ToneMap = ToneMap.Clamp, Metadata = texts };
            written.AddRange(JobFiles.Write([path], image, plain, watch));
        }

        foreach ((string path, int layer) in _layers)
        {
            KeyValuePair<string, string>[] texts = [.. writing.Metadata, new("Layer", layers!.Names[layer])];
            written.AddRange(JobFiles.Write([path], layers.Image(layer), writing with { Metadata = texts }, watch));
        }

        if (denoised is not null)
        {
            written.AddRange(JobFiles.Write(_denoised, denoised, writing with { Metadata = [.. writing.Metadata, new("Denoised", "yes")] }, watch));
        }

        return written;
    }

    private string Take(string option, string output, string path) => _taken.Add(Path.GetFullPath(path))
        ? path
        : throw new JobException(JobFault.Request, $"{option} writes to '{path}' beside '{output}', but another image goes there");
}
