using System.Numerics;
using RayTracer.Description;
using RayTracer.Import;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Import.Tests;

/// <summary>What shapes, BSDFs, textures and emitters become.</summary>
public class MitsubaThingsTests
{
    [Fact]
    public void Steps_of_a_transform_are_applied_in_their_order()
    {
        SphereDescription sphere = Assert.IsType<SphereDescription>(Assert.Single(TestScene.Of("""
            <shape type="sphere">
              <transform name="to_world"><translate x="1"/><scale value="2"/><rotate z="1" angle="90"/><matrix value="1 0 0 0  0 1 0 0  0 0 1 5  0 0 0 1"/></transform>
            </shape>
            """).Shapes));
        Assert.Equal(0, (sphere.Center - new Vector3(0, 2, 5)).Norm(), 1e-5);
        Assert.Equal(2, sphere.Radius, 1e-5);
    }

    [Fact]
    public void A_checkerboard_that_is_a_number_has_its_fields_in_the_opposite_places()
    {
        SceneDescription scene = TestScene.Of("""
            <texture type="checkerboard" id="fields"><float name="color0" value="0.25"/><texture type="checkerboard" name="color1"><float name="color0" value="0.5"/><float name="color1" value="0.75"/></texture></texture>
            <shape type="sphere"><bsdf type="blendbsdf"><ref id="fields" name="weight"/><bsdf type="diffuse"><ref id="fields" name="reflectance"/></bsdf><bsdf type="null"/></bsdf></shape>
            """);
        MixMaterialDescription blend = Assert.IsType<MixMaterialDescription>(scene.Shapes[0].Material);
        CheckerTextureDescription color = Assert.IsType<CheckerTextureDescription>(scene.Textures["fields"]);
        CheckerTextureDescription number = Assert.IsType<CheckerTextureDescription>(blend.Weight);
        CheckerTextureDescription inner = Assert.IsType<CheckerTextureDescription>(number.Even);
        Assert.Equal(color.Even, number.Odd);
        Assert.Equal(((CheckerTextureDescription)color.Odd).Even, inner.Odd);
        Assert.Equal(((CheckerTextureDescription)color.Odd).Odd, inner.Even);
    }

    [Fact]
    public void The_diffuse_reflectance_of_a_plastic_is_a_color_and_no_number()
    {
        SceneDescription scene = TestScene.Of("""
            <texture type="checkerboard" id="fields"/>
            <shape type="sphere"><bsdf type="plastic"><ref id="fields" name="diffuse_reflectance"/></bsdf></shape>
            """);
        MaterialDescription material = Assert.IsType<OneSidedMaterialDescription>(scene.Shapes[0].Material).Material;
        Assert.Equal(scene.Textures["fields"], Assert.IsType<PlasticMaterialDescription>(material).Color);
    }

    [Fact]
    public void Mirrored_and_turned_rectangles_keep_their_front_and_their_uv()
    {
        IReadOnlyList<ShapeDescription> shapes = TestScene.Of("""
            <shape type="rectangle"/>
            <shape type="rectangle"><boolean name="flip_normals" value="true"/></shape>
            <shape type="rectangle"><transform name="to_world"><scale x="-1"/></transform></shape>
            <shape type="rectangle"><transform name="to_world"><scale x="-1"/></transform><boolean name="flip_normals" value="true"/></shape>
            """).Shapes;
        Vector3[] fronts =
        [
            .. shapes.Select(s => s is RectangleDescription r ? r.EdgeU.Cross(r.EdgeV).Unit()
                : s is MeshDescription m ? (m.Positions[m.Triangles[0].B] - m.Positions[m.Triangles[0].A]).Cross(m.Positions[m.Triangles[0].C] - m.Positions[m.Triangles[0].A]).Unit() : default),
        ];
        Assert.Equal([Vector3.UnitZ, -Vector3.UnitZ, Vector3.UnitZ, -Vector3.UnitZ], fronts);
        MeshDescription mirrored = Assert.IsType<MeshDescription>(shapes[2]);
        Assert.Equal(new(1, -1, 0), mirrored.Positions[mirrored.Uv.ToList().IndexOf(Vector2.Zero)]);
    }

    [Fact]
    public void Meshes_are_smooth_without_normals_of_their_own_and_obj_files_have_v_turned_over()
    {
        IReadOnlyList<ShapeDescription> shapes = TestScene.Of("""
            <shape type="obj"><string name="filename" value="a.obj"/></shape>
            <shape type="ply"><string name="filename" value="a.ply"/><boolean name="face_normals" value="true"/></shape>
            <shape type="serialized"><string name="filename" value="a.serialized"/><integer name="shape_index" value="2"/></shape>
            """).Shapes;
        Assert.Equal(
            [("a.obj", true, MeshShading.Smooth, -1), ("a.ply", false, MeshShading.Flat, -1), ("a.serialized", false, MeshShading.Smooth, 2)],
            shapes.Cast<MeshDescription>().Select(m => (m.File, m.FlipV, m.Shading, m.Part)));
    }

    [Theory]
    [InlineData("""<bsdf type="plastic"/>""", typeof(PlasticMaterialDescription), true)]
    [InlineData("""<bsdf type="roughplastic"><float name="alpha" value="0.3"/></bsdf>""", typeof(RoughPlasticMaterialDescription), true)]
    [InlineData("""<bsdf type="conductor"/>""", typeof(ConductorMaterialDescription), true)]
    [InlineData("""<bsdf type="roughconductor"/>""", typeof(RoughConductorMaterialDescription), true)]
    [InlineData("""<bsdf type="dielectric"/>""", typeof(DielectricMaterialDescription), false)]
    [InlineData("""<bsdf type="thindielectric"/>""", typeof(ThinDielectricMaterialDescription), false)]
    [InlineData("""<bsdf type="roughdielectric"/>""", typeof(RoughDielectricMaterialDescription), false)]
    [InlineData("""<bsdf type="mask"><float name="opacity" value="0.3"/><bsdf type="dielectric"/></bsdf>""", typeof(MaskMaterialDescription), false)]
    [InlineData("""<bsdf type="null"/>""", typeof(MaskMaterialDescription), false)]
    [InlineData("""<bsdf type="blendbsdf"><float name="weight" value="0.3"/><bsdf type="diffuse"/><bsdf type="conductor"/></bsdf>""", typeof(MixMaterialDescription), false)]
    public void What_reflects_does_so_on_one_side_unless_two_are_asked_for(string bsdf, Type type, bool isOneSided)
    {
        MaterialDescription one = Material($"{bsdf}");
        Assert.Equal(isOneSided ? typeof(OneSidedMaterialDescription) : type, one.GetType());
        Assert.Equal(type, (isOneSided ? ((OneSidedMaterialDescription)one).Material : one).GetType());
        Assert.Equal(type, Material($"""<bsdf type="twosided">{bsdf}</bsdf>""").GetType());
    }

    [Fact]
    public void Two_sides_may_differ()
    {
        var sides = (TwoSidedMaterialDescription)Material("""<bsdf type="twosided"><bsdf type="diffuse"/><bsdf type="conductor"/></bsdf>""");
        Assert.IsType<DiffuseMaterialDescription>(sides.Front);
        Assert.IsType<ConductorMaterialDescription>(sides.Back);
    }

    [Fact]
    public void Refractive_indices_are_relative_and_have_names()
    {
        Assert.Equal(1.5046f / 1.000277f, ((DielectricMaterialDescription)Material("""<bsdf type="dielectric"/>""")).RefractiveIndex);
        Assert.Equal(2.419f / 1.333f, ((DielectricMaterialDescription)Material("""<bsdf type="dielectric"><string name="int_ior" value="diamond"/><string name="ext_ior" value="water"/></bsdf>""")).RefractiveIndex);
    }

    [Fact]
    public void Roughness_is_beckmanns_unless_stated_and_may_differ_along_u_and_v()
    {
        var metal = (RoughConductorMaterialDescription)Material("""
            <bsdf type="twosided"><bsdf type="roughconductor"><rgb name="eta" value="0.2, 0.9, 1.1"/><rgb name="k" value="3.9 2.4 2.2"/>
            <float name="alpha_u" value="0.3"/><float name="alpha_v" value="0.05"/></bsdf></bsdf>
            """);
        Assert.Equal(MicrofacetDistribution.Beckmann, metal.Distribution);
        Assert.Equal((new Rgb(0.2f, 0.9f, 1.1f), new Rgb(3.9f, 2.4f, 2.2f)), (metal.Eta!.Value, metal.K!.Value));
        Assert.Equal((new(0.3f, 0.3f, 0.3f), new Rgb(0.05f, 0.05f, 0.05f)), (((SolidTextureDescription)metal.AlphaU!).Color, ((SolidTextureDescription)metal.AlphaV!).Color));
    }

    [Fact]
    public void Maps_of_uv_scale_turn_and_move_before_the_texture_is_looked_up()
    {
        (float u, float v) = (0.3f, 0.2f);
        const string Steps = """<scale x="3" y="2"/><rotate z="1" angle="30"/><translate x="0.25" y="0.1"/>""";
        double c = Math.Cos(Math.PI / 6);
        double s = Math.Sin(Math.PI / 6);
        AssertLookedUp(Steps, u, v, (c * 3 * u) - (s * 2 * v) + 0.25, (s * 3 * u) + (c * 2 * v) + 0.1);
        AssertLookedUp("""<rotate z="1" angle="30"/><scale x="3" y="-2"/>""", u, v, 3 * ((c * u) - (s * v)), -2 * ((s * u) + (c * v)));
        AssertLookedUp("""<scale x="3" y="2"/><translate x="0.25" y="0.1"/>""", u, v, (3 * u) + 0.25, (2 * v) + 0.1);
    }

    [Fact]
    public void Lights_without_extent_are_placed_by_their_transforms()
    {
        IReadOnlyList<ShapeDescription> lights = TestScene.Of("""
            <emitter type="point"><point name="position" x="1" y="2" z="3"/><rgb name="intensity" value="1, 2, 3"/></emitter>
            <emitter type="spot"><transform name="to_world"><lookat origin="0, 5, 0" target="0, 0, 0" up="1, 0, 0"/></transform><float name="cutoff_angle" value="40"/></emitter>
            <emitter type="directional"><vector name="direction" x="0" y="-1" z="0"/><float name="irradiance" value="2"/></emitter>
            """).Lights;
        Assert.Equal(new PointLightDescription { Position = new(1, 2, 3), Intensity = new(1, 2, 3) }, lights[0] with { Transform = lights[0].Transform });
        SpotLightDescription spot = (SpotLightDescription)lights[1];
        Assert.Equal((new(0, 5, 0), -Vector3.UnitY, 40, 30f), (spot.Position, spot.Direction, spot.CutoffAngle, spot.BeamWidth!.Value));
        Assert.Equal(new Rgb(2, 2, 2), ((DirectionalLightDescription)lights[2]).Irradiance);
    }

    [Fact]
    public void Shining_shapes_reflect_by_their_bsdf_and_are_black_without_one()
    {
        IReadOnlyList<ShapeDescription> shapes = TestScene.Of("""
            <shape type="sphere"><emitter type="area"><rgb name="radiance" value="5"/></emitter></shape>
            <shape type="sphere"><emitter type="area"/><bsdf type="diffuse"/></shape>
            """).Shapes;
        LuminaireMaterialDescription black = (LuminaireMaterialDescription)shapes[0].Material;
        Assert.Equal(new Rgb(5, 5, 5), ((SolidTextureDescription)black.Color).Color);
        Assert.True(((SolidTextureDescription)((DiffuseMaterialDescription)black.Material).Color).Color.IsBlack);
        Assert.IsType<OneSidedMaterialDescription>(((LuminaireMaterialDescription)shapes[1].Material).Material);
    }

    // What Mitsuba 3.9.1 makes of these spectra in its mode "rgb".
    [Theory]
    [InlineData("<spectrum name=\"reflectance\" value=\"0.25\"/>", 0.25f, 0.25f, 0.25f)]
    [InlineData("<spectrum name=\"reflectance\" value=\"360:0.5, 830:0.5\"/>", 0.5f, 0.5f, 0.5f)]
    [InlineData("<spectrum name=\"reflectance\" value=\"400:0.1, 500:0.2, 600:0.7, 700:0.9\"/>", 0.856f, 0.404f, 0.1124f)]
    [InlineData("<spectrum name=\"reflectance\" type=\"irregular\"><string name=\"wavelengths\" value=\"400, 500, 600, 700\"/><string name=\"values\" value=\"0.1, 0.2, 0.7, 0.9\"/></spectrum>", 0.856f, 0.404f, 0.1124f)]
    [InlineData("<rgb name=\"reflectance\" value=\"#ff8000\"/>", 1f, 128 / 255f, 0f)]
    public void Spectra_are_the_colours_that_they_are_by_daylight(string reflectance, float r, float g, float b)
    {
        var matt = (DiffuseMaterialDescription)Material($"""<bsdf type="twosided"><bsdf type="diffuse">{reflectance}</bsdf></bsdf>""");
        AssertColor(new(r, g, b), ((SolidTextureDescription)matt.Color).Color, 0.0015);
    }

    [Theory]
    [InlineData("<spectrum name=\"radiance\" value=\"0.5\"/>", 0.602397f, 0.474146f, 0.454458f)]
    [InlineData("<spectrum name=\"radiance\" value=\"400:0.1, 500:0.2, 600:0.7, 700:0.9\"/>", 0.98816f, 0.387351f, 0.0956021f)]
    [InlineData("<spectrum name=\"radiance\" type=\"d65\"><float name=\"scale\" value=\"2\"/></spectrum>", 2, 2, 2)]
    public void Spectra_of_light_are_its_colour(string radiance, float r, float g, float b) =>
        AssertColor(new(r, g, b), TestScene.Of($"""<emitter type="constant">{radiance}</emitter>""").Background, 0.001);

    private static void AssertColor(Rgb expected, Rgb found, double tolerance)
    {
        Assert.Equal(expected.R, found.R, tolerance);
        Assert.Equal(expected.G, found.G, tolerance);
        Assert.Equal(expected.B, found.B, tolerance);
    }

    private static MaterialDescription Material(string bsdf) => Assert.Single(TestScene.Of($"""<shape type="sphere">{bsdf}</shape>""").Shapes).Material;

    // Of a picture whose colour gives the position in it.
    private static void AssertLookedUp(string steps, float u, float v, double mappedU, double mappedV)
    {
        var side = (OneSidedMaterialDescription)Material($"""
            <bsdf type="diffuse"><texture type="bitmap" name="reflectance"><string name="filename" value="x.png"/><transform name="to_uv">{steps}</transform></texture></bsdf>
            """);
        Texture texture = ((DiffuseMaterialDescription)side.Material).Color.Build(new SceneBuilder((_, _) => Ramp()));
        texture.Evaluate(u, v, out RgbW color);
        Assert.Equal(mappedU - Math.Floor(mappedU), color.R[0], 0.002);
        Assert.Equal(mappedV - Math.Floor(mappedV), color.G[0], 0.002);
    }

    // 1024 texels a side; the first row is at v = 0 in the other renderer's uv.
    private static Picture Ramp()
    {
        const int Side = 1024;
        Picture picture = new(Side, Side);
        for (int i = 0; i < Side * Side; i++)
        {
            picture.Pixels[3 * i] = ((i % Side) + 0.5f) / Side;
            picture.Pixels[(3 * i) + 1] = ((i / Side) + 0.5f) / Side;
        }

        return picture;
    }

    // What Mitsuba 3.9.1 renders in its spectral mode, whose noise is a few in a thousand; it refuses black bodies in RGB.
    [Theory]
    [InlineData(2500, 159.5, 59.35, 10.77)]
    [InlineData(4000, 4902, 3204, 1850)]
    [InlineData(6500, 43964, 41448, 43625)]
    public void Black_bodies_shine_by_their_temperature(int temperature, double red, double green, double blue)
    {
        SceneDescription scene = TestScene.Of($"""<emitter type="constant"><spectrum name="radiance" type="blackbody"><float name="temperature" value="{temperature}"/></spectrum></emitter>""");
        Assert.Equal(1, scene.Background.R / red, 0.02);
        Assert.Equal(1, scene.Background.G / green, 0.02);
        Assert.Equal(1, scene.Background.B / blue, 0.03);
    }

    [Fact]
    public void Colours_of_corners_are_textures_of_their_meshes_alone()
    {
        using TestScene scene = new();
        File.WriteAllText(scene["c.ply"], """
            ply
            format ascii 1.0
            element vertex 3
            property float x
            property float y
            property float z
            property float color_0
            property float color_1
            property float color_2
            element face 1
            property list uchar int vertex_indices
            end_header
            0 0 0 0.2 0.5 0.9
            1 0 0 0.2 0.5 0.9
            0 1 0 0.2 0.5 0.9
            3 0 1 2

            """);
        string path = scene.Write("scene.xml", """
            <shape type="ply"><string name="filename" value="c.ply"/><bsdf type="diffuse"><texture name="reflectance" type="mesh_attribute"><string name="name" value="vertex_color"/></texture></bsdf></shape>
            <shape type="ply"><string name="filename" value="c.ply"/></shape>
            """);
        SceneReadResult read = MitsubaReader.Read(path);
        Assert.Equal("", Diagnostic.Format([.. read.Diagnostics]));
        Assert.Equal([false, true], read.Description!.Shapes.Select(s => ((MeshDescription)s).IgnoreColors));
        MeshDescription file = Assert.IsType<MeshDescription>(Assert.Single(ModelFile.Read(scene["c.ply"]).Scene.Shapes));
        Assert.Equal(new Rgb(0.2f, 0.5f, 0.9f), file.Data!.Colors![1]);
    }

    [Theory]
    [InlineData("""<shape type="shapegroup" id="a"><shape type="shapegroup"><shape type="sphere"/></shape></shape>""", "a shapegroup cannot hold another one")]
    [InlineData("""<shape type="sphere"><bsdf type="diffuse"><texture name="reflectance" type="mesh_attribute"><string name="name" value="heat"/></texture></bsdf></shape>""", "the name of a mesh's attribute begins with vertex_ or face_, as in \"vertex_color\"")]
    public void What_is_not_read_is_said(string things, string message) => Assert.Equal(message, TestScene.Complaint(things));
}
