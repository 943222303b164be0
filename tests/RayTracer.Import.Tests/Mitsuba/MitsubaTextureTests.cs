using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import.Tests;

public class MitsubaTextureTests
{
    private const string Picture = """<texture type="bitmap" name="NAME"><string name="filename" value="c.png"/></texture>""";

    [Theory]
    [InlineData("""<bsdf type="roughconductor">alpha</bsdf>""", "Alpha")]
    [InlineData("""<bsdf type="principled">roughness</bsdf>""", "Roughness")]
    [InlineData("""<bsdf type="principled">metallic</bsdf>""", "Metallic")]
    [InlineData("""<bsdf type="mask">opacity<bsdf type="diffuse"/></bsdf>""", "Opacity")]
    [InlineData("""<bsdf type="blendbsdf">weight<bsdf type="diffuse"/><bsdf type="conductor"/></bsdf>""", "Weight")]
    [InlineData("""<bsdf type="bumpmap">any<bsdf type="diffuse"/></bsdf>""", "Map")]
    public void A_picture_that_is_a_number_counts_by_its_luminance(string bsdf, string property) => Assert.True(PictureOf(bsdf, property).Luminance);

    [Theory]
    [InlineData("""<bsdf type="diffuse">reflectance</bsdf>""", "Color")]
    [InlineData("""<bsdf type="principled">base_color</bsdf>""", "BaseColor")]
    [InlineData("""<bsdf type="normalmap">normalmap<bsdf type="diffuse"/></bsdf>""", "Map")]
    public void A_picture_of_colours_or_normals_keeps_its_channels(string bsdf, string property) => Assert.False(PictureOf(bsdf, property).Luminance);

    [Fact]
    public void A_picture_that_is_turned_counts_by_its_luminance_too()
    {
        SceneDescription scene = TestScene.Of("""
            <shape type="rectangle"><bsdf type="mask"><texture type="bitmap" name="opacity"><string name="filename" value="c.png"/><transform name="to_uv"><rotate z="1" angle="30"/></transform></texture><bsdf type="diffuse"/></bsdf></shape>
            """);
        PlacedTextureDescription placed = Assert.IsType<PlacedTextureDescription>(Assert.IsType<MaskMaterialDescription>(scene.Shapes[0].Material).Opacity);
        Assert.True(Assert.IsType<ImageTextureDescription>(placed.Texture).Luminance);
    }

    [Fact]
    public void Raw_constants_are_numbers_as_they_are()
    {
        SceneDescription scene = TestScene.Of("""
            <texture type="rawconstant" id="three"><vector name="value" value="0.25, 0.5, 0.75"/></texture>
            <texture type="rawconstant" id="one"><float name="value" value="0.125"/></texture>
            """);
        Assert.Equal(MaterialTextures.Solid(new Rgb(0.25f, 0.5f, 0.75f)), scene.Textures["three"]);
        Assert.Equal(MaterialTextures.Solid(new Rgb(0.125f, 0.125f, 0.125f)), scene.Textures["one"]);
        Assert.Contains("needs a \"value\"", TestScene.Complaint("""<texture type="rawconstant"/>"""), StringComparison.Ordinal);
    }

    // What Mitsuba 3.9.1 computes of its tables when it renders in RGB.
    [Theory]
    [InlineData("a-C", 2.94405, 2.22714, 1.96816, 0.887465, 0.799299, 0.81529)]
    [InlineData("TiO2_palik", 3.45661, 2.80174, 2.90517, 0.000105265, 0, 0.000652887)]
    [InlineData("Cu_palik", 0.213229, 0.919715, 1.10241, 3.92187, 2.45733, 2.13658)]
    [InlineData("HgTe", 4.77904, 3.2312, 2.6599, 1.63161, 1.58081, 1.72929)]
    public void Conductors_have_Mitsubas_indices(string name, double r, double g, double b, double kr, double kg, double kb)
    {
        ConductorMaterialDescription made = Conductor(name);
        Assert.Equal((new Rgb((float)r, (float)g, (float)b), new Rgb((float)kr, (float)kg, (float)kb)), (made.Eta, made.K));
    }

    [Theory]
    [InlineData("Au", Metal.Gold)]
    [InlineData("Li_palik", Metal.Lithium)]
    [InlineData("Na_palik", Metal.Sodium)]
    public void Metals_that_this_renderer_knows_keep_their_names(string name, Metal metal) => Assert.Equal((metal, null), (Conductor(name).Metal, Conductor(name).Eta));

    private static ConductorMaterialDescription Conductor(string name)
    {
        SceneDescription scene = TestScene.Of($"<shape type=\"sphere\"><bsdf type=\"conductor\"><string name=\"material\" value=\"{name}\"/></bsdf></shape>");
        return Assert.IsType<ConductorMaterialDescription>(Assert.IsType<OneSidedMaterialDescription>(scene.Shapes[0].Material).Material);
    }

    private static ImageTextureDescription PictureOf(string bsdf, string property)
    {
        int end = bsdf.IndexOf('>', StringComparison.Ordinal) + 1;
        int next = bsdf.IndexOf('<', end);
        string things = $"<shape type=\"rectangle\">{bsdf[..end]}{Picture.Replace("NAME", bsdf[end..next], StringComparison.Ordinal)}{bsdf[next..]}</shape>";
        MaterialDescription material = TestScene.Of(things).Shapes[0].Material;
        material = material is OneSidedMaterialDescription sided ? sided.Material : material;
        return Assert.IsType<ImageTextureDescription>(material.GetType().GetProperty(property)!.GetValue(material));
    }
}
