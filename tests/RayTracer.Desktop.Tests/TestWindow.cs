using Avalonia.Controls;
using Avalonia.VisualTree;
using RayTracer.Desktop.ViewModels;
using RayTracer.Desktop.Views;
using RayTracer.Session;

namespace RayTracer.Desktop.Tests;

/// <summary>A window with a real session behind it, whose folders are temporary.</summary>
internal sealed class TestWindow : IDisposable
{
    private readonly string _folder = Directory.CreateTempSubdirectory("raytracer-desktop-test-").FullName;
    private readonly string _gallery;

    private TestWindow(string scenes)
    {
        _gallery = scenes;
        UserFolders folders = new(this["state"], this["cache"], _folder);
        LeaveUnsaved(folders, scenes);
        Session = new(folders, scenes);
        Services = new();
        Main = new(Session, Services);
        Window = new() { DataContext = Main };
        Services.CloseWindow = Window.CloseAnyway;
        Window.Closed += (_, _) => IsClosed = true;
    }

    public StudioSession Session { get; }

    public MainViewModel Main { get; }

    public MainWindow Window { get; }

    public TestServices Services { get; }

    public bool IsClosed { get; private set; }

    /// <summary>A file in the test's folder.</summary>
    public string this[string name] => Path.Combine(_folder, name);

    /// <summary>Opens a window with a small picture of one of the report's scenes.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="samples">Samples a pixel.</param>
    public static async Task<TestWindow> Open(string scene = "report/scene2.json", int samples = 4)
    {
        // A gallery of one scene: its picture takes time.
        string gallery = Directory.CreateTempSubdirectory("raytracer-desktop-scenes-").FullName;
        Directory.CreateDirectory(Path.Combine(gallery, "report"));
        File.WriteAllText(Path.Combine(gallery, "report", "one.json"), """{ "camera": {}, "render": { "integrator": "report", "width": 16, "height": 12 }, "shapes": [{ "type": "sphere", "center": [0, 0, 0], "radius": 1 }] }""");
        TestWindow window = new(gallery);
        string text = File.ReadAllText(ProjectFolder.PathOf("scenes", scene));
        JsonText small = JsonText.Of(text).Set("/render/width", 60).Set("/render/height", 40).Set("/render/samplesPerPixel", samples);
        window.Session.Document.Open(small.Text, new("test.json", null, Path.GetDirectoryName(ProjectFolder.PathOf("scenes", scene))!), isSaved: true);
        await window.Session.Document.WhenBuilt();
        window.Window.Show();
        _ = window.Main.Run();
        await Ui.Until(() => window.Main.Viewport.Frame is not null && window.Main.Outliner.Rows.Count > 0 && window.Main.DocumentName == "test.json", "the scene is shown");
        window.Layout();
        return window;
    }

    /// <summary>Waits until something is so.</summary>
    public async Task Until(Func<bool> isSo, [System.Runtime.CompilerServices.CallerArgumentExpression(nameof(isSo))] string what = "")
    {
        try
        {
            await Ui.Until(isSo, what);
        }
        catch (Exception e) when (Main.Messages.All.Count > 0)
        {
            throw new InvalidOperationException($"{e.Message} Messages: {string.Join("; ", Main.Messages.All.Select(m => m.Text))}", e);
        }
    }

    /// <summary>Does a command.</summary>
    public void Do(string id) => Main.Commands[id].Execute(null);

    /// <summary>Gives the window a size, and lays all out.</summary>
    public void Layout(double width = 1280, double height = 800)
    {
        Window.PlatformImpl!.Resize(new(width, height), WindowResizeReason.User);
        Window.UpdateLayout();
    }

    /// <summary>All controls of a type that are to be seen.</summary>
    public IEnumerable<T> Seen<T>()
        where T : Control => Window.GetVisualDescendants().OfType<T>().Where(c => c.IsEffectivelyVisible);

    /// <summary>The view of a type that is to be seen.</summary>
    public T View<T>()
        where T : Control => Seen<T>().First();

    public void Dispose()
    {
        Main.Dispose();
        if (!IsClosed)
        {
            Window.CloseAnyway();
        }

        Session.Dispose();
        Directory.Delete(_folder, recursive: true);
        Directory.Delete(_gallery, recursive: true);
    }

    // Another session, which ended without saving.
    private static void LeaveUnsaved(UserFolders folders, string scenes)
    {
        using StudioSession session = new(folders, scenes);
        session.Document.TryReplace(session.Document.Revision, 0, 0, "// kept\n", null);
    }
}
