using System.Text.RegularExpressions;
using Microsoft.Playwright;
using static Microsoft.Playwright.Assertions;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>What makes a window fit for every day.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
public class EverydayWalks(ChromiumBrowser browser)
{
    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task It_is_dark_or_light_as_the_system_is()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene1", new() { ColorScheme = ColorScheme.Dark }, samples: null);
        await w.Painted(2);
        async Task<bool> IsDark()
        {
            string colour = await w.Page.EvaluateAsync<string>("() => getComputedStyle(document.body).backgroundColor");
            return int.Parse(colour.Split('(', ',')[1], System.Globalization.CultureInfo.InvariantCulture) < 128;
        }

        Assert.True(await IsDark());
        await w.Shot("dark", isShown: true);
        await w.Page.EmulateMediaAsync(new() { ColorScheme = ColorScheme.Light });
        await StudioWindow.Until("it is light", async () => !await IsDark());
        await w.Shot("light");
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task At_twice_the_size_everything_can_be_reached()
    {
        // What a window of 1280×800 is at 200 % zoom.
        await using StudioWindow w = await StudioWindow.Open(
            browser, "report/scene2", new() { ViewportSize = new() { Width = 640, Height = 400 }, DeviceScaleFactor = 2 });
        await w.Painted();
        await w.Shot("zoom-200");
        Assert.Equal(0, await w.Page.EvaluateAsync<int>("() => document.documentElement.scrollWidth - innerWidth"));
        foreach (string pane in new[] { "Properties pane", "Scene and files pane", "Source and insight pane" })
        {
            await w.Button(pane).ClickAsync();
            await w.Shot("zoom-200-" + pane.Split(' ')[0].ToLowerInvariant());
            await w.Button(pane).ClickAsync();
        }
    }

    [SkippableFact]
    public async Task The_keyboard_alone_opens_a_scene_and_changes_a_number()
    {
        await using StudioWindow w = await StudioWindow.Open(browser);
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Name = "Render a scene" })).ToBeVisibleAsync();
        async Task Reach(Func<string, bool> isIt)
        {
            List<string> passed = [];
            for (int i = 0; i < 120; i++)
            {
                await w.Page.Keyboard.PressAsync("Tab");
                string name = await w.Page.EvaluateAsync<string>("() => (document.activeElement.getAttribute('aria-label') ?? document.activeElement.textContent ?? '') + ''");
                if (isIt(name))
                {
                    return;
                }

                passed.Add(name);
            }

            Assert.Fail($"The Tab key does not get there, but to {string.Join(", ", passed.Take(60))}.");
        }

        await Reach(n => n.StartsWith("Open ", StringComparison.Ordinal) && n.Contains("mirror", StringComparison.OrdinalIgnoreCase));
        await w.Page.Keyboard.PressAsync("Enter");
        await w.Painted();
        Assert.Contains("mirror", w.Session.Document.Status.Name, StringComparison.Ordinal);
        string before = w.Session.Document.Text;
        await w.Page.Keyboard.PressAsync("Control+Home");
        await Reach(n => n == "Object");
        await w.Page.Keyboard.PressAsync("ArrowRight");
        await w.Page.Keyboard.PressAsync("ArrowRight");
        await Reach(n => n == "Size");
        await w.Page.Keyboard.PressAsync("ArrowDown");
        await w.Text("the size is another", t => t != before);
    }

    [SkippableFact]
    public async Task Two_windows_show_the_same_scene()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        IPage other = await w.NewPage();
        await w.Choose("Add", "Shape", "torus");
        await Expect(other.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("torus") })).ToBeVisibleAsync();
        await other.GetByRole(AriaRole.Application, new() { NameRegex = new("Rendered picture") }).FocusAsync();
        await other.Keyboard.PressAsync("Control+z");
        await Expect(w.Page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("torus") })).ToHaveCountAsync(0);
    }

    [SkippableFact]
    public async Task A_page_with_a_wrong_secret_says_so_and_one_without_says_what_to_do_and_shows_nothing_else()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        w.Expected.Add("403");
        w.Expected.Add("401");
        await w.Page.EvaluateAsync("() => { sessionStorage.clear(); location.hash = 'token=wrong'; location.reload(); }");
        await Expect(w.Page.GetByText("This window belongs to an earlier run of the Studio.")).ToBeVisibleAsync();
        await w.Page.EvaluateAsync("() => { sessionStorage.clear(); location.hash = ''; location.reload(); }");
        await Expect(w.Page.GetByRole(AriaRole.Heading, new() { Name = "This window has no way in" })).ToBeVisibleAsync();
        await Expect(w.Page.GetByText("raytracer studio", new() { Exact = true })).ToBeVisibleAsync();
        await Expect(w.Page.GetByRole(AriaRole.Button)).ToHaveCountAsync(0);
    }

    [SkippableFact]
    public async Task Closing_a_window_over_a_running_job_asks_and_a_page_that_comes_back_shows_it()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        using ManualResetEventSlim end = new();
        try
        {
            w.Session.Jobs.Start("frames 0 to 5", (progress, _) =>
            {
                progress.Report(0.5);
                end.Wait(CancellationToken.None);
                return "wrote 6 frames";
            });
            await Expect(w.Page.GetByRole(AriaRole.Progressbar, new() { Name = "frames 0 to 5" })).ToBeVisibleAsync();
            await w.Stage.ClickAsync();
            TaskCompletionSource<string> asked = new();
            w.Page.Dialog += async (_, dialog) =>
            {
                asked.TrySetResult(dialog.Type);
                await dialog.AcceptAsync();
            };
            await w.Page.CloseAsync(new() { RunBeforeUnload = true });
            Assert.Equal("beforeunload", await asked.Task.WaitAsync(TimeSpan.FromMinutes(1)));
            IPage again = await w.NewPage();
            await Expect(again.GetByRole(AriaRole.Progressbar, new() { Name = "frames 0 to 5" })).ToHaveAttributeAsync("value", "0.5");
        }
        finally
        {
            end.Set();
        }
    }

    [SkippableFact]
    public async Task Unsaved_changes_are_asked_about_and_offered_again_by_the_next_Studio()
    {
        DirectoryInfo user = Directory.CreateTempSubdirectory("studio-user-");
        try
        {
            string text;
            await using (StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere", user: user.FullName))
            {
                await w.Painted();
                await w.Drag(0.5, 0.5, 0.6, 0.5);
                await w.Page.Keyboard.PressAsync("Shift+Home");
                await StudioWindow.Until("there are changes", () => Task.FromResult(w.Session.Document.IsDirty));
                text = w.Session.Document.Text;
                await w.Tab("Gallery");
                await w.Page.GetByRole(AriaRole.Button, new() { NameRegex = new("Open .*glass") }).First.ClickAsync();
                await Expect(w.Page.GetByText("Save your changes first?")).ToBeVisibleAsync();
                await w.Shot("unsaved");
                await w.Button("Cancel").ClickAsync();
                Assert.Contains("01-sphere", w.Session.Document.Status.Name, StringComparison.Ordinal);
            }

            await using StudioWindow again = await StudioWindow.Open(browser, user: user.FullName);
            await again.Button("Recover").ClickAsync();
            await again.Text("the changes are back", t => t == text);
            await again.Painted();
        }
        finally
        {
            user.Delete(recursive: true);
        }
    }

    [SkippableFact]
    public async Task What_is_typed_while_the_Studio_is_gone_is_sent_when_it_is_back_or_merged_by_the_next_window()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        await TypeWithoutServer(w, "// typed in the dark");
        await w.Page.UnrouteAsync("**/api/document/text");
        await w.Page.UnrouteAsync("**/api/state*");
        await w.Text("it is there", t => t.StartsWith("// typed in the dark\n", StringComparison.Ordinal));
        await StudioWindow.Until("nothing is kept", async () => await w.Page.EvaluateAsync<bool>("() => localStorage.getItem('studio.unsent') === null"));

        await TypeWithoutServer(w, "// typed in another");
        IPage page = w.Page;
        await StudioWindow.Until("it is kept", async () => (await page.EvaluateAsync<string>("() => localStorage.getItem('studio.unsent') ?? ''")).Contains("typed in another", StringComparison.Ordinal));
        await page.CloseAsync();
        Assert.DoesNotContain("typed in another", w.Session.Document.Text, StringComparison.Ordinal);
        w.Session.Edits.Set("/shapes/0/radius", 0.5);
        IPage next = await w.NewPage();
        await next.GetByRole(AriaRole.Button, new() { Name = "Merge it in" }).ClickAsync();
        await w.Text("all changes are there", t => t.StartsWith("// typed in another\n// typed in the dark\n", StringComparison.Ordinal) && t.Contains("0.5", StringComparison.Ordinal));
        await StudioWindow.Until("nothing is kept any more", async () => await next.EvaluateAsync<bool>("() => localStorage.getItem('studio.unsent') === null"));

        // Without a server, a window says so.
        await w.Server.DisposeAsync();
        await Expect(next.GetByText("The Studio is not responding.")).ToBeVisibleAsync();
        await Expect(next.GetByRole(AriaRole.Contentinfo)).ToHaveTextAsync("not connected");
    }

    [SkippableFact]
    public async Task What_was_typed_while_the_Studio_was_gone_is_offered_where_another_scene_is_open()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere");
        await w.Painted();
        string file = w.Session.Document.Place.Path!;
        string before = w.Session.Document.Text;
        await TypeWithoutServer(w, "// typed in the dark");
        IPage page = w.Page;
        await StudioWindow.Until("it is kept", async () => (await page.EvaluateAsync<string>("() => localStorage.getItem('studio.unsent') ?? ''")).Contains("typed in the dark", StringComparison.Ordinal));
        await page.CloseAsync();
        w.Session.Files.New();

        IPage next = await w.NewPage();
        await next.GetByRole(AriaRole.Button, new() { Name = "Open 01-sphere.json" }).ClickAsync();
        await next.GetByRole(AriaRole.Button, new() { Name = "Merge it in" }).ClickAsync();
        await w.Text("it is there", t => t == "// typed in the dark\n" + before);
        Assert.Equal(file, w.Session.Document.Place.Path);

        // One that is in no file becomes a new scene.
        w.Session.Files.OpenGallery("minimal.json", discard: true);
        string minimal = w.Session.Document.Text;
        await Expect(next).ToHaveTitleAsync(new Regex("minimal"));
        await TypeWithoutServer(w, "// typed in none", next);
        await StudioWindow.Until("it is kept", async () => (await next.EvaluateAsync<string>("() => localStorage.getItem('studio.unsent') ?? ''")).Contains("typed in none", StringComparison.Ordinal));
        await next.CloseAsync();
        w.Session.Files.Open(file);
        IPage last = await w.NewPage();
        await last.GetByRole(AriaRole.Button, new() { Name = "Open it as a new scene" }).ClickAsync();
        await w.Text("it is there", t => t == "// typed in none\n" + minimal);
        Assert.True(w.Session.Document.IsDirty);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task A_draft_takes_fewer_samples_than_the_file_says()
    {
        await using StudioWindow w = await StudioWindow.OpenEndless(browser);
        await w.Tab("Render");
        await w.Page.GetByRole(AriaRole.Radio, new() { Name = "Draft" }).Or(w.Button("Draft")).ClickAsync();
        await StudioWindow.Until("there are fewer", () => Task.FromResult(w.Session.View.Loop.Status.SamplesTotal < 1000));
        await w.Page.GetByRole(AriaRole.Radio, new() { Name = "As written" }).Or(w.Button("As written")).ClickAsync();
        await StudioWindow.Until("there are as many as the file says", () => Task.FromResult(w.Session.View.Loop.Status.SamplesTotal == 102400));
        await w.Shot("render-settings", isShown: true);
    }

    [ThoroughFact]
    [Trait("Category", "Thorough")]
    public async Task Two_fingers_come_nearer()
    {
        await using StudioWindow w = await StudioWindow.Open(browser, "primer/01-sphere", new() { HasTouch = true });
        await w.Painted();
        float Distance() => (w.Session.View.Shown!.Camera.Position - w.Session.View.Shown.Camera.LookAt).Length();
        float before = Distance();
        (float x, float y) = await w.Point(0.5, 0.5);
        ICDPSession touch = await w.Page.Context.NewCDPSessionAsync(w.Page);
        async Task Fingers(string kind, float apart) => await touch.SendAsync("Input.dispatchTouchEvent", new()
        {
            ["type"] = kind,
            ["touchPoints"] = kind == "touchEnd" ? Array.Empty<object>() : new object[] { new { x = x - apart, y, id = 1 }, new { x = x + apart, y, id = 2 } },
        });
        await Fingers("touchStart", 40);
        for (int i = 1; i <= 6; i++)
        {
            await Fingers("touchMove", 40 + (10 * i));
        }

        await Fingers("touchEnd", 0);
        await StudioWindow.Until("the view is nearer", () => Task.FromResult(Distance() < before));
    }

    // The state that changes ends the request that waits for it; the next one fails.
    private static async Task TypeWithoutServer(StudioWindow w, string line, IPage? page = null)
    {
        page ??= w.Page;
        w.Expected.Add("ERR_");
        w.Expected.Add("Failed to load resource");
        await page.RouteAsync("**/api/document/text", route => route.AbortAsync("connectionrefused"));
        await page.RouteAsync("**/api/state*", route => route.AbortAsync("connectionrefused"));
        w.Session.Selection.Select(w.Session.Selection.Pointer is null ? "/shapes/0" : null);
        await Expect(page.GetByText("The Studio is not responding.")).ToBeVisibleAsync();
        await page.GetByRole(AriaRole.Textbox, new() { Name = "Scene source" }).ClickAsync();
        await page.Keyboard.PressAsync("Control+Home");
        await page.Keyboard.TypeAsync($"{line}\n");
    }
}
