using RayTracer.Description;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Session;

/// <summary>A parameter of a record of scene files.</summary>
/// <param name="Key">Its key.</param>
/// <param name="Kind">The name of its <see cref="ParameterForm"/>.</param>
/// <param name="Summary">What it means.</param>
/// <param name="Unit">Its unit; empty where there is none.</param>
/// <param name="Minimum">The smallest allowed number; null where there is no bound.</param>
/// <param name="Maximum">The largest allowed number; null where there is no bound.</param>
/// <param name="MinimumIsExclusive">Whether the minimum itself is refused.</param>
/// <param name="Required">Whether it must be written.</param>
/// <param name="Choices">The words to choose from; empty where it is no choice.</param>
/// <param name="Default">What holds where nothing is written; null where it may be missing.</param>
/// <param name="Range">The allowed range in words; empty where every number is allowed.</param>
/// <param name="Family">shape, material, texture or environment where it is one, or several; otherwise null.</param>
/// <param name="Record">The section that it is, or that its elements are; otherwise null.</param>
/// <param name="IsNumber">Whether it is a texture in whose place a number may stand.</param>
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
