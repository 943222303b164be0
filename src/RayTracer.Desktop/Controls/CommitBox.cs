using System.Windows.Input;
using Avalonia;
using Avalonia.Controls;
using Avalonia.Data;
using Avalonia.Input;
using Avalonia.Interactivity;

namespace RayTracer.Desktop.Controls;

/// <summary>A box for a short text that counts when it is left, or with Enter; Escape takes it back. Arrow keys step numbers.</summary>
internal sealed class CommitBox : TextBox
{
    /// <summary>The text that counts.</summary>
    public static readonly StyledProperty<string> ValueProperty =
        AvaloniaProperty.Register<CommitBox, string>(nameof(Value), "", defaultBindingMode: BindingMode.TwoWay);

    /// <summary>Steps a number; its parameter is by how many steps.</summary>
    public static readonly StyledProperty<ICommand?> StepProperty = AvaloniaProperty.Register<CommitBox, ICommand?>(nameof(Step));

    /// <summary>The text that counts.</summary>
    public string Value
    {
        get => GetValue(ValueProperty);
        set => SetValue(ValueProperty, value);
    }

    /// <summary>Steps a number.</summary>
    public ICommand? Step
    {
        get => GetValue(StepProperty);
        set => SetValue(StepProperty, value);
    }

    /// <inheritdoc/>
    protected override Type StyleKeyOverride => typeof(TextBox);

    /// <summary>The text that is typed counts.</summary>
    public void Commit()
    {
        if (Text != Value)
        {
            SetCurrentValue(ValueProperty, Text ?? "");

            // Where it was not taken, what counts is shown again.
            Text = Value;
        }
    }

    /// <inheritdoc/>
    protected override void OnPropertyChanged(AvaloniaPropertyChangedEventArgs change)
    {
        base.OnPropertyChanged(change);
        if (change.Property == ValueProperty)
        {
            Text = Value;
        }
    }

    /// <inheritdoc/>
    protected override void OnLostFocus(RoutedEventArgs e)
    {
        base.OnLostFocus(e);
        Commit();
    }

    /// <inheritdoc/>
    protected override void OnKeyDown(KeyEventArgs e)
    {
        int steps = e.KeyModifiers.HasFlag(KeyModifiers.Shift) ? 10 : 1;
        switch (e.Key)
        {
            case Key.Enter:
                Commit();
                break;
            case Key.Escape when Text != Value:
                Text = Value;
                break;
            case Key.Up when Step is not null:
                Commit();
                Step.Execute(steps);
                break;
            case Key.Down when Step is not null:
                Commit();
                Step.Execute(-steps);
                break;
            default:
                base.OnKeyDown(e);
                return;
        }

        e.Handled = true;
    }
}
