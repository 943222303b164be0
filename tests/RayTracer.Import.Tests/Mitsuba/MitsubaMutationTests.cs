using System.Diagnostics;
using RayTracer.Scenes;

namespace RayTracer.Import.Tests;

/// <summary>Damaged scenes in Mitsuba's format are read or refused, with what the budgets of memory and work allow.</summary>
[Trait("Category", "Thorough")]
public class MitsubaMutationTests
{
    private const string Scene = """
        <scene version="3.0.0"><default name="size" value="8"/><path value="."/><include filename="more.xml"/><alias id="fields" as="both"/>
        <integrator type="aov"><string name="aovs" value="d:depth"/><integrator type="volpath"><integer name="max_depth" value="3"/><boolean name="hide_emitters" value="true"/></integrator></integrator>
        <sensor type="thinlens"><float name="aperture_radius" value="0.1"/><float name="focus_distance" value="4"/><string name="focal_length" value="35mm"/><float name="principal_point_offset_x" value="0.1"/>
        <transform name="to_world"><lookat origin="0,1,5" target="0,0,0" up="0,1,0"/></transform><sampler type="multijitter"><integer name="sample_count" value="4"/></sampler>
        <film type="hdrfilm"><integer name="width" value="$size"/><integer name="height" value="$size"/><integer name="crop_width" value="4"/><rfilter type="mitchell"><float name="A" value="0.3"/></rfilter></film></sensor>
        <shape type="sphere"><boolean name="flip_normals" value="true"/></shape><shape type="sphere"><point name="center" x="1" y="0" z="0"/><float name="radius" value="0.5"/><bsdf type="twosided"><bsdf type="blendbsdf"><ref id="both" name="weight"/>
        <bsdf type="roughconductor"><string name="material" value="a-C"/><float name="alpha_u" value="0.1"/><float name="alpha_v" value="0.2"/></bsdf><bsdf type="principled"><rgb name="base_color" value="0.5,0.2,0.1"/><ref id="both" name="metallic"/></bsdf></bsdf></bsdf></shape>
        <shape type="cube"><transform name="to_world"><scale value="2"/><rotate y="1" angle="30"/><translate x="1"/></transform><bsdf type="null"/><medium type="heterogeneous" name="interior"><float name="scale" value="2"/>
        <volume type="gridvolume" name="sigma_t"><string name="filename" value="fog.vol"/><string name="wrap_mode" value="mirror"/></volume><volume type="constvolume" name="albedo"><float name="value" value="0.5"/></volume><phase type="blendphase"><float name="weight" value="0.3"/><phase type="hg"><float name="g" value="0.4"/></phase><phase type="tabphase"><string name="values" value="1, 2, 1"/></phase></phase></medium></shape>
        <shape type="shapegroup" id="group"><shape type="disk"><bsdf type="mask"><float name="opacity" value="0.5"/><bsdf type="roughplastic"/></bsdf></shape></shape><shape type="instance"><ref id="group"/></shape>
        <shape type="cylinder"><point name="p1" value="0 0 2"/><bsdf type="dielectric"><string name="int_ior" value="bk7"/></bsdf></shape><shape type="linearcurve"><string name="filename" value="curves.txt"/></shape>
        <shape type="ply"><string name="filename" value="one.ply"/><bsdf type="diffuse"><texture type="mesh_attribute" name="reflectance"><string name="name" value="face_color"/></texture></bsdf></shape>
        <shape type="rectangle"><emitter type="area"><spectrum name="radiance" value="400:1, 700:2"/></emitter></shape><emitter type="spot"><rgb name="intensity" value="3"/><float name="cutoff_angle" value="30"/></emitter>
        <emitter type="constant"><spectrum name="radiance" type="blackbody"><float name="temperature" value="3000"/></spectrum></emitter></scene>
        """;

    private static readonly string[] s_pieces =
        ["\"", "<", ">", "/>", "</shape>", "<shape type=\"sphere\">", "<bsdf type=\"mask\">", "<ref id=\"both\"/>", "<ref id=\"group\"/>", "<include filename=\"scene.xml\"/>", "$size", "$x", "1e38", "-1", "0", "nan", "99999999999",
        " name=\"scale\"", " id=\"both\"", " value=\"\"", "&#0;", "&amp;", "\0", "\uFFFD", "<!--", "]]>", "<?x?>"];

    [Fact]
    public void Damaged_scenes_are_read_or_refused()
    {
        using TestScene folder = new();
        File.WriteAllText(folder["more.xml"], """<scene version="3.0.0"><texture type="checkerboard" id="fields"><float name="color0" value="0.2"/><rgb name="color1" value="0.5"/></texture></scene>""");
        File.WriteAllText(folder["curves.txt"], "0 0 0 0.1\n1 0 0 0.2\n");
        File.WriteAllBytes(folder["fog.vol"], TestVolumes.Vol(2, 2, 2, (x, _, _) => [x]));
        File.WriteAllText(
            folder["one.ply"],
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\nproperty float z\nelement face 1\nproperty list uchar int vertex_indices\n"
            + "property float r\nproperty float g\nproperty float b\nend_header\n0 0 0\n1 0 0\n0 1 0\n3 0 1 2 1 0 0\n");
        string path = folder["scene.xml"];
        File.WriteAllText(path, Scene);
        SceneLoadResult whole = SceneLoader.Load(path);
        Assert.True(whole.Scene is not null, Diagnostic.Format([.. whole.Diagnostics]));
        Random random = new(2010 + TestSettings.Seed);
        int rounds = TestSettings.Scale(200, 5000);
        int refused = 0;
        for (int round = 0; round < rounds; round++)
        {
            string damaged = Damage(random);
            File.WriteAllText(path, damaged);
            long before = GC.GetAllocatedBytesForCurrentThread();
            Stopwatch watch = Stopwatch.StartNew();
            SceneLoadResult load = SceneLoader.Load(path);
            refused += load.Scene is null ? 1 : 0;
            Assert.Equal(load.Diagnostics.Any(d => d.Severity == Severity.Error), load.Scene is null);
            Assert.All(load.Diagnostics, d => Assert.DoesNotContain('\n', d.Message));
            Assert.True(watch.Elapsed.TotalSeconds < 5 && GC.GetAllocatedBytesForCurrentThread() - before < 1L << 30, damaged);
        }

        Assert.InRange(refused, rounds / 5, rounds - (rounds / 100));
    }

    private static string Damage(Random random)
    {
        string text = Scene;
        for (int damage = random.Next(1, 3); damage > 0; damage--)
        {
            // Half of the time a whole value gives way to a piece: other damage mostly ends as bad XML.
            int at = random.Next(text.Length);
            int begin = text.IndexOf("value=\"", at, StringComparison.Ordinal) + 7;
            bool isValue = random.Next(2) == 0 && begin > 7;
            int end = isValue ? text.IndexOf('"', begin) : -1;
            text = end > 0 ? text[..begin] + s_pieces[random.Next(s_pieces.Length)] + text[end..]
                : text.Remove(at, int.Min(random.Next(12), text.Length - at)).Insert(at, random.Next(2) == 0 ? s_pieces[random.Next(s_pieces.Length)] : "");
        }

        return text;
    }
}
