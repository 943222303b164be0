using System.Text.Json.Nodes;
using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>
/// A texture or a material: a number or a colour where they may stand for one, one of the named ones, or one that is written in place.
/// </summary>
internal sealed class KindFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer)
    : FieldViewModel(context, parameter, pointer)
{
    private const string PlainNumber = "number";
    private const string PlainColor = "color";
    private const string Named = "name:";
    private const string InPlace = "type:";
    private readonly bool _isTexture = parameter.Kind == "texture";

    /// <summary>The kinds to choose from.</summary>
    public IReadOnlyList<Choice> Choices { get; private set; } = [];

    public Choice? Chosen
    {
        get => Choices.FirstOrDefault(c => c.Value == Kind);
        set
        {
            if (!IsReporting && value is { Value.Length: > 0 } && Choices.Contains(value) && value.Value != Kind)
            {
                Write(FirstOf(value.Value));
            }
        }
    }

    /// <summary>The editor for what it is: a number, a colour, or a record; null where it is named.</summary>
    public object? Inner { get; private set; }

    /// <summary>Returns whether it is one of the named ones.</summary>
    public bool IsNamed => Kind.StartsWith(Named, StringComparison.Ordinal);

    /// <summary>The text of the button that shows the named one.</summary>
    public string EditText => SessionTexts.Of("panel.edit", IsNamed ? Kind[Named.Length..] : "");

    /// <summary>Goes to the named one.</summary>
    public ICommand Edit => new RelayCommand(() => Context.Select(JsonPointer.Of(Family + "s", Kind[Named.Length..])));

    private string Family => _isTexture ? "texture" : "material";

    private CatalogueType? Type => ParameterValues.TypeOf(Effective, Family);

    private string Kind => _isTexture && Parameter.IsNumber && ParameterValues.Grey(Effective) is not null ? PlainNumber
        : _isTexture && ParameterValues.Color(Effective) is not null ? PlainColor
        : ParameterValues.Text(Effective) is { } name ? Named + name
        : Type is { } type ? InPlace + type.Name : "";

    /// <inheritdoc/>
    protected override void Shown()
    {
        IEnumerable<Choice> plain = !_isTexture ? [] : Parameter.IsNumber && Kind != PlainColor ? [new(PlainNumber, SessionTexts.Of("panel.number"))]
            : Parameter.IsNumber ? [new(PlainNumber, SessionTexts.Of("panel.number")), new(PlainColor, SessionTexts.Of("panel.plainColor"))]
            : [new(PlainColor, SessionTexts.Of("panel.plainColor"))];
        IEnumerable<OutlineNode> named = (_isTexture ? Context.Outline?.Textures : Context.Outline?.Materials) ?? [];
        Choice[] choices =
        [
            .. Kind.Length == 0 ? [new Choice("", SessionTexts.Of("panel.noneYet"))] : Array.Empty<Choice>(), .. plain,
            .. named.Select(n => new Choice(Named + n.Name, $"{n.Name} ({SessionTexts.Of("panel.named").ToLowerInvariant()})")),
            .. PanelContext.Catalogue.Types[Family].Select(t => new Choice(InPlace + t.Name, Figures.Spaced(t.Name), t.Summary)),
        ];
        if (!choices.SequenceEqual(Choices))
        {
            Choices = choices;
        }

        ShowInner();
    }

    private void ShowInner()
    {
        switch (Kind)
        {
            case PlainNumber:
                NumberFieldViewModel number = Inner as NumberFieldViewModel ?? new(Context, Parameter, Pointer);
                number.Show(Written);
                Inner = number;
                break;
            case PlainColor:
                ColorFieldViewModel color = Inner as ColorFieldViewModel ?? new(Context, Parameter, Pointer);
                color.Show(Written);
                Inner = color;
                break;
            default:
                RecordViewModel? record = Type is not { } type ? null : Inner is RecordViewModel same && same.Type == type ? same : new(Context, type, Pointer);
                record?.Show(Effective);
                Inner = record;
                break;
        }
    }

    private JsonNode? FirstOf(string kind) => kind switch
    {
        PlainNumber => ParameterValues.Grey(Parameter.Default) ?? 0.5,
        PlainColor => ParameterValues.List([0.5, 0.5, 0.5]),
        _ when kind.StartsWith(Named, StringComparison.Ordinal) => kind[Named.Length..],
        _ => ParameterValues.Retyped(Effective, PanelContext.Catalogue.Types[Family].First(t => t.Name == kind[InPlace.Length..]), Type),
    };
}
