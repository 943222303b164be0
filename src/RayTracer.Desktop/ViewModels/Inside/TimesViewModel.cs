using System.Windows.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The report's times beside this machine's, which are measured when they are asked for.</summary>
internal sealed class TimesViewModel : Observable
{
    private readonly Hand _hand;
    private bool _isRunning;

    /// <summary>Times, not measured yet.</summary>
    public TimesViewModel(Hand hand)
    {
        _hand = hand;
        Measure = new ActionCommand(() => _ = Run());
    }

    /// <summary>The times; none before they are measured.</summary>
    public IReadOnlyList<TimeRow> Rows { get; private set; } = [];

    /// <summary>Whether there are none yet.</summary>
    public bool IsEmpty => Rows.Count == 0;

    /// <summary>Whether they are.</summary>
    public bool IsMeasured => Rows.Count > 0;

    /// <summary>Whether they can be measured now.</summary>
    public bool CanMeasure => !_isRunning;

    /// <summary>What the button says.</summary>
    public string ButtonText => SessionTexts.Of(_isRunning ? "times.running" : "times.run");

    /// <summary>Measures them.</summary>
    public ICommand Measure { get; }

    private async Task Run()
    {
        _isRunning = true;
        Tell("");
        await _hand.Attempt(async () => Rows = [.. (await _hand.Aside(s => s.Part<ReportTimes>().Measure())).Select(t => new TimeRow(t))]);
        _isRunning = false;
        Tell("");
    }
}
