using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Maps a glTF file's materials to the nearest ones that there are; docs/gltf.md has the table.</summary>
internal sealed class GltfMaterials(GltfDocument document, GltfTextures textures)
{
    // Below this roughness (α = 0.01), glass is shown clear.
    private const float ClearRoughness = 0.1f;

    // 20 over Abbe's number, which is 20 to 90 of glass.
    private const float MostDispersion = 20;

    private readonly Dictionary<int, GltfMaterial> _described = [];
    private readonly GltfMaterial _default = new(new DiffuseMaterialDescription { Color = new SolidTextureDescription { Color = new(0.8f, 0.8f, 0.8f) } }, 0, false);

    /// <summary>The material of a primitive.</summary>
    /// <param name="index">Which of the file's materials: an index that has been checked; null for none, which is light grey and matt here.</param>
    public GltfMaterial Describe(int? index) =>
        index is { } known ? _described.Remember(known, () => Describe(document.List("materials")[known])) : _default;

    private GltfMaterial Describe(GltfObject material)
    {
        GltfSurface surface = GltfSurface.Of(document, textures, material);
        MaterialDescription description = CutOut(Embossed(material, surface, Scattering(material, surface)), surface);
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

    private MaterialDescription Scattering(GltfObject material, GltfSurface surface)
    {
        if (material.Extension("KHR_materials_unlit") is not null)
        {
            document.Notes.Add("an unlit material is shown as matt");
            return new DiffuseMaterialDescription { Color = surface.Color };
        }

        PrincipledMaterialDescription opaque = Opaque(material, surface);
        MaterialDescription diffusing = material.Extension("KHR_materials_diffuse_transmission") is { } passing ? Diffusing(passing, surface, opaque) : opaque;
        return surface.Transmission is null || IsOne(surface.Metallic) ? diffusing : Transparent(material, surface, diffusing, opaque);
    }

    // What passes comes out evenly on the other side, and so weakens highlights, which the extension does not.
    private MaterialDescription Diffusing(GltfObject passing, GltfSurface surface, PrincipledMaterialDescription opaque)
    {
        float factor = passing.Fraction("diffuseTransmissionFactor", 0);
        if (factor == 0)
        {
            return opaque;
        }

        document.Notes.Add("KHR_materials_diffuse_transmission is approximated: highlights are weaker by what passes through");
        return new MixMaterialDescription
        {
            First = opaque,
            Second = new TranslucentMaterialDescription
            {
                Color = Number(0),
                Transmittance = textures.Colour(
                    passing.Color("diffuseTransmissionColorFactor", Rgb.White), GltfTextureUse.Of(document, passing, "diffuseTransmissionColorTexture"), surface.UvSet),
            },
            Weight = textures.Number(factor, GltfTextureUse.Of(document, passing, "diffuseTransmissionTexture"), GltfChannel.Alpha, surface.UvSet),
        };
    }

    private PrincipledMaterialDescription Opaque(GltfObject material, GltfSurface surface)
    {
        PrincipledMaterialDescription opaque = new()
        {
            BaseColor = surface.Color,
            Metallic = surface.Metallic,
            Roughness = surface.Roughness,
            RefractiveIndex = surface.ReflectiveIndex,
        };
        if (material.Extension("KHR_materials_clearcoat") is { } coat)
        {
            float roughness = coat.Fraction("clearcoatRoughnessFactor", 0);
            if (coat.Has("clearcoatRoughnessTexture") || coat.Has("clearcoatNormalTexture"))
            {
                document.Notes.Add("roughness and normal textures of a clear coat are ignored");
            }

            // The coat's α is from 0.001 to 0.1 here, and roughness² there.
            opaque = opaque with
            {
                Clearcoat = textures.Number(coat.Fraction("clearcoatFactor", 0), GltfTextureUse.Of(document, coat, "clearcoatTexture"), GltfChannel.Red, surface.UvSet),
                ClearcoatRoughness = Number(float.Clamp(((roughness * roughness) - 0.001f) / 0.099f, 0, 1)),
            };
        }

        opaque = material.Extension("KHR_materials_iridescence") is { } film ? Shimmering(opaque, film, surface) : opaque;
        opaque = material.Extension("KHR_materials_anisotropy") is { } anisotropy ? Stretched(opaque, anisotropy) : opaque;
        return material.Extension("KHR_materials_sheen") is { } sheen ? WithSheen(opaque, sheen) : opaque;
    }

    // The film is as thick as the texture says, between two thicknesses; without one, as the larger.
    private PrincipledMaterialDescription Shimmering(PrincipledMaterialDescription opaque, GltfObject film, GltfSurface surface)
    {
        float thickest = film.Number("iridescenceThicknessMaximum", 400, 0);
        float index = film.Number("iridescenceIor", 1.3f, 1);
        GltfTextureUse? thickness = GltfTextureUse.Of(document, film, "iridescenceThicknessTexture");
        document.Notes.AddIf(index > 10 || thickest > 1e5f, "the index and the thickness of a film are limited to 10 and 0.1 mm");
        SolidTextureDescription most = Number(float.Min(thickest, 1e5f));
        return opaque with
        {
            Iridescence = textures.Number(film.Fraction("iridescenceFactor", 0), GltfTextureUse.Of(document, film, "iridescenceTexture"), GltfChannel.Red, surface.UvSet),
            FilmIndex = float.Min(index, 10),
            FilmThickness = thickness is null ? most : new MixTextureDescription
            {
                First = Number(float.Min(film.Number("iridescenceThicknessMinimum", 100, 0), 1e5f)),
                Second = most,
                Weight = textures.Number(1, thickness, GltfChannel.Green, surface.UvSet),
            },
        };
    }

    // Along the tangent α grows from r² towards 1 with the strength's square. Here the two are r²/a and r²·a, with a² = 1 − 0.9 of what
    // the material is given; so their product gives the roughness, and their ratio the rest.
    private PrincipledMaterialDescription Stretched(PrincipledMaterialDescription opaque, GltfObject anisotropy)
    {
        float strength = anisotropy.Fraction("anisotropyStrength", 0);
        document.Notes.AddIf(anisotropy.Has("anisotropyTexture"), "a texture of KHR_materials_anisotropy is ignored");
        document.Notes.AddIf(anisotropy.Number("anisotropyRotation", 0) != 0, "the rotation of KHR_materials_anisotropy is ignored: highlights are stretched along the tangent");
        if (opaque.Roughness is not SolidTextureDescription { Color.R: var roughness })
        {
            document.Notes.AddIf(strength > 0, "KHR_materials_anisotropy is approximated where the roughness has a texture");
            return opaque with { Anisotropic = Number(strength) };
        }

        float across = float.Max(roughness * roughness, 1e-4f);
        float along = across + ((1 - across) * strength * strength);
        document.Notes.AddIf(across < 0.1f * along, "KHR_materials_anisotropy is limited: highlights are at most ten times as long as wide");
        return opaque with
        {
            Roughness = strength > 0 ? Number(float.Sqrt(float.Sqrt(across * along))) : opaque.Roughness,
            Anisotropic = Number(float.Min((1 - (across / along)) / 0.9f, 1)),
        };
    }

    private PrincipledMaterialDescription WithSheen(PrincipledMaterialDescription opaque, GltfObject sheen)
    {
        Rgb color = sheen.Color("sheenColorFactor", Rgb.Black);
        document.Notes.AddIf(sheen.Has("sheenColorTexture") || sheen.Has("sheenRoughnessTexture"), "sheen textures are ignored");
        document.Notes.AddIf(sheen.Has("sheenRoughnessFactor"), "the roughness of KHR_materials_sheen is ignored");

        float most = float.Max(color.R, float.Max(color.G, color.B));
        bool isGrey = float.Min(color.R, float.Min(color.G, color.B)) > 0.9f * most;
        return opaque with { Sheen = Number(most), SheenTint = Number(isGrey ? 0 : 1) };
    }

    // Walls without thickness let light straight through; volumes refract it.
    private MaterialDescription Transparent(GltfObject material, GltfSurface surface, MaterialDescription rest, PrincipledMaterialDescription opaque)
    {
        GltfObject? volume = material.Extension("KHR_materials_volume");
        float wanted = material.Extension("KHR_materials_dispersion")?.Number("dispersion", 0, 0) ?? 0;
        float dispersion = float.Min(wanted, MostDispersion);
        document.Notes.AddIf(wanted > dispersion, $"KHR_materials_dispersion is limited to {MostDispersion}");
        bool isThin = volume is null || volume.Number("thicknessFactor", 0, 0) == 0;
        bool isClear = surface.Roughness is SolidTextureDescription { Color.R: <= ClearRoughness };
        document.Notes.AddIf(volume?.Has("thicknessTexture") ?? false, "a texture of thickness is ignored: light takes the way that the shape gives it");
        document.Notes.AddIf(dispersion > 0 && (isThin || !isClear), "KHR_materials_dispersion is ignored but in clear volumes");
        if (!isThin && !isClear)
        {
            document.Notes.AddIf(volume!.Has("attenuationDistance"), "absorption in the volume of rough glass is ignored");

            return opaque with { Transmission = surface.Transmission!, RefractiveIndex = float.Max(surface.RefractiveIndex, 1.001f) };
        }

        document.Notes.AddIf(!isClear, "a rough transparent wall is shown as clear");
        document.Notes.AddIf(material.Extension("KHR_materials_iridescence") is not null, "the iridescence of clear glass is ignored");

        MaterialDescription glass = isThin
            ? new ThinDielectricMaterialDescription { RefractiveIndex = surface.RefractiveIndex, SpecularTransmittance = surface.Color }
            : Glass(surface, volume!, dispersion);
        return IsOne(surface.Transmission!) && surface.Metallic is SolidTextureDescription { Color.R: 0 }
            ? glass
            : new MixMaterialDescription { First = rest, Second = glass, Weight = surface.Transmission! };
    }

    private DielectricMaterialDescription Glass(GltfSurface surface, GltfObject volume, float dispersion)
    {
        if (surface.Color is not SolidTextureDescription { Color: var color } || color != Rgb.White)
        {
            document.Notes.Add("the colour of a transparent surface is ignored: only its volume absorbs light");
        }

        float distance = volume.Number("attenuationDistance", float.PositiveInfinity, float.Epsilon);
        Rgb left = volume.Color("attenuationColor", Rgb.White);
        DielectricMaterialDescription glass = new() { Extinction = new(Extinction(left.R, distance), Extinction(left.G, distance), Extinction(left.B, distance)) };
        return dispersion > 0 && surface.RefractiveIndex > 1
            ? glass with { Cauchy = Cauchy(surface.RefractiveIndex, dispersion) }
            : glass with { RefractiveIndex = surface.RefractiveIndex };
    }

    // Of n at Fraunhofer's line d and 20 over Abbe's number (n − 1)/(n at F − n at C): n = A + B/λ², with the wavelengths of the lines in µm.
    private static Vector2 Cauchy(float index, float dispersion)
    {
        const double d = 0.5875618;
        const double f = 0.4861327;
        const double c = 0.6562725;
        double b = (index - 1) * dispersion / 20 / ((1 / (f * f)) - (1 / (c * c)));
        return new((float)(index - (b / (d * d))), (float)b);
    }

    private MaterialDescription Embossed(GltfObject material, GltfSurface surface, MaterialDescription inner)
    {
        if (textures.Normals(GltfTextureUse.Of(document, material, "normalTexture"), surface.UvSet) is not { } normals)
        {
            return inner;
        }

        float scale = material.Child("normalTexture")!.Number("scale", 1);
        document.Notes.AddIf(scale is < 0 or > 100, "the scale of a normal map is limited to 0 to 100");

        return new NormalMapMaterialDescription { Map = normals, Strength = float.Clamp(scale, 0, 100), GreenAlongV = true, Material = inner };
    }

    private static MaterialDescription CutOut(MaterialDescription inner, GltfSurface surface) => surface.Opacity is { } opacity && !IsOne(opacity)
        ? new MaskMaterialDescription { Material = inner, Opacity = opacity }
        : inner;

    private static bool IsOne(TextureDescription number) => number is SolidTextureDescription { Color.R: 1 };

    private static SolidTextureDescription Number(float value) => new() { Color = new(value, value, value) };

    // Beer's law: after the distance, the fraction is left. A black fraction would need an infinite coefficient.
    private static float Extinction(float fraction, float distance) =>
        float.Clamp(-LaneMath.Log(float.Max(fraction, 1e-6f)) / distance, 0, 1e6f);

    private void NoteWhatIsLeftOut(GltfObject material)
    {
        document.Notes.AddIf(material.Has("occlusionTexture"), "an occlusion map is ignored: shadows are computed");

        foreach (string name in material.Child("extensions")?.Node.Members.Select(m => m.Key) ?? [])
        {
            document.Notes.AddIf(!GltfExtensions.Materials.Contains(name), $"the extension {Quotation.Of(name)} of a material is ignored");
        }
    }
}

/// <summary>A material of a glTF file in the terms of scenes.</summary>
/// <param name="Description">The nearest material that there is.</param>
/// <param name="UvSet">Which set of uv its textures use.</param>
/// <param name="IsLamp">True where it shines more than a picture on a screen would (KHR_materials_emissive_strength), so that it lights the scene.</param>
internal sealed record GltfMaterial(MaterialDescription Description, int UvSet, bool IsLamp);
