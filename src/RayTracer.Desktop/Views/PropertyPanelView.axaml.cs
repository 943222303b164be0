using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>The properties: of the selected thing, the camera, the rendering and the world.</summary>
internal sealed partial class PropertyPanelView : UserControl
{
    /// <summary>Makes it.</summary>
    public PropertyPanelView() => InitializeComponent();
}
