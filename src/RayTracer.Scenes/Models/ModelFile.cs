using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Reads model files, by their extension.</summary>
public static class ModelFile
{
    private static readonly Dictionary<string, Func<string, ImportedModel>> Readers = new(StringComparer.OrdinalIgnoreCase)
    {
        [".glb"] = GltfReader.Read,
        [".gltf"] = GltfReader.Read,
        [".obj"] = ObjReader.Read,
        [".ply"] = PlyReader.Read,
        [".serialized"] = SerializedReader.Read,
        [".stl"] = StlReader.Read,
    };

    /// <summary>The extensions of the formats that are read, with their dots.</summary>
    public static IReadOnlyCollection<string> Extensions => Readers.Keys;

    /// <summary>Whether a path has the extension of a format that is read.</summary>
    public static bool IsModel(string path) => Readers.ContainsKey(Path.GetExtension(path));

    /// <summary>Reads a model.</summary>
    /// <param name="path">The file's path; files that it names are looked for from its folder.</param>
    /// <exception cref="ModelException">It is of no format that is read, or something is wrong with it.</exception>
    /// <exception cref="IOException">It cannot be opened.</exception>
    public static ImportedModel Read(string path)
    {
        string extension = Path.GetExtension(path);
        return Readers.TryGetValue(extension, out Func<string, ImportedModel>? read)
            ? read(path)
            : throw new ModelException($"{(extension.Length > 0 ? Quotation.Of(extension) : "a file without an extension")} is no format of models that is read here: {string.Join(", ", Extensions)}");
    }
}
