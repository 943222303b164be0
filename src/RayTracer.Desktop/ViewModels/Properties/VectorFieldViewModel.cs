using System.Text.Json.Nodes;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Two or three numbers.</summary>
internal sealed class VectorFieldViewModel : FieldViewModel
{
    private double[] _numbers;

    /// <summary>An editor of numbers.</summary>
    public VectorFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : base(context, parameter, pointer)
    {
        _numbers = new double[parameter.Kind == "vector3" ? 3 : 2];
        string names = _numbers.Length == 3 ? "panel.axes" : "panel.pair";
        Components = [.. _numbers.Select((_, i) => new ComponentViewModel(SessionTexts.Of($"{names}.{i}"), value => Write(ParameterValues.List(_numbers.Select((n, j) => j == i ? value : n)))))];
    }

    /// <summary>The numbers.</summary>
    public IReadOnlyList<ComponentViewModel> Components { get; }

    /// <inheritdoc/>
    protected override JsonNode Start => ParameterValues.List(_numbers.Length == 3 ? [0, 0, 0] : [1, 1]);

    /// <inheritdoc/>
    protected override void Shown()
    {
        _numbers = ParameterValues.Numbers(Effective, _numbers.Length) ?? _numbers;
        for (int i = 0; i < _numbers.Length; i++)
        {
            Components[i].Show(_numbers[i]);
        }
    }
}

/// <summary>A colour: a name or #rrggbb, and the linear numbers that the renderer calculates with.</summary>
internal sealed class ColorFieldViewModel : FieldViewModel
{
    private double[] _linear = [0.5, 0.5, 0.5];

    /// <summary>An editor of a colour.</summary>
    public ColorFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer) : base(context, parameter, pointer) =>
        Components = [.. _linear.Select((_, i) => new ComponentViewModel(SessionTexts.Of($"panel.channels.{i}"), value => Write(ParameterValues.List(_linear.Select((n, j) => j == i ? value : n)))))];

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

            Tell();
        }
    }

    /// <summary>The colour as #rrggbb.</summary>
    public string Hex => ParameterValues.Hex(_linear);

    /// <summary>The linear numbers.</summary>
    public IReadOnlyList<ComponentViewModel> Components { get; }

    /// <inheritdoc/>
    protected override JsonNode Start => ParameterValues.List(Enumerable.Repeat(Math.Max(Parameter.Minimum ?? 0, Math.Min(0.5, Parameter.Maximum ?? 1)), 3));

    /// <inheritdoc/>
    protected override void Shown()
    {
        _linear = ParameterValues.Color(Effective) ?? _linear;
        for (int i = 0; i < 3; i++)
        {
            Components[i].Show(_linear[i]);
        }
    }
}

/// <summary>One number of several.</summary>
/// <param name="name">What it is called.</param>
/// <param name="change">Told the number that was typed.</param>
internal sealed class ComponentViewModel(string name, Action<double> change) : Observable
{
    private double _value;

    /// <summary>What it is called.</summary>
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

            Tell();
        }
    }

    /// <summary>Shows a number.</summary>
    public void Show(double value)
    {
        _value = value;
        Tell(nameof(Text));
    }
}
