using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import.Tests;

/// <summary>Pictures, samplers and texture transforms of glTF files.</summary>
public class GltfTextureTests
{
    private const string Textured = """{ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 }, "metallicFactor": 0 } }""";

    // 2×2: red, green / blue, white.
    private static readonly byte[] s_png = Png(255, 0, 0, 0, 255, 0, 0, 0, 255, 255, 255, 255);

    /// <summary>Adds a picture of 2×2 pixels and a texture of it.</summary>
    internal static void AddPicture(TestGltf file, byte[]? png = null, string sampler = "")
    {
        int image = file.Add("images", $$"""{ "bufferView": {{file.View(png ?? s_png)}}, "mimeType": "image/png" }""");
        string more = sampler.Length > 0 ? $", \"sampler\": {file.Add("samplers", sampler)}" : "";
        file.Add("textures", $$"""{ "source": {{image}}{{more}} }""");
    }

    [Fact]
    public void A_picture_in_the_buffer_is_the_base_colour()
    {
        TestGltf file = TestGltf.Triangle(Textured);
        AddPicture(file);
        ImageTextureDescription texture = Assert.IsType<ImageTextureDescription>(BaseColor(file));
        Assert.Equal([1, 0, 0, 0, 1, 0, 0, 0, 1, 1, 1, 1], texture.Picture!.Pixels);
        Assert.Equal((Interpolation.Bilinear, Wrapping.Repeat, Wrapping.Repeat), (texture.Interpolation, texture.Wrapping, texture.VerticalWrapping));
    }

    [Fact]
    public void A_picture_may_be_embedded_or_beside_the_file()
    {
        using TemporaryFolder folder = new();
        File.WriteAllBytes(folder["a picture.png"], s_png);
        foreach (string uri in (string[])["a%20picture.png", "data:image/png;base64," + Convert.ToBase64String(s_png)])
        {
            TestGltf file = TestGltf.Triangle(Textured);
            file.Add("images", $$"""{ "uri": "{{uri}}" }""");
            file.Add("textures", """{ "source": 0 }""");
            Assert.Equal(2, Assert.IsType<ImageTextureDescription>(BaseColor(file, folder.Path)).Picture!.Width);
        }
    }

    [Fact]
    public void A_buffer_may_be_beside_the_file()
    {
        using TemporaryFolder folder = new();
        File.WriteAllBytes(folder["numbers.bin"], TestGltf.Floats(0, 0, 0, 2, 0, 0, 0, 3, 0));
        TestGltf file = new();
        file.Add("buffers", """{ "uri": "numbers.bin", "byteLength": 36 }""");
        file.Add("bufferViews", """{ "buffer": 0, "byteLength": 36 }""");
        file.Add("accessors", """{ "bufferView": 0, "componentType": 5126, "type": "VEC3", "count": 3 }""");
        file.Mesh("""{ "attributes": { "POSITION": 0 } }""");
        Assert.Single(file.Import(folder.Path).Scene.Shapes);
        Assert.Contains("buffers[0].uri: cannot read \"numbers.bin\": file not found", file.Complaint(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("""{ "magFilter": 9728 }""", Interpolation.Nearest, Wrapping.Repeat, Wrapping.Repeat)]
    [InlineData("""{ "magFilter": 9729, "minFilter": 9728 }""", Interpolation.Bilinear, Wrapping.Repeat, Wrapping.Repeat)]
    [InlineData("""{ "minFilter": 9984, "wrapS": 33071 }""", Interpolation.Nearest, Wrapping.Clamp, Wrapping.Repeat)]
    [InlineData("""{ "wrapS": 10497, "wrapT": 33648 }""", Interpolation.Bilinear, Wrapping.Repeat, Wrapping.Mirror)]
    public void Samplers_say_how_pictures_are_shown(string sampler, Interpolation interpolation, Wrapping across, Wrapping upwards)
    {
        TestGltf file = TestGltf.Triangle(Textured);
        AddPicture(file, null, sampler);
        ImageTextureDescription texture = Assert.IsType<ImageTextureDescription>(BaseColor(file));
        Assert.Equal((interpolation, across, upwards), (texture.Interpolation, texture.Wrapping, texture.VerticalWrapping));
    }

    [Fact]
    public void A_colour_multiplies_its_texture()
    {
        TestGltf file = TestGltf.Triangle("""{ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 }, "baseColorFactor": [0.5, 0.25, 1, 1], "metallicFactor": 0 } }""");
        AddPicture(file);
        ProductTextureDescription product = Assert.IsType<ProductTextureDescription>(BaseColor(file));
        Assert.IsType<ImageTextureDescription>(product.First);
        Assert.Equal(new Rgb(0.5f, 0.25f, 1), Assert.IsType<SolidTextureDescription>(product.Second).Color);
    }

    [Fact]
    public void Materials_that_use_one_texture_share_it()
    {
        TestGltf file = TestGltf.Triangle(Textured);
        AddPicture(file);
        file.Add("materials", Textured);
        file.Mesh("""{ "attributes": { "POSITION": 0, "TEXCOORD_0": 1 }, "material": 1 }""");
        TextureDescription[] colors = [.. file.Import().Scene.Shapes.Select(s => ((PrincipledMaterialDescription)s.Material).BaseColor)];
        Assert.Same(colors[0], colors[1]);
    }

    // KHR_texture_transform in its own coordinates: s′ = offset + R · (scale · (s, t)), where R turns (1, 0) towards −t.
    [Theory]
    [InlineData(1, 1, 0, 0.25, 0)]
    [InlineData(2, 0.5, 0, 0.1, 0.7)]
    [InlineData(1, 1, 0.5, 0, 0)]
    [InlineData(1.5, -0.75, -2.2, 0.3, -0.4)]
    public void Texture_transforms_are_those_of_the_extension(float scaleX, float scaleY, float angle, float offsetX, float offsetY)
    {
        TestGltf file = TestGltf.Triangle($$$"""
            { "pbrMetallicRoughness": { "metallicFactor": 0, "baseColorTexture": { "index": 0, "extensions": { "KHR_texture_transform":
              { "scale": [{{{TestGltf.Text([scaleX, scaleY])}}}], "rotation": {{{TestGltf.Text([angle])}}}, "offset": [{{{TestGltf.Text([offsetX, offsetY])}}}] } } } } }
            """);
        AddPicture(file);
        PlacedTextureDescription placed = Assert.IsType<PlacedTextureDescription>(BaseColor(file));
        PlacedTexture texture = new(new UvTexture(), placed.Scale, placed.Rotate, placed.Offset);
        foreach ((double s, double t) in ((double, double)[])[(0, 0), (1, 0), (0, 1), (0.3, 0.6)])
        {
            (double sin, double cos) = Math.SinCos(angle);
            double expectedS = offsetX + (cos * scaleX * s) + (sin * scaleY * t);
            double expectedT = offsetY - (sin * scaleX * s) + (cos * scaleY * t);
            texture.Evaluate((float)s, (float)(1 - t), out RgbW uv);
            Assert.Equal(expectedS, uv.R[0], 1e-5);
            Assert.Equal(1 - expectedT, uv.G[0], 1e-5);
        }
    }

    [Fact]
    public void A_texture_on_another_set_of_uv_is_averaged_with_a_note()
    {
        TestGltf file = TestGltf.Triangle("""{ "emissiveFactor": [1, 1, 1], "emissiveTexture": { "index": 0, "texCoord": 1 }, "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 } } }""");
        AddPicture(file);
        ImportedModel model = file.Import();
        LuminaireMaterialDescription lamp = Assert.IsType<LuminaireMaterialDescription>(model.Scene.Shapes[0].Material);
        Assert.Equal(new Rgb(0.5f, 0.5f, 0.5f), Assert.IsType<SolidTextureDescription>(lamp.Color).Color);
        Assert.Contains(model.Notes, n => n.Contains("different uv set", StringComparison.Ordinal));
    }

    [Fact]
    public void A_texture_without_a_picture_that_can_be_read_leaves_its_colour()
    {
        TestGltf file = TestGltf.Triangle(Textured);
        file.Add("textures", """{ "extensions": { "EXT_texture_webp": { "source": 0 } } }""");
        Assert.Equal(Rgb.White, Assert.IsType<SolidTextureDescription>(BaseColor(file)).Color);
    }

    [Fact]
    public void A_damaged_picture_is_refused_with_its_place()
    {
        TestGltf file = TestGltf.Triangle(Textured);
        byte[] png = [.. s_png];
        png[20] ^= 1;
        AddPicture(file, png);
        Assert.Contains("images[0]: the picture cannot be read: ", file.Complaint(), StringComparison.Ordinal);
    }

    /// <summary>A PNG of 2×2 pixels.</summary>
    internal static byte[] Png(params byte[] rgb) => TestPng.File(
        TestPng.Header(2, 2), TestPng.Chunk("IDAT", TestPng.Zlib([0, .. rgb[..6], 0, .. rgb[6..]])), TestPng.End);

    private static TextureDescription BaseColor(TestGltf file, string folder = "") =>
        Assert.IsType<PrincipledMaterialDescription>(Assert.Single(file.Import(folder).Scene.Shapes).Material).BaseColor;
}
