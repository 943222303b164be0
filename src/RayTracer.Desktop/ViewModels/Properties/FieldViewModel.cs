using System.Text.Json;
using System.Text.Json.Nodes;
using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The editor of one parameter.</summary>
internal abstract class FieldViewModel : Observable
{
    /// <summary>An editor.</summary>
    /// <param name="context">What it needs of the rest.</param>
    /// <param name="parameter">The parameter.</param>
    /// <param name="pointer">Where its value stands, or would.</param>
    protected FieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer)
    {
        (Context, Parameter, Pointer) = (context, parameter, pointer);
        Reset = new ActionCommand(() => context.Reset(pointer));
        Begin = new ActionCommand(() => Write(Start));
    }

    /// <summary>The parameter.</summary>
    public CatalogueParameter Parameter { get; }

    /// <summary>Where its value stands, or would.</summary>
    public string Pointer { get; }

    /// <summary>What it is called.</summary>
    public string Label => Figures.Spaced(Parameter.Key);

    /// <summary>Its unit; empty where there is none.</summary>
    public string Unit => Parameter.Unit;

    /// <summary>What it means, its unit and its range.</summary>
    public string Tip => string.Join(' ', new[]
    {
        Parameter.Summary,
        Parameter.Unit.Length > 0 ? $"({SessionTexts.Of("panel.unit", Parameter.Unit)})" : "",
        Parameter.Range.Length > 0 ? $"{SessionTexts.Of("panel.range", Parameter.Range)}." : "",
    }.Where(t => t.Length > 0));

    /// <summary>Whether the text says something here that can go, so that the default counts.</summary>
    public bool CanReset => Written is not null && !Parameter.Required;

    /// <summary>What that button says.</summary>
    public string ResetText => SessionTexts.Of("panel.reset", Label);

    /// <summary>Whether there is a value, written or by default.</summary>
    public bool IsSet => Effective is not null;

    /// <summary>Takes the value out of the text.</summary>
    public ICommand Reset { get; }

    /// <summary>Writes a first value where there is none.</summary>
    public ICommand Begin { get; }

    /// <summary>What it needs of the rest.</summary>
    protected PanelContext Context { get; }

    /// <summary>What is written; null where nothing is.</summary>
    protected JsonNode? Written { get; private set; }

    /// <summary>What counts: the written value, or the default.</summary>
    protected JsonNode? Effective { get; private set; }

    /// <summary>A first value.</summary>
    protected virtual JsonNode Start => Parameter.Minimum ?? 0;

    /// <summary>Shows what is written.</summary>
    public void Show(JsonNode? written)
    {
        (Written, Effective) = (written, written ?? Parameter.Default);
        Shown();
        Tell("");
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
        "record" when SectionOf(p) is { } type => new RecordFieldViewModel(context, p, pointer, type),
        "records" when SectionOf(p) is { } type => new StepsFieldViewModel(context, p, pointer, type),
        _ => new SourceFieldViewModel(context, p, pointer),
    };

    /// <summary>Takes over what is written, before all properties are told anew.</summary>
    protected abstract void Shown();

    /// <summary>Writes a value.</summary>
    protected void Write(JsonNode? value, string? gesture = null) => Context.Set(Pointer, value, gesture);

    private static CatalogueType? SectionOf(CatalogueParameter p) => PanelContext.Catalogue.Sections.GetValueOrDefault(p.Record ?? p.Key);
}

/// <summary>On or off.</summary>
internal sealed class SwitchFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : FieldViewModel(context, parameter, pointer)
{
    private bool _isOn;

    /// <summary>Whether it is on.</summary>
    public bool IsOn
    {
        get => _isOn;
        set
        {
            if (!IsTelling && Set(ref _isOn, value))
            {
                Write(value);
            }
        }
    }

    /// <inheritdoc/>
    protected override void Shown() => _isOn = Effective?.GetValueKind() == JsonValueKind.True;
}

/// <summary>A text, or the name of a file.</summary>
internal sealed class TextFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : FieldViewModel(context, parameter, pointer)
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

    /// <summary>Whether it is a file.</summary>
    public bool IsFile => Parameter.Kind == "file";

    /// <summary>Asks for a file.</summary>
    public ICommand Choose => new ActionCommand(() => Context.ChooseFile(path => Write(path)));

    /// <inheritdoc/>
    protected override void Shown()
    {
    }
}

/// <summary>Something long, which is better edited as text.</summary>
internal sealed class SourceFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : FieldViewModel(context, parameter, pointer)
{
    /// <summary>Whether something is written.</summary>
    public bool IsWritten => Written is not null;

    /// <summary>Shows it in the source.</summary>
    public ICommand ShowText => new ActionCommand(() => Context.ShowInSource(Pointer));

    /// <inheritdoc/>
    protected override void Shown()
    {
    }
}

/// <summary>One of several words.</summary>
internal sealed class ChoiceFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : FieldViewModel(context, parameter, pointer)
{
    /// <summary>The words.</summary>
    public IReadOnlyList<Choice> Choices { get; } = [new("", SessionTexts.Of("panel.noneYet")), .. parameter.Choices.Select(c => new Choice(c, Figures.Spaced(c)))];

    /// <summary>The chosen word.</summary>
    public Choice? Chosen
    {
        get => Choices.FirstOrDefault(c => c.Value.Equals(ParameterValues.Text(Effective) ?? "", StringComparison.OrdinalIgnoreCase)) ?? Choices[0];
        set
        {
            if (!IsTelling && value is { Value.Length: > 0 } && Choices.Contains(value) && value.Value != ParameterValues.Text(Effective))
            {
                Write(value.Value);
            }
        }
    }

    /// <inheritdoc/>
    protected override void Shown()
    {
    }
}
