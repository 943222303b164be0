using System.Numerics;
using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Lights;
using RayTracer.Numerics;
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

    // Numbers of Mitsuba 3.9.1: the light that the sky and the sun bring onto a level ground, in green.
    [Theory]
    [InlineData(15, 0.3736, 0.25)]
    [InlineData(40, 1.0006, 0.03)]
    [InlineData(70, 1.4761, 0.1)]
    public void A_sky_stands_in_for_the_table_of_another_where_scenes_are_read_leniently(float elevation, float irradiance, float tolerance)
    {
        ImportSettings.IsLenient = true;
        using TestScene scene = new();
        (float up, float x, float y) = (float.SinPi(elevation / 180), 0.6f * float.CosPi(elevation / 180), 0.8f * float.CosPi(elevation / 180));
        string sky = string.Create(System.Globalization.CultureInfo.InvariantCulture, $"""
            <emitter type="sunsky"><vector name="sun_direction" x="{x}" y="{up}" z="{-y}"/><transform name="to_world"><rotate x="1" angle="-90"/></transform></emitter>
            <shape type="rectangle"><transform name="to_world"><rotate x="1" angle="-90"/></transform><bsdf type="diffuse"><rgb name="reflectance" value="1"/></bsdf></shape>
            """);
        SceneReadResult read = MitsubaReader.Read(scene.Write("scene.xml", sky));
        Assert.EndsWith("; the native sky with the same sun stands in for it", Assert.Single(read.Diagnostics).Message, StringComparison.Ordinal);
        SkyEnvironmentDescription stand = (SkyEnvironmentDescription)read.Description!.Environment!;
        Assert.Equal(elevation, stand.SunElevation, 1e-3f);
        EnvironmentLight light = stand.Build(new())!;

        // The sun stands where it is said to, and its light and the sky's come to as much on the ground.
        Vector3 toSun = new(x, up, -y);
        light.Evaluate(toSun, out RgbW sun);
        light.Evaluate(toSun + new Vector3(0, 0.03f, 0), out RgbW beside);
        Assert.True(sun.G[0] > 1000 * beside.G[0], $"{sun.G[0]} beside {beside.G[0]}");
        Assert.Equal(irradiance, Irradiance(light), tolerance * irradiance);
    }

    // By samples of the light, in strata.
    private static double Irradiance(EnvironmentLight light)
    {
        const int side = 128;
        double sum = 0;
        for (int i = 0; i < side * side; i++)
        {
            light.Sample(default, ((i % side) + 0.5f) / side, ((i / side) + 0.5f) / side, 0f, out ShapeSampleW sample, out RgbW radiance);
            sum += radiance.G[0] * float.Max(sample.Direction.Y[0], 0);
        }

        return sum / (side * side);
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
