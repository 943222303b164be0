using System.Text.Json.Nodes;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Several numbers, each with its own box.</summary>
/// <param name="context">The rest of the window, as editors use it.</param>
/// <param name="parameter">The parameter.</param>
/// <param name="pointer">The pointer to its value, written or not.</param>
/// <param name="numbers">The numbers while none are written.</param>
/// <param name="names">The place of the boxes' names among the texts.</param>
internal abstract class ComponentsFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer, double[] numbers, string names)
    : FieldViewModel(context, parameter, pointer)
{
    /// <summary>The boxes.</summary>
    public IReadOnlyList<ComponentViewModel> Components => field ??= [.. Numbers.Select((_, i) => new ComponentViewModel(
        SessionTexts.Of($"{names}.{i}"), value => Write(ParameterValues.List(Numbers.Select((n, j) => j == i ? value : n)))))];

    /// <summary>The numbers.</summary>
    protected double[] Numbers { get; private set; } = numbers;

    /// <summary>Returns the numbers of a written value; null where it has none.</summary>
    protected abstract double[]? Read(JsonNode? value);

    /// <inheritdoc/>
    protected override void Shown()
    {
        Numbers = Read(Effective) ?? Numbers;
        for (int i = 0; i < Numbers.Length; i++)
        {
            Components[i].Show(Numbers[i]);
        }
    }
}

/// <summary>Two or three numbers.</summary>
internal sealed class VectorFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : ComponentsFieldViewModel(
    context, parameter, pointer, new double[parameter.Kind == "vector3" ? 3 : 2], parameter.Kind == "vector3" ? "panel.axes" : "panel.pair")
{
    /// <inheritdoc/>
    protected override JsonNode Start => ParameterValues.List(Numbers.Length == 3 ? [0, 0, 0] : [1, 1]);

    /// <inheritdoc/>
    protected override double[]? Read(JsonNode? value) => ParameterValues.Numbers(value, Numbers.Length);
}

/// <summary>A colour: a name or #rrggbb, and the linear numbers that the renderer calculates with.</summary>
internal sealed class ColorFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer)
    : ComponentsFieldViewModel(context, parameter, pointer, [0.5, 0.5, 0.5], "panel.channels")
{
    /// <summary>The name or #rrggbb; empty where numbers are written.</summary>
    public string Name
    {
        get => ParameterValues.Text(Written) ?? "";
        set
        {
            string tidy = (value ?? "").Trim().ToLowerInvariant();
            if (tidy != Name && ParameterValues.Color(tidy) is not null)
            {
                Write(tidy);
            }

            OnPropertyChanged();
        }
    }

    /// <summary>The colour as #rrggbb.</summary>
    public string Hex => ParameterValues.Hex(Numbers);

    /// <inheritdoc/>
    protected override JsonNode Start =>
        ParameterValues.List(Enumerable.Repeat(Math.Max(Parameter.Minimum ?? 0, Math.Min(0.5, Parameter.Maximum ?? 1)), 3));

    /// <inheritdoc/>
    protected override double[]? Read(JsonNode? value) => ParameterValues.Color(value);
}

/// <summary>One number of several.</summary>
/// <param name="name">Its name.</param>
/// <param name="change">Takes the number that was typed.</param>
internal sealed class ComponentViewModel(string name, Action<double> change) : Observable
{
    private double _value;

    public string Name => name;

    /// <summary>The number as it is typed.</summary>
    public string Text
    {
        get => Figures.Short(_value, 7);
        set
        {
            if (Figures.Parse(value) is { } number && number != _value)
            {
                _value = number;
                change(number);
            }

            OnPropertyChanged();
        }
    }

    /// <summary>Shows a number.</summary>
    public void Show(double value)
    {
        _value = value;
        OnPropertyChanged(nameof(Text));
    }
}
