using System.Diagnostics;
using System.Globalization;
using System.Text.Json;
using Microsoft.Playwright;
using RayTracer.Testing;

namespace RayTracer.Benchmarks.Studio;

/// <summary>
/// How quickly the Studio follows a hand, in a real browser without a window: painted frames while the camera orbits, times from a drag, a
/// release and an edit to the frame that shows it, paths a second beside the command's, start, memory.
/// <c>studio [SCENE] [--minutes N]</c>: for so many minutes, memory is watched during use at random.
/// </summary>
internal static class StudioBenchmark
{
    private static readonly string s_command = StudioProcess.Program("RayTracer.Cli", "raytracer.dll");

    public static async Task<int> Run(string[] args)
    {
        int option = Array.IndexOf(args, "--minutes");
        double minutes = option >= 0 ? double.Parse(args[option + 1], CultureInfo.InvariantCulture) : 0;
        string scene = args is [var first, ..] && option != 0 ? first : ProjectFolder.PathOf("scenes", "report", "scene2.json");
        DirectoryInfo folder = Directory.CreateTempSubdirectory("studio-bench-");
        try
        {
            string sized = Sized(scene, folder, 800, 600, 16);
            using IPlaywright playwright = await Playwright.CreateAsync();
            await using IBrowser browser = await playwright.Chromium.LaunchAsync(new() { ExecutablePath = InstalledBrowser.Find() ?? throw new FileNotFoundException(InstalledBrowser.WhyNot), Args = ["--no-sandbox", "--disable-dev-shm-usage"] });
            await Interaction(browser, sized);
            await Throughput(browser, Sized(scene, folder, 800, 600, 102400), sized, folder);
            if (minutes > 0)
            {
                await Memory(browser, Sized(scene, folder, 1920, 1080, 102400), minutes);
            }

            return 0;
        }
        finally
        {
            folder.Delete(recursive: true);
        }
    }

    private static async Task Interaction(IBrowser browser, string scene)
    {
        long start = Stopwatch.GetTimestamp();
        using StudioProcess studio = StudioProcess.Start(scene);
        double listening = Stopwatch.GetElapsedTime(start).TotalSeconds;
        IPage page = await Open(browser, studio, 1400, 900);
        Console.WriteLine($"start to listening             {listening,8:F2} s");
        Console.WriteLine($"start to first picture         {Stopwatch.GetElapsedTime(start).TotalSeconds,8:F2} s");
        for (int round = 0; round < 3; round++)
        {
            Console.WriteLine($"painted frames while orbiting  {await page.EvaluateAsync<double>("() => window.probe.orbit(4)"),8:F1} a second");
        }

        Tell("drag to paint", await page.EvaluateAsync<double[]>("() => window.probe.drags(60)"));
        Tell("release to full resolution", await page.EvaluateAsync<double[]>("() => window.probe.releases(12)"));
        await page.GetByRole(AriaRole.Treeitem, new() { NameRegex = new("^floor.*diffuse") }).ClickAsync();
        await page.WaitForTimeoutAsync(1500);
        Tell("colour to paint", await page.EvaluateAsync<double[]>("() => window.probe.colours(12)"));
        await page.CloseAsync();
    }

    // The same scene with all threads in both, in turn.
    private static async Task Throughput(IBrowser browser, string endless, string sized, DirectoryInfo folder)
    {
        List<double> ratios = [];
        for (int round = 0; round < 3; round++)
        {
            double command = Command(Sized(sized, folder, 800, 600, 144));
            using StudioProcess studio = StudioProcess.Start(endless);
            IPage page = await Open(browser, studio, 1400, 900);
            await page.WaitForTimeoutAsync(3000);
            (double before, double start) = await Progress(page);
            await page.WaitForTimeoutAsync(10000);
            (double after, double end) = await Progress(page);
            double watched = (after - before) * 800 * 600 / (end - start);
            ratios.Add(watched / command);
            Console.WriteLine($"paths a second                 {watched / 1e6,8:F2} M watched, {command / 1e6:F2} M by the command: {watched / command:P0}");
            await page.CloseAsync();
        }

        Console.WriteLine($"paths a second, median ratio   {ratios.Order().ElementAt(1),8:P0}");
    }

    // Samples in each pixel, and the seconds on the clock: all that the window costs is in the time.
    private static async Task<(double Samples, double Seconds)> Progress(IPage page)
    {
        double[] both = await page.EvaluateAsync<double[]>(
            """
            async () => {
                const answer = await fetch("/api/state?after=0", { headers: { "X-Studio-Token": sessionStorage.getItem("studio-token") } });
                return [(await answer.json()).render.samples, performance.now() / 1000];
            }
            """);
        return (both[0], both[1]);
    }

    private static async Task Memory(IBrowser browser, string scene, double minutes)
    {
        using StudioProcess studio = StudioProcess.Start(scene);
        IPage page = await Open(browser, studio, 1920, 1080);
        Stopwatch watch = Stopwatch.StartNew();
        Random random = new(1);
        string[] maps = ["light", "samples", "variance", "depth", "normal", "albedo", "light"];
        for (double next = 0; watch.Elapsed.TotalMinutes < minutes;)
        {
            await page.EvaluateAsync(random.Next(4) == 0 ? "() => window.probe.releases(2)" : "() => window.probe.orbit(2)");
            if (random.Next(4) == 0)
            {
                await page.GetByRole(AriaRole.Combobox, new() { Name = "Show", Exact = true }).SelectOptionAsync(maps[random.Next(maps.Length)]);
            }

            if (watch.Elapsed.TotalMinutes >= next)
            {
                Console.WriteLine($"memory after {watch.Elapsed.TotalMinutes,5:F1} minutes       {studio.MemoryMiB,8:F0} MiB");
                next++;
            }
        }

        Console.WriteLine($"memory at the end              {studio.MemoryMiB,8:F0} MiB");
        await page.CloseAsync();
    }

    private static async Task<IPage> Open(IBrowser browser, StudioProcess studio, int width, int height)
    {
        IPage page = await browser.NewPageAsync(new() { ViewportSize = new() { Width = width, Height = height } });
        await page.AddInitScriptAsync("localStorage.setItem('studio.tourSeen', 'true')");
        await page.GotoAsync(studio.Link);
        while (await page.Locator("canvas.picture[data-preview=false]").CountAsync() == 0)
        {
            await page.WaitForTimeoutAsync(10);
        }

        using StreamReader probe = new(typeof(StudioBenchmark).Assembly.GetManifestResourceStream("probe.js")!);
        await page.EvaluateAsync(await probe.ReadToEndAsync());
        return page;
    }

    private static double Command(string scene)
    {
        using Process process = Process.Start(new ProcessStartInfo("dotnet", [s_command, "render", scene, "--json", "--quiet"]) { RedirectStandardOutput = true, UseShellExecute = false })!;
        using JsonDocument json = JsonDocument.Parse(process.StandardOutput.ReadToEnd());
        process.WaitForExit();
        return json.RootElement.GetProperty("paths").GetDouble() / json.RootElement.GetProperty("renderSeconds").GetDouble();
    }

    // A copy of the scene with another size and number of samples.
    private static string Sized(string scene, DirectoryInfo folder, int width, int height, int samples)
    {
        string text = File.ReadAllText(scene);
        foreach ((string key, int value) in new[] { ("width", width), ("height", height), ("samplesPerPixel", samples) })
        {
            text = System.Text.RegularExpressions.Regex.Replace(
                text, $"\"{key}\": [0-9]+", $"\"{key}\": {value}", System.Text.RegularExpressions.RegexOptions.None, TimeSpan.FromSeconds(10));
        }

        string path = Path.Combine(folder.FullName, $"{width}x{height}x{samples}.json");
        File.WriteAllText(path, text);
        return path;
    }

    private static void Tell(string what, double[] times)
    {
        double[] sorted = [.. times.Order()];
        Console.WriteLine($"{what,-30} {sorted[sorted.Length / 2],8:F0} ms in the median, {sorted[(int)(0.95 * (sorted.Length - 1))]:F0} ms of 95 %, {sorted[^1]:F0} ms at most");
    }
}
