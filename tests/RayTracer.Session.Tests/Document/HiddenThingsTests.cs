using RayTracer.Imaging;
using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Session.Tests;

/// <summary>Things that are hidden are left out of the view but not of files; those that are locked cannot be picked or dragged.</summary>
public sealed class HiddenThingsTests
{
    private const string Row = """
        {
          "camera": { "position": [0, 0, 8], "lookAt": [0, 0, 0] },
          "render": { "width": 24, "height": 16, "samplesPerPixel": 2 },
          "background": [0.3, 0.4, 0.5],
          "shapes": [
            { "type": "sphere", "center": [-2, 0, 0], "radius": 0.9 },
            { "type": "group", "shapes": [
              { "type": "sphere", "center": [0, 0.8, 0], "radius": 0.7 },
              { "type": "sphere", "center": [0, -0.8, 0], "radius": 0.7 }
            ] },
            { "type": "sphere", "center": [2, 0, 0], "radius": 0.9 }
          ],
          "lights": [{ "type": "point", "position": [0, 5, 5], "intensity": [50, 50, 50] }]
        }
        """;

    [Theory]
    [InlineData("/shapes/2", ",\n    { \"type\": \"sphere\", \"center\": [2, 0, 0], \"radius\": 0.9 }")]
    [InlineData("/shapes/1/shapes/1", ",\n      { \"type\": \"sphere\", \"center\": [0, -0.8, 0], \"radius\": 0.7 }")]
    [InlineData("/lights/0", "{ \"type\": \"point\", \"position\": [0, 5, 5], \"intensity\": [50, 50, 50] }")]
    public async Task The_view_is_that_of_a_scene_without_them_to_the_bit(string pointer, string without)
    {
        using TestSession test = new();
        await test.Open(Row);
        string whole = await test.FilmHash();
        test.Session.Document.Hide([pointer], areHidden: true);
        await test.Until(() => test.Session.View.Shown is { Good.Hidden.Count: 1 } shown ? shown : null);
        Assert.False(test.Session.View.IsWhole);
        string hidden = await test.FilmHash();
        Assert.Equal(Row, test.Session.Document.Text);
        Assert.False(test.Session.Document.Status.CanUndo);
        test.Session.Document.Hide([pointer], areHidden: false);
        await test.Until(() => test.Session.View.Shown is { Good.Hidden.Count: 0 } shown ? shown : null);
        Assert.Equal(whole, await test.FilmHash());
        Assert.Contains(without, Row, StringComparison.Ordinal);
        await test.Open(Row.Replace(without, "", StringComparison.Ordinal));
        Assert.Equal(await test.FilmHash(), hidden);
        Assert.NotEqual(whole, hidden);
        Assert.Empty(test.Session.Document.Hidden);
    }

    [Fact]
    public async Task They_are_not_picked_and_what_is_left_of_a_group_keeps_its_name()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Row);
        Assert.Equal("/shapes/2", Picking.At(shown, 18, 8).Pointer);
        test.Session.Document.Hide(["/shapes/2", "/shapes/1/shapes/0"], areHidden: true);
        shown = await test.Until(() => test.Session.View.Shown is { Good.Hidden.Count: 2 } s ? s : null);
        Assert.Null(Picking.At(shown, 18, 8).Pointer);
        Assert.Equal("/shapes/1/shapes/1", Picking.At(shown, 12, 10).Pointer);
        Assert.Null(Picking.At(shown, 12, 5).Pointer);
        Assert.Single(LightBody.Of(shown));
    }

    [Fact]
    public async Task Files_have_them_unless_the_user_asks_for_what_is_seen()
    {
        using TestSession test = new();
        await test.Open(Row);
        test.Session.Document.Hide(["/shapes/0"], areHidden: true);
        await test.Until(() => test.Session.View.Shown is { Good.Hidden.Count: 1 } shown ? shown : null);
        await test.FilmHash();
        Film whole = new RTracer(SceneLoader.LoadText(Row, "row.json", "").Scene!).Render().Film;
        string path = Path.Combine(test.Folder, "whole.pfm");
        await test.Session.Pictures.Save(test.Session.Pictures.Job(path), overwrite: false);
        await test.Until(() => File.Exists(path) && test.Session.Jobs.Running.Count == 0 ? path : null);
        Assert.Equal(whole.Mean(6, 8).R, Red(path), 1e-6f);
        string seen = Path.Combine(test.Folder, "seen.pfm");
        await test.Session.Pictures.Save(test.Session.Pictures.Job(seen), overwrite: false, asSeen: true);
        await test.Until(() => File.Exists(seen) && test.Session.Jobs.Running.Count == 0 ? seen : null);
        Assert.Equal(0.3f, Red(seen), 1e-6f);
        await Assert.ThrowsAsync<SessionException>(() => test.Session.Pictures.Save(test.Session.Pictures.Job(Path.Combine(test.Folder, "a.rtfilm")), overwrite: false, asSeen: true));
    }

    private static float Red(string path)
    {
        float[] row = new float[3 * 24];
        ImageFile.Read(path).ReadRow(8, row);
        return row[3 * 6];
    }

    [Fact]
    public void Marks_follow_things_whatever_is_done_to_the_text()
    {
        SceneDocument document = new(Row, new("row.json", null, ""));
        document.Hide(["/shapes/2"], areHidden: true);
        document.Lock(["/shapes/1/shapes/1"], areLocked: true);
        document.Change("delete", null, t => SceneThings.Delete(t, ["/shapes/0"]).Text);
        Assert.Equal("/shapes/1 /shapes/0/shapes/1", $"{document.Hidden.Single()} {document.Locked.Single()}");
        document.Undo();
        Assert.Equal("/shapes/2 /shapes/1/shapes/1", $"{document.Hidden.Single()} {document.Locked.Single()}");
        document.Change("edit", null, t => t.Set("/shapes/2/radius", 0.5));
        Assert.Equal(["/shapes/2"], document.Hidden);
        document.Change("duplicate", null, t => SceneThings.Duplicate(t, "/shapes/2").Text);
        Assert.Equal(["/shapes/2"], document.Hidden);
        document.TryReplace(document.Revision, 0, 0, "{", null);
        Assert.Equal(["/shapes/2"], document.Hidden);
        document.TryReplace(document.Revision, 0, 1, "", null);
        document.Change("delete", null, t => SceneThings.Delete(t, ["/shapes/2"]).Text);
        Assert.Empty(document.Hidden);
        Assert.True(document.IsLocked("/shapes/1/shapes/1"));
        Assert.False(document.IsLocked("/shapes/1"));
        document.Dispose();
    }

    [Fact]
    public async Task What_is_locked_is_neither_picked_nor_dragged()
    {
        using TestSession test = new();
        ViewportScene shown = await test.Open(Row);
        StudioSession session = test.Session;
        session.Document.Lock(["/shapes/1", "/lights/0"], areLocked: true);
        Assert.Null(Picking.Selectable(session.Document, shown, 12, 5).Pointer);
        Assert.Equal("/shapes/0", Picking.Selectable(session.Document, shown, 6, 8).Pointer);
        Assert.Throws<SessionException>(() => session.Handles.Drag(new("/shapes/1/shapes/0", GizmoKind.Move, 0, new(12, 5), new(14, 5), "g")));
        Assert.Throws<SessionException>(() => session.LightHandles.Drag(new("/lights/0", LightHandleKind.Radius, new(1, 1), "g")));
        session.Selection.SelectAll("/shapes/1", "/shapes/0");
        session.Edits.Place("/shapes/0", new(new(1, 0, 0)));
        Assert.Equal(Row.Replace("[-2, 0, 0]", "[-1, 0, 0]", StringComparison.Ordinal), session.Document.Text);
        session.Document.Lock(["/shapes/1"], areLocked: false);
        Assert.Equal("/shapes/1/shapes/0", Picking.Selectable(session.Document, shown, 12, 5).Pointer);
        Assert.Throws<SessionException>(() => session.Document.Hide(["/materials/x"], areHidden: true));
        Assert.Throws<SessionException>(() => session.Document.Lock(["/shapes/9"], areLocked: true));
        Assert.Throws<SessionException>(() => session.Document.Lock(["/shapes/0/radius"], areLocked: true));
    }
}
