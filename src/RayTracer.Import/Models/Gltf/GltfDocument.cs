using System.Text;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>A glTF file that is open: its JSON, the lists that indices refer to, and what the whole import shares.</summary>
internal sealed class GltfDocument(GltfSource source, JsonNode root, string folder, ReadOnlyMemory<byte>? binaryChunk, ModelMemory memory)
{
    private readonly Dictionary<string, IReadOnlyList<GltfObject>> _lists = new(StringComparer.Ordinal);

    /// <summary>The file's root object.</summary>
    public GltfObject Root { get; } = new(source, root, "");

    /// <summary>The place of the JSON.</summary>
    public GltfSource Source => source;

    /// <summary>The folder that relative paths start from.</summary>
    public string Folder => folder;

    /// <summary>The binary chunk of a .glb file; null where there is none.</summary>
    public ReadOnlyMemory<byte>? BinaryChunk => binaryChunk;

    /// <summary>The memory that may be allocated.</summary>
    public ModelMemory Memory => memory;

    /// <summary>The notes for the user.</summary>
    public ModelNotes Notes { get; } = new();

    /// <summary>One of the root's lists.</summary>
    public IReadOnlyList<GltfObject> List(string name) => _lists.Remember(name, () => Root.Children(name));

    /// <summary>The object that an index refers to; null where there is no such property.</summary>
    /// <param name="from">The object that holds the index.</param>
    /// <param name="key">The property that is the index.</param>
    /// <param name="listName">The root's list that it points into.</param>
    public int? Reference(GltfObject from, string key, string listName)
    {
        if (from.Integer(key) is not { } index)
        {
            return null;
        }

        Check(from, key, index, listName);
        return index;
    }

    /// <summary>The object that a required index refers to.</summary>
    public int RequiredReference(GltfObject from, string key, string listName) => Reference(from, key, listName) ?? throw from.Missing(key);

    /// <summary>A list of indices into one of the root's lists.</summary>
    public IReadOnlyList<int> References(GltfObject from, string key, string listName)
    {
        IReadOnlyList<int> indices = from.Integers(key);
        foreach (int index in indices)
        {
            Check(from, key, index, listName);
        }

        return indices;
    }

    private void Check(GltfObject from, string key, int index, string listName)
    {
        int count = List(listName).Count;
        if (index >= count)
        {
            throw from.Error(key, $"there is no {listName}[{index}]: {(count == 0 ? "the file has none" : $"the last is [{count - 1}]")}");
        }
    }
}

/// <summary>The JSON text of a glTF file, and how messages name places in it.</summary>
/// <param name="text">The text.</param>
/// <param name="glbOffset">The offset of the text in a .glb file, in bytes; null where the text is a separate file.</param>
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
