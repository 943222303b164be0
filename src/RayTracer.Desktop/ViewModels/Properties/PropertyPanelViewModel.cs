using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The properties: of the selected thing, the camera, the rendering and the world.</summary>
/// <param name="context">The rest of the window, as editors use it.</param>
/// <param name="render">The user's settings of the picture.</param>
/// <param name="addEnvironment">Adds an environment that needs a file.</param>
internal sealed class PropertyPanelViewModel(PanelContext context, RenderViewModel render, Action<CatalogueType> addEnvironment)
    : Observable
{
    private static readonly string[] WorldKinds = ["color", "texture", "number", "choice", "boolean"];
    private static readonly string[] TabNames = ["object", "camera", "render", "world"];

    /// <summary>The selected thing; null where there is none.</summary>
    public ThingViewModel? Thing { get; private set => SetProperty(ref field, value); }

    /// <summary>The camera.</summary>
    public ThingViewModel Camera { get; } = new(context, "/camera");

    /// <summary>The user's settings of the picture.</summary>
    public RenderViewModel Render => render;

    /// <summary>The scene's settings of the rendering.</summary>
    public ThingViewModel RenderDetails { get; } = new(context, "/render");

    /// <summary>The values that colour the whole scene.</summary>
    public IReadOnlyList<ThingViewModel> World { get; private set; } = [];

    /// <summary>The environment.</summary>
    public EnvironmentViewModel Environment { get; } = new(context, addEnvironment);

    /// <summary>The tab that is shown.</summary>
    public int Tab { get; set => SetProperty(ref field, value); }

    /// <summary>Shows a tab by its name.</summary>
    public void Open(string tab) => Tab = Array.IndexOf(TabNames, tab);

    /// <summary>Shows a document.</summary>
    public void Show(DocumentSnapshot shown)
    {
        context.Outline = shown.Outline ?? context.Outline;
        ShowThing(shown);
        ShowAt(shown, Camera);
        ShowAt(shown, RenderDetails);
        Environment.Show(shown.Values.GetValueOrDefault("/environment"));
        bool isSurrounded = context.Outline is { } outline && outline.Environment.Summary != "none";
        string[] keys = [.. PanelContext.Catalogue.Sections["scene"].Parameters.Where(p => WorldKinds.Contains(p.Kind) && !(isSurrounded && p.Key == "background")).Select(p => $"/{p.Key}")];
        if (!keys.SequenceEqual(World.Select(w => w.Pointer)))
        {
            World = [.. keys.Select(k => new ThingViewModel(context, k))];
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
        ThingViewModel? thing = !isShown ? null : Thing?.Pointer == shown.Selection ? Thing : new(context, shown.Selection!, "name");
        if (thing is not null)
        {
            ShowAt(shown, thing);
        }

        Thing = thing;
    }

    private static void ShowAt(DocumentSnapshot shown, ThingViewModel thing)
    {
        if (shown.Values.TryGetValue(thing.Pointer, out PropertyValues? values))
        {
            thing.Show(values);
        }
    }
}
