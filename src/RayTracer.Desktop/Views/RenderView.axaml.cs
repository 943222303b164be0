using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>How the picture is rendered.</summary>
internal sealed partial class RenderView : UserControl
{
    /// <summary>Makes it.</summary>
    public RenderView() => InitializeComponent();
}
