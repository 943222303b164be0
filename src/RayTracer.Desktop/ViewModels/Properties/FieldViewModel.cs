using System.Text.Json;
using System.Text.Json.Nodes;
using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The editor of one parameter.</summary>
/// <param name="context">The rest of the window, as editors use it.</param>
/// <param name="parameter">The parameter.</param>
/// <param name="pointer">The pointer to its value, written or not.</param>
internal abstract class FieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : Observable
{
    /// <summary>The parameter.</summary>
    public CatalogueParameter Parameter => parameter;

    public string Pointer => pointer;

    public string Label => Figures.Spaced(Parameter.Key);

    /// <summary>Its unit; empty where there is none.</summary>
    public string Unit => Parameter.Unit;

    /// <summary>The meaning, unit and range.</summary>
    public string Tip => string.Join(' ', new[]
    {
        Parameter.Summary,
        Parameter.Unit.Length > 0 ? $"({SessionTexts.Of("panel.unit", Parameter.Unit)})" : "",
        Parameter.Range.Length > 0 ? $"{SessionTexts.Of("panel.range", Parameter.Range)}." : "",
    }.Where(t => t.Length > 0));

    /// <summary>Returns whether a value is written that can be removed, so that the default counts.</summary>
    public bool CanReset => Written is not null && !Parameter.Required;

    public string ResetText => SessionTexts.Of("panel.reset", Label);

    /// <summary>Returns whether there is a value, written or by default.</summary>
    public bool IsSet => Effective is not null;

    /// <summary>Takes the value out of the text.</summary>
    public ICommand Reset => field ??= new RelayCommand(() => context.Reset(pointer));

    /// <summary>Writes a first value where there is none.</summary>
    public ICommand Begin => field ??= new RelayCommand(() => Write(Start));

    protected PanelContext Context => context;

    /// <summary>The written value; null where there is none.</summary>
    protected JsonNode? Written { get; private set; }

    /// <summary>The written value, or the default.</summary>
    protected JsonNode? Effective { get; private set; }

    /// <summary>A first value.</summary>
    protected virtual JsonNode Start => Parameter.Minimum ?? 0;

    /// <summary>Shows what is written.</summary>
    public void Show(JsonNode? written)
    {
        (Written, Effective) = (written, written ?? Parameter.Default);
        Shown();
        OnPropertyChanged("");
    }

    /// <summary>The editor of a parameter, by its kind.</summary>
    public static FieldViewModel Of(PanelContext context, CatalogueParameter p, string pointer) => p.Kind switch
    {
        "number" or "integer" => new NumberFieldViewModel(context, p, pointer),
        "boolean" => new SwitchFieldViewModel(context, p, pointer),
        "choice" => new ChoiceFieldViewModel(context, p, pointer),
        "text" or "file" => new TextFieldViewModel(context, p, pointer),
        "vector2" or "vector3" => new VectorFieldViewModel(context, p, pointer),
        "color" => new ColorFieldViewModel(context, p, pointer),
        "texture" or "material" => new KindFieldViewModel(context, p, pointer),

        // What may hold others of its own kind without end, as a mix of phase functions, is edited in the source.
        "record" when SectionOf(p) is { } type && !type.Parameters.Any(inner => inner.Record == type.Name) => new RecordFieldViewModel(context, p, pointer, type),
        "records" when SectionOf(p) is { } type => new StepsFieldViewModel(context, p, pointer, type),
        _ => new SourceFieldViewModel(context, p, pointer),
    };

    /// <summary>Takes over what is written, before all properties are reported.</summary>
    protected virtual void Shown()
    {
    }

    /// <summary>Writes a value.</summary>
    protected void Write(JsonNode? value, string? gesture = null) => Context.Set(Pointer, value, gesture);

    private static CatalogueType? SectionOf(CatalogueParameter p) => PanelContext.Catalogue.Sections.GetValueOrDefault(p.Record ?? p.Key);
}

/// <summary>On or off.</summary>
internal sealed class SwitchFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer)
    : FieldViewModel(context, parameter, pointer)
{
    private bool _isOn;

    public bool IsOn
    {
        get => _isOn;
        set
        {
            if (!IsReporting && SetProperty(ref _isOn, value))
            {
                Write(value);
            }
        }
    }

    /// <inheritdoc/>
    protected override void Shown() => _isOn = Effective?.GetValueKind() == JsonValueKind.True;
}

/// <summary>A text, or the name of a file.</summary>
internal sealed class TextFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer)
    : FieldViewModel(context, parameter, pointer)
{
    /// <summary>The text.</summary>
    public string Text
    {
        get => ParameterValues.Text(Effective) ?? "";
        set
        {
            if (value is not null && value != Text)
            {
                Write(value);
            }
        }
    }

    public bool IsFile => Parameter.Kind == "file";

    /// <summary>Asks for a file.</summary>
    public ICommand Choose => new RelayCommand(() => Context.ChooseFile(path => Write(path)));
}

/// <summary>Something long, which is better edited as text.</summary>
internal sealed class SourceFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer)
    : FieldViewModel(context, parameter, pointer)
{
    public bool IsWritten => Written is not null;

    /// <summary>Shows it in the source.</summary>
    public ICommand ShowText => new RelayCommand(() => Context.ShowInSource(Pointer));
}

/// <summary>One of several words.</summary>
internal sealed class ChoiceFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer)
    : FieldViewModel(context, parameter, pointer)
{
    /// <summary>The words.</summary>
    public IReadOnlyList<Choice> Choices { get; } =
        [new("", SessionTexts.Of("panel.noneYet")), .. parameter.Choices.Select(c => new Choice(c, Figures.Spaced(c)))];

    /// <summary>The chosen word.</summary>
    public Choice? Chosen
    {
        get => Choices.FirstOrDefault(c => c.Value.Equals(ParameterValues.Text(Effective) ?? "", StringComparison.OrdinalIgnoreCase)) ?? Choices[0];
        set
        {
            if (!IsReporting && value is { Value.Length: > 0 } && Choices.Contains(value) && value.Value != ParameterValues.Text(Effective))
            {
                Write(value.Value);
            }
        }
    }
}
