using System.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Session.Tests;

/// <summary>Materials, textures and lights are given to things: by their pointers, or where they are dropped.</summary>
public sealed class AssignmentTests
{
    private const string Balls = """
        {
          "camera": { "position": [0, 0, 8], "lookAt": [0, 0, 0], "fieldOfView": 40 },
          "render": { "width": 40, "height": 40, "samplesPerPixel": 1 },
          "background": [1, 1, 1],
          "textures": { "board": { "type": "checker" } },
          "materials": {
            "red": { "type": "diffuse", "color": [0.8, 0.1, 0.1] },
            "own": { "type": "principled", "baseColor": "blue" },
            "worn": { "type": "mask", "material": "red" },
            "glass": { "type": "dielectric" },
          },
          "shapes": [
            { "type": "sphere", "center": [-1.5, 0, 0], "radius": 1, "material": "red" },   // left
            { "type": "sphere", "center": [1.5, 0, 0], "radius": 1, "material": "own" },
            { "type": "sphere", "center": [0, 2, 0], "radius": 0.5 },
          ],
          "lights": [
            { "type": "spot", "position": [0, 5, 5], "direction": [1, 0, 0] },
            { "type": "directional", "direction": [0, -1, 0] },
            { "type": "point", "position": [1.5, 0, 4] },
          ],
        }
        """;

    [Fact]
    public async Task A_material_is_dropped_on_a_thing_and_applied_to_several()
    {
        using TestSession test = new();
        await test.Open(Balls);
        test.Session.Edits.Apply("/materials/glass", new Vector2(12, 20));
        Assert.Equal(Balls.Replace("\"material\": \"red\" },   //", "\"material\": \"glass\" },   //", StringComparison.Ordinal), test.Session.Document.Text);
        test.Session.Document.Undo();
        Assert.Equal(Balls, test.Session.Document.Text);
        test.Session.Edits.Apply("/materials/glass", "/shapes/0", "/shapes/1", "/shapes/2");
        Assert.Equal(3, test.Session.Document.Text.Split("\"material\": \"glass\"").Length - 1);
        test.Session.Document.Undo();
        Assert.Equal(Balls, test.Session.Document.Text);
    }

    [Fact]
    public void A_texture_is_the_colour_of_the_things_own_material_or_of_a_copy_where_others_have_it()
    {
        JsonText text = JsonText.Of(Balls);
        JsonText own = Assignment.Texture(text, "/shapes/1", "board");
        Assert.Equal(Balls.Replace("\"baseColor\": \"blue\"", "\"baseColor\": \"board\"", StringComparison.Ordinal), own.Text);

        // The mask has it, too.
        JsonText copied = Assignment.Texture(text, "/shapes/0", "board");
        Assert.Equal("red 2", copied.At("/shapes/0/material").Text);
        Assert.Equal("board", copied.At("/materials/red 2/color").Text);
        Assert.Equal(JsonKind.Array, copied.At("/materials/red/color").Kind);

        Assert.Equal("board", Assignment.Texture(text, "/shapes/2", "board").At("/shapes/2/material/color").Text);
        Assert.Equal("board", Assignment.Texture(text, "/materials/worn", "board").At("/materials/red/color").Text);
        Assert.All([own, copied], t => Assert.True(SceneReader.ReadText(t.Text, "").Description is not null, t.Text));
    }

    [Fact]
    public async Task A_light_is_turned_to_the_thing_or_moved_before_it()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Balls);
        PickResult seen = Picking.At(shown, 28, 20);
        test.Session.Edits.Apply("/lights/0", new Vector2(28, 20));
        Near(Vector3.Normalize(seen.Position!.Value - new Vector3(0, 5, 5)), Vector3.Normalize(Vector(test, "/lights/0/direction")), 1e-3f);
        test.Session.Edits.Apply("/lights/1", new Vector2(28, 20));
        Near(-seen.Normal!.Value, Vector(test, "/lights/1/direction"), 1e-3f);
        float before = Vector3.Distance(new(1.5f, 0, 4), seen.Position.Value);
        test.Session.Edits.Apply("/lights/2", new Vector2(28, 20));
        Near(seen.Position.Value + (seen.Normal.Value * before), Vector(test, "/lights/2/position"), 1e-2f);
        test.Session.Edits.Apply("/lights/0", "/shapes/2");
        Near(Vector3.Normalize(new Vector3(0, 2.5f, 0) - new Vector3(0, 5, 5)), Vector3.Normalize(Vector(test, "/lights/0/direction")), 1e-3f);
    }

    [Fact]
    public async Task What_cannot_be_is_refused_and_changes_nothing()
    {
        using TestSession test = new();
        await test.Open(Balls);
        SceneEdits edits = test.Session.Edits;
        Assert.Contains("dielectric", Assert.Throws<SessionException>(() => edits.Apply("/textures/board", "/materials/glass")).Message, StringComparison.Ordinal);
        Assert.Throws<SessionException>(() => edits.Apply("/materials/red", "/lights/0"));
        Assert.Throws<SessionException>(() => edits.Apply("/materials/red", "/materials/own"));
        Assert.Throws<SessionException>(() => edits.Apply("/materials/none", "/shapes/0"));
        Assert.Throws<SessionException>(() => edits.Apply("/shapes/0", "/shapes/1"));
        Assert.Throws<SessionException>(() => edits.Apply("/materials/red"));
        Assert.Throws<SessionException>(() => edits.Apply("/materials/red", "/shapes/7"));
        Assert.Throws<SessionException>(() => edits.Apply("/materials/red", new Vector2(1, 1)));
        Assert.Equal(Balls, test.Session.Document.Text);
    }

    private static Vector3 Vector(TestSession test, string pointer) => SceneValue.At(test.Session.Document.Read.Root!, JsonPointer.Parent(pointer)!)!.Vector(JsonPointer.Last(pointer));

    private static void Near(Vector3 expected, Vector3 actual, float within) => Assert.True((expected - actual).Length() < within, $"{expected} {actual}");
}
