using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>The textures of materials, and of the materials within them.</summary>
internal static class MaterialTextures
{
    /// <summary>The same colour everywhere.</summary>
    public static TextureDescription Solid(Rgb color) => new SolidTextureDescription { Color = color };

    /// <summary>The same number everywhere.</summary>
    public static TextureDescription Solid(float number) => Solid(new Rgb(number, number, number));

    /// <summary>True where a material looks different where uv is, or turns with it.</summary>
    public static bool NeedUv(MaterialDescription material) =>
        Parts(material).Any(part => part is TextureDescription ? part is not SolidTextureDescription : TurnsWithUv(part));

    /// <summary>The textures of a material that show the colours of a mesh.</summary>
    public static IEnumerable<VertexColorTextureDescription> Colors(MaterialDescription material) => Parts(material).OfType<VertexColorTextureDescription>();

    /// <summary>A material with other textures.</summary>
    /// <param name="material">The material.</param>
    /// <param name="change">Makes another texture of each that is not the same colour everywhere.</param>
    public static MaterialDescription Map(MaterialDescription material, Func<TextureDescription, TextureDescription> change) =>
        Map(material, change, new(ReferenceEqualityComparer.Instance));

    private static MaterialDescription Map(MaterialDescription material, Func<TextureDescription, TextureDescription> change, Dictionary<object, MaterialDescription> known)
    {
        if (known.TryGetValue(material, out MaterialDescription? done))
        {
            return done;
        }

        RecordType type = RecordType.Of(material.GetType());
        object changed = type.Create();
        foreach (RecordParameter parameter in type.Parameters)
        {
            parameter.Set(changed, parameter.Get(material) switch
            {
                TextureDescription texture and not SolidTextureDescription => change(texture),
                MaterialDescription inner => Map(inner, change, known),
                var other => other,
            });
        }

        return known[material] = (MaterialDescription)changed;
    }

    private static bool TurnsWithUv(object material)
    {
        Dictionary<string, object?> values = RecordType.Of(material.GetType()).Parameters.ToDictionary(p => p.PropertyName, p => p.Get(material));
        return !Equals(values.GetValueOrDefault("AlphaU"), values.GetValueOrDefault("AlphaV"))
            || values.GetValueOrDefault("Anisotropic") is SolidTextureDescription { Color.R: not 0 };
    }

    private static IEnumerable<object> Parts(MaterialDescription material) => RecordType.WithParts(material).Select(p => p.Record);
}
