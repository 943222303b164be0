using Microsoft.Playwright;
using RayTracer.Description;
using RayTracer.Imaging;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>What students do with the picture.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class ViewportWalks(ChromiumBrowser browser)
{
    [SkippableFact]
    public async Task A_drag_orbits_the_camera_and_is_one_step_of_undo()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");
        await w.Painted();
        await w.Shot("scene-2", isShown: true);
        string before = w.Session.Document.Text;

        await w.Drag(0.5, 0.5, 0.62, 0.45);

        await w.Text("the camera stands elsewhere", t => t != before);
        await w.Painted();
        string after = w.Session.Document.Text;
        Assert.Equal(Without(before, "position"), Without(after, "position"));
        await w.Page.Keyboard.PressAsync("Control+z");
        await w.Text("undo puts it back", t => t == before);
        await w.Page.Keyboard.PressAsync("Control+Shift+z");
        await w.Text("redo moves it again", t => t == after);
    }

    [SkippableFact]
    public async Task Keys_and_the_wheel_move_the_camera()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        await w.Stage.FocusAsync();
        foreach (string key in new[] { "ArrowRight", "Shift+ArrowUp", "+", "w" })
        {
            string before = w.Session.Document.Text;
            await w.Page.Keyboard.PressAsync(key, new() { Delay = 60 });
            await w.Text($"{key} moves the camera", t => t != before);
        }

        string far = w.Session.Document.Text;
        (float x, float y) = await w.Point(0.5, 0.5);
        await w.Page.Mouse.MoveAsync(x, y);
        await w.Page.Mouse.WheelAsync(0, -300);
        await w.Text("the camera is nearer", t => t != far);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task Exposure_and_tone_map_change_the_picture_and_render_nothing_again()
    {
        await using StudioWindow w = await StudioWindow.OpenEndless(browser);
        await w.Button("Stop").ClickAsync();
        await Expect(w.Status).ToContainTextAsync("stopped");
        (int painted, int samples) = await Settled(w);

        await w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "Exposure", Exact = true }).FillAsync("2");
        await w.Page.Keyboard.PressAsync("Enter");

        await StudioWindow.Until("a frame is painted", async () => await w.Data("painted") > painted);
        Assert.Equal(samples, await w.Data("samples"));
        Assert.Equal(2, w.Session.View.Tone.Exposure);
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Exposure is chosen", Exact = true }).SelectOptionAsync("auto");
        ILocator stops = w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "Exposure", Exact = true });
        await StudioWindow.Until("the automatic exposure is shown", async () => await stops.InputValueAsync() != "2");
        Assert.Equal(Exposure.Auto, w.Session.View.Tone.Exposure);
        painted = await w.Data("painted");
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Tone map", Exact = true }).SelectOptionAsync("reinhard");
        await StudioWindow.Until("another is painted", async () => await w.Data("painted") > painted);
        Assert.Equal(ToneMap.Reinhard, w.Session.View.Tone.ToneMap);
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
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Compare with" }).SelectOptionAsync(new SelectOptionValue { Index = 1 });
        await w.Drag(0.4, 0.8, 0.5, 0.8);
        await w.Painted();
        await Expect(w.Page.GetByRole(AriaRole.Img, new() { Name = "The kept picture" })).ToBeVisibleAsync();
        await w.Shot("wipe", isShown: true);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task The_picture_is_enlarged_to_single_pixels_and_fitted_again()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/14-aliasing");

        // Messages that come meanwhile take from the picture's room.
        await Settled(w);
        float fitted = (await w.Canvas.BoundingBoxAsync())!.Width;
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Zoom", Exact = true }).SelectOptionAsync("800");
        float enlarged = (await w.Canvas.BoundingBoxAsync())!.Width;
        Assert.Equal(8.0 * w.Session.View.RequireShown().Scene.Render.Width, enlarged, 1.0);
        await w.Button("Fit picture to window").ClickAsync();
        Assert.Equal(fitted, (await w.Canvas.BoundingBoxAsync())!.Width, 1.0);
    }

    // Frames painted and samples shown, once a stopped picture's last frame has come.
    private static async Task<(int Painted, int Samples)> Settled(StudioWindow w)
    {
        (int Painted, int Samples) now = default;
        await StudioWindow.Until("no more frames come", async () =>
        {
            (int, int) before = now;
            await Task.Delay(300);
            now = (await w.Data("painted"), await w.Data("samples"));
            return now == before;
        });
        return now;
    }

    // The lines of a text that do not hold a word.
    private static string Without(string text, string word) => string.Join('\n', text.Split('\n').Where(l => !l.Contains(word, StringComparison.Ordinal)));
}
