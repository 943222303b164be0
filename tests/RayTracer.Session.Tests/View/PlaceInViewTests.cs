using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session.Tests;

/// <summary>New things are put down where one looks, on what is seen there, of a material that can be seen.</summary>
public sealed class PlaceInViewTests
{
    // Seen from above, aslant: a floor at −0.5, a wall at x = −4, and a ramp.
    private const string Room = """
        {
          "camera": { "position": [0, 4, 8], "lookAt": [0, -0.5, 0], "fieldOfView": 60 },
          "render": { "width": 40, "height": 30, "samplesPerPixel": 1 },
          "background": [1, 1, 1],
          "materials": { "red": { "type": "diffuse", "color": [0.8, 0.1, 0.1] } },
          "shapes": [
            { "type": "plane", "point": [0, -0.5, 0], "normal": [0, 1, 0] },
            { "type": "plane", "point": [-4, 0, 0], "normal": [1, 0, 0] },
            { "type": "plane", "point": [5, -0.5, 0], "normal": [-0.6, 0.8, 0] }
          ]
        }
        """;

    private static readonly string WithBall = Room.Replace(
        "\"shapes\": [", "\"shapes\": [ { \"type\": \"sphere\", \"center\": [0, 0.5, 0], \"radius\": 1 },", StringComparison.Ordinal);

    public static TheoryData<string> Shapes => [.. TypeCatalogue.Instance.Types["shape"].Where(t => t.AddedAs.Contains("shape") && t.Name is not ("model" or "instance" or "plane")).Select(t => t.Name)];

    [Theory]
    [MemberData(nameof(Shapes))]
    public async Task A_shape_stands_on_the_floor_under_the_middle_of_the_view(string type)
    {
        using TestSession test = new();
        await test.Open(Room);
        string before = test.Session.Document.Text;
        (_, string pointer) = test.Session.Edits.Add("shape", type);
        Bounds box = await BoxOf(test, pointer);
        Vector3 size = box.Maximum - box.Minimum;
        float largest = MathF.Max(size.X, MathF.Max(size.Y, size.Z));
        Assert.Equal(-0.5f + (size.Y < 0.02f ? 0.01f : 0), box.Minimum.Y, 2e-3f);

        // Within a pixel.
        Assert.Equal(0, (box.Minimum.X + box.Maximum.X) / 2, 0.3f);
        Assert.Equal(0, (box.Minimum.Z + box.Maximum.Z) / 2, 0.5f);

        // The view is about ten high there.
        Assert.InRange(largest, 0.8f, 4);
        test.Session.Document.Undo();
        Assert.Equal(before, test.Session.Document.Text);
        Assert.False(test.Session.Document.Status.CanUndo);
    }

    [Theory]
    [InlineData(2, 8, -4f, 1f, 0f)]
    [InlineData(38, 13, 5f, -0.6f, 0.8f)]
    public async Task At_a_pixel_a_box_touches_the_wall_or_the_ramp_that_is_seen_there(float x, float y, float at, float normalX, float normalY)
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Room);
        PickResult seen = Picking.At(shown, x, y);
        Vector3 normal = new(normalX, normalY, 0);
        Assert.True((seen.Normal!.Value - normal).Length() < 1e-4f, $"{seen}");
        (_, string pointer) = test.Session.Edits.Add("shape", "box", at: new(x, y));
        Bounds box = await BoxOf(test, pointer);
        Vector3 half = (box.Maximum - box.Minimum) / 2;
        float distance = Vector3.Dot((box.Maximum + box.Minimum) / 2, normal) - Vector3.Dot(Vector3.Abs(normal), half) - Vector3.Dot(new(at, normalY > 0 ? -0.5f : 0, 0), normal);
        Assert.Equal(0, distance, 1e-2f * half.X);
    }

    [Fact]
    public async Task On_a_ramp_a_ball_touches_what_is_seen()
    {
        using TestSession test = new();
        await test.Open(Room);
        (_, string pointer) = test.Session.Edits.Add("shape", "sphere", at: new(38, 13));
        SceneValue ball = SceneValue.At(test.Session.Document.Read.Root!, pointer)!;
        float distance = Vector3.Dot(ball.Vector("center") - new Vector3(5, -0.5f, 0), new(-0.6f, 0.8f, 0));
        Assert.Equal(ball.Number("radius"), distance, 2e-3f * ball.Number("radius"));
    }

    [Theory]
    [InlineData(20, 17)]
    [InlineData(16, 16)]
    public async Task Beside_a_ball_a_torus_stands_on_the_floor_and_does_not_cut_into_it(float x, float y)
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(WithBall);
        Vector3 seen = Picking.At(shown, x, y).Position!.Value;
        (_, string pointer) = test.Session.Edits.Add("shape", "torus", at: new(x, y));
        SceneValue torus = SceneValue.At(test.Session.Document.Read.Root!, pointer)!;
        (Vector3 center, float radius, float tube) = (torus.Vector("center"), torus.Number("radius"), torus.Number("tubeRadius"));
        Assert.Equal(-0.5f + tube, center.Y, 2e-3f);
        Assert.True(Ring(seen with { Y = center.Y }) < 1, "There would be nothing to avoid at the pixel.");
        Assert.True(Ring(center) > 1 - (0.02f * radius), $"The torus at {center} cuts into the ball.");
        Assert.True((center - seen).Length() < 3 * radius, $"The torus at {center} is far from {seen}.");

        // The distance between the ball's middle and the surface of a torus that stands at a point.
        float Ring(Vector3 at)
        {
            Vector3 way = new Vector3(0, 0.5f, 0) - at;
            float across = new Vector2(way.X, way.Z).Length() - radius;
            return new Vector2(across, way.Y).Length() - tube;
        }
    }

    [Fact]
    public async Task What_is_added_before_the_picture_shows_the_last_thing_stands_beside_that()
    {
        using TestSession test = new();
        await test.Open(Room);
        SceneValue[] balls = [.. Enumerable.Range(0, 3).Select(_ => test.Session.Edits.Add("shape", "sphere").Pointer).ToArray()
            .Select(p => SceneValue.At(test.Session.Document.Read.Root!, p)!)];
        foreach ((SceneValue a, SceneValue b) in balls.SelectMany((a, i) => balls.Skip(i + 1).Select(b => (a, b))))
        {
            float apart = (a.Vector("center") - b.Vector("center")).Length();
            Assert.True(apart > 0.97f * (a.Number("radius") + b.Number("radius")), test.Session.Document.Text);
        }
    }

    [Theory]
    [InlineData(20, 13)]
    [InlineData(18, 14)]
    public async Task On_the_side_of_a_ball_nothing_hangs_while_there_is_ground_beside(float x, float y)
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(WithBall);
        PickResult seen = Picking.At(shown, x, y);
        Assert.True(seen.Pointer == "/shapes/0" && seen.Normal!.Value.Y < 0.9f, $"{seen}");
        (_, string pointer) = test.Session.Edits.Add("shape", "box", at: new(x, y));
        Bounds box = await BoxOf(test, pointer);
        Assert.Equal(-0.5f, box.Minimum.Y, 2e-3f);
        Vector3 nearest = Vector3.Clamp(new(0, 0.5f, 0), box.Minimum, box.Maximum);
        Assert.True((nearest - new Vector3(0, 0.5f, 0)).Length() > 0.97f, $"The box at {box} cuts into the ball.");
    }

    [Fact]
    public async Task Where_there_is_no_room_on_what_is_seen_a_thing_stands_on_the_ground_beside()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Room.Replace("\"shapes\": [", """
            "shapes": [
              { "type": "sphere", "center": [0, -0.1, 0], "radius": 0.4 },
              { "type": "sphere", "center": [-1.6, 0.7, 0], "radius": 1.2 },
              { "type": "sphere", "center": [1.6, 0.7, 0], "radius": 1.2 },
            """, StringComparison.Ordinal));
        Assert.Equal("/shapes/0", Picking.At(shown, 19, 13).Pointer);
        string pointer = test.Session.Edits.Add("shape", "sphere", at: new(19, 13)).Pointer;
        SceneValue ball = SceneValue.At(test.Session.Document.Read.Root!, pointer)!;
        Assert.Equal(-0.5f + ball.Number("radius"), ball.Vector("center").Y, 2e-3f);
        foreach ((Vector3 center, float radius) in new[] { (new Vector3(0, -0.1f, 0), 0.4f), (new(-1.6f, 0.7f, 0), 1.2f), (new(1.6f, 0.7f, 0), 1.2f) })
        {
            Assert.True((ball.Vector("center") - center).Length() > radius + (0.97f * ball.Number("radius")), test.Session.Document.Text);
        }
    }

    [Fact]
    public async Task Where_there_is_no_room_it_stands_where_one_clicks()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open("""
            {
              "camera": { "position": [0, 0.2, 8], "lookAt": [0, -0.5, 0], "fieldOfView": 60 },
              "render": { "width": 40, "height": 30, "samplesPerPixel": 1 },
              "background": [1, 1, 1],
              "shapes": [ { "type": "plane", "point": [0, -0.5, 0], "normal": [0, 1, 0] }, { "type": "plane", "point": [0, 0.45, 0], "normal": [0, -1, 0] } ]
            }
            """);
        Vector3 seen = Picking.At(shown, 20, 15).Position!.Value;
        Assert.Equal(-0.5f, seen.Y, 1e-4f);
        (_, string pointer) = test.Session.Edits.Add("shape", "sphere", at: new(20, 15));
        SceneValue ball = SceneValue.At(test.Session.Document.Read.Root!, pointer)!;
        Vector3 away = ball.Vector("center") - seen;
        Assert.True(new Vector2(away.X, away.Z).Length() < 0.03f, $"The ball of radius {ball.Number("radius")} at {ball.Vector("center")} is not at {seen}.");
    }

    [Fact]
    public async Task Where_one_looks_is_where_the_view_is_and_not_the_scenes_camera()
    {
        using TestSession test = new();
        await test.Open(Room);
        test.Session.Camera.Move(new(CameraMoveKind.Set) { Position = new(-3, 0.5f, 5), LookAt = new(-3, -0.5f, 4) });
        (_, string pointer) = test.Session.Edits.Add("shape", "sphere");
        SceneValue sphere = SceneValue.At(test.Session.Document.Read.Root!, pointer)!;
        Assert.True((sphere.Vector("center") - new Vector3(-3, -0.5f + sphere.Number("radius"), 4)).Length() < 0.06f, test.Session.Document.Text);
        Assert.InRange(sphere.Number("radius"), 0.1f, 0.3f);
    }

    [Fact]
    public async Task It_is_made_of_the_material_that_was_used_last_or_a_matt_one()
    {
        using TestSession test = new();
        await test.Open(Room);
        SceneEdits edits = test.Session.Edits;
        string first = edits.Add("shape", "sphere").Pointer;
        Assert.Equal("matt", MaterialOf(test, first));
        Assert.Equal("diffuse", test.Session.Document.Read.Root!.Find("materials")!.Find("matt")!.Find("type")!.Text);
        Assert.Equal("matt", MaterialOf(test, edits.Add("shape", "box").Pointer));
        edits.Set(first + "/material", "red");
        Assert.Equal("red", MaterialOf(test, edits.Add("shape", "cone").Pointer));
        edits.Add("material", "plastic");
        Assert.Equal("plastic", MaterialOf(test, edits.Add("shape", "torus").Pointer));
        edits.Delete("/materials/plastic");
        Assert.Equal("matt", MaterialOf(test, edits.Add("shape", "torus").Pointer));
        Assert.Equal("{ \"type\": \"luminaire\", \"multiplier\": 20 }", MaterialOf(test, edits.Add("light", "sphere").Pointer));
    }

    [Fact]
    public async Task A_model_gets_a_size_that_can_be_seen_and_stands()
    {
        using TestSession test = new();
        string file = Path.Combine(test.Folder, "far.obj");
        await File.WriteAllTextAsync(file, "v 1000 1000 1000\nv 1400 1000 1000\nv 1000 1200 1000\nv 1000 1000 1100\nf 1 2 3\nf 1 2 4\nf 1 3 4\nf 2 3 4\n");
        await test.Open(Room);
        (_, string pointer) = test.Session.Edits.Add("shape", "model", "far.obj");
        Bounds box = await BoxOf(test, pointer);
        Assert.InRange((box.Maximum - box.Minimum).X, 0.8f, 4);
        Assert.Equal(-0.5f, box.Minimum.Y, 2e-3f);
        Assert.Equal(0, (box.Minimum.X + box.Maximum.X) / 2, 0.3f);
    }

    [Fact]
    public async Task Where_nothing_is_seen_it_is_put_where_the_camera_looks()
    {
        using TestSession test = new();
        await test.Open("""{ "camera": { "position": [0, 0, 5], "lookAt": [0, 0, 0] }, "render": { "width": 20, "height": 20, "samplesPerPixel": 1 }, "background": [1, 1, 1] }""");
        (_, string pointer) = test.Session.Edits.Add("shape", "sphere");
        Assert.Equal(Vector3.Zero, SceneValue.At(test.Session.Document.Read.Root!, pointer)!.Vector("center"));
        Assert.Throws<SessionException>(() => test.Session.Edits.Add("shape", "sphere", at: new(20, 3)));
        Assert.Throws<SessionException>(() => test.Session.Edits.Add("shape", "sphere", at: new(float.NaN, 3)));
    }

    private static string MaterialOf(TestSession test, string pointer)
    {
        RayTracer.Scenes.JsonNode node = JsonPointer.Find(test.Session.Document.Read.Root!, pointer + "/material")!;
        return node.Kind == JsonKind.String ? node.Text : test.Session.Document.Text[node.Start..node.End];
    }

    private static async Task<Bounds> BoxOf(TestSession test, string pointer)
    {
        DocumentContent content = await test.Session.Document.WhenBuilt();
        Assert.True(content.Load.Scene is not null, string.Join('\n', content.Load.Diagnostics));
        ViewportScene shown = await test.Until(() => test.Session.View.Shown is { } s && s.Good.Revision == test.Session.Document.Revision ? s : null);
        return shown.Scene.Surfaces().Where(s => Picking.IsWithin(shown.PointerOf(s.Source), pointer)).Aggregate(Bounds.Empty, (box, s) => box.Union(s.Bounds));
    }
}
