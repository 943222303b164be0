using RayTracer.Jobs;

namespace RayTracer.Cli.Reproduce;

/// <summary>A picture of the report, and how long it took here.</summary>
/// <param name="Scene">Its scene.</param>
/// <param name="Picture">The report's picture.</param>
/// <param name="All">The rendering with all threads, whose picture was written.</param>
/// <param name="One">The rendering with one thread.</param>
internal sealed record ReproducedPicture(ReportScene Scene, ReportPicture Picture, Measurement All, Measurement One)
{
    /// <summary>The picture's name in the report.</summary>
    public string Name => $"{Scene.Figure} {Picture.Letter}";

    /// <summary>How many times as fast a rendering is as the report's, path for path.</summary>
    public double SpeedUp(Measurement measurement) => Picture.Seconds / Scene.Paths(Picture) / measurement.SecondsPerPath;
}
