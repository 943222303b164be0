using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>What to show in the picture.</summary>
internal sealed partial class MapsView : UserControl
{
    /// <summary>Makes it.</summary>
    public MapsView() => InitializeComponent();
}
