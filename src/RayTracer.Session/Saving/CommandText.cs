using System.Globalization;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Jobs;

namespace RayTracer.Session;

/// <summary>The command line that renders what the view shows.</summary>
public static class CommandText
{
    /// <summary>The command that renders a document as it was saved last.</summary>
    /// <param name="place">Where the document is at home.</param>
    /// <param name="scene">What it says.</param>
    /// <param name="settings">What the user wants besides.</param>
    /// <param name="tone">How light is brought into the picture.</param>
    /// <param name="output">The picture's file; null for one beside the scene's.</param>
    /// <param name="frame">The frame of the animation; null for the scene as it is written.</param>
    public static string Of(DocumentPlace place, SceneDescription? scene, ViewSettings settings, Tone tone, string? output = null, int? frame = null)
    {
        string path = place.Path ?? place.Name;
        List<string> words = ["render", path, "-o", output ?? Path.ChangeExtension(path, ".png")];
        void Add(string option, IFormattable value) => words.AddRange([option, value.ToString(null, CultureInfo.InvariantCulture)]);
        if (settings.Samples is { } samples && samples != scene?.Render.SamplesPerPixel)
        {
            Add("--spp", samples);
        }

        if (settings.Region is { } r)
        {
            words.AddRange(["--crop", string.Create(CultureInfo.InvariantCulture, $"{r.X},{r.Y},{r.Width},{r.Height}")]);
        }

        if (tone.Exposure != 0)
        {
            Add("--exposure", tone.Exposure);
        }

        if (tone.ToneMap != ToneMap.Clamp)
        {
            words.AddRange(["--tonemap", tone.ToneMap.ToString().ToLowerInvariant()]);
        }

        if (settings.Map == ViewMap.Denoised)
        {
            words.Add("--denoise");
        }

        if (frame is { } number)
        {
            Add("--frames", number);
        }

        return Shell.Command(words);
    }
}
