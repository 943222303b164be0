using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>The textures of materials, and of the materials within them.</summary>
internal static class MaterialTextures
{
    /// <summary>True where a material looks different where uv is, or turns with it.</summary>
    public static bool NeedUv(MaterialDescription material)
    {
        Dictionary<string, object?> values = RecordType.Of(material.GetType()).Parameters.ToDictionary(p => p.PropertyName, p => p.Get(material));
        return values.Values.Any(v => v is (TextureDescription and not SolidTextureDescription) || (v is MaterialDescription inner && NeedUv(inner)))
            || !Equals(values.GetValueOrDefault("AlphaU"), values.GetValueOrDefault("AlphaV"))
            || values.GetValueOrDefault("Anisotropic") is SolidTextureDescription { Color.R: not 0 };
    }

    /// <summary>True where a material has the colours of a mesh's corners.</summary>
    public static bool UseColors(object material) =>
        material is VertexColorTextureDescription || RecordType.Of(material.GetType()).Parameters.Any(p => p.Get(material) is (MaterialDescription or TextureDescription) and var part && UseColors(part));

    /// <summary>A material with other textures.</summary>
    /// <param name="material">The material.</param>
    /// <param name="change">Makes another texture of each that is not the same colour everywhere.</param>
    public static MaterialDescription Map(MaterialDescription material, Func<TextureDescription, TextureDescription> change)
    {
        RecordType type = RecordType.Of(material.GetType());
        object changed = type.Create();
        foreach (RecordParameter parameter in type.Parameters)
        {
            parameter.Set(changed, parameter.Get(material) switch
            {
                TextureDescription texture and not SolidTextureDescription => change(texture),
                MaterialDescription inner => Map(inner, change),
                var other => other,
            });
        }

        return (MaterialDescription)changed;
    }
}
