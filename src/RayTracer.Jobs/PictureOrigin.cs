using System.Globalization;
using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Jobs;

/// <summary>What a film or an image of the program says about how it was rendered.</summary>
/// <param name="Scene">The scene's file, where there is one.</param>
/// <param name="Options">The options that replace what it says, and the part: names and values.</param>
public sealed record PictureOrigin(string Scene, IReadOnlyList<KeyValuePair<string, string>> Options)
{
    private static readonly string[] WithoutValue = ["--denoise", "--adaptive", "--quiet", "--verbose", "--json", "--preview", "--exr-film", "--resume"];

    /// <summary>The number of samples; null for the scene's.</summary>
    public int? Samples => Last("--spp") is { } word && int.TryParse(word, CultureInfo.InvariantCulture, out int samples) && samples > 0 ? samples : null;

    /// <summary>The part; null for all of the picture.</summary>
    public Tile? Crop => Last("--crop")?.Split(',').Select(n => int.TryParse(n, CultureInfo.InvariantCulture, out int number) ? number : -1).ToArray() is [var x, var y, > 0 and var w, > 0 and var h]
        ? new(x, y, w, h) : null;

    /// <summary>Where the scene of a film or image is: where it was, or beside the file.</summary>
    /// <param name="scene">The scene as the command named it, from the folder where that ran.</param>
    /// <param name="file">The film or image.</param>
    /// <param name="outputs">The files that the command wrote, as it named them: <paramref name="file"/> tells from which folder.</param>
    public static string ScenePath(string scene, string file, IEnumerable<string>? outputs = null)
    {
        string full = Path.GetFullPath(file);
        IEnumerable<string> folders = (outputs ?? []).Select(o => o.StartsWith("./", StringComparison.Ordinal) ? o[2..] : o).Where(o => full.EndsWith(Path.DirectorySeparatorChar + o, StringComparison.Ordinal)).Select(o => full[..^o.Length]);
        string beside = Path.Combine(Path.GetDirectoryName(full)!, Path.GetFileName(scene));
        string? found = folders.Select(f => Path.Combine(f, scene)).Append(scene).Append(beside).FirstOrDefault(File.Exists);
        return found is null || Path.GetFullPath(found) == Path.GetFullPath(scene) ? scene : found;
    }

    /// <summary>What a film says.</summary>
    public static PictureOrigin Of(FilmHeader header, string file) => Of([header.Scene, .. FilmTexts.Words(header, header.Total)], file);

    /// <summary>What an image says.</summary>
    /// <exception cref="JobException">It says nothing.</exception>
    public static PictureOrigin OfImage(string path)
    {
        try
        {
            string? command = ImageFile.ReadText(path).FirstOrDefault(t => t.Key == "Command").Value;
            return command is not null && Shell.Words(command) is [_, "render", .. var words] ? Of(words, path)
                : throw new JobException($"{Path.GetFileName(path)} does not say which scene it shows: only images and films of this program do");
        }
        catch (PictureException e)
        {
            throw new JobException(e.Message.TrimEnd('.'), e);
        }
    }

    private static PictureOrigin Of(IReadOnlyList<string> words, string file)
    {
        List<KeyValuePair<string, string>> options = [];
        string? scene = null;
        for (int i = 0; i < words.Count; i++)
        {
            string word = words[i];
            int equals = word.IndexOf('=', StringComparison.Ordinal);
            if (!word.StartsWith('-'))
            {
                scene ??= word;
            }
            else if (word.StartsWith("--", StringComparison.Ordinal) && equals > 0)
            {
                options.Add(new(word[..equals], word[(equals + 1)..]));
            }
            else if (!WithoutValue.Contains(word) && i + 1 < words.Count)
            {
                options.Add(new(word, words[++i]));
            }
        }

        return scene is null ? throw new JobException($"{Path.GetFileName(file)} does not say which scene it shows") : new(Path.GetFullPath(ScenePath(scene, file, options.Where(o => o.Key is "-o" or "--output").Select(o => o.Value))), options);
    }

    private string? Last(string option) => Options.LastOrDefault(o => o.Key == option).Value;
}
