using Avalonia;
using Avalonia.Controls;
using Avalonia.Input;
using RayTracer.Desktop.ViewModels;

namespace RayTracer.Desktop.Views;

/// <summary>The picture, and what is drawn over it.</summary>
internal sealed partial class ViewportView : UserControl
{
    private bool _isSpaceHeld;

    /// <summary>Makes it.</summary>
    public ViewportView()
    {
        InitializeComponent();
        Surface.SizeChanged += (_, e) => Shown?.Resize(e.NewSize.Width, e.NewSize.Height);
        Surface.PointerPressed += Press;
        Surface.PointerMoved += (_, e) => Shown?.Move(At(e));
        Surface.PointerReleased += (_, e) => Shown?.Release(At(e));
        Surface.PointerWheelChanged += Turn;
        Surface.KeyDown += Key;
        Surface.KeyUp += (_, e) => _isSpaceHeld &= e.Key != Avalonia.Input.Key.Space;
    }

    private ViewportViewModel? Shown => DataContext as ViewportViewModel;

    /// <inheritdoc/>
    protected override void OnDataContextChanged(EventArgs e)
    {
        base.OnDataContextChanged(e);
        if (Surface.Bounds.Width > 0)
        {
            Shown?.Resize(Surface.Bounds.Width, Surface.Bounds.Height);
        }
    }

    /// <inheritdoc/>
    protected override void OnAttachedToVisualTree(VisualTreeAttachmentEventArgs e)
    {
        base.OnAttachedToVisualTree(e);
        if (Shown is { } shown && TopLevel.GetTopLevel(this) is { } window)
        {
            shown.ScreenScale = window.RenderScaling;
        }
    }

    private Spot At(PointerEventArgs e) => e.GetPosition(Surface) is var at ? new(at.X, at.Y) : default;

    private void Press(object? sender, PointerPressedEventArgs e)
    {
        Surface.Focus();
        e.Pointer.Capture(Surface);
        PointerPointProperties buttons = e.GetCurrentPoint(Surface).Properties;
        PointerButton button = buttons.IsRightButtonPressed ? PointerButton.Second : buttons.IsMiddleButtonPressed ? PointerButton.Middle : PointerButton.Main;
        Shown?.Press(At(e), button, Keyboard.Held(e.KeyModifiers) | (_isSpaceHeld ? HeldKeys.Space : HeldKeys.None));
        e.Handled = true;
    }

    private void Turn(object? sender, PointerWheelEventArgs e)
    {
        Shown?.Turn(At(e), e.Delta.Y, Keyboard.Held(e.KeyModifiers));
        e.Handled = true;
    }

    private void Key(object? sender, KeyEventArgs e)
    {
        _isSpaceHeld |= e.Key == Avalonia.Input.Key.Space;
        e.Handled = e.Key == Avalonia.Input.Key.Space || Shown?.Key(Keyboard.NameOf(e.Key, e.KeyModifiers), Keyboard.Held(e.KeyModifiers)) == true;
    }
}
