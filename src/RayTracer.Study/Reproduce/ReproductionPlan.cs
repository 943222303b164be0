namespace RayTracer.Study;

/// <summary>The sizes of the pictures, and the measurements of the chart.</summary>
/// <param name="SizeDivisor">By how much the report's widths and heights are divided.</param>
/// <param name="SamplesDivisor">By how much numbers of samples above 16 are divided; the quotients must be squares.</param>
/// <param name="ChartSamples">The samples a pixel that are measured for figure 6.6, at least four.</param>
/// <param name="Rounds">The number of measurements of everything, in turn, so that other programs' busy times do not meet one rendering every time;
/// the fastest counts.</param>
/// <param name="FrameSeconds">For how long pictures of one sample are rendered one after the other.</param>
internal sealed record ReproductionPlan(int SizeDivisor, int SamplesDivisor, IReadOnlyList<int> ChartSamples, int Rounds, double FrameSeconds)
{
    private const int FewSamples = 16;

    /// <summary>The report's sizes.</summary>
    public static ReproductionPlan Full { get; } = new(1, 1, [1, 4, 9, 16, 25, 36, 49, 64, 81, 100, 400], 2, 1);

    /// <summary>A sixteenth of the pixels and, of many samples, a quarter: some seconds.</summary>
    public static ReproductionPlan Quick { get; } = new(4, 4, [1, 4, 9, 16, 25, 36, 49, 64, 81, 100], 2, 0.1);

    /// <summary>True if the pictures are smaller than the report's.</summary>
    public bool IsQuick => SizeDivisor > 1 || SamplesDivisor > 1;

    /// <summary>Width and height of a scene's pictures.</summary>
    public int Size(ReportScene scene) => scene.Size / SizeDivisor;

    /// <summary>Samples a pixel of a picture.</summary>
    public int Samples(ReportPicture picture) =>
        picture.SamplesPerPixel <= FewSamples ? picture.SamplesPerPixel : picture.SamplesPerPixel / SamplesDivisor;
}
