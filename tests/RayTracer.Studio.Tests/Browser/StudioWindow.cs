using System.Globalization;
using Microsoft.Playwright;
using RayTracer.Session;

namespace RayTracer.Studio.Tests.Browser;

/// <summary>A Studio and a window on it. What goes wrong in the page or the server fails the test when it is closed.</summary>
internal sealed class StudioWindow : IAsyncDisposable
{
    // More of them would take the processor from the window, and hardly any walk looks at noise.
    private const int FewSamples = 4;
    private readonly DirectoryInfo _folder;
    private readonly StringWriter _errors;
    private readonly List<string> _troubles = [];
    private readonly IBrowserContext _context;

    private StudioWindow(IBrowserContext context, DirectoryInfo folder, StringWriter errors) => (_context, _folder, _errors) = (context, folder, errors);

    public StudioSession Session { get; private init; } = null!;

    public StudioServer Server { get; private init; } = null!;

    public IPage Page { get; private set; } = null!;

    private static bool IsKeepingShots { get; } = Environment.GetEnvironmentVariable("RAYTRACER_UPDATE") == "1";

    /// <summary>Where the walk may write.</summary>
    public string Folder => _folder.FullName;

    /// <summary>Troubles that the walk makes on purpose are listed here, as parts of their texts.</summary>
    public List<string> Expected { get; } = [];

    public ILocator Canvas => Page.Locator("canvas.picture");

    public ILocator Stage => Page.GetByRole(AriaRole.Application, new() { NameRegex = new("Rendered picture") });

    public ILocator Status => Page.GetByRole(AriaRole.Contentinfo);

    /// <summary>Starts a Studio and opens its window.</summary>
    /// <param name="browser">The browser.</param>
    /// <param name="scene">A shipped scene to begin with, as "report/scene2"; null for the empty state.</param>
    /// <param name="more">Changes the window.</param>
    /// <param name="isFirst">Whether it is the user's first time, so that the tour is offered.</param>
    /// <param name="user">The user's folder; null for a new one.</param>
    /// <param name="samples">Samples of each pixel of scenes that are opened; null, or where screenshots are kept, for as many as they say.</param>
    public static async Task<StudioWindow> Open(
        ChromiumBrowser browser, string? scene = null, BrowserNewContextOptions? more = null, bool isFirst = false, string? user = null, int? samples = FewSamples)
    {
        Skip.If(browser.Instance is null, browser.WhyNot);
        BrowserNewContextOptions options = more ?? new();
        options.ViewportSize ??= new() { Width = 1280, Height = 800 };
        options.Permissions = ["clipboard-read", "clipboard-write"];
        options.ReducedMotion = ReducedMotion.Reduce;
        IBrowserContext context = await browser.Instance!.NewContextAsync(options);
        context.SetDefaultTimeout(60_000);
        DirectoryInfo folder = Directory.CreateTempSubdirectory("studio-walk-");
        user ??= folder.FullName;
        StudioSession session = new(new UserFolders(Path.Combine(user, "state"), Path.Combine(user, "cache"), user));
        if (scene is not null)
        {
            session.View.Change(s => s with { Samples = IsKeepingShots ? null : samples });
            session.Files.Open(Copy(scene, folder));
        }

        StringWriter errors = new();
        StudioServer server = await StudioServer.Start(session, new() { Errors = errors });
        StudioWindow window = new(context, folder, errors) { Session = session, Server = server };
        await context.AddInitScriptAsync($"localStorage.getItem('studio.tourSeen') ?? localStorage.setItem('studio.tourSeen', '{(isFirst ? "false" : "true")}')");
        window.Page = await window.NewPage();
        return window;
    }

    /// <summary>As <see cref="Open"/>, with a scene that takes very long to be finished.</summary>
    public static async Task<StudioWindow> OpenEndless(ChromiumBrowser browser)
    {
        StudioWindow window = await Open(browser);
        string path = Path.Combine(window.Folder, "endless.json");
        string text = await File.ReadAllTextAsync(ProjectFolder.PathOf("scenes", "report", "scene2.json"));
        await File.WriteAllTextAsync(path, text.Replace("\"samplesPerPixel\": 16", "\"samplesPerPixel\": 102400", StringComparison.Ordinal));
        window.Session.Files.Open(path);
        await window.Painted();
        return window;
    }

    /// <summary>Opens another window on the same Studio.</summary>
    public async Task<IPage> NewPage()
    {
        IPage page = await _context.NewPageAsync();
        page.Console += (_, message) =>
        {
            if (message.Type is "error" or "warning")
            {
                Trouble($"console: {message.Text}");
            }
        };
        page.Response += async (_, response) =>
        {
            // The console does not tell which request it was.
            if (response.Status is 400 or 404)
            {
                Trouble($"refused: {response.Request.Method} {response.Url} {response.Request.PostData}");
                try
                {
                    Trouble($"the refusal: {await response.TextAsync()}");
                }
                catch (PlaywrightException)
                {
                    // The page is gone, and its answer with it.
                }
            }
        };
        page.PageError += (_, error) => Trouble($"page: {error}");
        await page.GotoAsync(Server.Link);
        return page;
    }

    /// <summary>Waits until a full picture of so many samples is painted.</summary>
    public async Task Painted(int samples = 1)
    {
        try
        {
            await Until($"{samples} samples are painted", async () => await Canvas.CountAsync() > 0 && await Canvas.GetAttributeAsync("data-preview") == "false" && await Data("samples") >= samples);
        }
        catch (Xunit.Sdk.XunitException e)
        {
            throw new Xunit.Sdk.XunitException($"{e.Message} The page:{Environment.NewLine}{await Page.Locator("body").InnerTextAsync()}", e);
        }
    }

    /// <summary>A number that the canvas reports.</summary>
    public async Task<int> Data(string name) => int.Parse(await Canvas.GetAttributeAsync("data-" + name) ?? "0", CultureInfo.InvariantCulture);

    /// <summary>Waits for something; fails after a time that no machine should need.</summary>
    public static async Task Until(string what, Func<Task<bool>> condition)
    {
        for (int i = 0; i < 1200; i++)
        {
            if (await condition())
            {
                return;
            }

            await Task.Delay(50);
        }

        Assert.Fail($"In a minute, it did not come true that {what}.");
    }

    /// <summary>A point of the picture, as fractions of its width and height, in the window.</summary>
    public async Task<(float X, float Y)> Point(double x, double y)
    {
        LocatorBoundingBoxResult box = (await Canvas.BoundingBoxAsync())!;
        return ((float)(box.X + (x * box.Width)), (float)(box.Y + (y * box.Height)));
    }

    /// <summary>Clicks a point of the picture.</summary>
    public async Task Click(double x, double y)
    {
        (float left, float top) = await Point(x, y);
        await Page.Mouse.ClickAsync(left, top);
    }

    /// <summary>Drags over the picture, in steps.</summary>
    public async Task Drag(double fromX, double fromY, double toX, double toY, MouseButton button = MouseButton.Left)
    {
        (float x, float y) = await Point(fromX, fromY);
        (float endX, float endY) = await Point(toX, toY);
        await Page.Mouse.MoveAsync(x, y);
        await Page.Mouse.DownAsync(new() { Button = button });
        await Page.Mouse.MoveAsync(endX, endY, new() { Steps = 8 });
        await Page.Mouse.UpAsync(new() { Button = button });
    }

    /// <summary>Opens one of the tabs.</summary>
    public async Task Tab(string name) => await Page.GetByRole(AriaRole.Tab, new() { Name = name, Exact = true }).ClickAsync();

    /// <summary>Waits until the document's text is so.</summary>
    public Task Text(string what, Func<string, bool> isSo) => Until(what, () => Task.FromResult(isSo(Session.Document.Text)));

    /// <summary>Keeps a screenshot where pictures are renewed: in the documentation if it is shown there, else among the results.</summary>
    public async Task Shot(string name, bool isShown = false)
    {
        if (!IsKeepingShots)
        {
            return;
        }

        string folder = isShown ? ProjectFolder.PathOf("docs", "studio") : ProjectFolder.PathOf("artifacts", "studio");
        Directory.CreateDirectory(folder);
        await Page.ScreenshotAsync(new() { Path = Path.Combine(folder, name + ".png"), Animations = ScreenshotAnimations.Disabled });
    }

    /// <summary>Opens a menu, and goes through it by the names of its items.</summary>
    public async Task Choose(string menu, params string[] items)
    {
        await Button(menu).ClickAsync();
        foreach (string item in items)
        {
            await Page.GetByRole(AriaRole.Menuitem, new() { Name = item, Exact = true }).ClickAsync();
        }
    }

    /// <summary>A button of that name.</summary>
    public ILocator Button(string name) => Page.GetByRole(AriaRole.Button, new() { Name = name, Exact = true });

    /// <inheritdoc/>
    public async ValueTask DisposeAsync()
    {
        await _context.CloseAsync();
        await Server.DisposeAsync();
        Session.Dispose();
        _folder.Delete(recursive: true);
        lock (_troubles)
        {
            string server = _errors.ToString();
            string all = string.Join("\n", _troubles.Append(server).Where(t => t.Length > 0 && !Expected.Exists(e => t.Contains(e, StringComparison.Ordinal))));
            Assert.True(all.Length == 0, all);
        }
    }

    // Of the scene and what lies beside it: a walk may save.
    private static string Copy(string scene, DirectoryInfo folder)
    {
        string from = Path.GetDirectoryName(ProjectFolder.PathOf("scenes", scene + ".json"))!;
        string to = Path.Combine(folder.FullName, "scenes", Path.GetFileName(from));
        foreach (string file in Directory.EnumerateFiles(from, "*", SearchOption.AllDirectories))
        {
            string copy = Path.Combine(to, Path.GetRelativePath(from, file));
            Directory.CreateDirectory(Path.GetDirectoryName(copy)!);
            File.Copy(file, copy);
        }

        return Path.Combine(to, Path.GetFileName(scene) + ".json");
    }

    private void Trouble(string text)
    {
        lock (_troubles)
        {
            _troubles.Add(text);
        }
    }
}
