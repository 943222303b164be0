using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>What can be added.</summary>
internal sealed partial class AddView : UserControl
{
    /// <summary>Makes it.</summary>
    public AddView() => InitializeComponent();
}
