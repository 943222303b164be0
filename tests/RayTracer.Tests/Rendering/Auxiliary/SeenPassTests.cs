using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>Covers `SeenPass`: the light of one sample, and what it sees, are those of passes of their own.</summary>
public sealed class SeenPassTests
{
    private const int Width = 48;
    private const int Height = 36;
    private const int Sample = 3;
    private static readonly AuxiliaryImage[] s_kinds = [new AlbedoImage(), new NormalImage()];

    // Matt and shiny things, mirrors, glass in glass, fog, a media's boundary before the camera, a lamp, several of one kind of thing, and the sky.
    [Theory]
    [InlineData("path", 1)]
    [InlineData("path", 3)]
    [InlineData("volPath", 1)]
    [InlineData("report", 2)]
    public void Light_and_what_is_seen_are_those_of_passes_of_their_own(string integrator, int threads)
    {
        string media = integrator == "report" ? "" : """
            { "type": "box", "a": [-2.2, -1.2, 2], "b": [-0.6, 1.2, 2.2], "material": { "type": "invisible", "interior": { "extinction": [2, 2, 2], "albedo": [1, 1, 1] } } },
            """;
        string text = $$"""
            {
              "camera": { "position": [0, 0, 6], "lookAt": [0, 0, 0], "fieldOfView": 45 },
              "render": { "integrator": "{{integrator}}", "width": {{Width}}, "height": {{Height}}, "samplesPerPixel": 16, "sampler": "jittered" },
              "background": [0.5, 0.6, 0.7],
              "objects": { "pair": { "type": "group", "shapes": [{ "type": "sphere", "center": [-0.3, 0, 0], "radius": 0.2 }, { "type": "sphere", "center": [0.3, 0, 0], "radius": 0.2 }] } },
              "shapes": [
                {{media}}
                { "type": "plane", "point": [0, -1, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.4, 0.6, 0.2] } },
                { "type": "sphere", "center": [-1.5, 0, 0], "radius": 0.7, "material": { "type": "phongMetal", "color": [0.9, 0.8, 0.7], "exponent": 1000000 } },
                { "type": "sphere", "center": [0, 0, 0], "radius": 0.7, "material": { "type": "dielectric" } },
                { "type": "sphere", "center": [1.5, 0, 0], "radius": 0.7, "material": { "type": "phongMetal", "color": [0.3, 0.5, 0.9], "exponent": 20 } },
                { "type": "sphere", "center": [0, 1.8, -1], "radius": 0.4, "material": { "type": "luminaire", "color": [1, 1, 1], "multiplier": 4 } },
                { "type": "instance", "of": "pair", "transform": [{ "translate": [1, -0.7, 2] }], "material": { "type": "diffuse", "color": [0.7, 0.1, 0.1] } }
              ]
            }
            """;
        Scene scene = TestScenes.Build(text);

        // What a denoiser is given is weaker behind fog, but not behind what only absorbs.
        Scene clear = TestScenes.Build(text.Replace("\"albedo\": [1, 1, 1]", "\"albedo\": [0, 0, 0]", StringComparison.Ordinal));
        RenderOptions options = new() { Threads = 1, Samples = new(Sample, Sample + 1) };
        (Film film, _) = new RTracer(scene, options).Render();
        AovFilm seen = new(new(Width, Height), s_kinds);
        new FirstHitPass(clear, options) { SeesThrough = true }.Render(seen);
        PaddedRows rows = new(Width, Height);
        SeenPlanes planes = new(rows);
        Assert.True(new SeenPass(scene, threads).Take(planes, Sample, CancellationToken.None));
        HashSet<SurfaceName> surfaces = [];
        double[] row = new double[3 * Width];
        for (int y = 0; y < Height; y++)
        {
            foreach ((AuxiliaryImage kind, Func<int, Vec3W> of) in new (AuxiliaryImage, Func<int, Vec3W>)[] { (s_kinds[0], planes.Albedo), (s_kinds[1], planes.Normal) })
            {
                seen.ReadRow(kind, y, row);
                for (int x = 0; x < Width; x++)
                {
                    bool isSky = planes.Surface[rows.At(x, y)] == SurfaceName.None;
                    Vector3 expected = isSky && kind is AlbedoImage ? Vector3.One : new((float)row[3 * x], (float)row[(3 * x) + 1], (float)row[(3 * x) + 2]);
                    AssertClose(expected, First(of(rows.At(x, y))), 1e-5f);
                }
            }

            for (int x = 0; x < Width; x++)
            {
                Rgb light = film.Mean(x, y);
                AssertClose(new(light.R, light.G, light.B), First(planes.Light(rows.At(x, y))), 1e-4f * (1 + light.Luminance));
                surfaces.Add(planes.Surface[rows.At(x, y)]);
            }
        }

        Assert.InRange(surfaces.Count, 6, 20);
    }

    [Fact]
    public void It_ends_when_it_is_cancelled()
    {
        Scene scene = TestScenes.BuildEverything();
        using CancellationTokenSource source = new();
        source.Cancel();
        Assert.False(new SeenPass(scene, 2).Take(new(new(scene.Render.Width, scene.Render.Height)), 0, source.Token));
    }

    private static Vector3 First(in Vec3W v) => new(v.X[0], v.Y[0], v.Z[0]);

    private static void AssertClose(Vector3 expected, Vector3 actual, float tolerance) =>
        Assert.True((expected - actual).Length() <= tolerance, $"expected {expected}, found {actual}");
}
