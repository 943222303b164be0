using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Import.Tests;

/// <summary>Materials of glTF files become the nearest that there are.</summary>
public class GltfMaterialTests
{
    [Fact]
    public void Without_a_material_a_mesh_is_light_grey_and_matt() =>
        Assert.Equal(new Rgb(0.8f, 0.8f, 0.8f), Color(TestGltf.Triangle().ImportMesh().Material));

    [Fact]
    public void Factors_are_parameters_of_principled()
    {
        PrincipledMaterialDescription surface = Principled("""{ "pbrMetallicRoughness": { "baseColorFactor": [0.1, 0.2, 0.3, 1], "metallicFactor": 0.25, "roughnessFactor": 0.5 } }""");
        Assert.Equal(new Rgb(0.1f, 0.2f, 0.3f), Solid(surface.BaseColor));
        Assert.Equal((0.25f, 0.5f, 1.5f), (Value(surface.Metallic), Value(surface.Roughness), surface.RefractiveIndex!.Value));
        PrincipledMaterialDescription standard = Principled("{}");
        Assert.Equal((1f, 1f), (Value(standard.Metallic), Value(standard.Roughness)));
    }

    [Fact]
    public void Green_is_roughness_and_blue_metalness_of_one_texture()
    {
        TestGltf file = TestGltf.Triangle("""{ "pbrMetallicRoughness": { "metallicRoughnessTexture": { "index": 0 }, "roughnessFactor": 0.5 } }""");
        GltfTextureTests.AddPicture(file, GltfTextureTests.Png(0, 102, 255, 0, 153, 0, 0, 51, 255, 9, 255, 51));
        var surface = Assert.IsType<PrincipledMaterialDescription>(file.ImportMesh().Material);
        var product = Assert.IsType<ProductTextureDescription>(surface.Roughness);
        Assert.Equal(0.5f, Value(product.Second));
        Assert.Equal([0.4f, 0.6f, 0.2f, 1], Channel(product.First, 1));
        Assert.Equal([1, 0, 1, 0.2f], Channel(surface.Metallic, 0));
    }

    [Fact]
    public void Normals_keep_their_scale_and_their_green_points_along_v()
    {
        TestGltf file = TestGltf.Triangle("""{ "normalTexture": { "index": 0, "scale": 0.7 } }""");
        GltfTextureTests.AddPicture(file, GltfTextureTests.Png(128, 128, 255, 0, 153, 0, 0, 51, 255, 9, 255, 51));
        var map = Assert.IsType<NormalMapMaterialDescription>(file.ImportMesh().Material);
        Assert.Equal(0.7f, map.Strength);
        Assert.True(map.GreenAlongV);
        Assert.Equal(128 / 255f, Assert.IsType<ImageTextureDescription>(map.Map).Picture!.Pixels[0]);
        Assert.IsType<PrincipledMaterialDescription>(map.Material);
    }

    [Theory]
    [InlineData("BLEND", "", 0.5f, new[] { 0.5f, 0.2f })]
    [InlineData("MASK", "", 1, new[] { 1f, 0 })]
    [InlineData("MASK", ", \"alphaCutoff\": 0.3", 1, new[] { 1f, 1 })]
    public void Alpha_blends_or_cuts_out(string mode, string more, float factor, float[] expected)
    {
        TestGltf file = TestGltf.Triangle($$"""{ "alphaMode": "{{mode}}"{{more}}, "pbrMetallicRoughness": { "baseColorFactor": [1, 1, 1, {{TestGltf.Text([factor])}}], "baseColorTexture": { "index": 0 } } }""");

        // Opacities 1, 0.4.
        GltfTextureTests.AddPicture(file, TestPng.File(TestPng.Header(2, 1, type: 6), TestPng.Chunk("IDAT", TestPng.Zlib([0, 9, 8, 7, 255, 6, 5, 4, 102])), TestPng.End));
        var mask = Assert.IsType<MaskMaterialDescription>(file.ImportMesh().Material);
        float[] opacity = mask.Opacity is ProductTextureDescription product
            ? [.. Channel(product.First, 2).Select(a => a * Value(product.Second))]
            : Channel(mask.Opacity, 2);
        Assert.Equal(expected, opacity);
    }

    [Theory]
    [InlineData("OPAQUE", 0.2f, -1)]
    [InlineData("BLEND", 0.25f, 0.25f)]
    [InlineData("MASK", 0.25f, 0)]
    [InlineData("MASK", 0.75f, -1)]
    public void Alpha_without_a_texture_is_a_number(string mode, float alpha, float expected)
    {
        MaterialDescription material = Material($$"""{ "alphaMode": "{{mode}}", "pbrMetallicRoughness": { "baseColorFactor": [1, 1, 1, {{TestGltf.Text([alpha])}}] } }""");
        Assert.Equal(expected, material is MaskMaterialDescription mask ? Value(mask.Opacity) : -1);
    }

    [Fact]
    public void What_shines_is_a_luminaire_around_its_material()
    {
        var lamp = Assert.IsType<LuminaireMaterialDescription>(Material("""
            { "emissiveFactor": [1, 0.5, 0], "extensions": { "KHR_materials_emissive_strength": { "emissiveStrength": 12 } }, "pbrMetallicRoughness": { "metallicFactor": 0 } }
            """));
        Assert.Equal(new Rgb(1, 0.5f, 0), Solid(lamp.Color));
        Assert.Equal(12, lamp.Multiplier);
        Assert.IsType<PrincipledMaterialDescription>(lamp.Material);
    }

    [Fact]
    public void A_clear_volume_is_glass_that_absorbs()
    {
        var glass = Assert.IsType<DielectricMaterialDescription>(Material(Glass(0, 1, "\"thicknessFactor\": 1, \"attenuationDistance\": 2, \"attenuationColor\": [1, 0.5, 0.25]")));
        Assert.Equal(1.7f, glass.RefractiveIndex);
        Assert.Equal(0, glass.Extinction.R, 1e-6f);
        Assert.Equal(float.Log(2) / 2, glass.Extinction.G, 1e-6f);
        Assert.Equal(float.Log(4) / 2, glass.Extinction.B, 1e-6f);
    }

    [Fact]
    public void A_rough_volume_is_principled_glass()
    {
        var glass = Assert.IsType<PrincipledMaterialDescription>(Material(Glass(0.4f, 0.75f, "\"thicknessFactor\": 1")));
        Assert.Equal((0.75f, 0.4f, 1.7f), (Value(glass.Transmission), Value(glass.Roughness), glass.RefractiveIndex!.Value));
    }

    [Fact]
    public void A_wall_without_thickness_lets_its_colour_straight_through()
    {
        var wall = Assert.IsType<ThinDielectricMaterialDescription>(Material(Glass(0, 1, "\"thicknessFactor\": 0")));
        Assert.Equal((1.7f, new Rgb(0.5f, 1, 1)), (wall.RefractiveIndex, Solid(wall.SpecularTransmittance)));
        var part = Assert.IsType<MixMaterialDescription>(Material(Glass(0, 0.25f, "\"thicknessFactor\": 0")));
        Assert.Equal(0.25f, Value(part.Weight));
        Assert.IsType<PrincipledMaterialDescription>(part.First);
        Assert.IsType<ThinDielectricMaterialDescription>(part.Second);
    }

    [Fact]
    public void Thin_films_are_those_of_principled()
    {
        PrincipledMaterialDescription surface = Principled("""{ "extensions": { "KHR_materials_iridescence": { "iridescenceFactor": 0.7, "iridescenceIor": 1.8, "iridescenceThicknessMaximum": 550 } } }""");
        Assert.Equal((0.7f, 1.8f, 550f), (Value(surface.Iridescence), surface.FilmIndex, Value(surface.FilmThickness)));
        surface = Principled("""{ "extensions": { "KHR_materials_iridescence": { "iridescenceFactor": 1 } } }""");
        Assert.Equal((1f, 1.3f, 400f), (Value(surface.Iridescence), surface.FilmIndex, Value(surface.FilmThickness)));
        Assert.Equal(0, Value(Principled("""{ "extensions": { "KHR_materials_iridescence": {} } }""").Iridescence));
    }

    [Fact]
    public void Coats_and_sheen_are_those_of_principled()
    {
        PrincipledMaterialDescription surface = Principled("""
            { "extensions": { "KHR_materials_clearcoat": { "clearcoatFactor": 0.5, "clearcoatRoughnessFactor": 0.2 }, "KHR_materials_sheen": { "sheenColorFactor": [0.1, 0.3, 0.2] } } }
            """);
        Assert.Equal((0.5f, 0.3f, 1), (Value(surface.Clearcoat), Value(surface.Sheen), Value(surface.SheenTint)));

        // α = 0.2² = 0.001 + 0.099·x.
        Assert.Equal(0.039f / 0.099f, Value(surface.ClearcoatRoughness), 1e-5f);
    }

    [Fact]
    public void Index_and_specular_factors_become_one_index_that_reflects_as_much()
    {
        // ((1.8 − 1)/(1.8 + 1))² = 0.0816; times 0.5.
        PrincipledMaterialDescription surface = Principled("""{ "extensions": { "KHR_materials_ior": { "ior": 1.8 }, "KHR_materials_specular": { "specularFactor": 0.5 } } }""");
        float n = surface.RefractiveIndex!.Value;
        Assert.Equal(0.0816327f * 0.5f, (n - 1) * (n - 1) / ((n + 1) * (n + 1)), 1e-6f);
        Assert.Equal(1.001f, Principled("""{ "extensions": { "KHR_materials_specular": { "specularFactor": 0 } } }""").RefractiveIndex);
    }

    [Fact]
    public void Specular_and_glossiness_of_old_files_are_understood()
    {
        PrincipledMaterialDescription matt = Principled("""
            { "extensions": { "KHR_materials_pbrSpecularGlossiness": { "diffuseFactor": [0.5, 0, 0, 1], "specularFactor": [0.09, 0.09, 0.09], "glossinessFactor": 0.75 } } }
            """);
        Assert.Equal((0f, 0.25f, new Rgb(0.5f, 0, 0)), (Value(matt.Metallic), Value(matt.Roughness), Solid(matt.BaseColor)));
        Assert.Equal(1.3f / 0.7f, matt.RefractiveIndex!.Value, 1e-5f);
        PrincipledMaterialDescription metal = Principled("""
            { "extensions": { "KHR_materials_pbrSpecularGlossiness": { "diffuseFactor": [0, 0, 0, 1], "specularFactor": [1, 0.7, 0.3], "glossinessFactor": 0.9 } } }
            """);
        Assert.Equal((1f, new Rgb(1, 0.7f, 0.3f)), (Value(metal.Metallic), Solid(metal.BaseColor)));
    }

    [Theory]
    [InlineData("""{ "extensions": { "KHR_materials_unlit": {} } }""", "unlit")]
    [InlineData("""{ "occlusionTexture": { "index": 0 } }""", "occlusion map")]
    [InlineData("""{ "extensions": { "KHR_materials_wax": {} } }""", "\"KHR_materials_wax\"")]
    [InlineData("""{ "extensions": { "KHR_materials_iridescence": { "iridescenceIor": 11 } } }""", "the index and the thickness of a film are limited")]
    [InlineData("""{ "pbrMetallicRoughness": { "metallicFactor": 0, "roughnessFactor": 0 }, "extensions": { "KHR_materials_transmission": { "transmissionFactor": 1 }, "KHR_materials_iridescence": {} } }""", "the iridescence of clear glass is ignored")]
    [InlineData("""{ "extensions": { "KHR_materials_specular": { "specularColorFactor": [1, 0.5, 0.5] } } }""", "colour of a dielectric's reflection")]
    [InlineData("""{ "pbrMetallicRoughness": { "metallicFactor": 0 }, "extensions": { "KHR_materials_transmission": { "transmissionFactor": 1 } } }""", "rough transparent wall")]
    [InlineData("""{ "extensions": { "KHR_materials_anisotropy": { "anisotropyRotation": 1 } } }""", "rotation of KHR_materials_anisotropy")]
    [InlineData("""{ "extensions": { "KHR_materials_anisotropy": { "anisotropyStrength": 1 } }, "pbrMetallicRoughness": { "roughnessFactor": 0.2 } }""", "KHR_materials_anisotropy is limited")]
    [InlineData("""{ "extensions": { "KHR_materials_sheen": { "sheenRoughnessFactor": 0.3 } } }""", "roughness of KHR_materials_sheen")]
    [InlineData("""{ "extensions": { "KHR_materials_diffuse_transmission": { "diffuseTransmissionFactor": 0.3 } } }""", "KHR_materials_diffuse_transmission is approximated")]
    public void What_there_is_nothing_like_is_said(string material, string note) =>
        Assert.Contains(TestGltf.Triangle(material).Import().Notes, n => n.Contains(note, StringComparison.Ordinal));

    [Theory]
    [InlineData(0.5f, 0.6f)]
    [InlineData(0.8f, 1)]
    [InlineData(1, 0)]
    public void Anisotropy_gives_the_widths_of_the_highlight_that_the_file_says(float roughness, float strength)
    {
        PrincipledMaterialDescription surface = Principled($$"""
            { "extensions": { "KHR_materials_anisotropy": { "anisotropyStrength": {{TestGltf.Text([strength])}} } }, "pbrMetallicRoughness": { "roughnessFactor": {{TestGltf.Text([roughness])}} } }
            """);
        double aspect = Math.Sqrt(1 - (0.9 * Value(surface.Anisotropic)));
        double alpha = Value(surface.Roughness) * (double)Value(surface.Roughness);
        double across = roughness * (double)roughness;
        Assert.Equal(across + ((1 - across) * strength * strength), alpha / aspect, 1e-5);
        Assert.Equal(across, alpha * aspect, 1e-5);
    }

    [Fact]
    public void Dispersion_spreads_the_index_by_abbes_number()
    {
        var glass = Assert.IsType<DielectricMaterialDescription>(Material(Glass(0, 1, "\"thicknessFactor\": 1").Replace("\"KHR_materials_ior\"", "\"KHR_materials_dispersion\": { \"dispersion\": 0.4 }, \"KHR_materials_ior\"", StringComparison.Ordinal)));
        double At(double line) => glass.Cauchy!.Value.X + (glass.Cauchy.Value.Y / (line * line));
        Assert.Equal(1.7, At(0.5875618), 1e-6);
        Assert.Equal(20 / 0.4, (At(0.5875618) - 1) / (At(0.4861327) - At(0.6562725)), 1e-3);
        Assert.Empty(Built(glass));
    }

    [Fact]
    public void What_passes_diffusely_is_mixed_in()
    {
        var mix = Assert.IsType<MixMaterialDescription>(Material("""
            { "extensions": { "KHR_materials_diffuse_transmission": { "diffuseTransmissionFactor": 0.3, "diffuseTransmissionColorFactor": [1, 0.5, 0] } } }
            """));
        var leaf = Assert.IsType<TranslucentMaterialDescription>(mix.Second);
        Assert.Equal((0.3f, new Rgb(1, 0.5f, 0), Rgb.Black), (Value(mix.Weight), Solid(leaf.Transmittance), Solid(leaf.Color)));
        Assert.IsType<PrincipledMaterialDescription>(mix.First);
    }

    [Fact]
    public void A_variant_replaces_the_materials_that_it_maps()
    {
        TestGltf file = TestGltf.Triangle("""{ "extensions": { "KHR_materials_unlit": {} }, "pbrMetallicRoughness": { "baseColorFactor": [1, 0, 0, 1] } }""");
        file.Add("materials", """{ "extensions": { "KHR_materials_unlit": {} }, "pbrMetallicRoughness": { "baseColorFactor": [0, 1, 0, 1] } }""");
        file.Json["extensions"] = System.Text.Json.Nodes.JsonNode.Parse("""{ "KHR_materials_variants": { "variants": [{ "name": "beach" }, { "name": "street" }] } }""");
        file.Json["extensionsRequired"] = System.Text.Json.Nodes.JsonNode.Parse("""["KHR_materials_variants"]""");
        file.Json["meshes"]![0]!["primitives"]![0]!["extensions"] = System.Text.Json.Nodes.JsonNode.Parse("""{ "KHR_materials_variants": { "mappings": [{ "material": 1, "variants": [1] }] } }""");
        ImportedModel model = file.Import();
        Assert.Equal(["beach", "street"], model.Variants);
        Rgb Look(int? variant) => Color(model.At!(new(0, variant, 0, 0, t => t)).Shapes[0].Material);
        Assert.Equal([new(1, 0, 0), new(1, 0, 0), new(0, 1, 0)], ((int?[])[null, 0, 1]).Select(Look));

        using TemporaryFolder folder = new();
        File.WriteAllBytes(folder["model.gltf"], file.ToGltf());
        File.WriteAllText(folder["scene.json"], """{ "shapes": [{ "type": "model", "file": "model.gltf", "variant": "streets" }], "background": 1 }""");
        Assert.Contains(SceneLoader.Load(folder["scene.json"]).Diagnostics, d => d.Message == "there is no variant \"streets\" in the file: it has \"beach\", \"street\" (did you mean \"street\"?)");
    }

    [Fact]
    public void A_model_by_itself_shows_what_the_same_native_scene_shows()
    {
        // A strip of texels of metalness and roughness, seen by a camera of its own.
        TestGltf file = TestGltf.Triangle("""{ "pbrMetallicRoughness": { "baseColorFactor": [0.9, 0.5, 0.2, 1], "metallicRoughnessTexture": { "index": 0 } } }""");
        GltfTextureTests.AddPicture(file, GltfTextureTests.Png(0, 102, 255, 0, 153, 0, 0, 51, 255, 9, 255, 51));
        SceneDescription model = DefaultView.Complete(file.Import()).Scene;
        Assert.Equal(Integrator.Path, model.Render.Integrator);
        ImageTextureDescription Texture(params float[] values) => new() { Picture = new(2, 2, [.. values.SelectMany(v => (float[])[v, v, v])]) };
        MeshDescription shown = Assert.IsType<MeshDescription>(model.Shapes[0]);
        MeshDescription own = new()
        {
            Positions = shown.Data!.Positions,
            Uv = shown.Data.Uv!,
            Triangles = [new(0, 1, 2)],
            Material = new PrincipledMaterialDescription
            {
                BaseColor = new SolidTextureDescription { Color = new(0.9f, 0.5f, 0.2f) },
                Metallic = Texture(1, 0, 1, 51 / 255f),
                Roughness = Texture(102 / 255f, 153 / 255f, 51 / 255f, 1),
            },
        };
        RenderDescription small = model.Render with { Width = 24, Height = 24, SamplesPerPixel = 4 };
        Assert.Equal(Pixels(model with { Render = small, Shapes = [own, .. model.Shapes.Skip(1)] }), Pixels(model with { Render = small }));
    }

    private static double[] Pixels(SceneDescription description)
    {
        SceneBuilder builder = new((_, _) => throw new PictureException("there are no files"));
        Film film = new RTracer(builder.Build(description)!).Render().Film;
        return [.. Enumerable.Range(0, film.Width * film.Height).Select(i => (double)film.Mean(i % film.Width, i / film.Width).Luminance)];
    }

    private static IReadOnlyList<SceneComplaint> Built(MaterialDescription material)
    {
        SceneBuilder builder = new();
        builder.Build(new() { Shapes = [new SphereDescription { Material = material }], Background = Rgb.White });
        return [.. builder.Complaints.Where(c => c.IsError)];
    }

    private static string Glass(float roughness, float transmission, string volume) => $$"""
        { "pbrMetallicRoughness": { "baseColorFactor": [0.5, 1, 1, 1], "metallicFactor": 0, "roughnessFactor": {{TestGltf.Text([roughness])}} }, "extensions": {
          "KHR_materials_transmission": { "transmissionFactor": {{TestGltf.Text([transmission])}} }, "KHR_materials_ior": { "ior": 1.7 }, "KHR_materials_volume": { {{volume}} } } }
        """;

    private static PrincipledMaterialDescription Principled(string json) => Assert.IsType<PrincipledMaterialDescription>(Material(json));

    private static Rgb Solid(TextureDescription texture) => Assert.IsType<SolidTextureDescription>(texture).Color;

    private static float Value(TextureDescription texture) => Solid(texture).R;

    private static float[] Channel(TextureDescription texture, int channel) =>
        [.. Assert.IsType<ImageTextureDescription>(texture).Picture!.Pixels.Where((_, i) => i % 3 == channel)];

    private static MaterialDescription Material(string json) => TestGltf.Triangle(json).ImportMesh().Material;

    private static Rgb Color(MaterialDescription material) =>
        Assert.IsType<SolidTextureDescription>(Assert.IsType<DiffuseMaterialDescription>(material).Color).Color;
}
