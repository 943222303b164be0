using Microsoft.Playwright;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>The window at the sizes of a small laptop, of half a screen and of a large one.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class LayoutWalks(ChromiumBrowser browser)
{
    [SkippableFact]
    public async Task Toolbars_have_one_row_each_and_nothing_is_clipped()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");
        foreach ((int width, int height, ColorScheme scheme) in new[] { (1280, 800, ColorScheme.Light), (900, 700, ColorScheme.Dark), (1920, 1080, ColorScheme.Light) })
        {
            // As a window of this size is first seen.
            await w.Page.SetViewportSizeAsync(width, height);
            await w.Page.EmulateMediaAsync(new() { ColorScheme = scheme });
            await w.Page.EvaluateAsync("() => { localStorage.clear(); localStorage.setItem('studio.tourSeen', 'true'); }");
            await w.Page.ReloadAsync();
            await Check(w, width);
        }
    }

    private static async Task Check(StudioWindow w, int width)
    {
        await w.Painted();
        await w.Shot($"layout-{width}");
        Assert.Equal(0, await w.Page.EvaluateAsync<int>("() => document.documentElement.scrollWidth - innerWidth"));
        foreach (string bar in new[] { "Main toolbar", "Picture tools" })
        {
            int rows = await w.Page.GetByRole(AriaRole.Toolbar, new() { Name = bar }).EvaluateAsync<int>(
                "bar => new Set([...bar.children].filter(c => c.getClientRects().length).map(c => { const b = c.getBoundingClientRect(); return Math.round((b.top + b.bottom) / 16); })).size");
            Assert.True(rows == 1, $"The toolbar \"{bar}\" has {rows} rows.");
        }

        await Opened(w);
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

    // Menus and what else opens stand in the window, and hold what is in them.
    private static async Task Opened(StudioWindow w)
    {
        foreach (string menu in new[] { "File", "Add", "More commands", "Help" })
        {
            await w.Page.GetByRole(AriaRole.Toolbar, new() { Name = "Main toolbar" }).GetByRole(AriaRole.Button, new() { Name = menu, Exact = true }).ClickAsync();
            await Expect(w.Page.GetByRole(AriaRole.Menu, new() { Name = menu, Exact = true })).ToBeInViewportAsync(new() { Ratio = 1 });
            await w.Page.Keyboard.PressAsync("Escape");
        }

        await w.Button("Display").ClickAsync();
        ILocator display = w.Page.GetByRole(AriaRole.Group, new() { Name = "Display", Exact = true });
        await Expect(display).ToBeInViewportAsync(new() { Ratio = 1 });
        Assert.Empty(await display.EvaluateAsync<string[]>(
            "d => [...d.querySelectorAll('.number, select, input')].filter(e => e.getBoundingClientRect().right > d.getBoundingClientRect().right).map(e => e.outerHTML)"));
        await w.Page.Keyboard.PressAsync("Escape");
    }

    [SkippableFact]
    public async Task Keys_show_a_sheet_of_all_keys_and_the_picture_alone()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        await w.Stage.FocusAsync();
        await w.Page.Keyboard.PressAsync("?");
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Name = "Keyboard shortcuts" })).ToBeVisibleAsync();
        await w.Shot("shortcuts");
        await w.Page.Keyboard.PressAsync("Escape");
        await Expect(w.Page.GetByRole(AriaRole.Dialog)).ToHaveCountAsync(0);
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
