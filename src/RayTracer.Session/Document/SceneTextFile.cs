using System.Text;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Import;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>Reads and writes the texts of scenes: those of scene files, and those made up for model files.</summary>
internal static class SceneTextFile
{
    /// <summary>The text of a new scene: something to see at once.</summary>
    public const string NewScene = """
        // A new scene.
        {
          "camera": { "position": [0, 1.6, 5], "lookAt": [0, 0.9, 0], "fieldOfView": 36 },
          "render": { "width": 800, "height": 600, "samplesPerPixel": 64 },
          "background": [0.52, 0.7, 0.95],
          "materials": {
            "ball": { "type": "diffuse", "color": "tomato" },
            "floor": { "type": "diffuse", "color": [0.7, 0.68, 0.62] },
          },
          "shapes": [
            { "type": "sphere", "name": "ball", "center": [0, 1, 0], "radius": 1, "material": "ball" },
            { "type": "plane", "name": "floor", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "floor" },
          ],
          "lights": [
            { "type": "sphere", "name": "lamp", "center": [2.5, 4, 2.5], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 30 } },
          ],
        }

        """;

    /// <summary>Reads a scene file.</summary>
    /// <param name="path">The file.</param>
    /// <returns>The text, with \n at each line's end, and what ends the file's lines.</returns>
    /// <exception cref="SessionException">It cannot be read, or is no text.</exception>
    public static (string Text, string LineEnd) Read(string path)
    {
        byte[] bytes = Guard(path, () =>
        {
            if (!File.Exists(path))
            {
                throw new SessionException($"there is no file {path}");
            }

            using FileStream stream = File.OpenRead(path);
            using MemoryStream content = new();
            Bounded.Copy(stream, content, SceneReader.MaximumBytes, $"{path} is larger than a scene file may be");
            return content.ToArray();
        });
        SourceText source = SourceText.Decode(path, bytes, out Diagnostic? error);
        if (error is not null)
        {
            throw new SessionException($"{Path.GetFileName(path)} cannot be opened: {error.Message}");
        }

        string text = source.Text.ReplaceLineEndings("\n");
        return (text, source.Text == text.ReplaceLineEndings("\r\n") && text.Contains('\n', StringComparison.Ordinal) ? "\r\n" : "\n");
    }

    /// <summary>Makes a scene's text of a model file: the model, and the camera and light that are its own or made up.</summary>
    /// <exception cref="SessionException">It cannot be read.</exception>
    public static string ReadModel(string path) => Guard(path, () =>
    {
        try
        {
            return SceneWriter.Write(ModelScene.Of(ModelFile.Read(path), Path.GetFileName(path)).Scene);
        }
        catch (Exception e) when (e is ModelException or ArgumentException)
        {
            throw new SessionException($"{Path.GetFileName(path)} cannot be opened: {e.Message.TrimEnd('.')}", e);
        }
    });

    /// <summary>Makes a scene's text of one in another program's format, with its warnings as comments at the head.</summary>
    /// <exception cref="SessionException">There is something wrong with it.</exception>
    public static string ReadForeign(SceneFormat format, string path)
    {
        SceneReadResult read = format.Read(path);
        return read.Description is { } scene
            ? string.Concat(read.Diagnostics.Select(d => $"// {(d with { File = Path.GetFileName(d.File) }).ToString().ReplaceLineEndings(" ")}\n")) + SceneWriter.Write(scene)
            : throw new SessionException($"{Path.GetFileName(path)} cannot be opened: {read.Diagnostics.First(d => d.Severity == Severity.Error)}");
    }

    /// <summary>Writes a scene file under a temporary name and renames it.</summary>
    /// <exception cref="SessionException">It cannot be written; the old file is untouched.</exception>
    public static void Write(string path, string text, string lineEnd)
    {
        try
        {
            byte[] bytes = new UTF8Encoding(encoderShouldEmitUTF8Identifier: false).GetBytes(lineEnd == "\n" ? text : text.ReplaceLineEndings(lineEnd));
            AtomicFile.Write(path, stream => stream.Write(bytes));
        }
        catch (ImageWriteException e)
        {
            throw new SessionException(e.Message.TrimEnd('.'), e);
        }
    }

    private static T Guard<T>(string path, Func<T> read)
    {
        try
        {
            return read();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or NotSupportedException)
        {
            throw new SessionException($"{path} cannot be opened: {e.Message.TrimEnd('.')}", e);
        }
    }
}
