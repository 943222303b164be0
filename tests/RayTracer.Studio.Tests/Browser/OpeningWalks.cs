using Microsoft.Playwright;
using RayTracer.Description;
using RayTracer.Scenes;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>What is shown belongs to the file whose name stands above it.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class OpeningWalks(ChromiumBrowser browser)
{
    // A format of these tests' own, whose files are read until one of them says so.
    private static readonly ManualResetEventSlim IsRead = new();

    static OpeningWalks() => ModelFile.Register(".endless", _ =>
    {
        IsRead.Wait(TimeSpan.FromMinutes(5));
        throw new ModelException("it was read for nobody");
    });

    [SkippableFact]
    public async Task No_other_files_picture_is_shown_while_a_model_is_read_or_where_a_file_has_errors()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        string before = w.Session.Document.Text;
        string name = w.Session.Document.Place.Name;
        await File.WriteAllTextAsync(Path.Combine(w.Folder, "big.endless"), "without an end");
        string scene = Path.Combine(w.Folder, "big.json");
        await File.WriteAllTextAsync(scene, """{ "shapes": [{ "type": "model", "file": "big.endless" }], "render": { "integrator": "report", "width": 64, "height": 48 } }""");
        w.Session.Files.Open(scene);
        ILocator note = w.Page.Locator(".opening");
        await Expect(note).ToContainTextAsync("Opening big.json");
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Level = 1 })).ToContainTextAsync("big.json");
        await Expect(w.Canvas).ToBeHiddenAsync();
        await Expect(w.Status).Not.ToContainTextAsync("samples");
        await Expect(note).ToContainTextAsync("Reading big.endless");
        await w.Shot("opening", isShown: true);
        await note.GetByRole(AriaRole.Button, new() { Name = "Cancel" }).ClickAsync();
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Level = 1 })).ToContainTextAsync(name);
        await Expect(note).ToHaveCountAsync(0);
        await Expect(w.Canvas).ToBeVisibleAsync();
        Assert.Equal(before, w.Session.Document.Text);
        IsRead.Set();

        // A picture that is kept belongs to its scene.
        await w.Painted();
        await w.Button("Keep for comparison").ClickAsync();
        await Expect(w.Page.GetByRole(AriaRole.Slider, new() { Name = "Wipe position" })).ToBeVisibleAsync();
        w.Session.Files.OpenGallery("primer/02-light.json");
        await Expect(w.Page.GetByRole(AriaRole.Slider, new() { Name = "Wipe position" })).ToHaveCountAsync(0);
        await w.Painted();
        await Expect(w.Page.GetByRole(AriaRole.Slider, new() { Name = "Wipe position" })).ToHaveCountAsync(0);

        // A file with errors has no picture until it has one of its own.
        scene = Path.Combine(w.Folder, "bad.json");
        await File.WriteAllTextAsync(scene, """{ "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": "wide" }], "render": { "integrator": "report", "width": 64, "height": 48 } }""");
        w.Session.Files.Open(scene);
        await Expect(w.Page.GetByText("bad.json has errors: there is nothing to show yet.")).ToBeVisibleAsync();
        await Expect(w.Canvas).ToBeHiddenAsync();
        w.Session.Edits.Set("/shapes/0/radius", 1);
        await Expect(w.Canvas).ToBeVisibleAsync();
        w.Session.Edits.SetText("/shapes/0/radius", "\"wide\"");
        await Expect(w.Page.GetByText("The text has an error: this is the last valid picture.")).ToBeVisibleAsync();
        await Expect(w.Canvas).ToBeVisibleAsync();
    }

    [SkippableFact]
    public async Task Behind_the_start_page_nothing_is_rendered()
    {
        await using StudioWindow w = await StudioWindow.Open(browser);
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Name = "Render a scene" })).ToBeVisibleAsync();
        Assert.Null(w.Session.View.Shown);
        await w.Button("New scene").ClickAsync();
        await w.Painted();
    }
}
