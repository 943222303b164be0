namespace RayTracer.Jobs;

/// <summary>One picture of the report's section 6.3.</summary>
/// <param name="Letter">A to D, as in its figure.</param>
/// <param name="SamplesPerPixel">Samples a pixel, by the count of primary rays (the captions of 6.4 D and 6.5 C say 200).</param>
/// <param name="Seconds">The report's time.</param>
public sealed record ReportPicture(char Letter, int SamplesPerPixel, double Seconds);
