using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>The files that a scene's text names.</summary>
public static class FileNames
{
    /// <summary>The places of all names: of pictures, models and grids, and of the schema.</summary>
    internal static IEnumerable<SceneValue> All(JsonText text) => SceneValue.Scene(text.Root).WithInner()
        .Where(v => v is { Parameter.IsFile: true, Node: { Kind: JsonKind.String, Text.Length: > 0 } node } && !node.Text.Contains('\0', StringComparison.Ordinal));

    /// <summary>True for the name of a picture, model or grid: scenes have no use for other files.</summary>
    internal static bool IsNamed(string path) => ImageFormat.OfName(path) is not null || ModelFile.IsModel(path) || VolumeFile.IsNamed(path);

    /// <summary>
    /// Rewrites relative names for a text that moves to another folder, so that they name the same files. Names of no file stay.
    /// </summary>
    /// <param name="text">The scene.</param>
    /// <param name="from">The folder from which its names are meant.</param>
    /// <param name="to">The folder from which they are to be meant.</param>
    public static JsonText Move(JsonText text, string from, string to)
    {
        IEnumerable<Scenes.JsonNode> names = All(text).Select(v => v.Node!);
        if (text.Root.Find("$schema") is { Kind: JsonKind.String, Text.Length: > 0 } schema && !schema.Text.Contains(':', StringComparison.Ordinal))
        {
            names = names.Append(schema);
        }

        return text.With(names.Where(n => !Path.IsPathRooted(n.Text) && File.Exists(Path.Combine(from, n.Text)))
            .Select(n => new TextEdit(n.Start, n.End, JsonLayout.Quote(Relative(to, Path.GetFullPath(Path.Combine(from, n.Text)))))));
    }

    /// <summary>As the other one, for a text that is JSON.</summary>
    /// <exception cref="SessionException">It is none.</exception>
    public static string Move(string text, string from, string to) => Move(JsonText.Of(text), from, to).Text;

    private static string Relative(string folder, string file) => Path.GetRelativePath(folder, file).Replace('\\', '/');
}
