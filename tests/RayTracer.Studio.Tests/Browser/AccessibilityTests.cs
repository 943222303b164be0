using Microsoft.Playwright;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>What axe-core, an independent checker, finds serious: nothing. It comes with the front end's packages, where those are installed.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class AccessibilityTests(ChromiumBrowser browser)
{
    [SkippableFact]
    public async Task Axe_finds_nothing_serious_in_light_and_dark_colours()
    {
        string axe = ProjectFolder.PathOf("src", "RayTracer.Studio", "frontend", "node_modules", "axe-core", "axe.min.js");
        Skip.IfNot(File.Exists(axe), "axe-core is not installed: run \"npm ci\" in src/RayTracer.Studio/frontend");
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2", new() { ColorScheme = ColorScheme.Light, BypassCSP = true }, samples: 16);
        await w.Page.AddScriptTagAsync(new() { Path = axe });
        await w.Painted();
        await Check("scene", w.Page.Locator(":root"));
        await w.Click(0.66, 0.56);
        await Expect(w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("chrome ball") })).ToHaveAttributeAsync("aria-selected", "true");
        await w.Stage.FocusAsync();
        await w.Page.Keyboard.PressAsync("h");
        await w.Page.Keyboard.PressAsync("l");
        await Expect(w.Page.GetByText("Hidden: 1")).ToBeVisibleAsync();
        await Check("hidden", w.Page.Locator(":root"));
        await w.Page.Keyboard.PressAsync("Shift+F10");
        await Expect(w.Page.GetByRole(AriaRole.Menuitem).First).ToBeFocusedAsync();
        await Check("menu", w.Page.GetByRole(AriaRole.Menu));
        await w.Page.Keyboard.PressAsync("Escape");
        await Expect(w.Stage).ToBeFocusedAsync();
        await w.Page.Keyboard.PressAsync("Shift+H");
        foreach (string tab in new[] { "Light paths", "Heat maps", "Convergence", "Gallery", "Files", "Camera", "Render", "World" })
        {
            // Around it nothing has changed.
            await w.Tab(tab);
            await Check(tab, w.Page.GetByRole(AriaRole.Tabpanel, new() { Name = tab, Exact = true }));
        }

        await w.Stage.FocusAsync();
        await w.Page.Keyboard.PressAsync("?");
        await Check("shortcuts", w.Page.GetByRole(AriaRole.Dialog));
        await w.Page.Keyboard.PressAsync("Escape");
        await w.Page.Keyboard.PressAsync("F1");
        await Expect(w.Page.GetByRole(AriaRole.Article)).ToContainTextAsync("The picture");
        await Check("help", w.Page.GetByRole(AriaRole.Dialog));
        await w.Page.Keyboard.PressAsync("Escape");
        w.Session.Files.Open(ProjectFolder.PathOf("scenes", "animation", "01-turn.json"));
        await w.Page.GetByRole(AriaRole.Button, new() { NameRegex = new("camera.position: key at frame 0") }).ClickAsync();
        await w.Painted();
        await Check("timeline", w.Page.Locator(":root"));

        // Last, as it has the processor measured.
        await w.Tab("Times");
        await Check("times", w.Page.GetByRole(AriaRole.Tabpanel, new() { Name = "Times" }));
    }

    // What is found in a part of the page; in dark colours nothing but the contrast can be different.
    private static async Task Check(string what, ILocator part)
    {
        foreach (ColorScheme scheme in new[] { ColorScheme.Dark, ColorScheme.Light })
        {
            string[]? rules = scheme == ColorScheme.Dark ? ["color-contrast"] : null;
            await part.Page.EmulateMediaAsync(new() { ColorScheme = scheme });
            string[] found = await part.EvaluateAsync<string[]>(
                """
                async (part, rules) => (await axe.run(part, { resultTypes: ['violations'], ...(rules && { runOnly: rules }) })).violations
                    .filter(v => v.impact === 'serious' || v.impact === 'critical')
                    .map(v => `${v.id}: ${v.help}: ${v.nodes.slice(0, 3).map(n => n.html.slice(0, 120)).join(' | ')}`)
                """,
                rules);
            Assert.True(found.Length == 0, $"{what}, {scheme}: {string.Join("\n", found)}");
        }
    }
}
