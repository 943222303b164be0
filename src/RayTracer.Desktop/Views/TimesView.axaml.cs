using Avalonia.Controls;

namespace RayTracer.Desktop.Views;

/// <summary>The report's times beside this machine's.</summary>
internal sealed partial class TimesView : UserControl
{
    /// <summary>Makes it.</summary>
    public TimesView() => InitializeComponent();
}
