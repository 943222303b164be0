using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

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
    public string Here => Time.Seconds < 1 ? SessionTexts.Of("times.milliseconds", Figures.Short(Time.Seconds * 1000, 3)) : Figures.Duration(Time.Seconds);

    /// <summary>How much faster that is.</summary>
    public string Ratio => SessionTexts.Of("times.times", Figures.Short(Time.Factor, 3));
}
