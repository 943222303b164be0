using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>A record of scene files.</summary>
/// <param name="Name">What is written after "type", or the key that it stands under.</param>
/// <param name="Summary">What it is.</param>
/// <param name="Parameters">What it may have.</param>
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
