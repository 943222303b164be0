namespace RayTracer.Study;

/// <summary>A test scene of the report: table 6.1 and figures 6.3 to 6.5.</summary>
/// <param name="Number">1 to 3.</param>
/// <param name="Figure">The figure that shows it.</param>
/// <param name="Primitives">Shapes without the lights.</param>
/// <param name="Lights">Light sources.</param>
/// <param name="Size">Width and height in pixels.</param>
/// <param name="Pictures">The pictures of it.</param>
public sealed record ReportScene(int Number, string Figure, int Primitives, int Lights, int Size, IReadOnlyList<ReportPicture> Pictures)
{
    /// <summary>The machine of the report's times.</summary>
    public const string Machine = "Core 2 Duo laptop, 1.83 GHz";

    /// <summary>All three, with the times of the captions of figures 6.3, 6.4 and 6.5.</summary>
    public static IReadOnlyList<ReportScene> All { get; } =
    [
        new(1, "6.3", 2, 4, 600, [new('A', 1, 3.851), new('B', 16, 62.431), new('C', 100, 376.723)]),
        new(2, "6.4", 9, 4, 600, [new('A', 1, 5.712), new('B', 16, 80.342), new('C', 100, 540.481), new('D', 400, 2119.853)]),
        new(3, "6.5", 9, 4, 300, [new('A', 16, 31.776), new('B', 100, 193.846), new('C', 400, 794.008)]),
    ];

    /// <summary>The name of the scene's file.</summary>
    public string File => $"scene{Number}.json";

    /// <summary>The name of a picture's file.</summary>
    public string PictureFile(ReportPicture picture) => $"figure-{Figure.Replace('.', '-')}-{char.ToLowerInvariant(picture.Letter)}.png";

    /// <summary>The number of a picture's primary rays.</summary>
    public long Paths(ReportPicture picture) => (long)Size * Size * picture.SamplesPerPixel;
}

/// <summary>One picture of the report's section 6.3.</summary>
/// <param name="Letter">A to D, as in its figure.</param>
/// <param name="SamplesPerPixel">Samples a pixel, by the count of primary rays (the captions of 6.4 D and 6.5 C say 200).</param>
/// <param name="Seconds">The report's time.</param>
public sealed record ReportPicture(char Letter, int SamplesPerPixel, double Seconds);
