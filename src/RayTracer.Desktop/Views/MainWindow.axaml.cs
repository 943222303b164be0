using Avalonia.Controls;
using RayTracer.Desktop.ViewModels;

namespace RayTracer.Desktop.Views;

/// <summary>The window. It is closed only when nothing is lost by that, or the user says so.</summary>
internal sealed partial class MainWindow : Window
{
    private bool _isClosing;

    /// <summary>Makes it.</summary>
    public MainWindow() => InitializeComponent();

    /// <summary>Closes it, whatever is not saved.</summary>
    public void CloseAnyway()
    {
        _isClosing = true;
        Close();
    }

    /// <inheritdoc/>
    protected override void OnClosing(WindowClosingEventArgs e)
    {
        e.Cancel = !_isClosing && DataContext is MainViewModel main && !main.Files.Close();
        base.OnClosing(e);
    }
}
