using Avalonia.Controls;
using RayTracer.Desktop.ViewModels;

namespace RayTracer.Desktop.Views;

/// <summary>The error against the number of samples.</summary>
internal sealed partial class ConvergenceView : UserControl
{
    /// <summary>Makes it.</summary>
    public ConvergenceView()
    {
        InitializeComponent();
        Plot.SizeChanged += (_, e) => (DataContext as ConvergenceViewModel)?.Resize(e.NewSize.Width, e.NewSize.Height);
    }
}
