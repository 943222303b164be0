using System.Windows.Input;
using CommunityToolkit.Mvvm.Input;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The report's times beside this machine's, which are measured when they are asked for.</summary>
internal sealed class TimesViewModel(SessionDispatcher dispatcher) : Observable
{
    private bool _isRunning;

    /// <summary>The times; none before they are measured.</summary>
    public IReadOnlyList<TimeRow> Rows { get; private set; } = [];

    public bool IsEmpty => Rows.Count == 0;

    public bool CanMeasure => !_isRunning;

    public string ButtonText => SessionTexts.Of(_isRunning ? "times.running" : "times.run");

    /// <summary>Measures them.</summary>
    public ICommand Measure => field ??= new RelayCommand(() => _ = Run());

    private async Task Run()
    {
        _isRunning = true;
        OnPropertyChanged("");
        await dispatcher.Attempt(async () => Rows = [.. (await dispatcher.Aside(s => s.Part<ReportTimes>().Measure())).Select(t => new TimeRow(t))]);
        _isRunning = false;
        OnPropertyChanged("");
    }
}

/// <summary>A time of the report, beside this machine's.</summary>
internal sealed record TimeRow(ReportTime Time)
{
    /// <summary>The report's figure.</summary>
    public string Figure => Time.Figure;

    /// <summary>Size and samples.</summary>
    public string Settings => SessionTexts.Of("times.setting", Time.Width, Time.Width, Time.Samples);

    /// <summary>The report's time.</summary>
    public string Report => Figures.Duration(Time.ReportSeconds);

    /// <summary>This machine's time.</summary>
    public string Here =>
        Time.Seconds < 1 ? SessionTexts.Of("times.milliseconds", Figures.Short(Time.Seconds * 1000, 3)) : Figures.Duration(Time.Seconds);

    public string Ratio => SessionTexts.Of("times.times", Figures.Short(Time.Factor, 3));
}
