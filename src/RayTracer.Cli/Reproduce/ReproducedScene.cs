using RayTracer.Jobs;

namespace RayTracer.Cli.Reproduce;

/// <summary>A scene of the report, and everything that was measured with it.</summary>
/// <param name="Scene">The report's scene.</param>
/// <param name="Primitives">Shapes in the scene file, without the lights.</param>
/// <param name="Lights">Lights in the scene file.</param>
/// <param name="Width">Width in the scene file.</param>
/// <param name="Height">Height in the scene file.</param>
internal sealed record ReproducedScene(ReportScene Scene, int Primitives, int Lights, int Width, int Height)
{
    /// <summary>The pictures, in the report's order.</summary>
    public List<ReproducedPicture> Pictures { get; } = [];

    /// <summary>The renderings for figure 6.6, all with all threads.</summary>
    public List<Measurement> Growth { get; } = [];

    /// <summary>Whether the scene file has what table 6.1 says.</summary>
    public bool AgreesWithTheReport =>
        (Primitives, Lights, Width, Height) == (Scene.Primitives, Scene.Lights, Scene.Size, Scene.Size);

    /// <summary>Seconds against samples a pixel, here.</summary>
    public IReadOnlyList<(double X, double Y)> Points => [.. Growth.Select(m => ((double)m.SamplesPerPixel, m.Seconds))];

    /// <summary>Seconds against samples a pixel, in the report.</summary>
    public IReadOnlyList<(double X, double Y)> ReportPoints => [.. Scene.Pictures.Select(p => ((double)p.SamplesPerPixel, p.Seconds))];

    /// <summary>The cubic that comes closest to <see cref="Points"/>.</summary>
    public PolynomialFit Fit => PolynomialFit.Of(GrowthChart.Degree, Points);
}
