using System.Globalization;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Testing;

/// <summary>The scene that an image was rendered from, so that a failure can name the command that renders its worst pixel again.</summary>
public sealed class ReplayScene
{
    private readonly string? _path;
    private readonly string? _text;
    private readonly string[] _options;

    private ReplayScene(string? path, string? text, string[] options) => (_path, _text, _options) = (path, text, options);

    /// <summary>A scene file.</summary>
    /// <param name="path">Where it lies.</param>
    /// <param name="options">Options of <c>raytracer render</c> that change the scene as the test did, such as <c>--seed</c>, <c>7</c>.</param>
    public static ReplayScene File(string path, params string[] options) => new(Path.GetFullPath(path), null, options);

    /// <summary>A scene given as the text of a scene file; it is written beside the pictures. Pictures that it names need full paths.</summary>
    /// <param name="json">The text.</param>
    /// <param name="options">As for <see cref="File"/>.</param>
    public static ReplayScene Text(string json, params string[] options) => new(null, json, options);

    /// <summary>A description, as changed by a test; it is written beside the pictures. Pictures that it names need full paths.</summary>
    /// <param name="scene">The description.</param>
    /// <param name="options">As for <see cref="File"/>.</param>
    public static ReplayScene Of(SceneDescription scene, params string[] options) => Text(SceneWriter.Write(scene), options);

    /// <summary>Name of the file in the failure's folder that holds a scene given as text.</summary>
    internal const string FileName = "scene.json";

    /// <summary>The text that is to be written to <see cref="FileName"/>; null where the scene is a file already.</summary>
    internal string? Content => _text;

    /// <summary>The command that renders one pixel; it works from any folder.</summary>
    internal string Command(string folder, int x, int y)
    {
        string pixel = string.Create(CultureInfo.InvariantCulture, $"{x},{y}");
        string[] words = ["render", _path ?? Path.Combine(folder, FileName), "--pixel", pixel, .. _options];
        string[] program = ProjectFolder.Found is { } root
            ? ["dotnet", "run", "-c", "Release", "--project", Path.Combine(root, "src", "RayTracer.Cli"), "--"]
            : ["raytracer"];
        return string.Join(' ', program.Concat(words).Select(Quote));
    }

    private static string Quote(string word) =>
        word.Length > 0 && word.All(c => char.IsAsciiLetterOrDigit(c) || "-_./,=".Contains(c, StringComparison.Ordinal))
            ? word
            : $"'{word.Replace("'", "'\\''", StringComparison.Ordinal)}'";
}
