using RayTracer.Textures;

namespace RayTracer.Description;

/// <summary>
/// All records that a scene file may hold, found by their attributes; those of other assemblies are added by <see cref="Plugins"/>.
/// </summary>
public static class SceneTypes
{
    /// <summary>The whole scene.</summary>
    public static RecordType Scene { get; } = RecordType.Of(typeof(SceneDescription));

    /// <summary>The shapes.</summary>
    public static TypeFamily Shapes { get; } = new("shape", typeof(ShapeDescription));

    /// <summary>The materials.</summary>
    public static TypeFamily Materials { get; } = new("material", typeof(MaterialDescription));

    /// <summary>The textures.</summary>
    public static TypeFamily Textures { get; } = new("texture", typeof(TextureDescription));

    /// <summary>The environments of scenes.</summary>
    public static TypeFamily Environments { get; } = new("environment", typeof(EnvironmentDescription));

    /// <summary>The four families.</summary>
    public static IReadOnlyList<TypeFamily> Families { get; } = [Shapes, Materials, Textures, Environments];

    /// <summary>
    /// The scene and all records without a type that are parts of it or of its things, such as the camera, outer ones first.
    /// </summary>
    public static IReadOnlyList<RecordType> Parts =>
        [.. WithParts(Scene).Concat(Families.SelectMany(f => f.Types).SelectMany(t => WithParts(t).Skip(1))).Distinct()];

    /// <summary>All records: the scene and its parts, then the families' types.</summary>
    public static IEnumerable<RecordType> All => Parts.Concat(Families.SelectMany(f => f.Types));

    internal static RecordParameter SolidColor { get; } =
        RecordType.Of(typeof(SolidTextureDescription)).Parameters.First(p => p.PropertyName == nameof(SolidTextureDescription.Color));

    private static IEnumerable<RecordType> WithParts(RecordType type) => type.Parameters
        .Where(p => p.RecordType is not null && RecordType.Of(p.RecordType) != type)
        .SelectMany(p => WithParts(RecordType.Of(p.RecordType!)))
        .Prepend(type);
}
