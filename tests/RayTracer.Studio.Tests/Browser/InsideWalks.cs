using System.Text.RegularExpressions;
using Microsoft.Playwright;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>How students see how a picture came about.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class InsideWalks(ChromiumBrowser browser)
{
    [SkippableFact]
    public async Task The_paths_of_a_clicked_pixel_are_listed_and_drawn()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2", new() { ViewportSize = new() { Width = 1440, Height = 900 } });
        await w.Painted(2);
        await w.Button("Inspect a pixel").ClickAsync();

        // The glass ball: refraction, then more.
        await w.Click(0.36, 0.6);
        ILocator table = w.Page.GetByRole(AriaRole.Region, new() { Name = "Vertices of the path" });
        await Expect(table).ToContainTextAsync("glass ball");
        await Expect(table).ToContainTextAsync("specular");
        await Expect(w.Page.GetByRole(AriaRole.Application, new() { NameRegex = new("Paths in the scene") })).ToBeVisibleAsync();

        // The table's last column is the picture's, too.
        await w.Button("Properties pane").ClickAsync();
        await Expect(table.GetByRole(AriaRole.Columnheader).Last).ToBeInViewportAsync();
        await w.Shot("paths", isShown: true);

        // Neither the path nor its pixel is another picture's.
        await Expect(w.Page.Locator(".path-overlay")).ToHaveCountAsync(1);
        await w.Tab("Source");
        await Expect(w.Page.Locator(".path-overlay")).ToHaveCountAsync(0);
        await w.Tab("Light paths");
        await Expect(w.Page.Locator(".path-overlay")).ToHaveCountAsync(1);
        await w.Button("Properties pane").ClickAsync();
        w.Session.Files.Open(ProjectFolder.PathOf("scenes", "primer", "01-sphere.json"));
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Level = 1, Name = "01-sphere.json" })).ToBeVisibleAsync();
        await Expect(w.Page.Locator(".path-overlay")).ToHaveCountAsync(0);
        await StudioWindow.Until("the address names no pixel", async () => await w.Page.EvaluateAsync<string>("location.hash") == "");
    }

    [SkippableFact]
    public async Task A_vertex_opens_into_its_equation_and_bars_sum_up_the_samples()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "cornell", new() { ViewportSize = new() { Width = 1280, Height = 800 } });
        await w.Painted(2);

        // A link to a pixel and a sample opens the same view.
        await w.Page.EvaluateAsync("location.hash = '#pixel=40,90&sample=3'");
        ILocator table = w.Page.GetByRole(AriaRole.Region, new() { Name = "Vertices of the path" });
        await Expect(table.GetByText("Sample 3", new() { Exact = true })).ToBeVisibleAsync();
        await Expect(table.GetByRole(AriaRole.Columnheader).Last).ToBeInViewportAsync(new() { Ratio = 1 });
        await Expect(table.Locator(".sentence")).ToContainTextAsync("ight");

        await table.GetByRole(AriaRole.Button, new() { Name = "Vertex 1: the equation" }).ClickAsync();
        await Expect(table.Locator(".equation")).ToContainTextAsync("Asks the lights");
        await Expect(table.GetByRole(AriaRole.Columnheader).Last).ToBeInViewportAsync(new() { Ratio = 1 });
        await Expect(w.Page.Locator(".path-overlay line").First).ToBeAttachedAsync();
        await w.Shot("path-equation", isShown: true);

        // What is pointed at in the list or over the picture is marked in the others, too.
        ILocator asked = table.Locator(".equation li").First;
        ILocator line = w.Page.Locator(".path-overlay line.asked").First;
        await asked.HoverAsync();
        await Expect(line).ToHaveClassAsync(new Regex("marked"));
        await w.Page.Mouse.MoveAsync(0, 0);
        await Expect(line).Not.ToHaveClassAsync(new Regex("marked"));
        await line.DispatchEventAsync("pointerenter");
        await Expect(asked).ToHaveClassAsync(new Regex("pointed"));
        await w.Page.Locator(".path-overlay circle.grip").Nth(1).HoverAsync();
        await Expect(table.GetByRole(AriaRole.Row).Filter(new() { Has = w.Button("Vertex 2: the equation") })).ToHaveClassAsync(new Regex("pointed"));
        ILocator other = w.Page.GetByRole(AriaRole.List, new() { Name = "Samples" }).GetByRole(AriaRole.Button).First;
        await other.HoverAsync();
        await Expect(w.Page.Locator(".path-overlay g.pointed")).ToHaveCountAsync(1);

        // The link is of use on a slide, which knows no secret: another window gives it.
        IPage slide = await w.Page.Context.NewPageAsync();
        await slide.GotoAsync(w.Server.Address + "#pixel=40,90&sample=3");
        await Expect(slide.GetByRole(AriaRole.Region, new() { Name = "Vertices of the path" }).GetByText("Sample 3", new() { Exact = true })).ToBeVisibleAsync();
        await slide.CloseAsync();

        await w.Button("All samples").ClickAsync();
        await Expect(table.GetByText("By how it was found")).ToBeVisibleAsync();
        await Expect(table.GetByText("direct light", new() { Exact = true })).ToBeVisibleAsync();
        await w.Shot("path-bars", isShown: true);
        await StudioWindow.Until("the address names the pixel", async () => (await w.Page.EvaluateAsync<string>("location.hash")).StartsWith("#pixel=40,90&sample=", StringComparison.Ordinal));
    }

    [SkippableFact]
    public async Task The_textbook_edition_renders_and_a_ray_goes_through_its_trees()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2", new() { ViewportSize = new() { Width = 1280, Height = 800 } });
        await w.Painted(2);
        await w.Tab("Render");
        await w.Page.GetByLabel("Edition", new() { Exact = true }).SelectOptionAsync("textbook:whitted");
        await StudioWindow.Until("the textbook edition renders",
            () => Task.FromResult(w.Session.View is { Settings.Edition: "textbook:whitted", Loop.Status: { Samples: > 0, RaysPerSecond: 0 } }));

        await w.Button("Inspect a pixel").ClickAsync();
        await w.Click(0.36, 0.6);
        ILocator table = w.Page.GetByRole(AriaRole.Region, new() { Name = "Vertices of the path" });
        await Expect(table).ToContainTextAsync("glass ball");
        await Expect(table).ToContainTextAsync("branch");

        await w.Button("Trees").ClickAsync();
        await table.GetByLabel("Tree", new() { Exact = true }).SelectOptionAsync("boxes by area");
        ILocator status = table.GetByRole(AriaRole.Status);
        await Expect(status).ToContainTextAsync("Node 0 of");
        await w.Button("Next node").ClickAsync();
        await w.Button("Next node").ClickAsync();
        await Expect(status).ToContainTextAsync("Node 2 of");
        await table.GetByLabel("Node", new() { Exact = true }).PressAsync("End");
        await Expect(w.Button("Next node")).ToBeDisabledAsync();
        await w.Shot("trees", isShown: true);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task Where_light_is_traced_too_the_ways_of_a_pixel_are_listed_and_drawn()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "gallery/tea", new() { ViewportSize = new() { Width = 1440, Height = 900 } });
        await w.Painted();
        await w.Button("Inspect a pixel").ClickAsync();

        // The caustic on the table.
        await w.Click(0.434, 0.745);
        ILocator tables = w.Page.GetByRole(AriaRole.Region, new() { Name = "Vertices of the path" });
        ILocator ways = tables.GetByRole(AriaRole.Table, new() { Name = "How the light came, the brightest first" });
        await Expect(ways).ToContainTextAsync("merged", new() { Timeout = 60_000 });
        await w.Button("Properties pane").ClickAsync();
        ILocator first = ways.GetByRole(AriaRole.Button).First;
        await first.ClickAsync();
        await Expect(first).ToHaveAttributeAsync("aria-expanded", "true");
        await Expect(ways).ToContainTextAsync("light's part");
        await first.ScrollIntoViewIfNeededAsync();
        await w.Shot("ways", isShown: true);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task Every_map_is_shown_in_the_picture()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "meshes/02-smooth");
        await w.Painted();
        ILocator map = w.Page.GetByRole(AriaRole.Combobox, new() { Name = "Show", Exact = true });
        foreach (string name in new[] { "luminance", "samples", "error", "bvhCost", "depth", "normal", "albedo", "uv", "primitive", "light" })
        {
            int version = await w.Data("version");
            await map.SelectOptionAsync(name);
            await StudioWindow.Until($"{name} is painted", async () => await w.Data("version") > version);
            await StudioWindow.Until($"{name} is chosen", async () => await map.InputValueAsync() == name);
            await w.Shot("map-" + name, isShown: name == "bvhCost");
        }
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task Convergence_is_plotted_beside_the_theory()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene3", samples: null);
        await w.Painted(16);
        await w.Tab("Convergence");
        await Expect(w.Page.GetByText("Measured slope")).ToBeVisibleAsync();
        await w.Shot("convergence", isShown: true);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task The_reports_times_stand_beside_this_machines()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene3");
        await w.Painted();
        await w.Tab("Times");
        await Expect(w.Page.GetByText("Core 2 Duo")).ToBeVisibleAsync();
        await w.Shot("times");
    }
}
