using System.Reflection;
using RayTracer.Textures;

namespace RayTracer.Description;

/// <summary>All records that a scene file may hold, found by their attributes.</summary>
public static class SceneTypes
{
    /// <summary>The whole scene.</summary>
    public static RecordType Scene { get; } = RecordType.Of(typeof(SceneDescription));

    /// <summary>The shapes.</summary>
    public static TypeFamily Shapes { get; } = Family("shape", typeof(ShapeDescription));

    /// <summary>The materials.</summary>
    public static TypeFamily Materials { get; } = Family("material", typeof(MaterialDescription));

    /// <summary>The textures.</summary>
    public static TypeFamily Textures { get; } = Family("texture", typeof(TextureDescription));

    /// <summary>The environments of scenes.</summary>
    public static TypeFamily Environments { get; } = Family("environment", typeof(EnvironmentDescription));

    /// <summary>The four families.</summary>
    public static IReadOnlyList<TypeFamily> Families { get; } = [Shapes, Materials, Textures, Environments];

    /// <summary>The scene and all records without a type that are parts of it or of its things, such as the camera, outer ones first.</summary>
    public static IReadOnlyList<RecordType> Parts { get; } =
        [.. WithParts(Scene).Concat(Families.SelectMany(f => f.Types).SelectMany(t => WithParts(t).Skip(1))).Distinct()];

    internal static RecordParameter SolidColor { get; } =
        RecordType.Of(typeof(SolidTextureDescription)).Parameters.First(p => p.PropertyName == nameof(SolidTextureDescription.Color));

    private static TypeFamily Family(string noun, Type family) => new(noun, [.. family.Assembly.GetTypes()
        .Where(t => t.IsSubclassOf(family) && t.GetCustomAttribute<SceneTypeAttribute>() is not null)
        .Select(RecordType.Of)
        .OrderBy(t => t.Name, StringComparer.Ordinal)]);

    private static IEnumerable<RecordType> WithParts(RecordType type) => type.Parameters
        .Where(p => p.RecordType is not null)
        .SelectMany(p => WithParts(RecordType.Of(p.RecordType!)))
        .Prepend(type);
}
