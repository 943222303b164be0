using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Import.Tests;

/// <summary>What is inside of shapes, and around cameras.</summary>
public class MitsubaMediaTests
{
    private const string Fog = """<medium type="homogeneous" name="interior"><rgb name="sigma_t" value="1 2 3"/><float name="scale" value="2"/><rgb name="albedo" value="0.5 0.6 0.7"/></medium>""";

    [Theory]
    [InlineData("""<bsdf type="null"/>""")]
    [InlineData("""<bsdf type="dielectric"/>""")]
    [InlineData("""<bsdf type="roughdielectric"/>""")]
    [InlineData("""<bsdf type="thindielectric"/>""")]
    [InlineData("""<bsdf type="principled"><float name="spec_trans" value="1"/></bsdf>""")]
    [InlineData("""<bsdf type="mask"><float name="opacity" value="0.5"/><bsdf type="diffuse"/></bsdf>""")]
    [InlineData("""<bsdf type="blendbsdf"><float name="weight" value="0.5"/><bsdf type="diffuse"/><bsdf type="dielectric"/></bsdf>""")]
    public void Shapes_that_let_light_in_are_filled(string bsdf)
    {
        MediumDescription interior = Of(Assert.Single(TestScene.Of($"""<shape type="sphere">{bsdf}{Fog}</shape>""").Shapes));
        Assert.Equal(new(2, 4, 6), interior.Extinction);
        Assert.Equal(new(0.5f, 0.6f, 0.7f), interior.Albedo);
    }

    [Theory]
    [InlineData("""<shape type="sphere"><bsdf type="diffuse"/>FOG</shape>""", "a medium in a shape that lets no light in is invisible")]
    [InlineData("""<shape type="sphere"><bsdf type="null"/>EXTERIOR</shape>""", "the medium outside a shape follows from the shapes around it: this has no effect")]
    public void Media_without_effect_are_warned_of(string shape, string warning) =>
        Assert.Equal(warning, TestScene.Complaint(shape.Replace("FOG", Fog, StringComparison.Ordinal).Replace("EXTERIOR", Fog.Replace("interior", "exterior", StringComparison.Ordinal), StringComparison.Ordinal)));

    [Fact]
    public void The_medium_of_a_camera_follows_from_what_is_around_it()
    {
        string sensor = TestScene.Sensor.Replace("</sensor>", Fog.Replace("interior", "around", StringComparison.Ordinal) + "</sensor>", StringComparison.Ordinal);
        Assert.Equal("the medium around the camera follows from the shapes around it: this has no effect", TestScene.Complaint("", sensor));
    }

    [Fact]
    public void A_medium_may_stand_by_itself_and_fill_several_shapes()
    {
        string medium = Fog.Replace(" name=\"interior\"", " id=\"fog\"", StringComparison.Ordinal);
        const string ball = """<shape type="sphere"><bsdf type="null"/><ref id="fog" name="interior"/></shape>""";
        Assert.All(TestScene.Of(medium + ball + ball).Shapes, s => Assert.Equal(new(2, 4, 6), Of(s).Extinction));
    }

    [Fact]
    public void Volumes_become_grids_and_factors()
    {
        const string grid = """<volume name="NAME" type="gridvolume"><string name="filename" value="smoke.vol"/><string name="filter_type" value="nearest"/><string name="wrap_mode" value="mirror"/><transform name="to_world"><scale value="2"/><translate x="1"/></transform></volume>""";
        string medium = $"""<medium name="interior" type="heterogeneous">{grid.Replace("NAME", "sigma_t", StringComparison.Ordinal)}<volume name="albedo" type="constvolume"><rgb name="value" value="0.1 0.2 0.3"/></volume><float name="scale" value="7"/><phase type="hg"><float name="g" value="0.4"/></phase></medium>""";
        MediumDescription read = Of(Assert.Single(TestScene.Of($"""<shape type="cube"><bsdf type="null"/>{medium}</shape>""").Shapes));
        Assert.Equal((new(7, 7, 7), new(0.1f, 0.2f, 0.3f), 0.4f), (read.Extinction, read.Albedo, read.Anisotropy));
        Assert.Null(read.AlbedoGrid);
        Assert.EndsWith("smoke.vol", read.Density!.File, StringComparison.Ordinal);
        Assert.Equal((GridInterpolation.Nearest, Wrapping.Mirror), (read.Density.Interpolation, read.Density.Wrapping));
        Assert.Equal([Vector3.Zero, Vector3.One], read.Density.Box);
        Assert.Equal([2, 0, 0, 1, 0, 2, 0, 0, 0, 0, 2, 0], Assert.Single(read.Density.Transform).Matrix);
    }

    [Fact]
    public void Defaults_of_a_grid_are_Mitsubas()
    {
        const string medium = """<medium name="interior" type="heterogeneous"><volume name="sigma_t" type="gridvolume"><string name="filename" value="a.vol"/><boolean name="use_grid_bbox" value="true"/></volume></medium>""";
        MediumDescription read = Of(Assert.Single(TestScene.Of($"""<shape type="cube"><bsdf type="null"/>{medium}</shape>""").Shapes));
        Assert.Equal((new(1, 1, 1), new(0.75f, 0.75f, 0.75f)), (read.Extinction, read.Albedo));
        Assert.Equal((GridInterpolation.Trilinear, Wrapping.Clamp), (read.Density!.Interpolation, read.Density.Wrapping));
        Assert.Empty(read.Density.Box);
        Assert.Empty(read.Density.Transform);
    }

    [Theory]
    [InlineData("""<medium name="interior" type="heterogeneous"><volume name="sigma_t" type="nanovolume"/></medium>""", "volumes of type \"nanovolume\" are not supported: known are constvolume, gridvolume")]
    [InlineData("""<medium name="interior" type="heterogeneous"><volume name="sigma_t" type="gridvolume"/></medium>""", "volume \"gridvolume\" needs \"filename\", the path of a file")]
    [InlineData("""<medium name="interior" type="homogeneous"><volume name="sigma_t" type="gridvolume"><string name="filename" value="a.vol"/></volume></medium>""", "a homogeneous medium cannot have a grid: its type must be \"heterogeneous\"")]
    [InlineData("""<medium name="interior" type="heterogeneous"><volume name="albedo" type="gridvolume"><string name="filename" value="a.vol"/></volume></medium>""", "an albedo that varies is read only where \"sigma_t\" is a grid too")]
    public void Volumes_that_are_not_read_are_said(string medium, string message) =>
        Assert.Equal(message, TestScene.Complaint($"""<shape type="cube"><bsdf type="null"/>{medium}</shape>"""));

    private static MediumDescription Of(ShapeDescription shape) => Of(shape.Material);

    private static MediumDescription Of(MaterialDescription material) => material switch
    {
        InvisibleMaterialDescription m => m.Interior,
        GlassDescription m => m.Interior,
        ThinDielectricMaterialDescription m => m.Interior,
        PrincipledMaterialDescription m => m.Interior,
        MaskMaterialDescription m => m.Interior,
        MixMaterialDescription m => Of(m.Second),
        _ => new(),
    };
}
