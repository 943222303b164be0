using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>The name of a parameter, its editor, and the way back to its default.</summary>
internal sealed partial class FieldRow : UserControl
{
    /// <summary>Makes it.</summary>
    public FieldRow() => InitializeComponent();
}
