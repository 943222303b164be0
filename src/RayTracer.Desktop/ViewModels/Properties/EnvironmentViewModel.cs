using System.Text.Json.Nodes;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The environment of the scene: only its background, or light from all directions.</summary>
/// <param name="context">The rest of the window, as editors use it.</param>
/// <param name="add">Adds an environment that needs a file, and asks for that.</param>
internal sealed class EnvironmentViewModel(PanelContext context, Action<CatalogueType> add) : Observable
{
    private const string Pointer = "/environment";
    private JsonNode? _value;

    /// <summary>The environments to choose from.</summary>
    public IReadOnlyList<Choice> Choices { get; } =
        [new("", SessionTexts.Of("panel.noEnvironment")), .. PanelContext.Catalogue.Types["environment"].Select(t => new Choice(t.Name, Figures.Spaced(t.Name), t.Summary))];

    public Choice? Chosen
    {
        get => Choices.FirstOrDefault(c => c.Value == (Record?.Type.Name ?? ""));
        set
        {
            if (!IsReporting && value is not null && value.Value != (Record?.Type.Name ?? ""))
            {
                Choose(value.Value);
            }
        }
    }

    /// <summary>Its parameters; null where there is none.</summary>
    public RecordViewModel? Record { get; private set; }

    /// <summary>Shows what is written.</summary>
    public void Show(PropertyValues? values)
    {
        _value = values?.Value;
        CatalogueType? type = ParameterValues.TypeOf(_value, "environment");
        Record = type is null ? null : Record is { } same && same.Type == type ? same : new(context, type, Pointer);
        Record?.Show(_value);
        OnPropertyChanged("");
    }

    private void Choose(string name)
    {
        if (PanelContext.Catalogue.Types["environment"].FirstOrDefault(t => t.Name == name) is not { } type)
        {
            context.Reset(Pointer);
        }
        else if (Record is { } record && !type.Parameters.Any(p => p.Required))
        {
            context.Set(Pointer, ParameterValues.Retyped(_value, type, record.Type));
        }
        else
        {
            add(type);
        }
    }
}
