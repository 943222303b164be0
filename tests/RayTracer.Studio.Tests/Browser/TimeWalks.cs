using System.Text.RegularExpressions;
using Microsoft.Playwright;
using RayTracer.Imaging;
using RayTracer.Session;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>How a student sees an animation, and makes one.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class TimeWalks(ChromiumBrowser browser)
{
    [SkippableFact]
    public async Task An_animation_is_looked_at_scrubbed_played_and_its_keys_are_changed()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "animation/01-turn");
        await w.Painted();

        // The timeline appears by itself, and the picture is that of frame 0.
        ILocator ruler = w.Page.GetByRole(AriaRole.Slider, new() { Name = "Frame", Exact = true });
        await Expect(ruler).ToHaveAttributeAsync("aria-valuenow", "0");
        Assert.Equal(0, w.Session.View.Shown!.Good.Frame);
        ILocator length = w.Page.GetByText("48 frames, 2.00 s");
        await Expect(length).ToBeVisibleAsync();
        Assert.True(await length.EvaluateAsync<bool>("e => e.scrollWidth <= e.clientWidth + 1"), "How long the animation is can be read.");
        Assert.Equal(1, await w.Page.Locator(".timeline-bar").EvaluateAsync<int>(
            "bar => new Set([...bar.children].map(c => { const b = c.getBoundingClientRect(); return Math.round((b.top + b.bottom) / 16); })).size"));
        await ruler.FocusAsync();
        await ruler.PressAsync("PageUp");
        await Shown(w, 10);
        await w.Page.GetByRole(AriaRole.Button, new() { Name = "Select what camera.position is of", Exact = true }).ClickAsync();
        await w.Tab("Camera");
        ILocator x = w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "position x", Exact = true });
        await Expect(x).Not.ToHaveValueAsync("0");
        await w.Page.GetByRole(AriaRole.Button, new() { Name = "Select what jumper.motion is of", Exact = true }).ClickAsync();
        await Expect(w.Page.Locator(".motion-paths path.thing")).ToHaveAttributeAsync("d", new Regex("^M.*L"));
        await w.Page.GetByRole(AriaRole.Button, new() { Name = "Select what camera.position is of", Exact = true }).ClickAsync();
        await w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("^jumper") }).ClickAsync();
        await w.Tab("Camera");
        await Expect(w.Status).ToContainTextAsync("done");
        await w.Shot("timeline", isShown: true);

        // An edit at the playhead is a key.
        string before = w.Session.Document.Text;
        await x.FillAsync("-1");
        await x.PressAsync("Enter");
        await w.Text("there is a key", t => t.Contains("\"time\": 0.41666666", StringComparison.Ordinal) && t.Contains("\"position\": [0, 1.6, 6]", StringComparison.Ordinal));
        ILocator made = Key(w, "camera.position", 10);
        float top = (await made.BoundingBoxAsync())!.Y;
        await made.FocusAsync();
        await made.PressAsync("Space");
        await Expect(made).ToHaveAttributeAsync("aria-pressed", "true");

        // What is done with chosen keys has its place before any is: none moves away from under the pointer.
        Assert.Equal(top, (await made.BoundingBoxAsync())!.Y);
        await made.PressAsync("ArrowRight");
        await Expect(Key(w, "camera.position", 11)).ToHaveAttributeAsync("aria-pressed", "true");
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Until the next key", Exact = true }).SelectOptionAsync("step");
        await w.Text("it waits", t => t.Contains("\"step\"", StringComparison.Ordinal) && t.Split("\"step\"").Length == 3);
        await w.Button("Delete keys").ClickAsync();
        await w.Text("the key is gone", t => t == before);

        // A drag moves a key, and is one step to undo; with Alt it leaves a copy.
        await Drag(w, Key(w, "materials.glass.refractiveIndex", 48), -24);
        await w.Text("the key was moved", t => t.Contains("{ \"time\": 1, \"value\": 1.7 }", StringComparison.Ordinal));
        await w.Page.Keyboard.PressAsync("Control+z");
        await w.Text("it is back", t => t == before);
        await w.Page.Keyboard.DownAsync("Alt");
        await Drag(w, Key(w, "materials.glass.refractiveIndex", 0), 24);
        await w.Page.Keyboard.UpAsync("Alt");
        await Expect(w.Page.GetByRole(AriaRole.Group, new() { Name = "Keys of materials.glass.refractiveIndex" }).GetByRole(AriaRole.Button)).ToHaveCountAsync(3);

        // It plays, over and over.
        await w.Button("Play or stop the animation").ClickAsync();
        await StudioWindow.Until("other frames are shown", () => Task.FromResult(w.Session.View.Shown?.Good.Frame is > 10));
        await w.Button("Play or stop the animation").ClickAsync();
        await Expect(w.Button("Play or stop the animation")).ToHaveAttributeAsync("aria-pressed", "false");
    }

    [SkippableFact]
    public async Task A_value_gets_keys_and_all_frames_are_rendered()
    {
        await using StudioWindow w = await StudioWindow.Open(browser);
        string path = Path.Combine(w.Folder, "small.json");
        await File.WriteAllTextAsync(path, """
            {
              "camera": { "position": [0, 1.6, 5], "lookAt": [0, 0.9, 0] },
              "render": { "width": 24, "height": 16, "samplesPerPixel": 2, "framesPerSecond": 4 },
              "background": [0.5, 0.7, 0.9],
              "shapes": [{ "type": "sphere", "name": "ball", "center": [0, 1, 0], "radius": 1 }],
            }
            """);
        w.Session.Files.Open(path);
        await w.Painted();
        await w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("^ball") }).ClickAsync();
        await w.Button("radius: set a key at frame 0").ClickAsync();
        await w.Tab("Timeline");
        ILocator frame = w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "Frame", Exact = true });
        await frame.FillAsync("4");
        await frame.PressAsync("Enter");
        await Shown(w, 4);
        ILocator radius = w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "radius", Exact = true });
        await radius.FillAsync("0.5");
        await radius.PressAsync("Enter");
        await w.Text("there are two keys", t => t.Contains("{ \"time\": 0, \"value\": 1 }, { \"time\": 1, \"value\": 0.5 }", StringComparison.Ordinal));
        await Expect(w.Button("radius: remove the key at frame 4")).ToHaveAttributeAsync("aria-pressed", "true");
        await w.Shot("keys");

        // What a handle moves while keys are recorded has a key, too.
        await w.Button("Record").ClickAsync();
        await w.Button("Move").ClickAsync();
        await w.Page.GetByRole(AriaRole.Slider, new() { Name = "Move along x" }).PressAsync("ArrowRight");
        await w.Text("the place has a key", t => t.Contains("\"shapes.ball.center\"", StringComparison.Ordinal) && t.Contains("\"center\": [0, 1, 0]", StringComparison.Ordinal));
        await Expect(Key(w, "shapes.ball.center", 4)).ToBeVisibleAsync();
        await w.Shot("record");
        await w.Tab("Source");
        await StudioWindow.Until("recording ends with the timeline", () => Task.FromResult(!w.Session.Document.IsRecording));
        await w.Tab("Timeline");
        await Expect(w.Button("Record")).ToHaveAttributeAsync("aria-pressed", "false");

        await w.Button("Render animation").ClickAsync();
        await Expect(w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "Last frame" })).ToHaveValueAsync("3");
        await w.Page.GetByRole(AriaRole.Combobox, new() { Name = "As", Exact = true }).SelectOptionAsync("animated");
        await w.Button("Choose the file …").ClickAsync();
        await Expect(w.Page.GetByRole(AriaRole.Dialog).GetByRole(AriaRole.Textbox, new() { Name = "Path" })).ToHaveValueAsync(w.Folder);
        await w.Page.GetByRole(AriaRole.Dialog).GetByRole(AriaRole.Button, new() { Name = "Save", Exact = true }).ClickAsync();
        string file = Path.Combine(w.Folder, "small.apng");
        await StudioWindow.Until("it is written", () => Task.FromResult(File.Exists(file) && w.Session.Jobs.Running.Count == 0));
        Assert.Equal(24, ImageFile.Read(file).Width);
    }

    private static Task Shown(StudioWindow w, int frame) =>
        StudioWindow.Until($"frame {frame} is shown", () => Task.FromResult(w.Session.View.Shown?.Good.Frame == frame));

    private static ILocator Key(StudioWindow w, string row, int frame) => w.Button($"{row}: key at frame {frame}");

    private static async Task Drag(StudioWindow w, ILocator key, int frames)
    {
        LocatorBoundingBoxResult from = (await key.BoundingBoxAsync())!;
        LocatorBoundingBoxResult lane = (await key.Locator("..").BoundingBoxAsync())!;
        (float x, float y) = (from.X + (from.Width / 2), from.Y + (from.Height / 2));
        await w.Page.Mouse.MoveAsync(x, y);
        await w.Page.Mouse.DownAsync();
        await w.Page.Mouse.MoveAsync(x + (lane.Width * frames / (48 * 1.03f)), y, new() { Steps = 4 });
        await w.Page.Mouse.UpAsync();
    }
}
