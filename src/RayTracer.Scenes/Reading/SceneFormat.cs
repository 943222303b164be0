namespace RayTracer.Scenes;

/// <summary>A format of scene files other than the native one; RayTracer.Import registers Mitsuba's.</summary>
/// <param name="Extension">The extension, with its dot; upper and lower case are the same.</param>
/// <param name="Read">Reads the file of a path, by which diagnostics call it too.</param>
public sealed record SceneFormat(string Extension, Func<string, SceneReadResult> Read)
{
    private static readonly Dictionary<string, SceneFormat> Formats = new(StringComparer.OrdinalIgnoreCase);

    /// <summary>Adds a format, before the first scene is read.</summary>
    public static void Register(SceneFormat format) => Formats[format.Extension] = format;

    /// <summary>The format of a path; null where that is the native one, or a model's.</summary>
    public static SceneFormat? Of(string path) => Formats.GetValueOrDefault(Path.GetExtension(path));
}
