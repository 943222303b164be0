using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Scenes;

/// <summary>Makes materials.</summary>
internal sealed class MitsubaBsdfs(MitsubaReading reading, MitsubaTextures textures)
{
    private static readonly Rgb s_half = new(0.5f, 0.5f, 0.5f);

    private readonly Dictionary<MitsubaObject, MaterialDescription> _made = [];
    private readonly HashSet<MitsubaObject> _open = [];

    /// <summary>What surfaces are made of about which nothing is said.</summary>
    public static MaterialDescription Standard { get; } = new DiffuseMaterialDescription { Color = MitsubaTextures.Solid(s_half) };

    /// <summary>What shining surfaces are made of about which nothing is said.</summary>
    public static MaterialDescription Black { get; } = new DiffuseMaterialDescription { Color = MitsubaTextures.Solid(Rgb.Black) };

    /// <summary>The materials that have names.</summary>
    public Dictionary<string, MaterialDescription> Named { get; } = new(StringComparer.Ordinal);

    /// <summary>The material that a thing is.</summary>
    public MaterialDescription Read(MitsubaObject bsdf)
    {
        if (_made.TryGetValue(bsdf, out MaterialDescription? made))
        {
            return made;
        }

        if (!_open.Add(bsdf))
        {
            reading.Log.Error(bsdf.Place, $"{bsdf.Describe()} contains itself");
            return Standard;
        }

        made = reading.At(bsdf.Place, Make(bsdf));
        _open.Remove(bsdf);
        bsdf.Finish();
        _made.Add(bsdf, made);
        if (bsdf.Id.Length > 0)
        {
            Named[bsdf.Id] = made;
        }

        return made;
    }

    private MaterialDescription Make(MitsubaObject bsdf)
    {
        switch (bsdf.Type)
        {
            case "diffuse":
                return new DiffuseMaterialDescription { Color = textures.Read(bsdf, "reflectance", s_half) };
            case "twosided":
                return bsdf.Only("bsdf") is { } inner ? Read(inner) : Standard;
            default:
                reading.Log.Unknown(bsdf.TypePlace, $"BSDFs of the type {Quotation.Of(bsdf.Type)} are not read here", bsdf.Type, ["diffuse", "twosided"]);
                return Standard;
        }
    }
}
