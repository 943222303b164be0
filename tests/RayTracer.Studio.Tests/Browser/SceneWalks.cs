using Microsoft.Playwright;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>What students do with the things of a scene.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class SceneWalks(ChromiumBrowser browser)
{
    [SkippableFact]
    public async Task The_first_start_says_what_to_do_and_shows_around()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, isFirst: true);
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Name = "Render a scene" })).ToBeVisibleAsync();
        await StudioWindow.Until("thumbnails of all that is seen are made", () => w.Page.EvaluateAsync<bool>(
            """
            const seen = [...document.querySelectorAll("main .thumbnail")].filter(t => t.getBoundingClientRect().top < document.querySelector("footer").getBoundingClientRect().top);
            seen.length > 6 && seen.every(t => t.querySelector("img")?.complete)
            """));
        await w.Shot("start", isShown: true);
        Assert.Empty(await w.Page.EvaluateAsync<string[]>(
            "() => [...document.querySelectorAll('.gallery button > span:last-child')].filter(e => e.scrollWidth > e.clientWidth + 1).map(e => e.textContent)"));

        // As soon as there is something to see.
        await w.Page.GetByRole(AriaRole.Button, new() { NameRegex = new("Open Scene 1") }).First.ClickAsync();
        for (int step = 1; step < 5; step++)
        {
            await Expect(w.Page.GetByText($"Step {step} of 5")).ToBeVisibleAsync();
            await w.Shot($"tour-{step}");
            Assert.Equal(0, await w.Page.EvaluateAsync<int>(
                """
                () => {
                  const [card, frame] = [".tour", ".tour-frame"].map(s => document.querySelector(s).getBoundingClientRect());
                  return Math.max(0, Math.min(card.right, frame.right) - Math.max(card.left, frame.left)) * Math.max(0, Math.min(card.bottom, frame.bottom) - Math.max(card.top, frame.top));
                }
                """));
            await w.Button("Next").ClickAsync();
        }

        await w.Button("Done").ClickAsync();
        await w.Page.ReloadAsync();
        await w.Painted();
        await Expect(w.Page.GetByText("Step 1 of 5")).ToHaveCountAsync(0);
    }

    [SkippableFact]
    public async Task What_is_clicked_in_the_picture_is_selected_and_changed_alone_or_with_others()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");
        await w.Painted();
        string before = w.Session.Document.Text;

        // The chrome ball.
        await w.Click(0.66, 0.56);

        ILocator row = w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("chrome ball") });
        await Expect(row).ToHaveAttributeAsync("aria-selected", "true");
        await w.Painted();
        await w.Shot("selected", isShown: true);

        ILocator radius = w.Page.GetByRole(AriaRole.Spinbutton, new() { Name = "radius", Exact = true });
        await radius.FillAsync("1.25");
        await radius.PressAsync("Enter");
        await w.Text("the radius is written", t => t.Contains("\"center\": [1.35, 1, 0], \"radius\": 1.25", StringComparison.Ordinal));
        Assert.Equal(before.Replace("\"radius\": 1, \"material\": \"chrome\"", "\"radius\": 1.25, \"material\": \"chrome\"", StringComparison.Ordinal), w.Session.Document.Text);
        await w.Painted();
        await w.Stage.FocusAsync();
        await w.Page.Keyboard.PressAsync("Control+z");
        await w.Text("undo takes it back", t => t == before);

        ILocator Row(string name) => w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new($"^{name}") });
        await Row("red ball").ClickAsync();
        await Row("glass ball").ClickAsync(new() { Modifiers = [KeyboardModifier.Control] });
        await Expect(Row("red ball")).ToHaveAttributeAsync("aria-selected", "true");
        await Expect(w.Page.GetByText("2 things are selected.")).ToBeVisibleAsync();
        (float x, float y) = await w.Point(0.66, 0.56);
        await w.Page.Keyboard.DownAsync("Shift");
        await w.Page.Mouse.ClickAsync(x, y);
        await w.Page.Keyboard.UpAsync("Shift");
        await Expect(Row("chrome ball")).ToHaveAttributeAsync("aria-selected", "true");
        await w.Shot("several", isShown: true);

        await w.Button("Move").ClickAsync();
        await w.Page.GetByRole(AriaRole.Slider, new() { Name = "Move along x" }).PressAsync("ArrowRight");
        await w.Text("all three have moved", t => new[] { "[1.45, 1, 0]", "[-0.85, 0.9, 1.3]", "[-0.45, 0.6, -1.1]" }.All(t.Contains));
        await w.Page.Keyboard.PressAsync("Control+z");
        await w.Text("one step takes them back", t => t == before);
        await w.Page.Keyboard.PressAsync("Control+d");
        await w.Text("all three have copies", t => new[] { "chrome ball 2", "glass ball 2", "red ball 2" }.All(t.Contains));
        await Expect(Row("red ball 2")).ToHaveAttributeAsync("aria-selected", "true");
        await w.Page.Keyboard.PressAsync("Delete");
        await w.Text("the copies are gone", t => !t.Contains("ball 2", StringComparison.Ordinal));
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task A_colour_that_is_edited_shows()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");
        await w.Painted();
        await w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("^floor.*diffuse") }).ClickAsync();
        ILocator name = w.Page.GetByRole(AriaRole.Combobox, new() { NameRegex = new("name of a colour") }).First;
        await name.FillAsync("teal");
        await name.PressAsync("Enter");
        await w.Text("the colour is written", t => t.Contains("\"floor\": { \"type\": \"diffuse\", \"color\": \"teal\" }", StringComparison.Ordinal));
        await w.Painted();
    }

    [SkippableFact]
    public async Task Things_are_added_duplicated_renamed_and_deleted_by_keys()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        string before = w.Session.Document.Text;
        await w.Choose("Add", "Shape", "box");
        await w.Text("a box is there", t => t.Contains("\"box\"", StringComparison.Ordinal));
        string withBox = w.Session.Document.Text;
        await Expect(w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("^box.*box") })).ToHaveAttributeAsync("aria-selected", "true");

        await w.Stage.FocusAsync();
        await w.Page.Keyboard.PressAsync("Control+d");
        await w.Text("two are there", t => t.Split("\"type\": \"box\"").Length == 3);
        await Expect(w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("^box.*box") })).ToHaveCountAsync(2);
        await w.Page.Keyboard.PressAsync("F2");
        await w.Page.GetByRole(AriaRole.Textbox, new() { Name = "New name" }).FillAsync("twin");
        await w.Page.Keyboard.PressAsync("Enter");
        await w.Text("it has its name", t => t.Contains("\"twin\"", StringComparison.Ordinal));
        await Expect(w.Page.GetByRole(AriaRole.Dialog)).ToHaveCountAsync(0);
        await Expect(w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("^twin") })).ToHaveAttributeAsync("aria-selected", "true");
        await w.Stage.FocusAsync();
        await w.Page.Keyboard.PressAsync("Delete");
        await w.Text("it is gone", t => !t.Contains("\"twin\"", StringComparison.Ordinal));
        for (int i = 0; i < 4; i++)
        {
            await w.Page.Keyboard.PressAsync("Control+z");
        }

        await w.Text("undo goes back to the beginning", t => t == before);
        Assert.NotEqual(before, withBox);
    }

    [SkippableFact]
    public async Task Things_are_put_where_one_clicks_given_materials_hidden_and_locked()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");
        await w.Painted();
        string before = w.Session.Document.Text;
        ILocator Row(string name) => w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new($"^{name}") });

        // On the floor, where the right button was pressed.
        (float x, float y) = await w.Point(0.25, 0.85);
        await w.Page.Mouse.ClickAsync(x, y, new() { Button = MouseButton.Right });
        await Expect(w.Page.GetByRole(AriaRole.Menu, new() { Name = "What can be done here" })).ToBeVisibleAsync();
        await w.Page.Keyboard.PressAsync("ArrowRight");
        ILocator shapes = w.Page.GetByRole(AriaRole.Menu, new() { Name = "Add here: Shape" }).GetByRole(AriaRole.Menuitem);
        await Expect(shapes.First).ToBeFocusedAsync();
        await Expect(shapes.Last).ToBeInViewportAsync(new() { Ratio = 1 });
        await w.Page.Keyboard.PressAsync("ArrowLeft");
        await Expect(shapes).ToHaveCountAsync(0);
        await w.Page.Keyboard.PressAsync("Enter");
        await Expect(shapes.First).ToBeFocusedAsync();
        await w.Painted();
        await w.Shot("here", isShown: true);
        await w.Page.GetByRole(AriaRole.Menuitem, new() { Name = "box", Exact = true }).ClickAsync();
        await w.Text("a box stands there, of a material with a name", t => t.Contains("\"box\"", StringComparison.Ordinal) && t.Contains("\"material\": \"matt\"", StringComparison.Ordinal));
        await w.Painted();
        await w.Shot("added");
        await w.Page.Keyboard.PressAsync("Control+z");
        await w.Text("one step takes it away", t => t == before);

        // The material of the red ball is dragged onto the chrome ball, and given to both others.
        (float ballX, float ballY) = await w.Point(0.66, 0.56);
        LocatorBoundingBoxResult stage = (await w.Stage.BoundingBoxAsync())!;
        await Row("red.*diffuse").DragToAsync(w.Stage, new() { TargetPosition = new() { X = ballX - stage.X, Y = ballY - stage.Y } });
        await w.Text("the chrome ball is red", t => t.Contains("\"radius\": 1, \"material\": \"red\"", StringComparison.Ordinal));
        await w.Page.Keyboard.PressAsync("Control+z");
        await Row("glass ball").ClickAsync();
        await Row("chrome.*phongMetal").ClickAsync(new() { Modifiers = [KeyboardModifier.Control] });
        await w.Button("Apply to selected").ClickAsync();
        await w.Text("the glass ball is of chrome", t => t.Split("\"material\": \"chrome\"").Length == 3);

        // Hidden and locked, by keys that follow at once.
        await Row("chrome ball").ClickAsync();
        await w.Page.Keyboard.PressAsync("l");
        await w.Page.Keyboard.PressAsync("h");
        await Expect(w.Page.GetByText("Hidden: 1")).ToBeVisibleAsync();
        await Expect(Row("chrome ball.*hidden.*locked")).ToBeVisibleAsync();
        await w.Painted();
        await w.Shot("hidden", isShown: true);
        await w.Page.SetViewportSizeAsync(900, 700);
        await Expect(w.Page.GetByRole(AriaRole.Complementary)).ToHaveCountAsync(0);
        await w.Painted();
        await w.Shot("hidden-900");
        await w.Page.SetViewportSizeAsync(1280, 800);
        await w.Button("Show all").ClickAsync();
        await Expect(w.Page.GetByText("Hidden: 1")).ToHaveCountAsync(0);
        await w.Painted();
        await Row("red ball").ClickAsync();
        await w.Click(0.66, 0.56);
        await Expect(Row("chrome ball")).ToHaveAttributeAsync("aria-selected", "false");
        await w.Tab("Render");
        await w.Page.GetByText(new System.Text.RegularExpressions.Regex("Without effect now: .*merge radius")).ClickAsync();
        await Expect(w.Page.GetByText("Only with the integrator photons or vcm.")).ToBeVisibleAsync();
        await w.Page.GetByText("Only with the integrator photons or vcm.").ScrollIntoViewIfNeededAsync();
        await w.Shot("idle", isShown: true);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task A_shape_is_moved_by_its_handle()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");
        await w.Painted();
        await w.Click(0.66, 0.56);
        await w.Button("Move").ClickAsync();
        ILocator handle = w.Page.Locator(".gizmo [data-handle=x]").First;
        LocatorBoundingBoxResult box = (await handle.BoundingBoxAsync())!;
        await w.Shot("gizmo", isShown: true);
        string before = w.Session.Document.Text;
        (float x, float y) = (box.X + (box.Width * 0.8f), box.Y + (box.Height / 2));
        await w.Page.Mouse.MoveAsync(x, y);
        await w.Page.Mouse.DownAsync();
        await w.Page.Mouse.MoveAsync(x + 40, y, new() { Steps = 6 });
        await w.Page.Mouse.UpAsync();
        await w.Text("the ball has moved along x", t => t != before && t.Contains(", 1, 0], \"radius\": 1, \"material\": \"chrome\"", StringComparison.Ordinal));
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task A_click_with_the_focus_tool_makes_sharp_what_is_there()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/15-depth-of-field");
        await w.Painted();
        string before = w.Session.Document.Text;
        await w.Button("Focus").ClickAsync();
        await w.Click(0.3, 0.6);
        await w.Text("the focus distance is another", t => t != before && t.Contains("focusDistance", StringComparison.Ordinal));
    }
}
