using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Import.Tests;

/// <summary>Scenes that are read with parameters from outside, or leniently.</summary>
public sealed class MitsubaSettingsTests : IDisposable
{
    public void Dispose() => (ImportSettings.IsLenient, ImportSettings.Parameters) = (false, new Dictionary<string, string>());

    [Fact]
    public void Parameters_from_outside_come_before_those_of_the_scene()
    {
        ImportSettings.Parameters = new Dictionary<string, string> { ["r"] = "3", ["free"] = "0.5" };
        SphereDescription sphere = Assert.IsType<SphereDescription>(Assert.Single(TestScene.Of("""
            <default name="r" value="2"/><shape type="sphere"><float name="radius" value="$r"/><point name="center" x="$free"/></shape>
            """).Shapes));
        Assert.Equal((3, 0.5f), (sphere.Radius, sphere.Center.X));
    }

    [Fact]
    public void Parameters_that_stand_nowhere_are_errors()
    {
        ImportSettings.Parameters = new Dictionary<string, string> { ["radios"] = "3" };
        Assert.Equal(
            "the parameter \"radios\" is given a value, but $radios stands nowhere (did you mean \"radius\"?)",
            TestScene.Complaint("""<default name="radius" value="2"/><shape type="sphere"><float name="radius" value="$radius"/></shape>"""));
    }

    [Theory]
    [InlineData("""<shape type="sphere"><bsdf type="hair"><float name="eumelanin" value="1"/></bsdf></shape>""", "magenta is shown instead")]
    [InlineData("""<shape type="sphere"><bsdf type="diffuse"><texture type="volume" name="reflectance"/></bsdf></shape>""", "magenta is shown instead")]
    [InlineData("""<shape type="sdfgrid"><string name="filename" value="a.vol"/><bsdf type="diffuse"/></shape>""", "a magenta ball is shown instead")]
    [InlineData("""<emitter type="sunsky"><float name="turbidity" value="3"/></emitter>""", "it is left out")]
    [InlineData("""<integrator type="stokes"><integrator type="path"/></integrator>""", "\"path\" is used instead")]
    [InlineData("""<shape type="sphere"><float name="colour" value="1"/></shape>""", "it is ignored")]
    [InlineData("""<shape type="sphere"><boolean name="flip_normals" value="true"/><emitter type="area"/></shape>""", "it is not turned")]
    [InlineData("""<integrator type="ptracer"><boolean name="hide_emitters" value="true"/></integrator>""", "they are seen")]
    public void What_is_not_supported_is_a_warning_where_scenes_are_read_leniently(string things, string standIn)
    {
        using TestScene scene = new();
        string path = scene.Write("scene.xml", things);
        Assert.Contains(MitsubaReader.Read(path).Diagnostics, d => d.Severity == Severity.Error);
        ImportSettings.IsLenient = true;
        Diagnostic warning = Assert.Single(MitsubaReader.Read(path).Diagnostics);
        Assert.Equal(Severity.Warning, warning.Severity);
        Assert.EndsWith($"; {standIn}", warning.Message, StringComparison.Ordinal);
    }

    [Fact]
    public void Stand_ins_are_magenta_and_where_they_stand_for()
    {
        ImportSettings.IsLenient = true;
        using TestScene scene = new();
        SceneDescription read = MitsubaReader.Read(scene.Write("scene.xml", """
            <shape type="sdfgrid"><transform name="to_world"><translate x="3"/></transform></shape>
            <shape type="sphere"><bsdf type="measured"/></shape>
            """)).Description!;
        Assert.Equal([MitsubaBsdfs.Magenta, MitsubaBsdfs.Magenta], read.Shapes.Select(s => s.Material));
        Assert.Single(read.Shapes[0].Transform);
    }

    [Fact]
    public void What_is_wrong_stays_an_error_where_scenes_are_read_leniently()
    {
        ImportSettings.IsLenient = true;
        using TestScene scene = new();
        Assert.Equal(Severity.Error, Assert.Single(MitsubaReader.Read(scene.Write("scene.xml", """<shape type="sphere"><float name="radius" value="x"/></shape>""")).Diagnostics).Severity);
    }
}
