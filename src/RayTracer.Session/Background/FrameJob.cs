using System.Globalization;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>Renders frames of an animation, one after the other, as <c>raytracer render --frames</c> does.</summary>
/// <param name="order">What is rendered, but for the frame.</param>
/// <param name="shown">What is shown.</param>
/// <param name="place">Where the document is at home.</param>
/// <param name="pattern">The files, with signs # for the number.</param>
/// <param name="tone">How light is brought into the pictures.</param>
internal sealed class FrameJob(RenderOrder order, ShownScene shown, DocumentPlace place, string pattern, Tone tone)
{
    private readonly Dictionary<(string Path, bool Raw), Picture> _pictures = [];
    private readonly string _scene = Path.GetFullPath(place.Path ?? Path.Combine(place.Folder, place.Name));

    /// <summary>A frame's file: its number in place of the last signs #, with zeros before it.</summary>
    public string FileOf(int frame)
    {
        int end = pattern.LastIndexOf('#') + 1;
        int first = end;
        while (first > 0 && pattern[first - 1] == '#')
        {
            first--;
        }

        return end == 0 ? pattern : pattern[..first] + frame.ToString(CultureInfo.InvariantCulture).PadLeft(end - first, '0') + pattern[end..];
    }

    /// <summary>Renders them.</summary>
    /// <returns>What to tell the user.</returns>
    /// <exception cref="SessionException">The scene is wrong at a frame.</exception>
    public string Run(int first, int last, IProgress<double> progress, CancellationToken cancellation)
    {
        int count = last - first + 1;
        int kept = 0;
        for (int frame = first; frame <= last; frame++)
        {
            kept += Make(frame, new Share(progress, (double)(frame - first) / count, 1.0 / count), cancellation) ? 0 : 1;
        }

        return $"wrote {count - kept} frames, {FileOf(first)} to {Path.GetFileName(FileOf(last))}{(kept > 0 ? $"; {kept} were there already" : "")}";
    }

    // False where the file is there already.
    private bool Make(int frame, IProgress<double> progress, CancellationToken cancellation)
    {
        cancellation.ThrowIfCancellationRequested();
        SceneLoadResult load = SceneLoader.LoadText(
            shown.Good.Text, place.Name, place.Folder, s => s with { Render = s.Render with { SamplesPerPixel = order.Scene.Render.SamplesPerPixel } }, frame, ReadPicture);
        if (load.Scene is not { } scene)
        {
            throw new SessionException($"these errors are at frame {frame}: {load.Diagnostics.First(d => d.Severity == Severity.Error).Message}");
        }

        string file = FileOf(frame);
        string content = ContentHash.OfPicture(load.Description!, Path.Combine(place.Folder, place.Name), order.Region);
        string command = CommandText.Of(place with { Path = _scene }, shown.Description, new() { Region = order.Region, Samples = order.Scene.Render.SamplesPerPixel }, tone, file, frame);
        if (FinishedPicture.Is(file, content, command))
        {
            progress.Report(1);
            return false;
        }

        Film film = BackgroundRenders.Render(scene, BackgroundRenders.Options(order), progress, cancellation);
        int samples = scene.Render.SamplesPerPixel;
        KeyValuePair<string, string>[] texts =
        [
            new("Software", ProgramName.Text),
            new("Command", command),
            new("Scene", place.Name),
            new("Samples", $"{samples}"),
            new("FilmHash", film.ComputeHash()),
            new("SampleRange", FilmHeader.Text(new(0, samples))),
            new("Content", content),
        ];
        ImageFile.Write(file, film, new() { Exposure = tone.Exposure, ToneMap = tone.ToneMap, Metadata = texts });
        return true;
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

    private sealed class Share(IProgress<double> whole, double before, double part) : IProgress<double>
    {
        public void Report(double value) => whole.Report(before + (part * value));
    }
}
