using RayTracer.Description;

namespace RayTracer.RenderTests.Transport.LightPaths;

/// <summary>
/// An edge is as sharp in light that paths from the lamps bring to the picture as in that of the camera's own samples: a filter's negative lobes, which
/// no mean of a picture shows, make dark and bright lines beside it.
/// Covers `LightSubpaths` and `PixelFilter`.
/// </summary>
[Trait("Category", "Thorough")]
public class SplatFilterTests
{
    private static readonly int s_seeds = TestSettings.Scale(20, 64);

    [Fact]
    public void Edges_are_as_sharp_in_splats_as_in_samples()
    {
        const string scene = """
            {
              "camera": { "position": [0, 3, 0], "lookAt": [0, 0, 0], "up": [0, 0, -1], "projection": "orthographic", "viewSize": 2 },
              "render": { "width": 16, "height": 16, "samplesPerPixel": 1, "maxDepth": 2, "filter": { "shape": "mitchell", "radius": 3, "b": 0, "c": 1 } },
              "shapes": [
                { "type": "rectangle", "corner": [-2, 0, 2], "edgeU": [2.05, 0, 0], "edgeV": [0, 0, -4], "material": { "type": "diffuse", "color": [0.9, 0.9, 0.9] } },
                { "type": "rectangle", "corner": [0.05, 0, 2], "edgeU": [1.95, 0, 0], "edgeV": [0, 0, -4], "material": { "type": "diffuse", "color": [0.1, 0.2, 0.3] } }
              ],
              "lights": [ { "type": "directional", "direction": [0.1, -1, -0.2], "irradiance": [1, 1, 1] } ]
            }
            """;
        ImageSamples splats = Render(scene, "light", 64, firstSeed: 1);
        ImageSamples samples = Render(scene, "path", 16, firstSeed: 1001);
        IEnumerable<Block> columns = Enumerable.Range(0, 16).Select(x => new Block(x, 0, 1, 16));
        double p = PValues.Smallest(columns.Select(c => BlockTest.Welch(splats.Estimate(c, 1), samples.Estimate(c, 1))));
        ErrorBudget.Transport.Check(p, "an edge by light tracing", () => string.Join('\n', columns.Select(c => $"{splats.Estimate(c, 1)}, by samples {samples.Estimate(c, 1)}")));
    }

    private static ImageSamples Render(string scene, string integrator, int samples, long firstSeed) => SceneRuns.RenderText(
        scene,
        s_seeds,
        d => d with { Render = d.Render with { Integrator = Integrator.Known.All.Single(i => i.Name == integrator), SamplesPerPixel = samples } },
        firstSeed);
}
