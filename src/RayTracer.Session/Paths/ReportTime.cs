namespace RayTracer.Session;

/// <summary>A time of the report beside this machine's.</summary>
/// <param name="Scene">Number of the scene.</param>
/// <param name="Figure">The figure that shows it, and the picture's letter in it.</param>
/// <param name="Width">Width and height in pixels.</param>
/// <param name="Samples">Samples in each pixel.</param>
/// <param name="ReportSeconds">How long the report's machine took.</param>
/// <param name="Seconds">How long this one takes: measured with fewer samples, and multiplied.</param>
public sealed record ReportTime(int Scene, string Figure, int Width, int Samples, double ReportSeconds, double Seconds)
{
    /// <summary>The speed of this machine as a multiple.</summary>
    public double Factor => ReportSeconds / Seconds;
}
