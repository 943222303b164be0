using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>The light paths of one pixel.</summary>
internal sealed partial class PathsView : UserControl
{
    /// <summary>Makes it.</summary>
    public PathsView() => InitializeComponent();
}
