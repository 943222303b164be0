using System.Text.RegularExpressions;
using Microsoft.Playwright;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Session;
using RayTracer.Shapes;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>What students do with the picture.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class ViewportWalks(ChromiumBrowser browser)
{
    [SkippableFact]
    public async Task Looking_around_edits_nothing_and_the_scenes_camera_follows_on_request()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");
        await w.Painted();
        await w.Shot("scene-2", isShown: true);
        string before = w.Session.Document.Text;
        ILocator chip = w.Page.GetByRole(AriaRole.Group, new() { Name = "Your view, not the scene's camera" });
        await Expect(chip).ToHaveCountAsync(0);

        await w.Drag(0.5, 0.5, 0.62, 0.45);

        await Expect(chip).ToBeVisibleAsync();
        await w.Painted();
        await w.Shot("own-view", isShown: true);
        Assert.Equal(before, w.Session.Document.Text);
        await Expect(w.Button("Undo")).ToHaveAttributeAsync("aria-disabled", "true");
        await chip.GetByRole(AriaRole.Button, new() { Name = "Back to the camera" }).ClickAsync();
        await Expect(chip).ToHaveCountAsync(0);
        Assert.True(w.Session.View.IsSceneCamera);

        await w.Drag(0.5, 0.5, 0.62, 0.45);
        await chip.GetByRole(AriaRole.Button, new() { Name = "Set camera" }).ClickAsync();
        await w.Text("the scene's camera stands elsewhere", t => t != before);
        await Expect(chip).ToHaveCountAsync(0);
        string after = w.Session.Document.Text;
        Assert.Equal(Without(before, "\"camera\""), Without(after, "\"camera\""));
        await w.Page.Keyboard.PressAsync("Control+z");
        await w.Text("undo puts it back", t => t == before);
        await w.Page.Keyboard.PressAsync("Control+Shift+z");
        await w.Text("redo moves it again", t => t == after);
    }

    [SkippableFact]
    public async Task Pixels_have_numbers_maps_a_legend_and_views_are_moved_by_keys_and_kept()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        ILocator reading = w.Status.Locator(".reading");
        await Expect(reading).ToHaveCountAsync(0);
        LocatorBoundingBoxResult box = (await w.Canvas.BoundingBoxAsync())!;
        await w.Page.Mouse.MoveAsync(box.X + (box.Width * 0.5f), box.Y + (box.Height * 0.5f));
        await Expect(reading).ToContainTextAsync(new Regex("^(199|200), (149|150): R [0-9.e-]+ G [0-9.e-]+ B [0-9.e-]+$"));
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Show", Exact = true }).SelectOptionAsync("depth");
        ILocator legend = w.Page.Locator(".legend");
        await Expect(legend).ToContainTextAsync("scene units, evenly in 1/distance");
        await w.Page.Mouse.MoveAsync(box.X + (box.Width * 0.5f), box.Y + (box.Height * 0.45f));
        await Expect(reading).ToContainTextAsync(new Regex("^(199|200), 13[45]: Z 4[.][0-9]+$"));
        await w.Shot("reading", isShown: true);
        await w.Page.Mouse.MoveAsync(2, 2);
        await Expect(reading).ToHaveCountAsync(0);
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Show", Exact = true }).SelectOptionAsync("light");
        await Expect(legend).ToHaveCountAsync(0);

        // Keys and the wheel move the view.
        string text = w.Session.Document.Text;
        await w.Stage.FocusAsync();
        foreach (string key in new[] { "ArrowRight", "Shift+ArrowUp", "+", "w", "x", "Shift+Y", "f" })
        {
            await Moves(w, key, () => w.Page.Keyboard.PressAsync(key, new() { Delay = 60 }));
        }

        (float x, float y) = await w.Point(0.5, 0.5);
        await w.Page.Mouse.MoveAsync(x, y);
        await Moves(w, "the wheel", () => w.Page.Mouse.WheelAsync(0, -300));
        await Moves(w, "Home", () => w.Page.Keyboard.PressAsync("Home"));
        Assert.True(w.Session.View.IsSceneCamera);
        Assert.Equal(text, w.Session.Document.Text);

        // It is kept, returned to, and exported beside the camera's.
        await w.Drag(0.5, 0.5, 0.7, 0.4);
        ILocator menu = w.Page.GetByRole(AriaRole.Button, new() { Name = "Camera", Exact = true });
        await menu.ClickAsync();
        await w.Page.GetByRole(AriaRole.Menuitem, new() { NameRegex = new("^Keep this view") }).ClickAsync();
        await StudioWindow.Until("the view is kept", () => Task.FromResult(w.Session.Bookmarks.All.Count == 1));
        CameraPose kept = CameraPose.Of(w.Session.View.Shown!.Camera);
        await w.Page.Keyboard.PressAsync("Home");
        await StudioWindow.Until("the scene's camera is looked through", () => Task.FromResult(w.Session.View.IsSceneCamera));
        await menu.ClickAsync();
        await w.Shot("camera-menu");
        await w.Page.GetByRole(AriaRole.Menuitem, new() { Name = "View 1", Exact = true }).ClickAsync();
        await StudioWindow.Until("the view is back", () => Task.FromResult(!w.Session.View.IsSceneCamera));
        Assert.Equal(kept.Position.X, w.Session.View.Shown!.Camera.Position.X, 0.01f);

        await w.Page.Keyboard.PressAsync("Control+e");
        ILocator from = w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Seen from" });
        await Expect(w.Page.GetByRole(AriaRole.Button, new() { Name = "Download" })).ToHaveAttributeAsync("aria-disabled", "true");
        await w.Shot("export-own-view");
        await from.SelectOptionAsync("view");
        await Expect(w.Page.GetByRole(AriaRole.Button, new() { Name = "Download" })).Not.ToHaveAttributeAsync("aria-disabled", "true");
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task Exposure_and_tone_map_change_the_picture_and_render_nothing_again()
    {
        await using StudioWindow w = await StudioWindow.OpenEndless(browser);
        await w.Button("Stop").ClickAsync();
        await Expect(w.Status).ToContainTextAsync("stopped");
        await Settled(w);
        int samples = await w.Data("samples");
        long version = w.Session.View.Frames.Changes.Version;

        await w.Button("Display").ClickAsync();
        await w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "Exposure", Exact = true }).FillAsync("2");
        await w.Page.Keyboard.PressAsync("Enter");

        await StudioWindow.Until("the exposure arrives", () => Task.FromResult(w.Session.View.Tone.Exposure == 2));
        await StudioWindow.Until("a frame is painted", async () => await w.Data("version") > version);
        Assert.Equal(samples, await w.Data("samples"));
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Exposure is chosen", Exact = true }).SelectOptionAsync("auto");
        ILocator stops = w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "Exposure", Exact = true });
        await StudioWindow.Until("the automatic exposure is shown", async () => await stops.InputValueAsync() != "2");
        Assert.Equal(Exposure.Auto, w.Session.View.Tone.Exposure);
        version = w.Session.View.Frames.Changes.Version;
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Tone map", Exact = true }).SelectOptionAsync("reinhard");
        await StudioWindow.Until("the tone map arrives", () => Task.FromResult(w.Session.View.Tone.ToneMap == ToneMap.Reinhard));
        await StudioWindow.Until("another is painted", async () => await w.Data("version") > version);
        Assert.Equal(samples, await w.Data("samples"));
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task A_region_alone_is_rendered_and_then_all_again()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/02-light");
        await w.Painted();
        await w.Button("Render region").ClickAsync();
        await w.Drag(0.3, 0.3, 0.6, 0.6);
        await w.Button("Render the whole picture again").ClickAsync();
        await Expect(w.Button("Render the whole picture again")).ToHaveCountAsync(0);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task Pause_holds_the_samples_and_continue_goes_on()
    {
        await using StudioWindow w = await StudioWindow.OpenEndless(browser);
        await w.Button("Pause or resume").ClickAsync();
        await Expect(w.Status).ToContainTextAsync("paused");
        await w.Button("Pause or resume").ClickAsync();
        await Expect(w.Status).Not.ToContainTextAsync("paused");
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task A_kept_picture_is_wiped_against_a_later_one()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");
        await w.Painted(2);
        await w.Button("Keep for comparison").ClickAsync();
        await w.Drag(0.4, 0.8, 0.5, 0.8);
        await w.Painted();
        await Expect(w.Page.GetByRole(AriaRole.Img, new() { Name = "The kept picture" })).ToBeVisibleAsync();
        await w.Shot("wipe", isShown: true);
    }

    [SkippableFact]
    public async Task Two_kept_pictures_are_compared_and_enlarged_pixels_have_numbers()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        await w.Tab("Compare");
        ILocator pane = w.Page.GetByRole(AriaRole.Tabpanel, new() { Name = "Compare" });
        await Expect(pane).ToContainTextAsync("Keep a picture (K)");
        await pane.GetByRole(AriaRole.Button, new() { Name = "Keep for comparison" }).ClickAsync();
        await Expect(pane).ToContainTextAsync("keep another one");
        w.Session.Edits.Set("/shapes/0/radius", 0.6);
        await StudioWindow.Until("the ball is smaller", () => w.Session.View.Loop.ReadFilm((_, shown, samples) => samples == shown.Samples && shown.Description.Shapes.OfType<SphereDescription>().Any(s => s.Radius == 0.6f)));
        await w.Page.Keyboard.PressAsync("k");
        await StudioWindow.Until("two are kept", () => Task.FromResult(w.Session.Snapshots.All.Count == 2));
        Snapshot[] kept = [.. w.Session.Snapshots.All];
        await Expect(pane).ToContainTextAsync("choose one on the right");

        await pane.GetByRole(AriaRole.Combobox, new() { Name = "Left" }).SelectOptionAsync($"{kept[0].Id}");
        await pane.GetByRole(AriaRole.Combobox, new() { Name = "Right" }).SelectOptionAsync($"{kept[^1].Id}");
        await Expect(w.Page.GetByRole(AriaRole.Slider, new() { Name = "Wipe position" })).ToBeVisibleAsync();
        PictureComparison found = w.Session.Snapshots.Compare(kept[0].Id, kept[^1].Id);
        Assert.True(found.Flip > 0);
        await Expect(pane.GetByRole(AriaRole.Status)).ToHaveTextAsync(new Regex("^RMSE [0-9.e-]+, FLIP [0-9.e-]+$"));
        await pane.GetByRole(AriaRole.Radio, new() { Name = "FLIP" }).ClickAsync();
        ILocator errors = w.Page.GetByRole(AriaRole.Img, new() { Name = "FLIP", Exact = true });
        await StudioWindow.Until("the errors are there", async () => await errors.CountAsync() == 1 && await errors.EvaluateAsync<bool>("i => i.complete && i.naturalWidth > 0"));
        await w.Shot("compare", isShown: true);
        await pane.GetByRole(AriaRole.Radio, new() { Name = "Difference" }).ClickAsync();
        await Expect(pane).ToContainTextAsync($"at pixel {found.LargestX}, {found.LargestY}");
        ILocator name = pane.GetByRole(AriaRole.Textbox, new() { Name = "Name of the picture" }).First;
        await name.FillAsync("large ball");
        await name.PressAsync("Enter");
        await StudioWindow.Until("it has its name", () => Task.FromResult(w.Session.Snapshots.All[0].Name == "large ball"));
        await pane.GetByRole(AriaRole.Button, new() { Name = "Keep no longer: large ball" }).ClickAsync();
        await Expect(w.Page.GetByRole(AriaRole.Img, new() { Name = "Difference" })).ToHaveCountAsync(0);

        await w.Button("Display").ClickAsync();
        await Expect(w.Page.Locator(".histogram")).ToContainTextAsync("of the pixels are black");
        await w.Shot("histogram");
        await w.Page.Keyboard.PressAsync("Escape");
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Zoom", Exact = true }).SelectOptionAsync("6400");
        ILocator numbers = w.Page.Locator(".pixel-values > span");
        await Expect(numbers.First).ToHaveTextAsync(new Regex("^[0-9.e-]+$"));
        await w.Shot("pixel-values");
        await w.Button("Fit picture to window").ClickAsync();
        await Expect(numbers).ToHaveCountAsync(0);
        await w.Page.SetViewportSizeAsync(900, 700);
        await w.Page.EmulateMediaAsync(new() { ColorScheme = ColorScheme.Dark });
        await w.Shot("compare-900");
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task The_picture_is_enlarged_to_single_pixels_and_fitted_again()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/14-aliasing");

        // Messages that come meanwhile take from the picture's room.
        await w.Painted();
        await Settled(w);
        float fitted = (await w.Canvas.BoundingBoxAsync())!.Width;
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Zoom", Exact = true }).SelectOptionAsync("800");
        float enlarged = (await w.Canvas.BoundingBoxAsync())!.Width;
        Assert.Equal(8.0 * w.Session.View.RequireShown().Scene.Render.Width, enlarged, 1.0);
        await w.Button("Fit picture to window").ClickAsync();
        Assert.Equal(fitted, (await w.Canvas.BoundingBoxAsync())!.Width, 1.0);
    }

    private static async Task Moves(StudioWindow w, string what, Func<Task> act)
    {
        CameraPose before = CameraPose.Of(w.Session.View.Shown!.Camera);
        await act();
        await StudioWindow.Until($"{what} moves the view", () => Task.FromResult(CameraPose.Of(w.Session.View.Shown!.Camera) != before));
    }

    // The newest frame of a picture that is not rendered any more is on the screen.
    private static Task Settled(StudioWindow w) => StudioWindow.Until(
        "the last frame is painted",
        async () => w.Session.View.Loop.Status.Status is "stopped" or "done" && await w.Data("version") == w.Session.View.Frames.Changes.Version);

    // The lines of a text that do not hold a word.
    private static string Without(string text, string word) => string.Join('\n', text.Split('\n').Where(l => !l.Contains(word, StringComparison.Ordinal)));
}
