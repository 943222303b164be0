using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>Maps a glTF file's materials to the nearest ones that there are; docs/gltf.md has the table.</summary>
internal sealed class GltfMaterials(GltfDocument document, GltfTextures textures)
{
    private const float Half = 0.5f;

    private readonly Dictionary<int, GltfMaterial> _described = [];
    private readonly GltfMaterial _default = new(new DiffuseMaterialDescription { Color = new SolidTextureDescription { Color = new(0.8f, 0.8f, 0.8f) } }, 0, false);

    /// <summary>The material of a primitive.</summary>
    /// <param name="index">Which of the file's materials: an index that has been checked; null for none, which is light grey and matt here.</param>
    public GltfMaterial Describe(int? index)
    {
        if (index is not { } known)
        {
            return _default;
        }

        if (!_described.TryGetValue(known, out GltfMaterial? material))
        {
            material = Describe(document.List("materials")[known]);
            _described.Add(known, material);
        }

        return material;
    }

    private GltfMaterial Describe(GltfObject material)
    {
        GltfSurface surface = GltfSurface.Of(document, textures, material);
        MaterialDescription description = Reflecting(material, surface);
        NoteWhatIsLeftOut(material);
        Rgb emission = material.Color("emissiveFactor", Rgb.Black);
        if (emission.IsBlack)
        {
            return new(description, surface.UvSet, false);
        }

        float strength = material.Extension("KHR_materials_emissive_strength")?.Number("emissiveStrength", 1, 0) ?? 1;
        LuminaireMaterialDescription shining = new()
        {
            Color = textures.Colour(emission, GltfTextureUse.Of(document, material, "emissiveTexture"), surface.UvSet),
            Multiplier = strength,
            Material = description,
        };
        return new(shining, surface.UvSet, strength > 1);
    }

    private MaterialDescription Reflecting(GltfObject material, GltfSurface surface)
    {
        if (material.Extension("KHR_materials_unlit") is not null)
        {
            document.Notes.Add("a material that is to be shown without light is shown matt");
            return Matt(surface.Color);
        }

        if (surface.Metallic is > 0.1f and < 0.9f)
        {
            document.Notes.Add("a material that is partly metal is shown as the one or the other");
        }

        if (surface.Metallic >= Half)
        {
            return Metal(material, surface);
        }

        if (surface.Transmission >= Half)
        {
            return Glass(material, surface);
        }

        if (surface.Transmission > 0.1f)
        {
            document.Notes.Add("a material that lets less than half of the light through is shown opaque");
        }

        return Coated(material, surface);
    }

    private MaterialDescription Metal(GltfObject material, GltfSurface surface)
    {
        if (ClearCoat(material) > 0)
        {
            document.Notes.Add("the clear coat on a metal is left out");
        }

        float exponent = PhongLobe.Exponent(surface.Roughness);
        return PhongLobe.IsMatt(exponent)
            ? Matt(surface.Color)
            : new PhongMetalMaterialDescription { Color = surface.Color, Exponent = exponent };
    }

    private MaterialDescription Coated(GltfObject material, GltfSurface surface)
    {
        float clearCoat = ClearCoat(material);
        if (clearCoat > 0)
        {
            GltfObject coat = material.Extension("KHR_materials_clearcoat")!;
            float roughness = coat.Fraction("clearcoatRoughnessFactor", 0) * textures.Mean(GltfTextureUse.Of(document, coat, "clearcoatRoughnessTexture"))[1];

            // The specification's coat has an index of 1.5, which reflects 4 % head-on.
            return Coat(Matt(surface.Color), Rgb.White, 0.04f * clearCoat, PhongLobe.Exponent(roughness));
        }

        return Coat(Matt(surface.Color), surface.CoatColor, surface.R0, PhongLobe.Exponent(surface.Roughness));
    }

    private static MaterialDescription Coat(MaterialDescription matt, Rgb color, float r0, float exponent) =>
        PhongLobe.IsMatt(exponent) || r0 == 0 ? matt : new DiffuseSpecularMaterialDescription
        {
            Diffuse = matt,
            Specular = new PhongMetalMaterialDescription { Color = new SolidTextureDescription { Color = color }, Exponent = exponent },
            R0 = r0,
        };

    private static DiffuseMaterialDescription Matt(TextureDescription color) => new() { Color = color };

    private float ClearCoat(GltfObject material)
    {
        GltfObject? coat = material.Extension("KHR_materials_clearcoat");
        return coat is null ? 0 : coat.Fraction("clearcoatFactor", 0) * textures.Mean(GltfTextureUse.Of(document, coat, "clearcoatTexture"))[0];
    }

    private DielectricMaterialDescription Glass(GltfObject material, GltfSurface surface)
    {
        if (surface.Roughness > 0.1f)
        {
            document.Notes.Add("rough glass is shown clear");
        }

        if (surface.Color is not SolidTextureDescription { Color: var color } || color != Rgb.White)
        {
            document.Notes.Add("the colour of a transparent surface is left out: only its volume absorbs light");
        }

        GltfObject? volume = material.Extension("KHR_materials_volume");
        if (volume is null || volume.Number("thicknessFactor", 0, 0) == 0)
        {
            document.Notes.Add("a thin transparent wall is shown as the surface of a solid body");
            return new() { RefractiveIndex = surface.RefractiveIndex };
        }

        float distance = volume.Number("attenuationDistance", float.PositiveInfinity, float.Epsilon);
        Rgb left = volume.Color("attenuationColor", Rgb.White);
        return new() { RefractiveIndex = surface.RefractiveIndex, Extinction = new(Extinction(left.R, distance), Extinction(left.G, distance), Extinction(left.B, distance)) };
    }

    // Beer's law: after the distance, the fraction is left. A black fraction would need an infinite coefficient.
    private static float Extinction(float fraction, float distance) =>
        float.Clamp(-LaneMath.Log(float.Max(fraction, 1e-6f)) / distance, 0, 1e6f);

    private void NoteWhatIsLeftOut(GltfObject material)
    {
        if (material.Has("normalTexture"))
        {
            document.Notes.Add("a normal map is left out");
        }

        if (material.Has("occlusionTexture"))
        {
            document.Notes.Add("an occlusion map is left out: the shadows are computed");
        }

        if (material.Text("alphaMode") is "BLEND" or "MASK")
        {
            document.Notes.Add("a material that is transparent by its alpha is shown opaque");
        }

        foreach (string name in material.Child("extensions")?.Node.Members.Select(m => m.Key) ?? [])
        {
            if (!GltfExtensions.Materials.Contains(name))
            {
                document.Notes.Add($"the extension {Quotation.Of(name)} of a material is left out");
            }
        }
    }
}
