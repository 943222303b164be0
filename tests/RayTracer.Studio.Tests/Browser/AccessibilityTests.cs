using Microsoft.Playwright;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>What axe-core, an independent checker, finds serious: nothing. It comes with the front end's packages, where those are installed.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class AccessibilityTests(ChromiumBrowser browser)
{
    [SkippableTheory]
    [InlineData(ColorScheme.Light)]
    [InlineData(ColorScheme.Dark)]
    public async Task Axe_finds_nothing_serious(ColorScheme scheme)
    {
        string axe = ProjectFolder.PathOf("src", "RayTracer.Studio", "frontend", "node_modules", "axe-core", "axe.min.js");
        Skip.IfNot(File.Exists(axe), "axe-core is not installed: run \"npm ci\" in src/RayTracer.Studio/frontend");
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2", new() { ColorScheme = scheme, BypassCSP = true });
        await w.Painted();
        await Check("scene", w, axe);
        await w.Click(0.66, 0.56);
        await Expect(w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("chrome ball") })).ToHaveAttributeAsync("aria-selected", "true");
        await w.Stage.FocusAsync();
        await w.Page.Keyboard.PressAsync("h");
        await w.Page.Keyboard.PressAsync("l");
        await Expect(w.Page.GetByText("Hidden: 1")).ToBeVisibleAsync();
        await Check("hidden", w, axe);
        await w.Page.Keyboard.PressAsync("Shift+F10");
        await Expect(w.Page.GetByRole(AriaRole.Menuitem).First).ToBeFocusedAsync();
        await Check("menu", w, axe);
        await w.Page.Keyboard.PressAsync("Escape");
        await Expect(w.Stage).ToBeFocusedAsync();
        await w.Page.Keyboard.PressAsync("Shift+H");
        foreach (string tab in new[] { "Light paths", "Heat maps", "Convergence", "Times", "Gallery", "Files", "Camera", "Render", "World" })
        {
            await w.Tab(tab);
            await Check(tab, w, axe);
        }

        await w.Stage.FocusAsync();
        await w.Page.Keyboard.PressAsync("?");
        await Check("shortcuts", w, axe);
        await w.Page.Keyboard.PressAsync("Escape");
        await w.Page.Keyboard.PressAsync("F1");
        await Expect(w.Page.GetByRole(AriaRole.Article)).ToContainTextAsync("The picture");
        await Check("help", w, axe);
        await w.Page.Keyboard.PressAsync("Escape");
        w.Session.Files.Open(ProjectFolder.PathOf("scenes", "animation", "01-turn.json"));
        await w.Page.GetByRole(AriaRole.Button, new() { NameRegex = new("camera.position: key at frame 0") }).ClickAsync();
        await w.Painted();
        await Check("timeline", w, axe);
    }

    private static async Task Check(string what, StudioWindow w, string axe)
    {
        await w.Page.AddScriptTagAsync(new() { Path = axe });
        string[] found = await w.Page.EvaluateAsync<string[]>(
            """
            async () => (await axe.run({ resultTypes: ['violations'] })).violations
                .filter(v => v.impact === 'serious' || v.impact === 'critical')
                .map(v => `${v.id}: ${v.help}: ${v.nodes.slice(0, 3).map(n => n.html.slice(0, 120)).join(' | ')}`)
            """);
        Assert.True(found.Length == 0, $"{what}: {string.Join("\n", found)}");
    }
}
