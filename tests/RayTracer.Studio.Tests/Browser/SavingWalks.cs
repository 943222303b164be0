using System.IO.Compression;
using Microsoft.Playwright;
using RayTracer.Imaging;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>How work leaves the window.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class SavingWalks(ChromiumBrowser browser)
{
    [SkippableFact]
    public async Task A_scene_is_saved_and_its_picture_downloaded_in_each_format_and_its_command_line_copied()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        string before = w.Session.Document.Text;
        await w.Drag(0.5, 0.5, 0.6, 0.5);
        await w.Button("Set camera").ClickAsync();
        await w.Text("the camera has moved", t => t != before);
        await w.Page.Keyboard.PressAsync("Control+Shift+s");
        ILocator dialog = w.Page.GetByRole(AriaRole.Dialog);
        await Expect(dialog).ToBeVisibleAsync();
        await w.Shot("save-as");
        await Expect(dialog.GetByRole(AriaRole.Textbox, new() { Name = "File name" })).ToBeFocusedAsync();
        ILocator path = dialog.GetByRole(AriaRole.Textbox, new() { Name = "Path" });
        await path.FillAsync(w.Folder);
        await path.PressAsync("Enter");
        await dialog.GetByRole(AriaRole.Textbox, new() { Name = "File name" }).FillAsync("mine.json");
        await dialog.GetByRole(AriaRole.Button, new() { Name = "Save", Exact = true }).ClickAsync();
        string file = Path.Combine(w.Folder, "mine.json");
        await StudioWindow.Until("the file is there", () => Task.FromResult(File.Exists(file)));
        Assert.Equal(w.Session.Document.Text, await File.ReadAllTextAsync(file));
        Assert.Equal(before.Split('\n')[0], (await File.ReadAllTextAsync(file)).Split('\n')[0]);
        Assert.False(w.Session.Document.IsDirty);

        await Download(w, "png", "PNG");
        await Download(w, "exr", "OpenEXR");
        await Download(w, "pfm", "PFM");
        await w.Page.GetByRole(AriaRole.Button, new() { Name = "File", Exact = true }).ClickAsync();
        await w.Page.GetByRole(AriaRole.Menuitem, new() { Name = "Copy command line" }).ClickAsync();
        await StudioWindow.Until("it is on the clipboard", async () =>
            (await w.Page.EvaluateAsync<string>("() => navigator.clipboard.readText()")).StartsWith("raytracer render ", StringComparison.Ordinal));
    }

    [SkippableFact]
    public async Task A_scene_without_a_file_is_saved_first_and_then_the_other_one_opens_in_sight()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, more: new() { ViewportSize = new() { Width = 900, Height = 700 } });
        w.Session.Files.OpenGallery("primer/01-sphere.json");
        await w.Painted();
        await w.Drag(0.5, 0.5, 0.6, 0.5);
        await w.Page.Keyboard.PressAsync("Shift+Home");
        await StudioWindow.Until("there are changes", () => Task.FromResult(w.Session.Document.IsDirty));
        string text = w.Session.Document.Text;
        ILocator pane = w.Button("Scene and files pane");
        await pane.ClickAsync();
        await w.Tab("Gallery");
        await w.Page.GetByRole(AriaRole.Button, new() { NameRegex = new("Open .*glass") }).First.ClickAsync();
        ILocator dialog = w.Page.GetByRole(AriaRole.Dialog);
        await dialog.GetByRole(AriaRole.Button, new() { Name = "Save", Exact = true }).ClickAsync();
        ILocator path = dialog.GetByRole(AriaRole.Textbox, new() { Name = "Path" });
        await path.FillAsync(w.Folder);
        await path.PressAsync("Enter");
        await dialog.GetByRole(AriaRole.Textbox, new() { Name = "File name" }).FillAsync("kept.json");
        await dialog.GetByRole(AriaRole.Button, new() { Name = "Save", Exact = true }).ClickAsync();
        await StudioWindow.Until("the other scene is open", () => Task.FromResult(w.Session.Document.Status.Name.Contains("glass", StringComparison.Ordinal)));

        // The schema's address is another one there.
        static IEnumerable<string> Lines(string text) => text.Split('\n').Where(l => !l.Contains("$schema", StringComparison.Ordinal));
        Assert.Equal(Lines(text), Lines(await File.ReadAllTextAsync(Path.Combine(w.Folder, "kept.json"))));
        await Expect(pane).ToHaveAttributeAsync("aria-pressed", "false");
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task A_bundle_holds_the_scene_and_its_pictures()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene1");
        await w.Painted();
        await w.Page.GetByRole(AriaRole.Button, new() { Name = "File", Exact = true }).ClickAsync();
        IDownload download = await w.Page.RunAndWaitForDownloadAsync(() => w.Page.GetByRole(AriaRole.Menuitem, new() { Name = "Share bundle" }).ClickAsync());
        string file = Path.Combine(w.Folder, "bundle.zip");
        await download.SaveAsAsync(file);
        using ZipArchive zip = ZipFile.OpenRead(file);
        Assert.Contains(zip.Entries, e => e.Name == "globe.png");
        Assert.Contains(zip.Entries, e => e.FullName == "scene.json");
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task A_file_that_is_dropped_is_opened()
    {
        await using StudioWindow w = await StudioWindow.Open(browser);
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Name = "Render a scene" })).ToBeVisibleAsync();
        IJSHandle data = await w.Page.EvaluateHandleAsync(
            "text => { const data = new DataTransfer(); data.items.add(new File([text], 'dropped.obj')); return data; }", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n");
        foreach (string kind in new[] { "dragenter", "dragover", "drop" })
        {
            await w.Page.Locator("body").DispatchEventAsync(kind, new { dataTransfer = data });
        }

        await w.Painted();
        Assert.Contains("dropped", w.Session.Document.Text, StringComparison.Ordinal);
    }

    private static async Task Download(StudioWindow w, string format, string label)
    {
        await w.Button("Export picture").ClickAsync();
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Format" }).SelectOptionAsync(new SelectOptionValue { Label = label });
        if (format == "exr")
        {
            await w.Page.GetByRole(AriaRole.Checkbox, new() { Name = "Depth" }).CheckAsync();
            await w.Shot("export", isShown: true);
        }

        IDownload download = await w.Page.RunAndWaitForDownloadAsync(() => w.Button("Download").ClickAsync());
        string file = Path.Combine(w.Folder, "picture." + format);
        await download.SaveAsAsync(file);
        Textures.Picture picture = ImageFile.Read(file, false);
        Assert.Equal((w.Session.View.RequireShown().Scene.Render.Width, w.Session.View.RequireShown().Scene.Render.Height), (picture.Width, picture.Height));
    }
}
