using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The properties: of the selected thing, the camera, the rendering and the world.</summary>
internal sealed class PropertyPanelViewModel : Observable
{
    private static readonly string[] WorldKinds = ["color", "texture", "number", "choice", "boolean"];
    private static readonly string[] TabNames = ["object", "camera", "render", "world"];
    private readonly PanelContext _context;
    private ThingViewModel? _thing;
    private int _tab;

    /// <summary>The properties of a document.</summary>
    public PropertyPanelViewModel(PanelContext context, RenderViewModel render)
    {
        (_context, Render) = (context, render);
        Camera = new(context, "/camera");
        RenderDetails = new(context, "/render");
        Environment = new(context);
    }

    /// <summary>The selected thing; null where there is none.</summary>
    public ThingViewModel? Thing
    {
        get => _thing;
        private set => Set(ref _thing, value);
    }

    /// <summary>Whether nothing is selected.</summary>
    public bool IsNothing => _thing is null;

    /// <summary>The camera.</summary>
    public ThingViewModel Camera { get; }

    /// <summary>How the user wants the picture.</summary>
    public RenderViewModel Render { get; }

    /// <summary>How the scene says that it is rendered.</summary>
    public ThingViewModel RenderDetails { get; }

    /// <summary>What colours the whole scene.</summary>
    public IReadOnlyList<ThingViewModel> World { get; private set; } = [];

    /// <summary>What surrounds it.</summary>
    public EnvironmentViewModel Environment { get; }

    /// <summary>The tab that is shown.</summary>
    public int Tab
    {
        get => _tab;
        set => Set(ref _tab, value);
    }

    /// <summary>Shows a tab by its name.</summary>
    public void Open(string tab) => Tab = Array.IndexOf(TabNames, tab);

    /// <summary>Shows a document.</summary>
    public void Show(DocumentShown shown)
    {
        _context.Outline = shown.Outline ?? _context.Outline;
        ShowThing(shown);
        ShowAt(shown, Camera);
        ShowAt(shown, RenderDetails);
        Environment.Show(shown.Values.GetValueOrDefault("/environment"));
        bool isSurrounded = _context.Outline is { } outline && outline.Environment.Summary != "none";
        string[] keys = [.. PanelContext.Catalogue.Sections["scene"].Parameters.Where(p => WorldKinds.Contains(p.Kind) && !(isSurrounded && p.Key == "background")).Select(p => $"/{p.Key}")];
        if (!keys.SequenceEqual(World.Select(w => w.Pointer)))
        {
            World = [.. keys.Select(k => new ThingViewModel(_context, k))];
            Tell(nameof(World));
        }

        foreach (ThingViewModel part in World)
        {
            ShowAt(shown, part);
        }
    }

    private void ShowThing(DocumentShown shown)
    {
        bool isShown = shown.Selection is { } pointer && pointer is not ("" or "/camera" or "/render") && shown.Values.ContainsKey(pointer);
        ThingViewModel? thing = !isShown ? null : _thing?.Pointer == shown.Selection ? _thing : new(_context, shown.Selection!, "name");
        if (thing is not null)
        {
            ShowAt(shown, thing);
        }

        Thing = thing;
        Tell(nameof(IsNothing));
    }

    private static void ShowAt(DocumentShown shown, ThingViewModel thing)
    {
        if (shown.Values.TryGetValue(thing.Pointer, out PropertyValues? values))
        {
            thing.Show(values);
        }
    }
}
