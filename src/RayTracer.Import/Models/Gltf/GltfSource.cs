using System.Text;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>The JSON text of a glTF file, and how messages name places in it.</summary>
/// <param name="text">The text.</param>
/// <param name="glbOffset">Where the text begins in a .glb file, in bytes; null where the text is a separate file.</param>
internal sealed class GltfSource(SourceText text, int? glbOffset)
{
    /// <summary>The text.</summary>
    public SourceText Text => text;

    /// <summary>An error at a value: by line and column, in a .glb file by byte.</summary>
    public ModelException Error(JsonNode at, string message) => Error(at.Start, message);

    /// <summary>An error at an offset in the text.</summary>
    public ModelException Error(int at, string message)
    {
        if (glbOffset is { } offset)
        {
            int bytes = Encoding.UTF8.GetByteCount(text.Text.AsSpan(0, at));
            return new($"byte {offset + bytes}: {message}");
        }

        (int line, int column) = text.Position(at);
        return new($"line {line}, column {column}: {message}");
    }
}
