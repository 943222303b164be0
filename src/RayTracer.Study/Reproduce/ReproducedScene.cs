namespace RayTracer.Study;

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

    /// <summary>The small and the large pictures that are rendered one after the other.</summary>
    public List<FrameRate> Frames { get; } = [];

    /// <summary>True if the scene file has what table 6.1 says.</summary>
    public bool AgreesWithTheReport =>
        (Primitives, Lights, Width, Height) == (Scene.Primitives, Scene.Lights, Scene.Size, Scene.Size);

    /// <summary>Seconds against samples a pixel, here.</summary>
    public IReadOnlyList<(double X, double Y)> Points => [.. Growth.Select(m => ((double)m.SamplesPerPixel, m.Seconds))];

    /// <summary>Seconds against samples a pixel, in the report.</summary>
    public IReadOnlyList<(double X, double Y)> ReportPoints => [.. Scene.Pictures.Select(p => ((double)p.SamplesPerPixel, p.Seconds))];

    /// <summary>The cubic that comes closest to <see cref="Points"/>.</summary>
    public PolynomialFit Fit => PolynomialFit.Of(GrowthChart.Degree, Points);
}

/// <summary>A picture of the report, and how long it took here.</summary>
/// <param name="Scene">Its scene.</param>
/// <param name="Picture">The report's picture.</param>
/// <param name="All">The rendering with all threads, whose picture was written.</param>
/// <param name="One">The rendering with one thread.</param>
internal sealed record ReproducedPicture(ReportScene Scene, ReportPicture Picture, Measurement All, Measurement One)
{
    /// <summary>The picture's name in the report.</summary>
    public string Name => $"{Scene.Figure} {Picture.Letter}";

    /// <summary>The speed of a rendering as a multiple of the report's, path for path.</summary>
    public double SpeedUp(Measurement measurement) => Picture.Seconds / Scene.Paths(Picture) / measurement.SecondsPerPath;
}

/// <summary>One timed rendering.</summary>
/// <param name="Scene">The scene that was rendered.</param>
/// <param name="Size">Width and height in pixels.</param>
/// <param name="SamplesPerPixel">Samples a pixel.</param>
/// <param name="Threads">On how many threads.</param>
/// <param name="Seconds">The time that it took, in seconds, without loading and writing.</param>
/// <param name="Rays">Rays traced, shadow rays among them.</param>
internal sealed record Measurement(ReportScene Scene, int Size, int SamplesPerPixel, int Threads, double Seconds, long Rays)
{
    /// <summary>Seconds a light path.</summary>
    public double SecondsPerPath => Seconds / ((double)Size * Size * SamplesPerPixel);

    /// <summary>Rays a second.</summary>
    public double RaysPerSecond => Rays / Seconds;
}

/// <summary>The numbers of pictures of one sample that are rendered in a second.</summary>
/// <param name="Scene">The scene.</param>
/// <param name="Width">Their width in pixels.</param>
/// <param name="Height">Their height in pixels.</param>
/// <param name="All">Pictures a second with all threads.</param>
/// <param name="One">Pictures a second with one thread.</param>
/// <param name="RaysPerSecond">Rays a second with all threads.</param>
internal sealed record FrameRate(ReportScene Scene, int Width, int Height, double All, double One, double RaysPerSecond);
