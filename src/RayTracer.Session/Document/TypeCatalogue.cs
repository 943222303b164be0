using RayTracer.Description;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Session;

/// <summary>The types that scenes can be made of, as property panels need them. The same for every session.</summary>
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

/// <summary>A record of scene files.</summary>
/// <param name="Name">The name written after "type", or the key that it stands under.</param>
/// <param name="Summary">A description of it.</param>
/// <param name="Parameters">Its parameters.</param>
/// <param name="AddedAs">The families of things (shape, light, material …) among which editors offer it to be added.</param>
public sealed record CatalogueType(string Name, string Summary, IReadOnlyList<CatalogueParameter> Parameters, IReadOnlyList<string> AddedAs)
{
    /// <summary>Describes a record.</summary>
    /// <param name="type">The record.</param>
    /// <param name="family">The family that it belongs to; null where it belongs to none.</param>
    public static CatalogueType Of(RecordType type, TypeFamily? family = null) =>
        new(type.Name, type.Summary, [.. type.Parameters.Select(CatalogueParameter.Of)], Families(type, family));

    private static string[] Families(RecordType type, TypeFamily? family) =>
        family is null ? [] : type.Create() is not ShapeDescription shape ? [family.Noun]
        : [.. Enum.GetValues<SketchKinds>().Where(k => k != SketchKinds.None && shape.SketchedAs.HasFlag(k)).Select(k => k.ToString().ToLowerInvariant())];
}

/// <summary>A parameter of a record of scene files.</summary>
/// <param name="Key">Its key.</param>
/// <param name="Kind">The name of its <see cref="ParameterForm"/>.</param>
/// <param name="Summary">The meaning.</param>
/// <param name="Unit">Its unit; empty where there is none.</param>
/// <param name="Minimum">The smallest allowed number; null where there is no bound.</param>
/// <param name="Maximum">The largest allowed number; null where there is no bound.</param>
/// <param name="MinimumIsExclusive">True if the minimum itself is refused.</param>
/// <param name="Required">True if it must be written.</param>
/// <param name="Choices">The words to choose from; empty where it is no choice.</param>
/// <param name="Default">The value where nothing is written; null where it may be missing.</param>
/// <param name="Range">The allowed range in words; empty where every number is allowed.</param>
/// <param name="Family">shape, material, texture or environment where it is one, or several; otherwise null.</param>
/// <param name="Record">The section that it is, or that its elements are; otherwise null.</param>
/// <param name="IsNumber">True if it is a texture in whose place a number may stand.</param>
public sealed record CatalogueParameter(
    string Key, string Kind, string Summary, string Unit, double? Minimum, double? Maximum, bool MinimumIsExclusive, bool Required,
    IReadOnlyList<string> Choices, Json? Default, string Range, string? Family, string? Record, bool IsNumber)
{
    /// <summary>Describes a parameter.</summary>
    public static CatalogueParameter Of(RecordParameter p) => new(
        p.Key, ParameterForm.Of(p).Name, p.Summary, p.Unit, Finite(p.Minimum), Finite(p.Maximum), p.MinimumIsExclusive, p.Required,
        p.Choices, JsonValues.Of(p, p.Default), p.Range, p.Family?.Noun, p.RecordType is null ? null : RecordType.Of(p.RecordType).Name, p.IsNumber);

    private static double? Finite(double bound) => double.IsFinite(bound) ? bound : null;
}

/// <summary>A clear substance and its refractive index.</summary>
/// <param name="Name">The substance.</param>
/// <param name="Value">Its index with respect to vacuum.</param>
public sealed record RefractiveIndex(string Name, double Value)
{
    /// <summary>The report's table 4.1, by name; of garnet, whose index varies, both ends.</summary>
    public static IReadOnlyList<RefractiveIndex> All { get; } =
    [
        new("amber", 1.54), new("cubic zirconia", 2.15), new("diamond", 2.417), new("emerald", 1.57), new("fused quartz", 1.46), new("garnet (lowest)", 1.73),
        new("garnet (highest)", 1.89), new("glass", 1.5), new("ice", 1.309), new("ruby", 1.77), new("sapphire", 1.77), new("sodium chloride", 1.53), new("water", 1.333),
    ];
}
