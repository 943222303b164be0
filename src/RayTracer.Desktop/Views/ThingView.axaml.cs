using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>The properties of one thing.</summary>
internal sealed partial class ThingView : UserControl
{
    /// <summary>Makes it.</summary>
    public ThingView() => InitializeComponent();
}
