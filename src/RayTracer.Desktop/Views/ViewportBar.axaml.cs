using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>What the picture shows, and how.</summary>
internal sealed partial class ViewportBar : UserControl
{
    /// <summary>Makes it.</summary>
    public ViewportBar() => InitializeComponent();
}
