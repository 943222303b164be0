using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>A question over the window.</summary>
internal sealed partial class DialogView : UserControl
{
    /// <summary>Makes it.</summary>
    public DialogView() => InitializeComponent();
}
