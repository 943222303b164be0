using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The properties: of the selected thing, the camera, the rendering and the world.</summary>
internal sealed class PropertyPanelViewModel : Observable
{
    private static readonly string[] WorldKinds = ["color", "texture", "number", "choice", "boolean"];
    private static readonly string[] TabNames = ["object", "camera", "render", "world"];
    private readonly PanelContext _context;

    /// <summary>The properties of a document.</summary>
    public PropertyPanelViewModel(PanelContext context, RenderViewModel render)
    {
        (_context, Render) = (context, render);
        Camera = new(context, "/camera");
        RenderDetails = new(context, "/render");
        Environment = new(context);
    }

    /// <summary>The selected thing; null where there is none.</summary>
    public ThingViewModel? Thing { get; private set => SetProperty(ref field, value); }

    public bool IsNothing => Thing is null;

    /// <summary>The camera.</summary>
    public ThingViewModel Camera { get; }

    /// <summary>The user's settings of the picture.</summary>
    public RenderViewModel Render { get; }

    /// <summary>The scene's settings of the rendering.</summary>
    public ThingViewModel RenderDetails { get; }

    /// <summary>The values that colour the whole scene.</summary>
    public IReadOnlyList<ThingViewModel> World { get; private set; } = [];

    /// <summary>The environment.</summary>
    public EnvironmentViewModel Environment { get; }

    /// <summary>The tab that is shown.</summary>
    public int Tab { get; set => SetProperty(ref field, value); }

    /// <summary>Shows a tab by its name.</summary>
    public void Open(string tab) => Tab = Array.IndexOf(TabNames, tab);

    /// <summary>Shows a document.</summary>
    public void Show(DocumentSnapshot shown)
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
            OnPropertyChanged(nameof(World));
        }

        foreach (ThingViewModel part in World)
        {
            ShowAt(shown, part);
        }
    }

    private void ShowThing(DocumentSnapshot shown)
    {
        bool isShown = shown.Selection is { } pointer && pointer is not ("" or "/camera" or "/render") && shown.Values.ContainsKey(pointer);
        ThingViewModel? thing = !isShown ? null : Thing?.Pointer == shown.Selection ? Thing : new(_context, shown.Selection!, "name");
        if (thing is not null)
        {
            ShowAt(shown, thing);
        }

        Thing = thing;
        OnPropertyChanged(nameof(IsNothing));
    }

    private static void ShowAt(DocumentSnapshot shown, ThingViewModel thing)
    {
        if (shown.Values.TryGetValue(thing.Pointer, out PropertyValues? values))
        {
            thing.Show(values);
        }
    }
}
