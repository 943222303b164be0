using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>What surrounds the scene.</summary>
internal sealed partial class EnvironmentView : UserControl
{
    /// <summary>Makes it.</summary>
    public EnvironmentView() => InitializeComponent();
}
