using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>The scenes that come with the program.</summary>
internal sealed partial class GalleryView : UserControl
{
    /// <summary>Makes it.</summary>
    public GalleryView() => InitializeComponent();
}
