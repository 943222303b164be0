using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Five steps around the window.</summary>
internal sealed class TourViewModel : DialogViewModel
{
    private static readonly int Count = SessionTexts.Count("tour.steps");
    private int _step;

    /// <summary>The tour, at its first step.</summary>
    public TourViewModel()
    {
        Next = new ActionCommand(() => Go(1));
        Back = new ActionCommand(() => Go(-1));
    }

    /// <inheritdoc/>
    public override string Title => SessionTexts.Of($"tour.steps.{_step}.0");

    /// <inheritdoc/>
    public override string CancelText => SessionTexts.Of("tour.skip");

    /// <summary>What there is to know.</summary>
    public string Text => SessionTexts.Of($"tour.steps.{_step}.1");

    /// <summary>Which step it is.</summary>
    public string Progress => SessionTexts.Of("tour.progress", _step + 1, Count);

    /// <summary>What the button says that goes on.</summary>
    public string NextText => SessionTexts.Of(_step + 1 < Count ? "tour.next" : "tour.done");

    /// <summary>Whether there is a step before.</summary>
    public bool CanGoBack => _step > 0;

    /// <summary>Goes on; closes the last step.</summary>
    public ICommand Next { get; }

    /// <summary>Goes back.</summary>
    public ICommand Back { get; }

    private void Go(int by)
    {
        if (_step + by >= Count)
        {
            Close();
            return;
        }

        _step = Math.Max(0, _step + by);
        Tell("");
    }
}
