using RayTracer.Scenes;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

public sealed class SelectionTests : IDisposable
{
    private readonly TestSession _test = new();

    private Selection Selection => _test.Session.Selection;

    private JsonText Text => JsonText.Of(_test.Session.Document.Text);

    public void Dispose() => _test.Dispose();

    [Fact]
    public async Task Things_are_selected_beside_others_and_no_longer()
    {
        await _test.OpenShipped("report/scene2.json", 20, 1);
        Selection.Select("/shapes/3");
        Selection.Toggle("/shapes/5");
        Selection.Toggle("/shapes/4");
        Assert.Equal(("/shapes/4", 3), (Selection.Pointer, Selection.All.Count));
        Selection.Toggle("/shapes/4");
        Assert.Equal(["/shapes/3", "/shapes/5"], Selection.All);
        Assert.Equal(["/shapes/3", "/shapes/5"], SessionState.Of(_test.Session).Selected);
        Assert.Throws<SessionException>(() => Selection.Toggle("/shapes/99"));
        Assert.Equal(["/shapes/7"], Selection.With("/shapes/7"));
        Selection.Select("/shapes/7");
        Assert.Equal(["/shapes/7"], Selection.All);
    }

    [Fact]
    public async Task Selected_things_move_together_in_one_step()
    {
        await _test.OpenShipped("report/scene2.json", 20, 1);
        string before = _test.Session.Document.Text;
        Selection.SelectAll("/materials/red", "/shapes/6", "/lights/0", "/shapes/3");
        _test.Session.Edits.Place("/shapes/3", new(Translate: new(1, 0, 0)), "g");
        _test.Session.Edits.Place("/shapes/3", new(Translate: new(1, 0, 0)), "g");
        Assert.Equal((1.05f, 1.45f, -1.4f), (Center("/shapes/3"), Center("/shapes/6"), Center("/lights/0")));
        Assert.Equal(1.35f, Center("/shapes/4"));
        _test.Session.Document.Undo();
        Assert.Equal(before, _test.Session.Document.Text);

        // What is not one of them moves alone.
        _test.Session.Edits.Place("/shapes/4", new(Translate: new(1, 0, 0)));
        Assert.Equal((2.35f, -0.95f), (Center("/shapes/4"), Center("/shapes/3")));
    }

    [Fact]
    public async Task Several_things_are_copied_and_deleted_in_one_step()
    {
        await _test.OpenShipped("report/scene2.json", 20, 1);
        string before = _test.Session.Document.Text;
        (_, IReadOnlyList<string> copies) = _test.Session.Edits.Duplicate("/shapes/6", "/shapes/3", "/materials/red", "/lights/0");
        Assert.Equal(["/materials/red 2", "/shapes/4", "/shapes/8", "/lights/1"], copies);
        Assert.Equal(("glass ball 2", "red ball 2"), (Text.At("/shapes/4/name").Text, Text.At("/shapes/8/name").Text));
        _test.Session.Document.Undo();
        Assert.Equal(before, _test.Session.Document.Text);
        _test.Session.Edits.Delete("/shapes/3", "/shapes/6");
        Assert.Equal("chrome ball", Text.At("/shapes/3/name").Text);
        Assert.DoesNotContain("red ball", _test.Session.Document.Text, StringComparison.Ordinal);
        _test.Session.Document.Undo();
        Assert.Equal(before, _test.Session.Document.Text);
    }

    private float Center(string pointer) => SceneValue.At(Text.Root, pointer)!.Vector("center").X;
}
