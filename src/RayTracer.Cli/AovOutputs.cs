using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Cli;

/// <summary>The files that auxiliary images and denoised pictures are written to, beside outputs that hold no layers.</summary>
internal sealed class AovOutputs
{
    private readonly List<(string Path, Aov Kind)> _files = [];
    private readonly List<string> _denoised = [];

    /// <summary>Lists the files.</summary>
    /// <exception cref="CommandException">Two images would go to one file.</exception>
    public AovOutputs(RenderRequest request)
    {
        HashSet<string> taken = [.. request.Outputs.Select(Path.GetFullPath)];
        foreach (string output in request.Outputs.Distinct().Where(o => Path.GetExtension(o).Length > 0 && !o.EndsWith(".exr", StringComparison.OrdinalIgnoreCase) && !FilmFile.IsNamed(o)))
        {
            foreach (Aov kind in request.Aovs.Distinct())
            {
                string path = AovFiles.Beside(output, kind);
                if (!taken.Add(Path.GetFullPath(path)))
                {
                    throw new CommandException(ExitStatus.Usage, $"--aov {AovFiles.Name(kind)} writes to '{path}' beside '{output}', but another image goes there");
                }

                _files.Add((path, kind));
            }

            if (request.Denoise)
            {
                string path = DenoisedFiles.Beside(output);
                if (!taken.Add(Path.GetFullPath(path)))
                {
                    throw new CommandException(ExitStatus.Usage, $"--denoise writes to '{path}' beside '{output}', but another image goes there");
                }

                _denoised.Add(path);
            }
        }
    }

    /// <summary>The files.</summary>
    public IReadOnlyList<string> Files => [.. _files.Select(f => f.Path), .. _denoised];

    /// <summary>Writes them; says of each that cannot be written why.</summary>
    /// <param name="film">The images.</param>
    /// <param name="denoised">The denoised picture; null where there is none.</param>
    /// <param name="writing">How the picture is written.</param>
    /// <param name="streams">Takes complaints.</param>
    /// <returns>Those that were written.</returns>
    public IReadOnlyList<string> Write(AovFilm film, Picture? denoised, ImageWriteOptions writing, Streams streams)
    {
        List<string> written = [];
        foreach ((string path, Aov kind) in _files)
        {
            (IImageRows image, string range) = AovFiles.Rows(path, film, kind);
            KeyValuePair<string, string>[] texts = [.. writing.Metadata, new("Aov", AovFiles.Name(kind)), new("Range", range)];
            ImageWriteOptions plain = writing with { Exposure = 0, ToneMap = ToneMap.Clamp, Metadata = texts };
            written.AddRange(ImageOutputs.Write([path], image, plain, streams));
        }

        if (denoised is not null)
        {
            written.AddRange(ImageOutputs.Write(_denoised, denoised, writing with { Metadata = [.. writing.Metadata, new("Denoised", "yes")] }, streams));
        }

        return written;
    }
}
