using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>Short messages over the window.</summary>
internal sealed partial class MessagesView : UserControl
{
    /// <summary>Makes it.</summary>
    public MessagesView() => InitializeComponent();
}
