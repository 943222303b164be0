using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Import.Tests;

/// <summary>Nodes, cameras and lights of glTF files, and what is made up where there are none.</summary>
public class GltfSceneTests
{
    [Fact]
    public void A_node_is_scaled_then_turned_then_moved_within_its_parent()
    {
        TestGltf file = TestGltf.Triangle();
        file.Json["nodes"]![0]!["scale"] = Array(2, 3, 4);
        file.Json["nodes"]![0]!["rotation"] = Array(0, 0, float.Sqrt(0.5f), float.Sqrt(0.5f));
        file.Json["nodes"]![0]!["translation"] = Array(10, 0, 0);
        file.Add("nodes", """{ "children": [0], "matrix": [0,0,1,0, 1,0,0,0, 0,1,0,0, 100,200,300,1] }""");
        file.Add("scenes", """{ "nodes": [1] }""");

        // Child: (x, y, z) → (−3y + 10, 2x, 4z); parent: (x, y, z) → (y + 100, z + 200, x + 300).
        float[] expected = [2, 0, 0, 100, 0, 0, 4, 200, 0, -3, 0, 310];
        IReadOnlyList<float> actual = file.ImportMesh().Transform.Single().Matrix;
        Assert.Equal(12, actual.Count);
        Assert.All(expected.Zip(actual), p => Assert.Equal(p.First, p.Second, 1e-5f));
    }

    [Fact]
    public void A_mesh_that_many_nodes_show_is_shared()
    {
        TestGltf file = TestGltf.Triangle();
        file.Add("nodes", """{ "mesh": 0, "translation": [1, 0, 0] }""");
        SceneDescription scene = file.Import().Scene;
        ShapeDescription shared = Assert.Single(scene.Objects).Value;
        Assert.Equal(2, scene.Shapes.Count);
        Assert.All(scene.Shapes, s => Assert.Same(shared, Assert.IsType<InstanceDescription>(s).Of));
        Assert.Equal(1, scene.Shapes[1].Transform.Single().Matrix[3]);
    }

    [Fact]
    public void Only_the_nodes_of_the_chosen_scene_are_shown()
    {
        TestGltf file = TestGltf.Triangle();
        file.Add("nodes", """{ "name": "second", "mesh": 0 }""");
        file.Add("scenes", """{ "nodes": [0] }""");
        file.Add("scenes", """{ "nodes": [1] }""");
        file.Json["scene"] = 1;
        Assert.Equal("second", file.ImportMesh().Name);
    }

    [Fact]
    public void A_node_that_flattens_its_mesh_is_left_out()
    {
        TestGltf file = TestGltf.Triangle();
        file.Json["nodes"]![0]!["scale"] = Array(1, 0, 1);
        Assert.Empty(file.Import().Scene.Shapes);
        Assert.Contains(file.Import().Notes, n => n.Contains("scaled to nothing", StringComparison.Ordinal));
    }

    [Fact]
    public void A_camera_looks_along_its_nodes_negative_z()
    {
        TestGltf file = TestGltf.Triangle();
        file.Add("cameras", """{ "type": "perspective", "perspective": { "yfov": 0.5, "aspectRatio": 1.5, "znear": 0.1 } }""");
        file.Add("nodes", """{ "camera": 0, "translation": [1, 2, 3], "rotation": [0, 0.70710678, 0, 0.70710678] }""");
        ImportedModel model = file.Import();
        CameraDescription camera = model.Camera!;
        Assert.Equal(new Vector3(1, 2, 3), camera.Position);
        Vector3 direction = (camera.LookAt - camera.Position).Unit();
        Assert.Equal(-1, direction.X, 1e-5f);
        Assert.Equal(0, direction.Z, 1e-5f);
        Assert.Equal(1, camera.Up.Y, 1e-5f);
        Assert.Equal(0.5f * 180 / float.Pi, camera.FieldOfView, 1e-4f);
        Assert.Equal((900, 600), (model.Scene.Render.Width, model.Scene.Render.Height));
    }

    [Fact]
    public void An_orthographic_camera_shows_twice_its_magnifications()
    {
        TestGltf file = TestGltf.Triangle();
        file.Add("cameras", """{ "type": "orthographic", "orthographic": { "xmag": 3, "ymag": 1.5, "zfar": 9, "znear": 0.1 } }""");
        file.Add("nodes", """{ "camera": 0, "translation": [1, 2, 3] }""");
        ImportedModel model = file.Import();
        CameraDescription camera = model.Camera!;
        Assert.Equal((Projection.Orthographic, 3f, FieldOfViewAxis.Vertical), (camera.Projection, camera.ViewSize, camera.FieldOfViewAxis));
        Assert.Equal((new Vector3(1, 2, 3), -1f), (camera.Position, (camera.LookAt - camera.Position).Unit().Z));
        Assert.Equal((1200, 600), (model.Scene.Render.Width, model.Scene.Render.Height));
    }

    [Fact]
    public void A_point_light_is_one_of_the_same_intensity()
    {
        var light = Assert.IsType<PointLightDescription>(Light("""{ "type": "point", "color": [1, 0.5, 0.25], "intensity": 20 }"""));
        Assert.Equal((new Vector3(0, 5, 0), new Rgb(20, 10, 5)), (light.Position, light.Intensity));
    }

    [Theory]
    [InlineData(0, 0.785398f)]
    [InlineData(0.3f, 0.4f)]
    [InlineData(0.2f, 1.570796f)]
    public void A_spot_light_has_its_intensity_cone_and_falloff(float inner, float outer)
    {
        var light = Assert.IsType<SpotLightDescription>(Light($$"""{ "type": "spot", "intensity": 20, "spot": { "innerConeAngle": {{inner}}, "outerConeAngle": {{outer}} } }"""));
        Assert.Equal((new Vector3(0, 5, 0), new Rgb(20, 20, 20), SpotFalloff.Smooth), (light.Position, light.Intensity, light.Falloff));
        Assert.Equal(-1, light.Direction.Y, 1e-5f);
        Assert.Equal(inner * 180 / Math.PI, light.BeamWidth!.Value, 1e-3);
        Assert.Equal(outer * 180 / Math.PI, light.CutoffAngle, 1e-3);
    }

    [Fact]
    public void A_directional_light_has_its_direction_and_irradiance()
    {
        var light = Assert.IsType<DirectionalLightDescription>(Light("""{ "type": "directional", "intensity": 3 }"""));
        Assert.Equal(new Rgb(3, 3, 3), light.Irradiance);
        Assert.Equal(-1, light.Direction.Y, 1e-5f);
    }

    [Fact]
    public void Lights_of_a_file_light_what_it_shows()
    {
        foreach (string type in new[] { "point", "spot", "directional" })
        {
            SceneBuilder builder = new((_, _) => throw new NotSupportedException());
            Assert.Single(builder.Build(new() { Lights = [Light($$"""{ "type": "{{type}}" }""")] })!.Lights);
            Assert.Empty(builder.Complaints);
        }
    }

    [Fact]
    public void Without_camera_and_light_both_are_made_up_and_said()
    {
        ImportedModel model = DefaultView.Complete(TestGltf.Triangle().Import());
        Assert.StartsWith("the file has no camera and no light", Assert.Single(model.Notes), StringComparison.Ordinal);
        Assert.Equal(new Vector3(0.5f, 0.5f, 0), model.Scene.Camera.LookAt);
        Assert.Single(model.Scene.Lights);
        Assert.False(model.Scene.Background.IsBlack);
        Assert.Equal((1, Exposure.Auto), (model.Scene.Shapes.Count(s => s is PlaneDescription), model.Scene.Render.Exposure));
    }

    [Theory]
    [InlineData(0, 1, 0)]
    [InlineData(0, 0, 1)]
    [InlineData(-1, 0, 0)]
    public void A_model_fills_the_picture_and_stands_on_a_ground_whatever_axis_is_up(float x, float y, float z)
    {
        Vector3 up = new(x, y, z);
        BoxDescription box = new() { A = new(-1, 3, 2), B = new(4, 4, 9) };
        ImportedModel model = DefaultView.Complete(new(new() { Shapes = [box] }, []), up);
        CameraDescription camera = model.Scene.Camera;
        Vector3 forward = Vector3.Normalize(camera.LookAt - camera.Position);
        Vector3 right = Vector3.Normalize(Vector3.Cross(forward, camera.Up));
        Vector3 above = Vector3.Cross(right, forward);
        double slope = Math.Tan(camera.FieldOfView * Math.PI / 360);
        double[] places = [.. Enumerable.Range(0, 8).Select(i =>
        {
            Vector3 to = new Vector3((i & 1) == 0 ? -1 : 4, (i & 2) == 0 ? 3 : 4, (i & 4) == 0 ? 2 : 9) - camera.Position;
            return Math.Max(Math.Abs(Vector3.Dot(to, right)), Math.Abs(Vector3.Dot(to, above))) / Vector3.Dot(to, forward) / slope;
        })];
        Assert.Equal(0.9, places.Max(), 1e-3);
        Assert.Equal((up, true), (camera.Up, Vector3.Dot(camera.Position - camera.LookAt, up) > 0));
        PlaneDescription ground = Assert.IsType<PlaneDescription>(model.Scene.Shapes[^1]);
        Assert.Equal(up, ground.Normal);
        double lowest = Math.Min(Vector3.Dot(box.A, up), Vector3.Dot(box.B, up));
        Assert.InRange(lowest - Vector3.Dot(ground.Point, up), 1e-5, 0.01);
    }

    [Fact]
    public void The_camera_of_the_file_is_kept_and_a_glowing_material_is_no_light()
    {
        TestGltf file = TestGltf.Triangle("""{ "emissiveFactor": [1, 1, 1], "extensions": { "KHR_materials_emissive_strength": { "emissiveStrength": 5 } } }""");
        file.Add("cameras", """{ "type": "perspective", "perspective": { "yfov": 0.5, "znear": 0.1 } }""");
        file.Add("nodes", """{ "camera": 0, "translation": [0, 0, 9] }""");
        ImportedModel model = DefaultView.Complete(file.Import());
        Assert.Equal(9, model.Scene.Camera.Position.Z);
        Assert.Single(model.Scene.Lights);
        Assert.False(model.Scene.Background.IsBlack);
        Assert.StartsWith("the file has no light", Assert.Single(model.Notes), StringComparison.Ordinal);
        Assert.DoesNotContain(model.Scene.Shapes, s => s is PlaneDescription);
    }

    [Fact]
    public void The_made_up_view_sees_instances_and_groups_where_they_stand()
    {
        TestGltf file = TestGltf.Triangle();
        file.Json["nodes"]![0]!["translation"] = Array(10, 0, 0);
        file.Add("nodes", """{ "mesh": 0, "translation": [-10, 0, 0] }""");
        Assert.Equal(new Vector3(0.5f, 0.5f, 0), DefaultView.Complete(file.Import()).Scene.Camera.LookAt);
    }

    private static ShapeDescription Light(string light)
    {
        // Shines downwards from y = 5 onto the triangle.
        TestGltf file = TestGltf.Triangle();
        file.Add("nodes", """{ "translation": [0, 5, 0], "rotation": [-0.70710678, 0, 0, 0.70710678], "extensions": { "KHR_lights_punctual": { "light": 0 } } }""");
        file.Json["extensions"] = System.Text.Json.Nodes.JsonNode.Parse($$"""{ "KHR_lights_punctual": { "lights": [{{light}}] } }""");
        return Assert.Single(file.Import().Scene.Lights);
    }

    private static System.Text.Json.Nodes.JsonArray Array(params float[] numbers) => [.. numbers.Select(n => (System.Text.Json.Nodes.JsonNode)n)];
}
