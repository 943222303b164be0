using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Five steps around the window.</summary>
internal sealed class TourViewModel : DialogViewModel
{
    private static readonly int Count = SessionTexts.Count("tour.steps");
    private int _step;

    /// <inheritdoc/>
    public override string Title => SessionTexts.Of($"tour.steps.{_step}.0");

    /// <inheritdoc/>
    public override string CancelText => SessionTexts.Of("tour.skip");

    public string Text => SessionTexts.Of($"tour.steps.{_step}.1");

    public string Progress => SessionTexts.Of("tour.progress", _step + 1, Count);

    /// <summary>The text of the button for the next step.</summary>
    public string NextText => SessionTexts.Of(_step + 1 < Count ? "tour.next" : "tour.done");

    public bool CanGoBack => _step > 0;

    /// <summary>Shows the next step; closes the last one.</summary>
    public ICommand Next => field ??= new RelayCommand(() => Go(1));

    /// <summary>Goes back.</summary>
    public ICommand Back => field ??= new RelayCommand(() => Go(-1));

    private void Go(int by)
    {
        if (_step + by >= Count)
        {
            Close();
            return;
        }

        _step = Math.Max(0, _step + by);
        OnPropertyChanged("");
    }
}
