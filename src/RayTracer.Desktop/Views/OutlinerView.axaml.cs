using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>The tree of all things.</summary>
internal sealed partial class OutlinerView : UserControl
{
    /// <summary>Makes it.</summary>
    public OutlinerView() => InitializeComponent();
}
