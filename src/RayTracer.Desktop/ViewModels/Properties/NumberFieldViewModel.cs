using System.Globalization;
using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>A number, with a slider where its range is small, and the report's substances where it is a refractive index.</summary>
internal sealed class NumberFieldViewModel(PanelContext context, CatalogueParameter parameter, string pointer)
    : FieldViewModel(context, parameter, pointer)
{
    private readonly Gesture _sliding = new();
    private readonly bool _isInteger = parameter.Kind == "integer";
    private double _value;

    /// <summary>The number.</summary>
    public double Value
    {
        get => _value;
        set
        {
            double wanted = Clamped(value);
            if (IsSet && !IsReporting && SetProperty(ref _value, wanted))
            {
                Write(wanted, _sliding.Burst());
                OnPropertyChanged(nameof(Text));
            }
        }
    }

    /// <summary>The number as it is typed.</summary>
    public string Text
    {
        get => Figures.Short(_value, 7);
        set
        {
            if (Figures.Parse(value) is { } number)
            {
                Value = number;
            }

            OnPropertyChanged();
        }
    }

    /// <summary>Returns whether a slider can sensibly cover its range.</summary>
    public bool HasSlider => IsSet && Parameter is { Minimum: { } low, Maximum: { } high } && high - low <= (_isInteger ? 64 : 360);

    /// <summary>The slider's left end.</summary>
    public double Minimum => HasSlider ? Math.Min(Parameter.Minimum!.Value, _value) : 0;

    /// <summary>The slider's right end.</summary>
    public double Maximum => HasSlider ? Math.Max(Parameter.Maximum!.Value, _value) : 1;

    /// <summary>Adds steps, as many as the parameter says.</summary>
    public ICommand Step =>
        field ??= new RelayCommand<object?>(steps => Value = Stepped(_value, Convert.ToDouble(steps, CultureInfo.InvariantCulture)));

    /// <summary>Substances of known refractive index; none for other numbers.</summary>
    public IReadOnlyList<Choice> Substances { get; } = parameter.Key != "refractiveIndex" ? []
        : [new("", SessionTexts.Of("panel.own")), .. PanelContext.Catalogue.RefractiveIndices.Select(r => new Choice(r.Name, $"{r.Name} ({Figures.Short(r.Value)})"))];

    public bool HasSubstances => Substances.Count > 0;

    /// <summary>The substance that has this number.</summary>
    public Choice? Substance
    {
        get => Substances.FirstOrDefault(s => s.Value.Length > 0 && Math.Abs(IndexOf(s) - _value) < 1e-6) ?? (Substances is [var own, ..] ? own : null);
        set
        {
            if (!IsReporting && value is { Value.Length: > 0 })
            {
                Value = IndexOf(value);
            }
        }
    }

    /// <inheritdoc/>
    protected override void Shown() => _value = ParameterValues.Grey(Effective) ?? 0;

    private static double IndexOf(Choice substance) => PanelContext.Catalogue.RefractiveIndices.First(r => r.Name == substance.Value).Value;

    private double Clamped(double value)
    {
        double smallest = Parameter.Minimum is { } low ? low + (Parameter.MinimumIsExclusive ? (_isInteger ? 1 : 1e-4) : 0) : double.NegativeInfinity;
        double within = Math.Max(smallest, Math.Min(value, Parameter.Maximum ?? double.PositiveInfinity));
        return _isInteger ? Math.Round(within) : double.Parse(within.ToString("G7", CultureInfo.InvariantCulture), CultureInfo.InvariantCulture);
    }

    // About a hundredth of the number, a round power of ten.
    private double Stepped(double value, double steps)
    {
        double step = 1;
        while (!_isInteger && step > 1e-6 && step * 10 > Math.Max(Math.Abs(value), 0.1))
        {
            step /= 10;
        }

        return value + (steps * step);
    }
}
