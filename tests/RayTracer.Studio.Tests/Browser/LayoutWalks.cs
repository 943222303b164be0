using Microsoft.Playwright;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>The window at the sizes of a small laptop, of half a screen and of a large one.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class LayoutWalks(ChromiumBrowser browser)
{
    [SkippableTheory]
    [InlineData(1280, 800, ColorScheme.Light)]
    [InlineData(900, 700, ColorScheme.Dark)]
    [InlineData(1920, 1080, ColorScheme.Light)]
    public async Task Toolbars_have_one_row_each_and_nothing_is_clipped(int width, int height, ColorScheme scheme)
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2", new() { ViewportSize = new() { Width = width, Height = height }, ColorScheme = scheme });
        await w.Painted();
        await w.Shot($"layout-{width}");
        Assert.Equal(0, await w.Page.EvaluateAsync<int>("() => document.documentElement.scrollWidth - innerWidth"));
        foreach (string bar in new[] { "Main toolbar", "Picture tools" })
        {
            int rows = await w.Page.GetByRole(AriaRole.Toolbar, new() { Name = bar }).EvaluateAsync<int>(
                "bar => new Set([...bar.children].filter(c => c.getClientRects().length).map(c => { const b = c.getBoundingClientRect(); return Math.round((b.top + b.bottom) / 16); })).size");
            Assert.True(rows == 1, $"The toolbar \"{bar}\" has {rows} rows.");
        }

        LocatorBoundingBoxResult picture = (await w.Canvas.BoundingBoxAsync())!;
        Assert.True(width > 1000 || picture.Width >= 480, $"The picture is {picture.Width} pixels wide.");
        if (!await w.Page.GetByRole(AriaRole.Tab, new() { Name = "Render", Exact = true }).IsVisibleAsync())
        {
            await w.Button("Properties pane").ClickAsync();
        }

        await w.Tab("Render");
        await Expect(w.Page.GetByRole(AriaRole.Radio, new() { Name = "As written" })).ToBeVisibleAsync();
        await w.Shot($"layout-render-{width}");
        string[] cut = await w.Page.EvaluateAsync<string[]>(
            "() => [...document.querySelectorAll('[role=radio], [role=tab], .button')].filter(e => e.getClientRects().length && e.scrollWidth > e.clientWidth + 1).map(e => e.textContent)");
        Assert.Empty(cut);
    }

    [SkippableFact]
    public async Task One_key_shows_the_picture_alone_and_again_everything()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        await w.Stage.FocusAsync();
        await w.Page.Keyboard.PressAsync("m");
        foreach (ILocator gone in new[] { w.Page.GetByRole(AriaRole.Toolbar), w.Page.GetByRole(AriaRole.Complementary), w.Status })
        {
            await Expect(gone).ToHaveCountAsync(0);
        }

        await Expect(w.Stage).ToBeVisibleAsync();
        await w.Shot("picture-alone");
        await w.Button("Picture alone").ClickAsync();
        await Expect(w.Page.GetByRole(AriaRole.Toolbar, new() { Name = "Main toolbar" })).ToBeVisibleAsync();
        await w.Stage.FocusAsync();
        await w.Page.Keyboard.PressAsync("m");
        await Expect(w.Page.GetByRole(AriaRole.Toolbar)).ToHaveCountAsync(0);
        await w.Page.Keyboard.PressAsync("Escape");
        await Expect(w.Status).ToBeVisibleAsync();
    }
}
