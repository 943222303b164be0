using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>Work of an earlier session that was not saved.</summary>
internal sealed partial class RecoveryView : UserControl
{
    /// <summary>Makes it.</summary>
    public RecoveryView() => InitializeComponent();
}
