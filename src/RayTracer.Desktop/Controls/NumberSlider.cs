using Avalonia;
using Avalonia.Controls;
using Avalonia.Data;
using Avalonia.Input;
using Avalonia.Interactivity;

namespace RayTracer.Desktop.Controls;

/// <summary>
/// A slider whose number only the user changes. Avalonia's own moves its value into its range, and so writes into whatever it happens to be
/// bound to while it gets its parts, or is bound to something else.
/// </summary>
internal sealed class NumberSlider : Slider
{
    /// <summary>The number.</summary>
    public static readonly StyledProperty<double> NumberProperty =
        AvaloniaProperty.Register<NumberSlider, double>(nameof(Number), defaultBindingMode: BindingMode.TwoWay);

    private bool _isHeld;

    /// <summary>Makes it.</summary>
    public NumberSlider()
    {
        AddHandler(PointerPressedEvent, (_, _) => _isHeld = true, RoutingStrategies.Tunnel, handledEventsToo: true);
        AddHandler(PointerReleasedEvent, (_, _) => _isHeld = false, RoutingStrategies.Bubble, handledEventsToo: true);
        AddHandler(PointerCaptureLostEvent, (_, _) => _isHeld = false, RoutingStrategies.Bubble, handledEventsToo: true);
    }

    /// <summary>The number.</summary>
    public double Number
    {
        get => GetValue(NumberProperty);
        set => SetValue(NumberProperty, value);
    }

    /// <inheritdoc/>
    protected override Type StyleKeyOverride => typeof(Slider);

    /// <inheritdoc/>
    protected override void OnKeyDown(KeyEventArgs e)
    {
        bool wasHeld = _isHeld;
        _isHeld = true;
        base.OnKeyDown(e);
        _isHeld = wasHeld;
    }

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        base.OnPropertyChanged(change);
        if (change.Property == MinimumProperty || change.Property == MaximumProperty)
        {
            SmallChange = (Maximum - Minimum) / 100;
            LargeChange = (Maximum - Minimum) / 10;
            SetCurrentValue(ValueProperty, Number);
        }
        else if (change.Property == NumberProperty)
        {
            SetCurrentValue(ValueProperty, Number);
        }
        else if (change.Property == ValueProperty && _isHeld)
        {
            SetCurrentValue(NumberProperty, Value);
        }
    }
}
