using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Tests.Scenes.Models;

/// <summary>Materials of glTF files become the nearest that there are.</summary>
public class GltfMaterialTests
{
    [Fact]
    public void Without_a_material_a_mesh_is_light_grey_and_matt() =>
        Assert.Equal(new Rgb(0.8f, 0.8f, 0.8f), Color(TestGltf.Triangle().ImportMesh().Material));

    [Fact]
    public void A_rough_dielectric_is_matt() => Assert.Equal(
        new Rgb(0.1f, 0.2f, 0.3f),
        Color(Material("""{ "pbrMetallicRoughness": { "baseColorFactor": [0.1, 0.2, 0.3, 1], "metallicFactor": 0 } }""")));

    // n = (2/α² − 2)/4 with α = roughness².
    [Theory]
    [InlineData("0.5", 7.5f)]
    [InlineData("0.2", 312f)]
    [InlineData("0", 1e6f)]
    public void A_smooth_dielectric_is_matt_under_a_coat_that_reflects_4_percent(string roughness, float exponent)
    {
        var coated = Assert.IsType<DiffuseSpecularMaterialDescription>(
            Material($$"""{ "pbrMetallicRoughness": { "baseColorFactor": [0.1, 0.2, 0.3, 1], "metallicFactor": 0, "roughnessFactor": {{roughness}} } }"""));
        Assert.Equal(new Rgb(0.1f, 0.2f, 0.3f), Color(coated.Diffuse));
        Assert.Equal(0.04f, coated.R0, 1e-7f);
        var coat = Assert.IsType<PhongMetalMaterialDescription>(coated.Specular);
        Assert.Equal(exponent, coat.Exponent, exponent * 1e-5f);
        Assert.Equal(Rgb.White, Assert.IsType<SolidTextureDescription>(coat.Color).Color);
    }

    [Fact]
    public void A_metal_reflects_its_colour()
    {
        var metal = Assert.IsType<PhongMetalMaterialDescription>(Material("""{ "pbrMetallicRoughness": { "baseColorFactor": [1, 0.8, 0.3, 1], "roughnessFactor": 0.5 } }"""));
        Assert.Equal(new Rgb(1, 0.8f, 0.3f), Assert.IsType<SolidTextureDescription>(metal.Color).Color);
        Assert.Equal(7.5f, metal.Exponent, 1e-4f);
    }

    [Fact]
    public void The_lobe_has_the_spread_of_the_microfacets_it_stands_for()
    {
        // Seen head-on, microfacet normals of density ∝ D(h)·cos with Beckmann's D of small α turn reflections by twice their own
        // angle: its mean square is 4·α²; that of cosⁿ is 2/(n + 1) for large n.
        foreach (double roughness in (double[])[0.1, 0.2, 0.3])
        {
            string text = roughness.ToString(System.Globalization.CultureInfo.InvariantCulture);
            var metal = (PhongMetalMaterialDescription)Material($$"""{ "pbrMetallicRoughness": { "roughnessFactor": {{text}} } }""");
            double alpha = roughness * roughness;
            Assert.Equal(4 * alpha * alpha, 2 / (metal.Exponent + 1), 0.03 * 4 * alpha * alpha);
        }
    }

    [Fact]
    public void Metalness_and_roughness_of_a_texture_are_averaged()
    {
        // Green is roughness: mean 0.5; blue is metalness: mean 1.
        TestGltf file = TestGltf.Triangle("""{ "pbrMetallicRoughness": { "metallicRoughnessTexture": { "index": 0 } } }""");
        GltfTextureTests.AddPicture(file, GltfTextureTests.Png(0, 102, 255, 0, 153, 255, 0, 102, 255, 9, 153, 255));
        ImportedModel model = file.Import();
        Assert.Equal(7.5f, Assert.IsType<PhongMetalMaterialDescription>(model.Scene.Shapes[0].Material).Exponent, 1e-3f);
        Assert.Contains(model.Notes, n => n.Contains("averaged", StringComparison.Ordinal));
    }

    [Fact]
    public void What_shines_is_a_luminaire_around_its_material()
    {
        var lamp = Assert.IsType<LuminaireMaterialDescription>(Material("""
            { "emissiveFactor": [1, 0.5, 0], "extensions": { "KHR_materials_emissive_strength": { "emissiveStrength": 12 } }, "pbrMetallicRoughness": { "metallicFactor": 0 } }
            """));
        Assert.Equal(new Rgb(1, 0.5f, 0), Assert.IsType<SolidTextureDescription>(lamp.Color).Color);
        Assert.Equal(12, lamp.Multiplier);
        Assert.IsType<DiffuseMaterialDescription>(lamp.Material);
    }

    [Fact]
    public void What_lets_light_through_is_glass_that_absorbs_by_its_volume()
    {
        var glass = Assert.IsType<DielectricMaterialDescription>(Material("""
            { "pbrMetallicRoughness": { "metallicFactor": 0, "roughnessFactor": 0 }, "extensions": {
              "KHR_materials_transmission": { "transmissionFactor": 1 }, "KHR_materials_ior": { "ior": 1.7 },
              "KHR_materials_volume": { "thicknessFactor": 1, "attenuationDistance": 2, "attenuationColor": [1, 0.5, 0.25] } } }
            """));
        Assert.Equal(1.7f, glass.RefractiveIndex);
        Assert.Equal(0, glass.Extinction.R, 1e-6f);
        Assert.Equal(float.Log(2) / 2, glass.Extinction.G, 1e-6f);
        Assert.Equal(float.Log(4) / 2, glass.Extinction.B, 1e-6f);
    }

    [Fact]
    public void A_wall_without_volume_is_clear_glass_with_a_note()
    {
        TestGltf file = TestGltf.Triangle("""{ "pbrMetallicRoughness": { "metallicFactor": 0 }, "extensions": { "KHR_materials_transmission": { "transmissionFactor": 0.9 } } }""");
        Assert.Equal(new DielectricMaterialDescription(), file.ImportMesh().Material);
        Assert.Contains(file.Import().Notes, n => n.Contains("thin transparent wall", StringComparison.Ordinal));
    }

    [Fact]
    public void A_clear_coat_lies_over_matt_surfaces()
    {
        var coated = Assert.IsType<DiffuseSpecularMaterialDescription>(Material("""
            { "pbrMetallicRoughness": { "metallicFactor": 0 }, "extensions": { "KHR_materials_clearcoat": { "clearcoatFactor": 0.5, "clearcoatRoughnessFactor": 0.2 } } }
            """));
        Assert.Equal(0.02f, coated.R0, 1e-7f);
        Assert.Equal(312f, Assert.IsType<PhongMetalMaterialDescription>(coated.Specular).Exponent, 1e-2f);
    }

    [Fact]
    public void The_coat_takes_its_strength_from_index_and_specular_colour()
    {
        // ((1.8 − 1)/(1.8 + 1))² = 0.0816; times 0.5 · (0.4, 0.8, 0.2).
        var coated = Assert.IsType<DiffuseSpecularMaterialDescription>(Material("""
            { "pbrMetallicRoughness": { "metallicFactor": 0, "roughnessFactor": 0 }, "extensions": { "KHR_materials_ior": { "ior": 1.8 },
              "KHR_materials_specular": { "specularFactor": 0.5, "specularColorFactor": [0.4, 0.8, 0.2] } } }
            """));
        Assert.Equal(0.0816327f * 0.4f, coated.R0, 1e-6f);
        Rgb color = Assert.IsType<SolidTextureDescription>(Assert.IsType<PhongMetalMaterialDescription>(coated.Specular).Color).Color;
        Assert.Equal((0.5f, 1f, 0.25f), (color.R, color.G, color.B));
    }

    [Fact]
    public void Specular_and_glossiness_of_old_files_are_understood()
    {
        var coated = Assert.IsType<DiffuseSpecularMaterialDescription>(Material("""
            { "extensions": { "KHR_materials_pbrSpecularGlossiness": { "diffuseFactor": [0.5, 0, 0, 1], "specularFactor": [0.1, 0.05, 0.1], "glossinessFactor": 0.5 } } }
            """));
        Assert.Equal(0.1f, coated.R0);
        Assert.Equal(new Rgb(0.5f, 0, 0), Color(coated.Diffuse));
        Assert.IsType<PhongMetalMaterialDescription>(Material("""
            { "extensions": { "KHR_materials_pbrSpecularGlossiness": { "diffuseFactor": [0, 0, 0, 1], "specularFactor": [1, 0.7, 0.3], "glossinessFactor": 0.9 } } }
            """));
    }

    [Theory]
    [InlineData("""{ "extensions": { "KHR_materials_unlit": {} } }""", "without light")]
    [InlineData("""{ "alphaMode": "BLEND" }""", "transparent by its alpha")]
    [InlineData("""{ "normalTexture": { "index": 0 } }""", "normal map")]
    [InlineData("""{ "occlusionTexture": { "index": 0 } }""", "occlusion map")]
    [InlineData("""{ "pbrMetallicRoughness": { "metallicFactor": 0.4 } }""", "partly metal")]
    [InlineData("""{ "extensions": { "KHR_materials_sheen": {} } }""", "\"KHR_materials_sheen\"")]
    [InlineData("""{ "extensions": { "KHR_materials_clearcoat": { "clearcoatFactor": 1 } } }""", "clear coat on a metal")]
    public void What_there_is_nothing_like_is_said(string material, string note) =>
        Assert.Contains(TestGltf.Triangle(material).Import().Notes, n => n.Contains(note, StringComparison.Ordinal));

    private static MaterialDescription Material(string json) => TestGltf.Triangle(json).ImportMesh().Material;

    private static Rgb Color(MaterialDescription material) =>
        Assert.IsType<SolidTextureDescription>(Assert.IsType<DiffuseMaterialDescription>(material).Color).Color;
}
