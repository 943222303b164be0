using System.Collections.Frozen;
using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>The extensions of glTF that are understood.</summary>
internal static class GltfExtensions
{
    /// <summary>Those of materials.</summary>
    public static FrozenSet<string> Materials { get; } = FrozenSet.ToFrozenSet(
    [
        "KHR_materials_clearcoat", "KHR_materials_emissive_strength", "KHR_materials_ior", "KHR_materials_pbrSpecularGlossiness",
        "KHR_materials_sheen", "KHR_materials_specular", "KHR_materials_transmission", "KHR_materials_unlit", "KHR_materials_volume",
    ]);

    /// <summary>All.</summary>
    public static FrozenSet<string> All { get; } =
        FrozenSet.ToFrozenSet([.. Materials, "KHR_lights_punctual", "KHR_mesh_quantization", "KHR_texture_transform"]);

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
