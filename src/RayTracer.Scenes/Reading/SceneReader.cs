using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Reads scene files in the native format. Bad content never throws: it becomes diagnostics, all of them at once.</summary>
public static class SceneReader
{
    /// <summary>The largest scene file that is read, in bytes.</summary>
    public const int MaximumBytes = 1 << 28;

    /// <summary>Reads a file.</summary>
    /// <param name="path">The file's path, by which diagnostics call it too.</param>
    /// <param name="settings">Values to put in the place of the file's; null for none.</param>
    /// <param name="frame">The frame whose values animated properties get; null for those that the file has in their places.</param>
    public static SceneReadResult Read(string path, IReadOnlyList<SceneSetting>? settings = null, int? frame = null)
    {
        byte[]? bytes;
        try
        {
            if (FileSearch.Complaint(path, isStream: true) is { } complaint)
            {
                return Unreadable(path, complaint);
            }

            bytes = Bytes(path);
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException or NotSupportedException)
        {
            return Unreadable(path, $"cannot be read: {e.Message.TrimEnd('.')}");
        }

        if (bytes is null)
        {
            return Unreadable(path, $"larger than {MaximumBytes >> 20} MiB");
        }

        SourceText source = SourceText.Decode(path, bytes, out Diagnostic? error);
        return error is null ? Read(source, settings, frame) : new(source, null, null, new(), [error with { Rule = DiagnosticRule.Unreadable }]);
    }

    /// <summary>Reads a text.</summary>
    /// <param name="text">The scene file's text.</param>
    /// <param name="fileName">The name of the file in diagnostics.</param>
    /// <param name="settings">Values to put in the place of the text's; null for none.</param>
    /// <param name="frame">The frame whose values animated properties get; null for those that the file has in their places.</param>
    public static SceneReadResult ReadText(string text, string fileName, IReadOnlyList<SceneSetting>? settings = null, int? frame = null) =>
        Read(new SourceText(fileName, text), settings, frame);

    private static SceneReadResult Read(SourceText source, IReadOnlyList<SceneSetting>? settings, int? frame)
    {
        DiagnosticBag bag = new(source);
        SourceMap map = new();
        JsonNode? root = JsonParser.Parse(source, bag.Diagnostics);
        if (root is not null && settings is not null)
        {
            root = settings.Aggregate(root, (tree, setting) => SettingTree.Apply(setting, tree, source, bag));
        }

        SceneDescription? scene = root is null ? null : RecordReader.ReadScene(root, bag, map);
        if (frame is { } number && scene is { Animation.Count: > 0 } && bag.Diagnostics.Count == 0)
        {
            root = AnimationTrack.Apply(root!, scene.Animation, map, number / (double)scene.Render.FramesPerSecond);


            // What is set for the picture goes before tracks.
            IEnumerable<SceneSetting> ofPicture = (settings ?? []).Where(s => s.Path.StartsWith("render.", StringComparison.Ordinal));
            root = ofPicture.Aggregate(root, (tree, setting) => SettingTree.Apply(setting, tree, source, bag));
            map = new();
            scene = RecordReader.ReadScene(root, bag, map);
        }

        return new(source, root, scene, map, bag.Diagnostics);
    }

    /// <summary>The result for a file that is none, or not to be opened.</summary>
    internal static SceneReadResult Unreadable(string path, string message) =>
        new(null, null, null, new(), [new(path, 0, 0, Severity.Error, message) { Rule = DiagnosticRule.Unreadable }]);

    // Not File.ReadAllBytes: a device or a pipe has no end and no length. Null where there is too much.
    private static byte[]? Bytes(string path)
    {
        using FileStream stream = File.OpenRead(path);
        using MemoryStream bytes = new();
        byte[] block = new byte[1 << 16];
        for (int read = stream.Read(block); read > 0; read = stream.Read(block))
        {
            bytes.Write(block, 0, read);
            if (bytes.Length > MaximumBytes)
            {
                return null;
            }
        }

        return bytes.ToArray();
    }
}

/// <summary>The result of reading a scene file.</summary>
public sealed class SceneReadResult
{
    internal SceneReadResult(SourceText? source, JsonNode? root, SceneDescription? partial, SourceMap map, IEnumerable<Diagnostic> diagnostics)
    {
        Source = source;
        Root = root;
        Partial = partial;
        SourceMap = map;
        Diagnostics = Diagnostic.Sort(diagnostics);
        Description = Diagnostics.Any(d => d.Severity == Severity.Error) ? null : partial;
    }

    /// <summary>The scene; null where any diagnostic is an error.</summary>
    public SceneDescription? Description { get; }

    /// <summary>The diagnostics, by position.</summary>
    public IReadOnlyList<Diagnostic> Diagnostics { get; }

    /// <summary>The place of each record of the scene in the file.</summary>
    public SourceMap SourceMap { get; }

    /// <summary>The file's JSON, for editors; null after an error of syntax.</summary>
    public JsonNode? Root { get; }

    /// <summary>The file's text, which the offsets of <see cref="Root"/> count in; null where it could not be read.</summary>
    public SourceText? Source { get; }

    // What could be read in spite of errors, with defaults in place of what could not.
    internal SceneDescription? Partial { get; }
}
