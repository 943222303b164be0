using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Materials;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Import.Tests;

/// <summary>Mitsuba's plugins that are refused by name, and shapes that are turned inside out.</summary>
public class MitsubaPluginTests
{
    public static TheoryData<string, string> Refused
    {
        get
        {
            TheoryData<string, string> data = [];
            foreach ((string kind, string type) in MitsubaPlugins.Refused.Keys)
            {
                data.Add(kind, type);
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Refused))]
    public void What_is_refused_is_refused_by_name_and_with_the_reason(string kind, string type)
    {
        string thing = $"<{kind} type=\"{type}\"/>";
        string film = $"<sensor type=\"perspective\"><film type=\"{(kind == "film" ? type : "hdrfilm")}\"><rfilter type=\"{(kind == "rfilter" ? type : "box")}\"/></film></sensor>";
        if (kind == "phase")
        {
            thing = $"<shape type=\"sphere\"><bsdf type=\"null\"/><medium type=\"homogeneous\" name=\"interior\">{thing}</medium></shape>";
        }

        string things = type == "directionalarea" ? $"<shape type=\"sphere\">{thing}</shape>" : kind is "sensor" or "film" or "rfilter" ? "" : thing;
        Assert.EndsWith(
            $"of type \"{type}\" are not supported: {MitsubaPlugins.Refused[(kind, type)]}", TestScene.Complaint(things, kind == "sensor" ? thing : film + (kind == "phase" ? "<integrator type=\"volpath\"/>" : "")), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("sphere")]
    [InlineData("cylinder")]
    public void A_shape_that_is_turned_inside_out_is_seen_from_inside(string type)
    {
        TwoSidedMaterialDescription sided = Assert.IsType<TwoSidedMaterialDescription>(Turned(type, """<bsdf type="diffuse"/>"""));
        Assert.Equal(MitsubaBsdfs.Black, sided.Front);
        Assert.Equal(((OneSidedMaterialDescription)MitsubaBsdfs.Standard).Material, sided.Back);
        Assert.IsType<DiffuseMaterialDescription>(Turned(type, """<bsdf type="twosided"><bsdf type="diffuse"/></bsdf>"""));
        TwoSidedMaterialDescription two = Assert.IsType<TwoSidedMaterialDescription>(Turned(type, """<bsdf type="twosided"><bsdf type="diffuse"/><bsdf type="conductor"/></bsdf>"""));
        Assert.IsType<ConductorMaterialDescription>(two.Front);
    }

    [Fact]
    public void Glass_that_is_turned_inside_out_is_around_the_shape()
    {
        const string glass = """<bsdf type="dielectric"><float name="int_ior" value="1.6"/><float name="ext_ior" value="1"/></bsdf>""";
        Assert.Equal(1 / 1.6f, Assert.IsType<DielectricMaterialDescription>(Turned("sphere", glass)).RefractiveIndex);
        MaskMaterialDescription mask = Assert.IsType<MaskMaterialDescription>(Turned("sphere", $"<bsdf type=\"mask\">{glass}</bsdf>"));
        Assert.Equal(1 / 1.6f, Assert.IsType<DielectricMaterialDescription>(mask.Material).RefractiveIndex);
    }

    [Theory]
    [InlineData("""<emitter type="area"/>""")]
    [InlineData("""<bsdf type="dielectric"/><medium name="interior" type="homogeneous"/>""")]
    [InlineData("""<bsdf type="bumpmap"><texture type="checkerboard"/><bsdf type="diffuse"/></bsdf>""")]
    public void What_cannot_be_turned_inside_out_is_said(string things) => Assert.StartsWith("a sphere that is turned inside out and shines", TestScene.Complaint(Shape("sphere", things), TestScene.Sensor + "<integrator type=\"volpath\"/>"), StringComparison.Ordinal);

    [Fact]
    public void The_focus_distance_of_a_sensor_without_an_aperture_has_no_effect()
    {
        string sensor = TestScene.Sensor.Replace("<film", "<float name=\"focus_distance\" value=\"3\"/><film", StringComparison.Ordinal);
        Assert.Equal(TestScene.Of("").Camera, TestScene.Of("", sensor).Camera);
    }

    private static string Shape(string type, string things) => $"<shape type=\"{type}\"><boolean name=\"flip_normals\" value=\"true\"/>{things}</shape>";

    private static MaterialDescription Turned(string type, string things) => Assert.Single(TestScene.Of(Shape(type, things)).Shapes).Material;
}
