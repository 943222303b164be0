using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Import.Tests;

/// <summary>What is inside of shapes, and around cameras.</summary>
public class MitsubaMediaTests
{
    private const string Fog = """<medium type="homogeneous" name="interior"><rgb name="sigma_t" value="1 2 3"/><float name="scale" value="2"/><rgb name="albedo" value="0.5 0.6 0.7"/></medium>""";

    private const string Volumetric = TestScene.Sensor + """<integrator type="volpath"/>""";

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
        MediumDescription interior = Of(Assert.Single(TestScene.Of($"""<shape type="sphere">{bsdf}{Fog}</shape>""", Volumetric).Shapes));
        Assert.Equal(new(2, 4, 6), interior.Extinction);
        Assert.Equal(new(0.5f, 0.6f, 0.7f), interior.Albedo);
    }

    [Theory]
    [InlineData("""<shape type="sphere"><bsdf type="diffuse"/>FOG</shape>""", "a medium in a shape that lets no light in is invisible")]
    [InlineData("""<shape type="sphere"><bsdf type="null"/>EXTERIOR</shape>""", "the medium outside a shape follows from the shapes around it: this has no effect")]
    public void Media_without_effect_are_warned_of(string shape, string warning) =>
        Assert.Equal(warning, TestScene.Complaint(shape.Replace("FOG", Fog, StringComparison.Ordinal).Replace("EXTERIOR", Fog.Replace("interior", "exterior", StringComparison.Ordinal), StringComparison.Ordinal), Volumetric));

    // As in Mitsuba, whose pictures of such scenes are those without media.
    [Fact]
    public void Integrators_without_media_leave_them_out()
    {
        string shape = $"""<shape type="sphere"><bsdf type="null"/>{Fog}</shape>""";
        Assert.Equal("the scene's integrator shows no media: \"volpath\" and \"volpathmis\" do", TestScene.Complaint(shape));
        using TestScene scene = new();
        Assert.IsType<MaskMaterialDescription>(MitsubaReader.Read(scene.Write("scene.xml", shape)).Description!.Shapes[0].Material);
    }

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
        Assert.All(TestScene.Of(medium + ball + ball, Volumetric).Shapes, s => Assert.Equal(new(2, 4, 6), Of(s).Extinction));
    }

    [Fact]
    public void Volumes_become_grids_and_factors()
    {
        const string grid = """<volume name="NAME" type="gridvolume"><string name="filename" value="smoke.vol"/><string name="filter_type" value="nearest"/><string name="wrap_mode" value="mirror"/><transform name="to_world"><scale value="2"/><translate x="1"/></transform></volume>""";
        string medium = $"""<medium name="interior" type="heterogeneous">{grid.Replace("NAME", "sigma_t", StringComparison.Ordinal)}<volume name="albedo" type="constvolume"><rgb name="value" value="0.1 0.2 0.3"/></volume><float name="scale" value="7"/><phase type="hg"><float name="g" value="0.4"/></phase></medium>""";
        MediumDescription read = Of(Assert.Single(TestScene.Of($"""<shape type="cube"><bsdf type="null"/>{medium}</shape>""", Volumetric).Shapes));
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
        MediumDescription read = Of(Assert.Single(TestScene.Of($"""<shape type="cube"><bsdf type="null"/>{medium}</shape>""", Volumetric).Shapes));
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
        Assert.Equal(message, TestScene.Complaint($"""<shape type="cube"><bsdf type="null"/>{medium}</shape>""", Volumetric));

    [Fact]
    public void Phase_functions_are_read()
    {
        Assert.Null(Phase("""<phase type="hg"/>"""));
        Assert.Equal(PhaseShape.Rayleigh, Phase("""<phase type="rayleigh"/>""")!.Shape);
        PhaseDescription table = Phase("""<phase type="tabphase"><string name="values" value="1, 2 0,.5"/></phase>""")!;
        Assert.Equal((PhaseShape.Table, "1 2 0 0.5"), (table.Shape, string.Join(' ', table.Values)));
        const string grid = """<volume name="weight" type="gridvolume"><string name="filename" value="w.vol"/><transform name="to_world"><scale value="2"/></transform></volume>""";
        PhaseDescription blend = Phase($"""<phase type="blendphase">{grid}<phase type="hg"><float name="g" value="0.3"/></phase><phase type="blendphase"><phase type="isotropic"/><phase type="rayleigh"/></phase></phase>""")!;
        Assert.Equal((PhaseShape.Mix, 1, 0.3f), (blend.Shape, blend.Weight, blend.First!.Anisotropy));
        Assert.EndsWith("w.vol", blend.WeightGrid!.File, StringComparison.Ordinal);
        Assert.Equal((PhaseShape.Mix, 0.5f, PhaseShape.HenyeyGreenstein, PhaseShape.Rayleigh), (blend.Second!.Shape, blend.Second.Weight, blend.Second.First!.Shape, blend.Second.Second!.Shape));
        Assert.Null(blend.Second.WeightGrid);
    }

    [Fact]
    public void Flakes_are_a_grid_of_matrices()
    {
        PhaseDescription flakes = Phase("""<phase type="sggx"><volume name="S" type="gridvolume"><string name="filename" value="s.vol"/><string name="filter_type" value="nearest"/></volume></phase>""")!;
        Assert.Equal((PhaseShape.Sggx, GridInterpolation.Nearest, 0), (flakes.Shape, flakes.MatrixGrid!.Interpolation, flakes.Matrix.Count));
        Assert.EndsWith("s.vol", flakes.MatrixGrid.File, StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("""<phase type="tabphase"><string name="values" value="1"/></phase>""", "a table has from 2 to 65536 values, not 1")]
    [InlineData("""<phase type="tabphase"><string name="values" value="0, 0"/></phase>""", "of the values, one must be above 0")]
    [InlineData("""<phase type="tabphase"><string name="values" value="1, -2"/></phase>""", "the values of a phase function must be at least 0")]
    [InlineData("""<phase type="tabphase"><string name="values" value="1, two"/></phase>""", "expected a number, but found \"two\"")]
    [InlineData("""<phase type="blendphase"><phase type="hg"/></phase>""", "phase \"blendphase\" needs 2 phase functions within it, but has 1")]
    [InlineData("""<phase type="blendphase"><rgb name="weight" value="1 0 0"/><phase type="hg"/><phase type="hg"/></phase>""", "a weight is one number, not a colour")]
    [InlineData("""<phase type="sggx"/>""", "phase \"sggx\" needs a \"gridvolume\" of six channels as \"S\"")]
    [InlineData("""<phase type="sggx"><volume name="S" type="constvolume"><float name="value" value="1"/></volume></phase>""", "phase \"sggx\" needs a \"gridvolume\" of six channels as \"S\"")]
    [InlineData("""<phase type="blendphase"><phase type="hg"/><phase type="sggx"><volume name="S" type="gridvolume"><string name="filename" value="s.vol"/></volume></phase></phase>""", "\"sggx\" within \"blendphase\" is not supported: it also says how much light the medium weakens")]
    public void Phase_functions_that_are_not_read_are_said(string phase, string message) =>
        Assert.Equal(message, TestScene.Complaint($"""<shape type="cube"><bsdf type="null"/><medium name="interior" type="homogeneous">{phase}</medium></shape>""", Volumetric));

    // Each within the next one, twice: what is read grows by a factor of 2 with each, and would not end.
    [Fact]
    public void Mixtures_of_mixtures_have_an_end()
    {
        IEnumerable<string> phases = Enumerable.Range(0, 60).Select(i => $"""<phase type="blendphase" id="p{i}"><ref id="p{i + 1}"/><ref id="p{i + 1}"/></phase>""");
        const string medium = """<shape type="cube"><bsdf type="null"/><medium name="interior" type="homogeneous"><ref id="p0"/></medium></shape>""";
        using TestScene scene = new();
        SceneReadResult read = MitsubaReader.Read(scene.Write("scene.xml", string.Concat(phases) + """<phase type="isotropic" id="p60"/>""" + medium, Volumetric));
        Assert.Equal(55, read.Diagnostics.Count(d => d.Message == "mixtures of phase functions may be nested 5 deep"));
        Assert.Equal(55, read.Diagnostics.Count);
    }

    private static PhaseDescription? Phase(string phase) =>
        Of(Assert.Single(TestScene.Of($"""<shape type="cube"><bsdf type="null"/><medium name="interior" type="homogeneous">{phase}</medium></shape>""", Volumetric).Shapes)).Phase;

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
