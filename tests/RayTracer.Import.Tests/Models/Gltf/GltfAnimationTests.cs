using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Import.Tests;

/// <summary>What moves in glTF files: nodes, joints and morph targets; and meshes that a node shows at many places.</summary>
public class GltfAnimationTests
{
    private const float Half = 0.70710678f;
    private static readonly float[] s_still = [0, 0, 0, 1];

    [Theory]
    [InlineData("LINEAR", 0.25, 1)]
    [InlineData("LINEAR", 1.5, 5)]
    [InlineData("LINEAR", 9, 6)]
    [InlineData("STEP", 0.9999, 0)]
    [InlineData("STEP", 1, 4)]
    [InlineData("STEP", 2, 6)]
    public void A_node_is_where_its_keys_put_it(string interpolation, double time, float expected)
    {
        TestGltf file = TestGltf.Triangle();
        Animate(file, 0, "translation", "VEC3", [0, 1, 2], [0, 7, 0, 4, 7, 0, 6, 7, 0], interpolation);
        IReadOnlyList<float> matrix = Assert.Single(At(file.Import(), time).Shapes).Transform.Single().Matrix;
        Assert.Equal((expected, 7f), (matrix[3], matrix[7]));
    }

    [Fact]
    public void Splines_have_the_tangents_of_their_keys()
    {
        TestGltf file = TestGltf.Triangle();

        // x = t³ from 1 to 3: derivatives 3 and 27. Before and after them there are tangents that do not count.
        Animate(file, 0, "translation", "VEC3", [1, 3], [99, 0, 0, 1, 0, 0, 3, 0, 0, 27, 0, 0, 27, 0, 0, 99, 0, 0], "CUBICSPLINE");
        foreach (float t in (float[])[1, 1.5f, 2.25f, 3])
        {
            Assert.Equal(t * t * t, At(file.Import(), t).Shapes[0].Transform.Single().Matrix[3], 1e-4f);
        }
    }

    [Theory]
    [InlineData(1)]
    [InlineData(-1)]
    public void Rotations_turn_at_constant_speed_the_shorter_way(int sign)
    {
        TestGltf file = TestGltf.Triangle();
        Animate(file, 0, "rotation", "VEC4", [0, 1], [0, 0, 0, 1, 0, 0, sign * Half, sign * Half], "LINEAR");
        IReadOnlyList<float> matrix = At(file.Import(), 1 / 3.0).Shapes[0].Transform.Single().Matrix;
        Assert.Equal(Math.Cos(Math.PI / 6), matrix[0], 1e-6);
        Assert.Equal(Math.Sin(Math.PI / 6), matrix[4], 1e-6);
    }

    [Fact]
    public void What_moves_while_the_shutter_is_open_has_keyframes_of_the_scenes_time()
    {
        TestGltf file = TestGltf.Triangle();
        Animate(file, 0, "translation", "VEC3", [0, 10], [0, 0, 0, 20, 0, 0], "LINEAR");
        file.Add("nodes", """{ "mesh": 0, "translation": [0, 5, 0] }""");
        SceneDescription scene = file.Import().At!(new(0, null, 1, 1.5, new PlaybackDescription { Start = 2, Speed = -1 }.AtLength(10)));
        ShapeDescription moving = scene.Shapes[0];
        Assert.Equal((1f, 1.5f, 0), (moving.Motion[0].Time, moving.Motion[^1].Time, moving.Transform.Count));
        Assert.Equal([2, 1.5f, 1], ((int[])[0, 4, 8]).Select(i => moving.Motion[i].Transform.Single().Matrix[3]));
        Assert.Empty(scene.Shapes[1].Motion);
    }

    [Fact]
    public void Playback_has_a_start_a_speed_and_an_end_or_begins_again()
    {
        Assert.Equal([0, 1, 3], ((double[])[0, 2, 9]).Select(new PlaybackDescription { Speed = 0.5f }.AtLength(3)));
        Assert.Equal([1, 2, 0.5], ((double[])[0, 1, 2.5]).Select(new PlaybackDescription { Start = 1, Repeat = true }.AtLength(3)));
        Assert.Equal([2.5, 2.5], ((double[])[0, 50]).Select(new PlaybackDescription { Start = 2.5f, Speed = 0 }.AtLength(3)));
        Assert.Equal(2, new PlaybackDescription { Speed = -1, Repeat = true }.TimeAt(1, 3));
    }

    [Fact]
    public void Frames_show_the_animation_that_is_named_at_their_time()
    {
        using TemporaryFolder folder = new();
        TestGltf file = TestGltf.Triangle();
        Animate(file, 0, "translation", "VEC3", [0, 2], [0, 0, 0, 4, 0, 0], "LINEAR");
        Animate(file, 0, "translation", "VEC3", [0, 2], [0, 0, 0, 0, 4, 0], "LINEAR");
        file.Json["animations"]![1]!["name"] = "rise";
        File.WriteAllBytes(folder["model.gltf"], file.ToGltf());
        File.WriteAllText(folder["scene.json"], """{ "shapes": [{ "type": "model", "file": "model.gltf", "playback": { "animation": "rise", "speed": 2 } }], "background": 1 }""");
        Assert.Equal(new Vector3(1, 0, 0), Corner(folder["model.gltf"], 12));
        Assert.Equal(new Vector3(0, 2, 0), Corner(folder["scene.json"], 12));
        Assert.Equal(new Vector3(0, 4, 0), Corner(folder["scene.json"], 240));
        Assert.Equal(Vector3.Zero, Corner(folder["scene.json"], null));

        File.WriteAllText(folder["scene.json"], File.ReadAllText(folder["scene.json"]).Replace("rise", "rose", StringComparison.Ordinal));
        Diagnostic error = Assert.Single(SceneLoader.Load(folder["scene.json"]).Diagnostics, d => d.Severity == Severity.Error);
        Assert.Equal("there is no animation \"rose\" in the file: it has \"\", \"rise\" (did you mean \"rise\"?)", error.Message);
        Assert.Equal((1, 82), (error.Line, error.Column));
    }

    [Fact]
    public void Joints_put_a_skin_into_the_world_whatever_its_node_says()
    {
        TestGltf file = Skinned();
        SceneDescription scene = At(file.Import(), 1);
        MeshDescription mesh = Assert.IsType<MeshDescription>(Assert.Single(scene.Shapes));
        Assert.Empty(mesh.Transform);

        // The second joint, at (1, 0, 0), is turned a quarter about z: what is beside it goes up.
        Vector3[] expected = [new(0, 0, 0), new(1, 1, 0), new(1.25f, 0.25f, 0)];
        Assert.All(expected.Zip(mesh.Data!.Positions), p => Assert.Equal(0, (p.First - p.Second).Norm(), 1e-6f));
        Vector3[] normals = [new(0, 1, 0), new(-1, 0, 0), new Vector3(-1, 1, 0).Unit()];
        Assert.All(normals.Zip(mesh.Data.Normals!), p => Assert.Equal(0, (p.First - p.Second).Norm(), 1e-6f));
        Assert.Equal([new(0, 0, 0), new(2, 0, 0), new(1.5f, 0, 0)], ((MeshDescription)file.Import().Scene.Shapes[0]).Data!.Positions);
    }

    [Fact]
    public void Morph_targets_add_by_the_weights_of_key_node_or_mesh()
    {
        TestGltf file = TestGltf.Triangle();
        int moves = file.Accessor(5126, "VEC3", 3, TestGltf.Floats(0, 0, 1, 0, 0, 2, 0, 0, 4));
        int others = file.Accessor(5126, "VEC3", 3, TestGltf.Floats(1, 0, 0, 1, 0, 0, 1, 0, 0));
        file.Json["meshes"]![0]!["primitives"]![0]!["targets"] = Json($$"""[{ "POSITION": {{moves}} }, { "POSITION": {{others}} }]""");
        Assert.Equal(new Vector3(1, 0, 0), Positions(file.Import().Scene)[1]);
        file.Json["meshes"]![0]!["weights"] = Json("[0.5, 0]");
        Assert.Equal(new Vector3(1, 0, 1), Positions(file.Import().Scene)[1]);
        file.Json["nodes"]![0]!["weights"] = Json("[0, 3]");
        Assert.Equal(new Vector3(4, 0, 0), Positions(file.Import().Scene)[1]);
        Animate(file, 0, "weights", "SCALAR", [0, 1], [0, 0, 1, 2], "LINEAR");
        Assert.Equal([new(1, 0, 0.5f), new(2, 0, 1), new(1, 1, 2)], Positions(At(file.Import(), 0.5)));
    }

    [Fact]
    public void Instances_share_one_mesh()
    {
        TestGltf file = TestGltf.Triangle();
        int places = file.Accessor(5126, "VEC3", 2, TestGltf.Floats(1, 0, 0, 0, 2, 0));
        int turns = file.Accessor(5120, "VEC4", 2, [0, 0, 0, 127, 0, 127, 0, 0], ", \"normalized\": true");
        file.Json["nodes"]![0]!["translation"] = Json("[10, 0, 0]");
        file.Json["nodes"]![0]!["extensions"] = Json($$"""{ "EXT_mesh_gpu_instancing": { "attributes": { "TRANSLATION": {{places}}, "ROTATION": {{turns}} } } }""");
        file.Json["extensionsRequired"] = Json("""["EXT_mesh_gpu_instancing"]""");
        SceneDescription scene = file.Import().Scene;
        Assert.Single(scene.Objects);
        Assert.Equal([11, 10], scene.Shapes.Select(s => s.Transform.Single().Matrix[3]));
        Assert.Equal([1, -1], scene.Shapes.Select(s => s.Transform.Single().Matrix[0]));
        Assert.Equal(2, scene.Shapes.Count(s => s is InstanceDescription));
    }

    [Fact]
    public void Cameras_and_lights_move_with_their_nodes()
    {
        TestGltf file = TestGltf.Triangle();
        file.Add("cameras", """{ "type": "perspective", "perspective": { "yfov": 0.5, "znear": 0.1 } }""");
        file.Json["extensions"] = Json("""{ "KHR_lights_punctual": { "lights": [{ "type": "point", "intensity": 20 }] } }""");
        file.Add("nodes", """{ "camera": 0, "scale": [3, 3, 3], "extensions": { "KHR_lights_punctual": { "light": 0 } } }""");
        Animate(file, 1, "translation", "VEC3", [0, 1, 4], [0, 0, 5, 2, 0, 5, 2, 6, 5], "LINEAR");
        ImportedModel model = file.Import();
        CameraDescription camera = model.Camera!;
        Assert.Equal([0, 1, 4], camera.Motion.Select(k => k.Time));
        Assert.Equal([new(0, 0, 5), new(2, 0, 5), new(2, 6, 5)], camera.Motion.Select(k => new Vector3(k.Transform[0].Matrix[3], k.Transform[0].Matrix[7], k.Transform[0].Matrix[11])));
        Assert.Equal((Vector3.Zero, -Vector3.UnitZ, 1f), (camera.Position, camera.LookAt, camera.Motion[0].Transform[0].Matrix[0]));
        Assert.Equal(new Vector3(2, 4, 5), ((PointLightDescription)Assert.Single(At(model, 3).Lights)).Position);
        Assert.Equal(9, Assert.Single(model.At!(new(0, null, 0, 1, t => t)).Lights).Motion.Count);
    }

    [Theory]
    [InlineData("samplers", "[{ \"input\": 2, \"output\": 2 }]", "samplers[0].output: its accessor has 1 numbers an element, but 3 are needed")]
    [InlineData("samplers", "[{ \"input\": 3, \"output\": 3 }]", "its accessor has 3 numbers an element, but 1 are needed")]
    [InlineData("samplers", "[{ \"input\": 2, \"output\": 3, \"interpolation\": \"CUBIC\" }]", "expected \"LINEAR\", \"STEP\" or \"CUBICSPLINE\"")]
    [InlineData("samplers", "[{ \"input\": 2, \"output\": 3, \"interpolation\": \"CUBICSPLINE\" }]", "it has 2 elements, which does not go with 2 keys")]
    [InlineData("samplers", "[]", "there is no sampler 0: the animation has 0")]
    [InlineData("channels", "[{ \"sampler\": 0, \"target\": { \"node\": 0, \"path\": \"translations\" } }]", "\"translations\" is not one of translation, rotation, scale, weights")]
    [InlineData("channels", "[{ \"sampler\": 0, \"target\": { \"node\": 7, \"path\": \"scale\" } }]", "there is no nodes[7]")]
    public void Wrong_animations_are_refused(string key, string json, string message)
    {
        TestGltf file = TestGltf.Triangle();
        Animate(file, 0, "translation", "VEC3", [0, 2], [0, 0, 0, 4, 0, 0], "LINEAR");
        file.Json["animations"]![0]![key] = Json(json);
        Assert.Contains(message, file.Complaint(), StringComparison.Ordinal);
    }

    [Fact]
    public void Keys_out_of_order_are_refused()
    {
        TestGltf file = TestGltf.Triangle();
        Animate(file, 0, "translation", "VEC3", [1, 1], [0, 0, 0, 4, 0, 0], "LINEAR");
        Assert.Contains("animations[0].samplers[0]: the times of its keys must be 0 or more, each later", file.Complaint(), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("[9]", "there is no nodes[9]")]
    [InlineData("[]", "a skin needs at least one joint")]
    [InlineData("[1]", "is 1, but there are only 1 joints")]
    [InlineData("[1, 2, 1]", "it has 2 matrices for 3 joints")]
    public void Wrong_skins_are_refused(string joints, string message)
    {
        TestGltf file = Skinned();
        file.Json["skins"]![0]!["joints"] = Json(joints);
        Assert.Contains(message, file.Complaint(), StringComparison.Ordinal);
    }

    [Fact]
    public void A_skin_without_joints_of_its_vertices_or_with_a_joint_of_another_scene_is_refused()
    {
        TestGltf file = Skinned();
        file.Json["scenes"] = Json("""[{ "nodes": [0, 1] }]""");
        file.Json["nodes"]![1]!.AsObject().Remove("children");
        Assert.Contains("nodes[2] is not in the scene that is shown", file.Complaint(), StringComparison.Ordinal);
        file = Skinned();
        file.Json["meshes"]![0]!["primitives"]![0]!["attributes"]!.AsObject().Remove("JOINTS_0");
        Assert.Contains("\"JOINTS_0\" is missing", file.Complaint(), StringComparison.Ordinal);
    }

    [Fact]
    public void Instances_with_lists_of_different_lengths_are_refused()
    {
        TestGltf file = TestGltf.Triangle();
        int places = file.Accessor(5126, "VEC3", 2, TestGltf.Floats(1, 0, 0, 0, 2, 0));
        file.Json["nodes"]![0]!["extensions"] = Json($$"""{ "EXT_mesh_gpu_instancing": { "attributes": { "TRANSLATION": {{places}}, "SCALE": 0 } } }""");
        Assert.Contains("the lists of instances have different lengths: 2, 3", file.Complaint(), StringComparison.Ordinal);
        file.Json["nodes"]![0]!["extensions"] = Json("""{ "EXT_mesh_gpu_instancing": { "attributes": {} } }""");
        Assert.Contains("instances need a TRANSLATION", file.Complaint(), StringComparison.Ordinal);
    }

    [Fact]
    public void What_is_compressed_is_refused_by_name_and_its_textures_are_noted_by_theirs()
    {
        TestGltf file = TestGltf.Triangle();
        file.Add("accessors", """{ "componentType": 5126, "type": "VEC3", "count": 3 }""");
        file.Json["meshes"]![0]!["primitives"]![0] = Json("""{ "attributes": { "POSITION": 2 }, "extensions": { "KHR_draco_mesh_compression": {} } }""");
        Assert.Contains("meshes[0].primitives[0]: it is compressed with KHR_draco_mesh_compression, which is not read", file.Complaint(), StringComparison.Ordinal);
        file = TestGltf.Triangle();
        file.Json["buffers"] = Json("""[{ "byteLength": 99, "extensions": { "EXT_meshopt_compression": { "fallback": true } } }]""");
        Assert.Contains("buffers[0]: it is compressed with EXT_meshopt_compression, which is not read", file.Complaint(), StringComparison.Ordinal);
        foreach (string extension in (string[])["KHR_texture_basisu", "EXT_texture_webp"])
        {
            file = TestGltf.Triangle("""{ "pbrMetallicRoughness": { "baseColorTexture": { "index": 0 } } }""");
            file.Add("textures", $$"""{ "extensions": { "{{extension}}": { "source": 0 } } }""");
            Assert.Contains($"a texture without a PNG or JPEG picture is ignored: {extension} is not read", file.Import().Notes);
            file.Json["extensionsRequired"] = Json($"[\"{extension}\"]");
            Assert.Contains($"the file cannot be shown without \"{extension}\"", file.Complaint(), StringComparison.Ordinal);
        }
    }

    /// <summary>A triangle whose second corner follows a joint that turns, and whose third follows both; the animation is turned at 1 s.</summary>
    internal static TestGltf Skinned()
    {
        TestGltf file = new();
        int positions = file.Accessor(5126, "VEC3", 3, TestGltf.Floats(0, 0, 0, 2, 0, 0, 1.5f, 0, 0));
        int normals = file.Accessor(5126, "VEC3", 3, TestGltf.Floats(0, 1, 0, 0, 1, 0, 0, 1, 0));
        int joints = file.Accessor(5121, "VEC4", 3, [0, 0, 0, 0, 1, 0, 0, 0, 1, 0, 0, 0]);
        int weights = file.Accessor(5121, "VEC4", 3, [255, 0, 0, 0, 255, 0, 0, 0, 100, 100, 0, 0], ", \"normalized\": true");
        int inverses = file.Accessor(5126, "MAT4", 2, TestGltf.Floats([1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 1, 0, 0, 0, 0, 1, 0, 0, 0, 0, 1, 0, -1, 0, 0, 1]));
        file.Mesh($$"""{ "attributes": { "POSITION": {{positions}}, "NORMAL": {{normals}}, "JOINTS_0": {{joints}}, "WEIGHTS_0": {{weights}} } }""", ", \"skin\": 0, \"translation\": [50, 0, 0]");
        file.Add("nodes", """{ "children": [2] }""");
        file.Add("nodes", """{ "translation": [1, 0, 0] }""");
        file.Add("skins", $$"""{ "joints": [1, 2], "inverseBindMatrices": {{inverses}} }""");
        file.Json["scenes"] = Json("""[{ "nodes": [0, 1] }]""");
        Animate(file, 2, "rotation", "VEC4", [0, 1], [.. s_still, 0, 0, Half, Half], "LINEAR");
        return file;
    }

    /// <summary>Adds an animation of one property.</summary>
    internal static void Animate(TestGltf file, int node, string path, string type, float[] times, float[] values, string interpolation)
    {
        int components = type switch { "VEC3" => 3, "VEC4" => 4, _ => 1 };
        int input = file.Accessor(5126, "SCALAR", times.Length, TestGltf.Floats(times));
        int output = file.Accessor(5126, type, values.Length / components, TestGltf.Floats(values));
        file.Add("animations", $$"""
            { "samplers": [{ "input": {{input}}, "output": {{output}}, "interpolation": "{{interpolation}}" }],
              "channels": [{ "sampler": 0, "target": { "node": {{node}}, "path": "{{path}}" } }] }
            """);
    }

    private static SceneDescription At(ImportedModel model, double time) => model.At!(new(0, null, time, time, t => t));

    private static Vector3[] Positions(SceneDescription scene) => ((MeshDescription)scene.Shapes[0]).Data!.Positions;

    private static Vector3 Corner(string path, int? frame) =>
        SceneLoader.Load(path, frame: frame).Scene!.Surfaces().Select(s => s.Bounds).First(b => b.IsFinite && (b.Maximum - b.Minimum).X < 1.5f).Minimum;

    private static System.Text.Json.Nodes.JsonNode Json(string text) => System.Text.Json.Nodes.JsonNode.Parse(text)!;
}

/// <summary>Shortens tests of playback.</summary>
internal static class PlaybackOfLength
{
    public static Func<double, double> AtLength(this PlaybackDescription playback, double length) => time => playback.TimeAt(time, length);
}
