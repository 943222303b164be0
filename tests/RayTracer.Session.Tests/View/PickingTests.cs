using RayTracer.Session;

namespace RayTracer.Session.Tests;

public sealed class PickingTests
{
    private const string Nested = """
        {
          "camera": { "position": [0, 0, 20], "lookAt": [0, 0, 0], "fieldOfView": 40 },
          "render": { "integrator": "report", "width": 200, "height": 100, "samplesPerPixel": 1 },
          "materials": { "red": { "type": "diffuse", "color": "red" } },
          "objects": { "ball": { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": "red" } },
          "shapes": [
            { "type": "group", "material": "red", "shapes": [ { "type": "sphere", "center": [-6, 0, 0], "radius": 1 }, { "type": "box", "a": [-4, -1, -1], "b": [-2, 1, 1] } ] },
            { "type": "instance", "of": "ball", "transform": [ { "scale": [1, 2, 1] } ] },
            { "type": "mesh", "positions": [[2, -1, 0], [4, -1, 0], [3, 1, 0]], "triangles": [[0, 1, 2]] },
            { "type": "torus", "center": [0, 0, 0], "axis": [0, 0, 1], "transform": [ { "scale": [1, 0.5, 1], "translate": [6, 0, 0] } ] }
          ]
        }
        """;

    [Fact]
    public async Task Every_shape_of_the_second_scene_is_found_where_it_is_seen()
    {
        using TestSession test = new();
        ViewportScene shown = await test.OpenShipped("report/scene2.json", 200, 1);
        int seen = 0;
        for (int i = 0; i < shown.Description.Shapes.Count; i++)
        {
            PixelMask mask = Picking.Mask(shown, $"/shapes/{i}");
            foreach (int start in mask.Runs.Where((_, at) => at % 2 == 0).Take(20))
            {
                PickResult pick = Picking.At(shown, start % mask.Width, start / mask.Width);
                Assert.Equal($"/shapes/{i}", pick.Pointer);
                Assert.Equal(shown.PointerOf(shown.Description.Shapes[i].Material), pick.Material);
            }

            seen += mask.Runs.Count > 0 ? 1 : 0;
        }

        Assert.Equal(shown.Description.Shapes.Count, seen);
    }

    [Theory]
    [InlineData(-6, 0, "/shapes/0/shapes/0", "/materials/red")]
    [InlineData(-3, 0, "/shapes/0/shapes/1", "/materials/red")]
    [InlineData(0, 1.5, "/shapes/1", "/materials/red")]
    [InlineData(3, 0, "/shapes/2", null)]
    [InlineData(7, 0, "/shapes/3", null)]
    [InlineData(6, 0.8, null, null)]
    public async Task Things_in_groups_instances_meshes_and_transforms_are_found(double x, double y, string? pointer, string? material)
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Nested);
        double pixelsPerUnit = 100 / (2 * 20 * Math.Tan(20 * Math.PI / 180));
        PickResult pick = Picking.At(shown, (float)(100 + (x * pixelsPerUnit)), (float)(50 - (y * pixelsPerUnit)));
        Assert.Equal((pointer, material), (pick.Pointer, pick.Material));
    }

    [Fact]
    public async Task The_mask_of_a_group_is_that_of_all_in_it()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Nested);
        int Pixels(string pointer) => Picking.Mask(shown, pointer).Runs.Where((_, i) => i % 2 == 1).Sum();
        Assert.Equal(Pixels("/shapes/0"), Pixels("/shapes/0/shapes/0") + Pixels("/shapes/0/shapes/1"));
        Assert.NotEqual(0, Pixels("/shapes/0"));
        Assert.Equal(0, Pixels("/shapes"[..6]));
    }

    [Fact]
    public async Task Handles_are_where_the_thing_is_and_lines_of_it_too()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Nested);
        Gizmo gizmo = Gizmo.Of(shown, "/shapes/0");
        Assert.Equal(new(-7, -1, -1), gizmo.Minimum);
        Assert.Equal(new(-2, 1, 1), gizmo.Maximum);
        Assert.Throws<SessionException>(() => Gizmo.Of(shown, "/materials/red"));
        foreach (WireShape shape in Wireframe.Of(shown))
        {
            Gizmo box = Gizmo.Of(shown, shape.Pointer!);
            Assert.All(shape.Lines.SelectMany(l => l), p => Assert.True((p - box.Center).Length() <= box.Radius * 1.0001f));
        }

        Assert.Equal(["/shapes/0/shapes/0", "/shapes/0/shapes/1", "/shapes/1", "/shapes/2", "/shapes/3"], Wireframe.Of(shown).Select(s => s.Pointer).Order());
    }

    [Fact]
    public async Task What_is_picked_lies_on_the_thing_and_outside_of_the_picture_there_is_nothing()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Nested);
        PickResult pick = Picking.At(shown, 100, 50);
        Assert.Equal(1, pick.Position!.Value.Z, 0.02f);
        Assert.Equal(19, pick.Distance!.Value, 0.02f);
        Assert.Throws<SessionException>(() => Picking.At(shown, 200, 50));
        Assert.Throws<SessionException>(() => Picking.At(shown, float.NaN, 50));
    }
}
