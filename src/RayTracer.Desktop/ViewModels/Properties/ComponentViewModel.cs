namespace RayTracer.Desktop.ViewModels;

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
