using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>A record of scene files.</summary>
/// <param name="Name">What is written after "type", or the key that it stands under.</param>
/// <param name="Summary">What it is.</param>
/// <param name="Parameters">What it may have.</param>
/// <param name="IsLight">Whether it is a light without extent, which needs no luminaire to shine.</param>
public sealed record CatalogueType(string Name, string Summary, IReadOnlyList<CatalogueParameter> Parameters, bool IsLight)
{
    /// <summary>Describes a record.</summary>
    public static CatalogueType Of(RecordType type) => new(type.Name, type.Summary, [.. type.Parameters.Select(CatalogueParameter.Of)], type.IsLight);
}
