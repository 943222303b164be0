using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>How far the rendering is, and what is done beside.</summary>
internal sealed partial class StatusView : UserControl
{
    /// <summary>Makes it.</summary>
    public StatusView() => InitializeComponent();
}
