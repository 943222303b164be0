using Microsoft.Playwright;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>Somebody does not know what a thing is, and finds out without leaving the window.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class HelpWalks(ChromiumBrowser browser)
{
    [SkippableFact]
    public async Task F1_leads_to_the_page_of_what_is_looked_at_and_a_lesson_opens_its_scene()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");
        await w.Painted();
        ILocator page = w.Page.GetByRole(AriaRole.Article);
        ILocator back = w.Button("Back");

        // A thing: the section of its type is in sight.
        await w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("chrome ball") }).ClickAsync();
        await w.Page.Keyboard.PressAsync("F1");
        await Expect(page.Locator("#sphere")).ToBeInViewportAsync();
        await w.Shot("help-type");
        Assert.Equal("#help=scene-format&section=sphere", await w.Page.EvaluateAsync<string>("location.hash"));
        await w.Page.Keyboard.PressAsync("Escape");
        await Expect(w.Page.GetByRole(AriaRole.Dialog)).ToHaveCountAsync(0);
        Assert.Equal("", await w.Page.EvaluateAsync<string>("location.hash"));

        // A link opens the page.
        await w.Page.EvaluateAsync("location.hash = '#help=studio&section=films'");
        await Expect(page.Locator("#films")).ToBeInViewportAsync();
        await w.Page.Keyboard.PressAsync("Escape");

        // From within a dialog, which keeps what was typed.
        await w.Page.Keyboard.PressAsync("Control+Shift+S");
        ILocator name = w.Page.GetByRole(AriaRole.Dialog).GetByRole(AriaRole.Textbox).First;
        await name.FillAsync("kept.json");
        await w.Page.Keyboard.PressAsync("F1");
        await Expect(page.Locator("#save")).ToBeInViewportAsync();
        await w.Page.Keyboard.PressAsync("Escape");
        await Expect(name).ToHaveValueAsync("kept.json");
        await w.Page.Keyboard.PressAsync("Escape");

        // Search, a finding, and the way back.
        await w.Stage.FocusAsync();
        await w.Page.Keyboard.PressAsync("F1");
        await w.Page.GetByRole(AriaRole.Searchbox, new() { Name = "Search the help" }).FillAsync("snell");
        await w.Page.GetByRole(AriaRole.Button, new() { NameRegex = new("What happens to the light.*Why does glass") }).ClickAsync();
        await Expect(page.Locator("h1")).ToHaveTextAsync("7. Why does glass turn pictures upside down?");
        await StudioWindow.Until("its picture is there", () => page.Locator("img").First.EvaluateAsync<bool>("i => i.naturalWidth > 0"));
        await page.Locator("img").First.ScrollIntoViewIfNeededAsync();
        await w.Shot("help", isShown: true);
        await back.ClickAsync();
        await Expect(page.Locator("h1")).ToHaveTextAsync("The Studio");
        await w.Page.GetByRole(AriaRole.Searchbox, new() { Name = "Search the help" }).FillAsync("qwertz");
        await Expect(w.Page.GetByText("Nothing has all these words.")).ToBeVisibleAsync();
        await w.Page.GetByRole(AriaRole.Searchbox, new() { Name = "Search the help" }).FillAsync("");

        // A lesson's link opens its scene.
        await w.Page.GetByRole(AriaRole.Navigation, new() { Name = "Pages" }).GetByRole(AriaRole.Button, new() { NameRegex = new("^7\\. Why") }).ClickAsync();
        await page.GetByRole(AriaRole.Link, new() { Name = "the scene file" }).ClickAsync();
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Level = 1, Name = "07-refraction.json" })).ToBeVisibleAsync();
        await Expect(w.Page.GetByRole(AriaRole.Dialog)).ToHaveCountAsync(0);
    }

    [SkippableFact]
    public async Task A_lesson_stands_beside_its_scene_and_its_changes_are_tried()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2", new() { ViewportSize = new() { Width = 1280, Height = 800 } });
        await w.Painted();
        await w.Stage.FocusAsync();
        await w.Page.Keyboard.PressAsync("F1");
        await w.Page.GetByRole(AriaRole.Navigation, new() { Name = "Pages" }).GetByRole(AriaRole.Button, new() { NameRegex = new("^3\\. ") }).ClickAsync();
        await w.Button("Read this lesson beside its scene").ClickAsync();
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Level = 1, Name = "03-soft-shadows.json" })).ToBeVisibleAsync();
        ILocator lesson = w.Page.GetByRole(AriaRole.Complementary, new() { Name = "Scene and files" });

        // One change of two values, which is one step to undo.
        ILocator lamp = lesson.GetByRole(AriaRole.Link, new() { NameRegex = new("0\\.02") }).First;
        await lamp.ClickAsync();
        await w.Text("both values are set", text => text.Contains("\"radius\": 0.02", StringComparison.Ordinal) && text.Contains("\"multiplier\": 15925", StringComparison.Ordinal));
        await Expect(w.Status).ToContainTextAsync("done");
        await w.Shot("lesson", isShown: true);
        await w.Button("Undo").ClickAsync();
        await w.Text("neither is", text => !text.Contains("0.02,", StringComparison.Ordinal) && !text.Contains("15925", StringComparison.Ordinal));

        // From another scene, the lesson's is opened first.
        await w.Tab("Gallery");
        await w.Page.GetByRole(AriaRole.Button, new() { NameRegex = new("cornell", System.Text.RegularExpressions.RegexOptions.IgnoreCase) }).First.ClickAsync();
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Level = 1, NameRegex = new("cornell") })).ToBeVisibleAsync();
        await w.Tab("Lesson");
        await lamp.ClickAsync();
        await w.Text("the lesson's scene is changed", text => text.Contains("15925", StringComparison.Ordinal));
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Level = 1, Name = "03-soft-shadows.json" })).ToBeVisibleAsync();
        await w.Button("Close the lesson").ClickAsync();
        await Expect(w.Page.GetByRole(AriaRole.Tab, new() { Name = "Lesson" })).ToHaveCountAsync(0);
    }
}
