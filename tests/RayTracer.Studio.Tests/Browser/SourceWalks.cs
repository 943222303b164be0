using Microsoft.Playwright;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>What students do with the scene's text.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class SourceWalks(ChromiumBrowser browser)
{
    [SkippableFact]
    public async Task What_is_typed_is_rendered_and_what_is_wrong_is_shown_and_reached()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");
        await w.Painted();
        await Find(w, "\"chrome\": {");
        await w.Page.Keyboard.PressAsync("End");
        await w.Page.Keyboard.TypeAsync("x");

        ILocator problem = w.Page.GetByRole(AriaRole.Button, new() { NameRegex = new("unknown word") }).First;
        await Expect(problem).ToBeVisibleAsync();
        await Expect(w.Page.GetByText("The text has an error: this is the last valid picture.")).ToBeVisibleAsync();
        Assert.NotNull(w.Session.Document.Content.LastGood);
        await w.Shot("source-error", isShown: true);
        await problem.ClickAsync();
        await w.Page.Keyboard.PressAsync("Control+z");
        await Expect(w.Page.GetByText("The text has an error: this is the last valid picture.")).ToHaveCountAsync(0);
    }

    [SkippableFact]
    public async Task Keys_and_words_are_completed_from_the_schema()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        await Find(w, "\"render\": {");
        await w.Page.Keyboard.PressAsync("ArrowRight");
        await w.Page.Keyboard.TypeAsync(" \"maxD");
        await Expect(w.Page.GetByRole(AriaRole.Option, new() { NameRegex = new("maxDiffuseDepth") })).ToBeVisibleAsync();
        await w.Shot("completion", isShown: true);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task A_malformed_scene_typed_character_by_character_keeps_the_last_good_picture()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");

        // Where all text is replaced, Chromium tries to keep its looks by styles of its own, which the page's policy rightly forbids.
        w.Expected.Add("Applying inline style");
        await w.Painted();
        int painted = await w.Data("painted");
        await w.Page.Locator(".cm-content").ClickAsync();
        await w.Page.Keyboard.PressAsync("Control+a");
        await w.Page.Keyboard.TypeAsync("{ \"camera\": { \"position\": [0, 1e999, \"x\"], }, \"shapes\": [ { \"type\": \"sphre\" ", new() { Delay = 5 });
        await StudioWindow.Until("all is typed", () => Task.FromResult(w.Session.Document.Text.Contains("sphre", StringComparison.Ordinal)));
        Assert.NotNull(w.Session.Document.Content.LastGood);
        await Expect(w.Canvas).ToBeVisibleAsync();
        Assert.True(await w.Data("painted") >= painted);
        await w.Page.GetByRole(AriaRole.Button, new() { NameRegex = new("problem") }).First.ClickAsync();
        await Expect(w.Page.GetByText("The text has an error: this is the last valid picture.")).ToBeVisibleAsync();
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task A_source_that_is_left_before_its_text_comes_makes_no_trouble()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        await w.Tab("Times");

        // The text comes when its place has just been taken out of the window.
        await w.Page.EvaluateAsync(
            """
            () => {
                const real = window.fetch;
                window.fetch = async (...request) => {
                    const answer = await real(...request);
                    if (request[0] !== '/api/document') return answer;
                    window.fetch = real;
                    const text = await answer.text();
                    document.body.dataset.waits = 'true';
                    await new Promise(isGone => {
                        const watch = () => document.querySelector('.source') || (delete document.body.dataset.waits, isGone());
                        new MutationObserver(watch).observe(document.body, { childList: true, subtree: true });
                    });
                    return { ok: true, json: async () => JSON.parse(text) };
                };
            }
            """);
        await w.Tab("Source");
        await Expect(w.Page.Locator("body[data-waits]")).ToHaveCountAsync(1);
        await w.Tab("Times");
        await Expect(w.Page.Locator("body[data-waits]")).ToHaveCountAsync(0);
        await w.Tab("Source");
        await Expect(w.Page.Locator(".cm-content")).ToContainTextAsync("sphere");
    }

    // Selects a text in the editor.
    private static async Task Find(StudioWindow w, string text)
    {
        await w.Page.Locator(".cm-content").ClickAsync();
        await w.Page.Keyboard.PressAsync("Control+Home");
        await w.Page.Keyboard.PressAsync("Control+f");
        await w.Page.Keyboard.TypeAsync(text);
        await w.Page.Keyboard.PressAsync("Enter");
        await w.Page.Keyboard.PressAsync("Escape");
    }
}
