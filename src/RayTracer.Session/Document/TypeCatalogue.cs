using RayTracer.Description;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Session;

/// <summary>What scenes can be made of, as property panels need it. The same for every session.</summary>
/// <param name="Schema">The JSON Schema of scene files.</param>
/// <param name="Types">The types of shapes, materials and textures, by family.</param>
/// <param name="Sections">The records that there is one of: scene, camera, lens, render, and those of lists.</param>
/// <param name="RefractiveIndices">The report's table 4.1.</param>
/// <param name="Colors">The colours of CSS by their names, as #rrggbb.</param>
/// <param name="Maps">The things that the view can show of a picture.</param>
public sealed record TypeCatalogue(
    Json Schema, IReadOnlyDictionary<string, IReadOnlyList<CatalogueType>> Types, IReadOnlyDictionary<string, CatalogueType> Sections,
    IReadOnlyList<RefractiveIndex> RefractiveIndices, IReadOnlyDictionary<string, string> Colors, IReadOnlyList<ViewMap> Maps)
{
    /// <summary>The catalogue.</summary>
    public static TypeCatalogue Instance { get; } = new(
        Json.Parse(SceneSchema.Generate())!,
        SceneTypes.Families.ToDictionary(f => f.Noun, f => (IReadOnlyList<CatalogueType>)[.. f.Types.Select(t => CatalogueType.Of(t, f))], StringComparer.Ordinal),
        SceneTypes.Parts.ToDictionary(t => t.Name, t => CatalogueType.Of(t), StringComparer.Ordinal),
        RefractiveIndex.All,
        CssColors.Names.ToDictionary(n => n, n => Outline.Hex(CssColors.Find(n)!.Value), StringComparer.Ordinal),
        ViewMap.All);
}
