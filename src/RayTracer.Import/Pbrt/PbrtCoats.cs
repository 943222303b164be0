using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>
/// Makes surfaces under a clear coat. pbrt follows light through the coat at random (Guo, Hašan and Zhao 2018), where a little is lost on each way
/// through its thickness; here formulas sum what goes back and forth, and a darker matt base stands for that loss.
/// </summary>
internal static class PbrtCoats
{
    private const int Steps = 1024;

    /// <summary>A matt surface under a coat.</summary>
    /// <param name="material">The material.</param>
    /// <param name="textures">Makes textures.</param>
    /// <param name="alpha">The roughness of the coat along u and v.</param>
    public static MaterialDescription Diffuse(PbrtThing material, PbrtTextures textures, (TextureDescription U, TextureDescription V) alpha)
    {
        // How pbrt walks, which changes the noise, or where it ends.
        material.Ignore("maxdepth", "nsamples");
        RefuseScattering(material);
        float index = material.Float("eta", 1.5f, 1.0001f, 100);
        float thickness = material.Float("thickness", 0.01f, 0, 10);
        TextureDescription color = Darkened(textures.Color(material, "reflectance", new Rgb(0.5f, 0.5f, 0.5f)), index, thickness);
        float rough = One(material, alpha, "");
        return rough < 1e-3f
            ? new PlasticMaterialDescription { Color = color, RefractiveIndex = index, Nonlinear = true }
            : new RoughPlasticMaterialDescription { Color = color, RefractiveIndex = index, Nonlinear = true, Alpha = rough };
    }

    /// <summary>Metal under a coat.</summary>
    /// <param name="material">The material.</param>
    /// <param name="metal">The metal.</param>
    /// <param name="coatAlpha">The roughness of the coat along u and v.</param>
    /// <param name="alpha">That of the metal.</param>
    public static MaterialDescription Conductor(
        PbrtThing material, MetalDescription metal, (TextureDescription U, TextureDescription V) coatAlpha, (TextureDescription U, TextureDescription V) alpha)
    {
        material.Ignore("maxdepth", "nsamples");
        RefuseScattering(material);
        float thickness = material.Float("thickness", 0.01f, 0, 100);
        return new CoatedConductorMaterialDescription
        {
            Metal = metal.Metal,
            Eta = metal.Eta,
            K = metal.K,
            SpecularReflectance = metal.SpecularReflectance,
            Alpha = One(material, alpha, "conductor."),
            CoatAlpha = One(material, coatAlpha, "interface."),
            CoatIndex = material.Float("interface.eta", 1.5f, 1, 100),
            CoatAbsorption = new(thickness, thickness, thickness),
        };
    }

    // The albedos of coats are tabled by one number.
    private static float One(PbrtThing material, (TextureDescription U, TextureDescription V) alpha, string prefix)
    {
        if (alpha is not (SolidTextureDescription { Color.R: var along }, SolidTextureDescription { Color.R: var across }))
        {
            material.Log.Unsupported(material.PlaceOf(prefix + "roughness"), "the roughness of a coat, and of metal below one, cannot be a texture here", "0.1 is used instead");
            return 0.1f;
        }

        if (along == across)
        {
            return along;
        }

        string name = material.Has(prefix + "uroughness") ? prefix + "uroughness" : prefix + "vroughness";
        material.Log.Unsupported(material.PlaceOf(name), "the roughness of a coat, and of metal below one, is one number here, not two", "their geometric mean is used instead");
        return float.Sqrt(along * across);
    }

    private static void RefuseScattering(PbrtThing material)
    {
        material.Ignore("g");
        Rgb albedo = PbrtColors.Read(material, "albedo", Rgb.Black, maximum: 1);
        if (!albedo.IsBlack)
        {
            material.Log.Unsupported(material.PlaceOf("albedo"), "coats that scatter light are not supported", "it is clear");
        }
    }

    private static TextureDescription Darkened(TextureDescription color, float index, float thickness)
    {
        (float once, float twice, float back) = Losses(index, thickness);
        float Base(float r) => (once * r / (1 - (r * back * twice))) is var seen ? seen / (1 + (seen * back)) : 0;
        return color is SolidTextureDescription { Color: var c } ? MaterialTextures.Solid(new Rgb(Base(c.R), Base(c.G), Base(c.B)))
            : thickness == 0 ? color : new ProductTextureDescription { First = color, Second = MaterialTextures.Solid(once) };
    }

    // What is left, on average, of matt light that comes out, with its way in; of what is reflected within, on its way there and back; and the fraction of matt
    // light that is reflected within.
    private static (float Once, float Twice, float Back) Losses(float index, float thickness)
    {
        (double left, double inner, double reflected) = (0, 0, 0);
        for (int i = 0; i < Steps; i++)
        {
            float cosine = float.Sqrt((i + 0.5f) / Steps);
            float part = Reflectance(cosine, index);
            float kept = LaneMath.Exp(-thickness / cosine);
            left += (1 - part) * kept;
            inner += part * kept * kept;
            reflected += part;
        }

        float once = (float)(left / (Steps - reflected));
        return (once * once, (float)(inner / reflected), (float)(reflected / Steps));
    }

    // Fresnel's equations for unpolarised light, from within.
    private static float Reflectance(float cosine, float index)
    {
        float sine2 = index * index * (1 - (cosine * cosine));
        if (sine2 >= 1)
        {
            return 1;
        }

        float outside = float.Sqrt(1 - sine2);
        float s = ((index * cosine) - outside) / ((index * cosine) + outside);
        float p = ((index * outside) - cosine) / ((index * outside) + cosine);
        return 0.5f * ((s * s) + (p * p));
    }
}
