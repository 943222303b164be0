using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>Where a scene's text refers to a material, texture or object by its name.</summary>
internal static class SceneReferences
{
    /// <summary>All references to a definition.</summary>
    public static IEnumerable<SceneValue> To(JsonNode root, TypeFamily family, string name) => All(root).Where(v => v.Family == family && v.Reference == name);

    /// <summary>All references.</summary>
    public static IEnumerable<SceneValue> All(JsonNode root) => SceneValue.Scene(root).WithInner().Where(v => v.Reference is not null);

    /// <summary>The family of what is defined at a pointer, such as <c>/materials/glass</c>; null where it is no definition.</summary>
    public static TypeFamily? DefinedAt(string pointer) => JsonPointer.Parse(pointer) switch
    {
        ["materials", _] => SceneTypes.Materials,
        ["textures", _] => SceneTypes.Textures,
        ["objects", _] => SceneTypes.Shapes,
        _ => null,
    };
}
