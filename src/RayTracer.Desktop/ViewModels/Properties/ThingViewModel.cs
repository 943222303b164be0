using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The properties of one thing: its name, what it is, and an editor for each parameter.</summary>
/// <param name="context">The rest of the window, as editors use it.</param>
/// <param name="pointer">The pointer to the thing.</param>
/// <param name="without">Parameters that are shown elsewhere.</param>
internal sealed class ThingViewModel(PanelContext context, string pointer, params string[] without) : Observable
{
    private PropertyValues? _values;

    /// <summary>The pointer to the thing.</summary>
    public string Pointer => pointer;

    public string Title { get; private set; } = "";

    /// <summary>Returns whether it can be copied, deleted and renamed.</summary>
    public bool IsThing => SceneThings.IsThing(Pointer);

    /// <summary>The types that it can be; none where that cannot be changed.</summary>
    public IReadOnlyList<Choice> Types { get; private set; } = [];

    public bool CanRetype => Types.Count > 0;

    /// <summary>Its type.</summary>
    public Choice? Type
    {
        get => Types.FirstOrDefault(t => t.Value == Record?.Type.Name);
        set
        {
            if (!IsReporting && value is not null && Types.Contains(value) && Record is { } record && value.Value != record.Type.Name)
            {
                context.Set(Pointer, ParameterValues.Retyped(_values?.Value, PanelContext.Catalogue.Types[_values!.Family!].First(t => t.Name == value.Value), record.Type));
            }
        }
    }

    /// <summary>Its parameters; null where it is none of a type, but a plain value.</summary>
    public RecordViewModel? Record { get; private set; }

    /// <summary>The editor of a plain value: the background, or a texture that is just a colour; null where it is a record.</summary>
    public FieldViewModel? Plain { get; private set; }

    /// <summary>Shows where it is written.</summary>
    public ICommand ShowText => field ??= new RelayCommand(() => context.ShowInSource(pointer));

    /// <summary>Shows what is written.</summary>
    public void Show(PropertyValues values)
    {
        _values = values;
        CatalogueType? type = TypeOf(values);
        if (type is null)
        {
            ShowPlain(values);
        }
        else
        {
            Record = Record is { } same && same.Type == type ? same : new(context, type, Pointer, without);
            Record.Show(values.Value);
            Plain = null;
        }

        string? name = (values.Value as System.Text.Json.Nodes.JsonObject)?["name"] is { } own ? ParameterValues.Text(own) : null;
        string last = JsonPointer.Last(Pointer);
        Title = name ?? (JsonPointer.Index(last) >= 0 && type is not null ? type.Name : last);
        if (Types.Count == 0 && values.Family is "material" or "texture" && type is not null)
        {
            Types = [.. PanelContext.Catalogue.Types[values.Family!].Select(t => new Choice(t.Name, Figures.Spaced(t.Name), t.Summary))];
        }

        OnPropertyChanged("");
    }

    private static CatalogueType? TypeOf(PropertyValues values) => values.Type is not { } name ? null
        : values.Family is { } family ? PanelContext.Catalogue.Types[family].FirstOrDefault(t => t.Name == name)
        : PanelContext.Catalogue.Sections.GetValueOrDefault(name);

    private void ShowPlain(PropertyValues values)
    {
        Record = null;
        string key = JsonPointer.Last(Pointer);
        CatalogueParameter? parameter = PanelContext.Catalogue.Sections["scene"].Parameters.FirstOrDefault(p => p.Key == key && JsonPointer.Parent(Pointer) == "")
            ?? PanelContext.Catalogue.Types["texture"].First(t => t.Name == "solid").Parameters.FirstOrDefault(p => p.Kind == "color");
        Plain ??= parameter is null ? null : FieldViewModel.Of(context, parameter, Pointer);
        Plain?.Show(values.Value);
    }
}
