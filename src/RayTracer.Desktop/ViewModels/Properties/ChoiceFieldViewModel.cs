using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

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
