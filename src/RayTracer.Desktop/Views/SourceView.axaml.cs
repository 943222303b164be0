using System.ComponentModel;
using Avalonia.Controls;
using RayTracer.Desktop.ViewModels;

namespace RayTracer.Desktop.Views;

/// <summary>The scene file's text, and what is wrong with it.</summary>
internal sealed partial class SourceView : UserControl
{
    private SourceViewModel? _shown;

    /// <summary>Makes it.</summary>
    public SourceView() => InitializeComponent();

    /// <inheritdoc/>
    protected override void OnDataContextChanged(EventArgs e)
    {
        base.OnDataContextChanged(e);
        if (_shown is not null)
        {
            _shown.PropertyChanged -= Follow;
        }

        _shown = DataContext as SourceViewModel;
        if (_shown is not null)
        {
            _shown.PropertyChanged += Follow;
        }
    }

    private void Follow(object? sender, PropertyChangedEventArgs e)
    {
        if (e.PropertyName == nameof(SourceViewModel.Place) && _shown is { Place: var place })
        {
            int length = Editor.Text?.Length ?? 0;
            (Editor.SelectionStart, Editor.SelectionEnd) = (Math.Clamp(place.From, 0, length), Math.Clamp(place.To, 0, length));
            Editor.CaretIndex = Editor.SelectionEnd;
            (Editor.SelectionStart, Editor.SelectionEnd) = (Math.Clamp(place.From, 0, length), Math.Clamp(place.To, 0, length));
            Editor.Focus();
        }
    }
}
