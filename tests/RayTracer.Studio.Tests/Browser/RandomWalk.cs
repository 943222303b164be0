using System.Globalization;
using Microsoft.Playwright;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>Someone who tries everything.</summary>
[Collection(BrowserCollection.Name)]
[Trait("Category", "Browser")]
[Trait("Category", "Slow")]
[Trait("Category", "Thorough")]
public class RandomWalk(ChromiumBrowser browser)
{
    private static readonly string[] s_keys =
    [
        "Control+z", "Control+Shift+z", "Control+d", "Delete", "Escape", "Escape", "1", "2", "3", "4", "5", "6", "7", "f", "?", "Tab", "Enter", "ArrowLeft", "ArrowUp",
        "w", "a", "+", "-", "Space", "F2", "Shift+ArrowRight",
    ];

    [ThoroughFact]
    public async Task Hundreds_of_actions_at_random_end_without_an_error()
    {
        Random random = new(TestSettings.Seed + 7);
        await using StudioWindow w = await StudioWindow.Open(browser, "report/scene2");

        // Answers to what cannot be done are no errors of the page, though the browser lists them.
        w.Expected.Add("the server responded with a status of 4");
        w.Expected.Add("refused: POST");
        w.Expected.Add("/api/pick?");
        w.Expected.Add("the refusal: {\"error\":");
        await w.Painted();
        List<string> log = [];
        int actions = TestSettings.Scale(100, 500);
        for (int i = 0; i < actions; i++)
        {
            await Act(w, random, log);
        }

        await w.Shot("random-walk");
        for (int i = 0; i < 6; i++)
        {
            await w.Page.Keyboard.PressAsync("Escape");
        }

        Assert.Equal(0, await w.Page.EvaluateAsync<int>("() => document.querySelectorAll('body > *').length === 0 ? 1 : 0"));
        long sum = await w.Page.EvaluateAsync<long>("() => document.querySelectorAll('button').length");
        Assert.True(sum > 5, $"The window is empty after {string.Join("; ", log.TakeLast(10))}.");
    }

    private static async Task Act(StudioWindow w, Random random, List<string> log)
    {
        switch (random.Next(8))
        {
            case 0:
                string key = s_keys[random.Next(s_keys.Length)];
                log.Add(key);
                await w.Page.Keyboard.PressAsync(key);
                break;
            case 1:
                (int x, int y) = (random.Next(5, 1275), random.Next(5, 795));
                log.Add(string.Create(CultureInfo.InvariantCulture, $"click {x},{y}"));
                await w.Page.Mouse.ClickAsync(x, y, new() { Button = random.Next(6) == 0 ? MouseButton.Right : MouseButton.Left });
                break;
            case 2:
                log.Add("drag");
                await w.Page.Mouse.MoveAsync(random.Next(300, 900), random.Next(100, 500));
                await w.Page.Mouse.DownAsync();
                await w.Page.Mouse.MoveAsync(random.Next(300, 900), random.Next(100, 500), new() { Steps = 5 });
                await w.Page.Mouse.UpAsync();
                break;
            case 3:
                log.Add("wheel");
                await w.Page.Mouse.MoveAsync(random.Next(300, 900), random.Next(100, 700));
                await w.Page.Mouse.WheelAsync(0, random.Next(-400, 400));
                break;
            case 4:
                log.Add("type");
                await w.Page.Keyboard.TypeAsync(new string[] { "0.5", "{", "\"x\": 1,", "]", "mirror", "-1e9", "ø" }[random.Next(7)]);
                break;
            default:
                await Press(w, random, log);
                break;
        }
    }

    // One of the buttons, tabs, choices that can be seen.
    private static async Task Press(StudioWindow w, Random random, List<string> log)
    {
        ILocator all = w.Page.Locator("button:visible, [role=treeitem]:visible, [role=tab]:visible, input[type=range]:visible, [role=menuitem]:visible");
        int count = await all.CountAsync();
        if (count == 0)
        {
            return;
        }

        ILocator one = all.Nth(random.Next(count));
        try
        {
            log.Add("press " + await one.EvaluateAsync<string>("e => e.getAttribute('aria-label') ?? e.textContent ?? ''", null, new() { Timeout = 500 }));
            await one.ClickAsync(new() { Timeout = 500 });
        }
        catch (Exception e) when (e is TimeoutException or PlaywrightException)
        {
            // It went away, or something lies over it.
        }
    }
}
