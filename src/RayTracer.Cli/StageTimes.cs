using System.Diagnostics;
using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary>The times of the stages of the work.</summary>
/// <param name="spoken">Takes a line when a stage ends; null for none.</param>
internal sealed class StageTimes(Streams? spoken)
{
    private readonly Dictionary<JobStage, double> _seconds = [];
    private long _last = Stopwatch.GetTimestamp();

    /// <summary>The seconds that a stage took; 0 for one that there was none of.</summary>
    public double this[JobStage stage] => _seconds.GetValueOrDefault(stage);

    /// <summary>The most bytes of memory that the process has had; null where the system does not say.</summary>
    public static long? PeakMemory
    {
        get
        {
            using var process = Process.GetCurrentProcess();
            return process.PeakWorkingSet64 is > 0 and long bytes ? bytes : null;
        }
    }

    /// <summary>A stage of a job has come to its end.</summary>
    public void End(JobStage stage)
    {
        _seconds[stage] = End(stage.ToString().ToLowerInvariant());
        if (stage == JobStage.Write)
        {
            EndAll();
        }
    }

    /// <summary>All is done: reports the most memory used.</summary>
    public void EndAll()
    {
        if (spoken is not null && PeakMemory is { } bytes)
        {
            spoken.Error.WriteLine($"{"memory",-8} {FilmMemory.Text(bytes)} at most");
        }
    }

    /// <summary>A stage has come to its end.</summary>
    /// <param name="stage">Its name.</param>
    /// <returns>The seconds that it took.</returns>
    public double End(string stage)
    {
        double seconds = Stopwatch.GetElapsedTime(_last).TotalSeconds;
        _last = Stopwatch.GetTimestamp();
        spoken?.Error.WriteLine($"{stage,-8} {seconds:F3} s");
        return seconds;
    }
}
