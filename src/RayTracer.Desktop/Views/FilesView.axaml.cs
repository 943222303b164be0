using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>What was opened lately.</summary>
internal sealed partial class FilesView : UserControl
{
    /// <summary>Makes it.</summary>
    public FilesView() => InitializeComponent();
}
