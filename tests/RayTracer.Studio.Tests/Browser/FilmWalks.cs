using Microsoft.Playwright;
using RayTracer.Imaging;
using RayTracer.Jobs;
using RayTracer.Rendering;
using RayTracer.Session;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>How films come into the window and leave it.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class FilmWalks(ChromiumBrowser browser)
{
    [SkippableFact]
    public async Task A_film_is_opened_gone_on_with_and_saved_again()
    {
        await using StudioWindow w = await StudioWindow.Open(browser);
        (string whole, string name) = WriteFilm(w.Folder);
        await OpenFile(w, name);
        await w.Painted(12);
        Assert.Equal(whole, await w.Session.View.Loop.ReadFilm((film, _, _) => film.ComputeHash()));
        await w.Button("Export picture").ClickAsync();
        ILocator format = w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Format" });
        await Expect(format.GetByRole(AriaRole.Option)).ToHaveCountAsync(PictureSaver.Formats.Count);
        await Write(w, format, "Film, to resume later", "again.rtfilm");
        Assert.Equal(whole, FilmFile.Read(Path.Combine(w.Folder, "again.rtfilm")).Film.ComputeHash());
        await w.Button("Export picture").ClickAsync();
        await Write(w, format, "Radiance HDR", "again.hdr");
        Assert.Equal(30, ImageFile.Read(Path.Combine(w.Folder, "again.hdr")).Width);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task Parts_and_frames_are_rendered_into_files_and_parts_merged()
    {
        await using StudioWindow w = await StudioWindow.Open(browser);
        (string whole, _) = WriteFilm(w.Folder);
        await OpenFile(w, "small.json");
        await w.Painted(12);
        foreach (int part in new[] { 1, 2 })
        {
            await w.Page.Keyboard.PressAsync("Control+b");
            await w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "Part" }).FillAsync($"{part}");
            await ChooseFile(w, $"part{part}.rtfilm", $"part{part}.rtfilm");
        }

        await w.Page.Keyboard.PressAsync("Control+b");
        await w.Page.GetByRole(AriaRole.Radio, new() { Name = "Frames" }).ClickAsync();
        await w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "Last frame" }).FillAsync("1");
        await ChooseFile(w, "turn-##.png", "turn-01.png");
        await w.Page.Keyboard.PressAsync("Control+b");
        await w.Page.GetByRole(AriaRole.Radio, new() { Name = "Merge parts" }).ClickAsync();
        ILocator dialog = await InFolder(w);
        await dialog.GetByRole(AriaRole.Button, new() { NameRegex = new("part1") }).ClickAsync();
        await dialog.GetByRole(AriaRole.Button, new() { NameRegex = new("part2.rtfilm.*B") }).ClickAsync();
        await w.Shot("merge", isShown: true);
        await ChooseFile(w, "merged.rtfilm", "merged.rtfilm");
        Assert.Equal(whole, FilmFile.Read(Path.Combine(w.Folder, "merged.rtfilm")).Film.ComputeHash());
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task Lights_are_balanced_after_rendering()
    {
        await using StudioWindow w = await StudioWindow.Open(browser);
        JsonText text = JsonText.Of(File.ReadAllText(ProjectFolder.PathOf("scenes", "lights", "04-light-groups.json")));
        await File.WriteAllTextAsync(Path.Combine(w.Folder, "groups.json"), text.Set("/render/width", 60).Set("/render/height", 40).Set("/render/samplesPerPixel", 4).Text);
        await OpenFile(w, "groups.json");
        await w.Painted(4);
        await Lights(w);
        await w.Button("Render one …").ClickAsync();
        await SaveAs(w, "groups.exr", "groups.exr");
        await Lights(w);
        ILocator dialog = await InFolder(w);
        await dialog.GetByRole(AriaRole.Button, new() { NameRegex = new("groups.exr") }).ClickAsync();
        await dialog.GetByRole(AriaRole.Button, new() { Name = "Open", Exact = true }).ClickAsync();
        foreach (string light in w.Session.Lights.Open(Path.Combine(w.Folder, "groups.exr")).Where(l => l != "lamp"))
        {
            await w.Page.GetByRole(AriaRole.Slider, new() { Name = $"Strength of {light}" }).FillAsync("0");
        }

        await w.Page.GetByRole(AriaRole.Slider, new() { Name = "Strength of lamp" }).FillAsync("2");
        await w.Shot("lights", isShown: true);
        await w.Button("Write picture …").ClickAsync();
        await SaveAs(w, "lamp.pfm", "lamp.pfm");
        RelightableImage mix = RelightableImage.Open(await File.ReadAllBytesAsync(Path.Combine(w.Folder, "groups.exr")));
        Textures.Picture expected = mix.Compose(l => l == "lamp" ? new(2, 2, 2) : default);
        Assert.Equal(expected.Pixels, ImageFile.Read(Path.Combine(w.Folder, "lamp.pfm")).Pixels);
    }

    private static async Task Lights(StudioWindow w)
    {
        await w.Button("File").ClickAsync();
        await w.Page.GetByRole(AriaRole.Menuitem, new() { Name = "Balance lights" }).ClickAsync();
    }

    private static async Task OpenFile(StudioWindow w, string name)
    {
        // By the menu: keys pressed before the page is whole are lost.
        await w.Button("File").ClickAsync();
        await w.Page.GetByRole(AriaRole.Menuitem, new() { NameRegex = new("^Open") }).First.ClickAsync();
        ILocator dialog = await InFolder(w);
        await dialog.GetByRole(AriaRole.Button, new() { NameRegex = new(name) }).ClickAsync();
        await dialog.GetByRole(AriaRole.Button, new() { Name = "Open", Exact = true }).ClickAsync();
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task A_file_that_is_picked_stays_so_while_its_folder_is_read_again()
    {
        await using StudioWindow w = await StudioWindow.Open(browser);
        await File.WriteAllTextAsync(Path.Combine(w.Folder, "one.json"), await File.ReadAllTextAsync(ProjectFolder.PathOf("scenes", "primer", "02-light.json")));
        await w.Button("File").ClickAsync();
        await w.Page.GetByRole(AriaRole.Menuitem, new() { NameRegex = new("^Open") }).First.ClickAsync();
        ILocator dialog = await InFolder(w);

        // The list comes late, after the click.
        TaskCompletionSource picked = new();
        await w.Page.RouteAsync("**/file/list**", async route =>
        {
            await picked.Task;
            await route.ContinueAsync();
        });
        await dialog.GetByRole(AriaRole.Textbox, new() { Name = "Path" }).PressAsync("Enter");
        await dialog.GetByRole(AriaRole.Button, new() { NameRegex = new("one.json") }).ClickAsync();
        File.Copy(Path.Combine(w.Folder, "one.json"), Path.Combine(w.Folder, "two.json"));
        picked.SetResult();
        await Expect(dialog.GetByRole(AriaRole.Button, new() { NameRegex = new("two.json") })).ToBeVisibleAsync();
        await Expect(dialog.GetByRole(AriaRole.Button, new() { NameRegex = new("one.json") })).ToHaveAttributeAsync("aria-pressed", "true");
        await dialog.GetByRole(AriaRole.Button, new() { Name = "Open", Exact = true }).ClickAsync();
        await Expect(dialog).ToBeHiddenAsync();
    }

    private static async Task ChooseFile(StudioWindow w, string name, string expected)
    {
        await w.Button("Choose the file …").ClickAsync();
        await SaveAs(w, name, expected);
    }

    private static async Task SaveAs(StudioWindow w, string name, string expected)
    {
        ILocator dialog = await InFolder(w);
        await dialog.GetByRole(AriaRole.Textbox, new() { Name = "File name" }).FillAsync(name);
        await dialog.GetByRole(AriaRole.Button, new() { Name = "Save", Exact = true }).ClickAsync();
        await StudioWindow.Until($"{expected} is there", () => Task.FromResult(File.Exists(Path.Combine(w.Folder, expected))));
    }

    private static async Task<ILocator> InFolder(StudioWindow w)
    {
        ILocator dialog = w.Page.GetByRole(AriaRole.Dialog);
        ILocator path = dialog.GetByRole(AriaRole.Textbox, new() { Name = "Path" });

        // Filling selects what is there and then types, and the folder that the dialog begins with, which comes with its list, must not come between the two.
        await Expect(path).Not.ToHaveValueAsync("");
        await path.FillAsync(w.Folder);
        await path.PressAsync("Enter");
        await Expect(dialog.GetByRole(AriaRole.List, new() { Name = w.Folder })).ToBeVisibleAsync();
        return dialog;
    }

    private static async Task Write(StudioWindow w, ILocator format, string label, string name)
    {
        await format.SelectOptionAsync(new SelectOptionValue { Label = label });
        await w.Button("Write to file").ClickAsync();
        ILocator dialog = await InFolder(w);
        await dialog.GetByRole(AriaRole.Textbox, new() { Name = "File name" }).FillAsync(name);
        await dialog.GetByRole(AriaRole.Button, new() { Name = "Save", Exact = true }).ClickAsync();
        await StudioWindow.Until($"{name} is there", () => Task.FromResult(File.Exists(Path.Combine(w.Folder, name))));
    }

    // A scene with a film of the first 5 of its 12 samples.
    private static (string Whole, string Name) WriteFilm(string folder)
    {
        string scene = Path.Combine(folder, "small.json");
        JsonText text = JsonText.Of(File.ReadAllText(ProjectFolder.PathOf("scenes", "primer", "02-light.json")));
        File.WriteAllText(scene, text.Set("/render/width", 30).Set("/render/height", 20).Set("/render/samplesPerPixel", 12).Text);
        Scenes.SceneLoadResult load = Scenes.SceneLoader.Load(scene);
        Film film = new(30, 20);
        new RTracer(load.Scene!, new() { Samples = new(0, 5) }).Render(film, null, default);
        FilmFile.Write(Path.Combine(folder, "begun.rtfilm"), film, new()
        {
            Width = 30,
            Height = 20,
            Content = ContentHash.Of(load.Description!, scene, null),
            Samples = [new(0, 5)],
            Wanted = new(0, 12),
            Total = 12,
            Scene = scene,
        });
        return (new RTracer(load.Scene!).Render().Film.ComputeHash(), "begun.rtfilm");
    }
}
