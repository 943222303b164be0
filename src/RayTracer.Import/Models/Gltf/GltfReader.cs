using System.Collections.Frozen;
using RayTracer.Description;
using RayTracer.Scenes;
using static RayTracer.Import.ModelCheck;

namespace RayTracer.Import;

/// <summary>Reads glTF 2.0 files, .gltf and .glb (Khronos Group 2021).</summary>
internal static class GltfReader
{
    // What a value of JSON takes at least, with its node and text.
    private const long BytesPerValue = 120;

    /// <summary>Reads a file and those that it names.</summary>
    /// <param name="path">The file; its first bytes decide which of the two forms it has.</param>
    /// <exception cref="ModelException">Something is wrong with it; the message says what and where.</exception>
    /// <exception cref="IOException">It cannot be opened.</exception>
    public static ImportedModel Read(string path)
    {
        using FileStream stream = new(path, FileMode.Open, FileAccess.Read, FileShare.Read, bufferSize: 1);
        Require(stream.Length <= Array.MaxLength, "the file is larger than 2 GiB");

        byte[] bytes = new byte[stream.Length];
        stream.ReadExactly(bytes);
        return Read(bytes, Path.GetDirectoryName(Path.GetFullPath(path)) ?? "");
    }

    /// <summary>Reads a file that is in memory.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="folder">The folder where the files that it names are.</param>
    /// <exception cref="ModelException">Something is wrong with it; the message says what and where.</exception>
    public static ImportedModel Read(ReadOnlyMemory<byte> file, string folder)
    {
        ModelMemory memory = new();
        memory.AddFile(file.Length);
        bool isGlb = GlbContainer.IsGlb(file.Span);
        (ReadOnlyMemory<byte> json, ReadOnlyMemory<byte>? binary) = isGlb ? GlbContainer.Split(file) : (file, null);
        CheckSize(json.Span, memory);
        SourceText text = SourceText.Decode("", json.Span, out Diagnostic? error);
        GltfSource source = new(text, isGlb ? GlbContainer.JsonStart : null);
        List<Diagnostic> diagnostics = [];
        if (error is not null)
        {
            throw source.Error(text.Text.Length, error.Message);
        }

        JsonNode? root = JsonParser.Parse(text, diagnostics);
        if (diagnostics.Count > 0)
        {
            throw source.Error(text.Offset(diagnostics[0].Line, diagnostics[0].Column), diagnostics[0].Message);
        }

        if (root is not { Kind: JsonKind.Object })
        {
            throw source.Error(root!, "a glTF file must be an object { … }");
        }

        GltfDocument document = new(source, root, folder, binary, memory);
        CheckVersion(document);
        GltfExtensions.Check(document);
        return GltfScene.Import(document);
    }

    // A value takes two bytes in the file, and some hundred as a node.
    private static void CheckSize(ReadOnlySpan<byte> json, ModelMemory memory)
    {
        if (!memory.TryUse((json.Count((byte)',') + json.Count((byte)'[') + json.Count((byte)'{')) * BytesPerValue))
        {
            throw new ModelException("the JSON has far too many values for its size: large data belongs in buffers");
        }
    }

    private static void CheckVersion(GltfDocument document)
    {
        GltfObject asset = document.Root.RequiredChild("asset");
        string needed = asset.Text("minVersion") ?? asset.Text("version") ?? throw asset.Missing("version");
        if (needed != "2" && !needed.StartsWith("2.", StringComparison.Ordinal))
        {
            throw asset.Error(asset.Has("minVersion") ? "minVersion" : "version", $"the file is of version {Quotation.Of(needed)}: only glTF 2.0 is read");
        }
    }
}

/// <summary>The extensions of glTF that are understood.</summary>
internal static class GltfExtensions
{
    /// <summary>Those of materials.</summary>
    public static FrozenSet<string> Materials { get; } = FrozenSet.ToFrozenSet(
    [
        "KHR_materials_anisotropy", "KHR_materials_clearcoat", "KHR_materials_diffuse_transmission", "KHR_materials_dispersion",
        "KHR_materials_emissive_strength", "KHR_materials_ior", "KHR_materials_iridescence", "KHR_materials_pbrSpecularGlossiness", "KHR_materials_sheen",
        "KHR_materials_specular", "KHR_materials_transmission", "KHR_materials_unlit", "KHR_materials_volume",
    ]);

    /// <summary>All.</summary>
    public static FrozenSet<string> All { get; } =
        FrozenSet.ToFrozenSet([.. Materials, "EXT_mesh_gpu_instancing", "KHR_lights_punctual", "KHR_materials_variants", "KHR_mesh_quantization", "KHR_texture_transform"]);

    /// <summary>Refuses a file that cannot be shown without an extension that is not understood.</summary>
    /// <exception cref="ModelException">There is one.</exception>
    public static void Check(GltfDocument document)
    {
        string[] unknown = [.. document.Root.Texts("extensionsRequired").Where(e => !All.Contains(e)).Distinct(StringComparer.Ordinal)];
        if (unknown.Length > 0)
        {
            throw document.Root.Error("extensionsRequired", $"the file cannot be shown without {string.Join(", ", unknown.Take(5).Select(Quotation.Of))}, which {(unknown.Length > 1 ? "are" : "is")} not understood here");
        }
    }
}
