using System.Diagnostics;
using RayTracer.Jobs;

namespace RayTracer.Cli;

/// <summary>The times of the stages of the work.</summary>
/// <param name="spoken">Takes a line when a stage ends; null for none.</param>
internal sealed class StageTimes(Streams? spoken)
{
    private long _last = Stopwatch.GetTimestamp();

    /// <summary>Seconds for reading the scene file.</summary>
    public double Load { get; private set; }

    /// <summary>Seconds for reading pictures and models, and building what rays meet.</summary>
    public double Build { get; private set; }

    /// <summary>Seconds for taking out noise.</summary>
    public double Denoise { get; private set; }

    /// <summary>Seconds for writing files.</summary>
    public double Write { get; private set; }

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
        Action end = stage switch { JobStage.Load => EndLoad, JobStage.Build => EndBuild, JobStage.Render => EndRender, JobStage.Denoise => EndDenoise, _ => EndWrite };
        end();
    }

    /// <summary>The scene file has been read.</summary>
    public void EndLoad() => Load = End("load");

    /// <summary>The scene has been built.</summary>
    public void EndBuild() => Build = End("build");

    /// <summary>The picture has been rendered.</summary>
    public void EndRender() => End("render");

    /// <summary>The noise has been taken out of the picture.</summary>
    public void EndDenoise() => Denoise = End("denoise");

    /// <summary>The files have been written.</summary>
    public void EndWrite()
    {
        Write = End("write");
        EndAll();
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
    /// <returns>How many seconds it took.</returns>
    public double End(string stage)
    {
        double seconds = Stopwatch.GetElapsedTime(_last).TotalSeconds;
        _last = Stopwatch.GetTimestamp();
        spoken?.Error.WriteLine($"{stage,-8} {seconds:F3} s");
        return seconds;
    }
}
