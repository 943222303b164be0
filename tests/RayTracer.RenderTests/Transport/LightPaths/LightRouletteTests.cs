using RayTracer.Description;

namespace RayTracer.RenderTests.Transport.LightPaths;

/// <summary>
/// A closed room, much of whose light has been scattered many times, with paths that may end at random from the first bounce on.
/// Covers `SubpathShader`.
/// </summary>
[Trait("Category", "Thorough")]
public class LightRouletteTests
{
    private const string Room = """
        {
          "camera": { "position": [0, 1, 2.4], "lookAt": [0, 0.9, 0], "fieldOfView": 50 },
          "render": { "width": 12, "height": 12, "samplesPerPixel": 1, "rouletteDepth": 1 },
          "shapes": [
            { "type": "box", "a": [-1.5, 0, -1.5], "b": [1.5, 2.5, 2.5], "material": { "type": "diffuse", "color": [0.8, 0.6, 0.7] } },
            { "type": "rectangle", "corner": [-0.9, 2.3, -0.9], "edgeU": [1.8, 0, 0], "edgeV": [0, 0, 1.8], "material": { "type": "luminaire", "multiplier": 2 } }
          ]
        }
        """;

    private static readonly int s_seeds = TestSettings.Scale(16, 64);

    [Theory]
    [InlineData("light", 4)]
    [InlineData("bidirectional", 3)]
    public void Paths_that_go_on_make_up_for_those_that_end(string integrator, int samples)
    {
        BlockTest test = BlockTest.Compare(Render(integrator, samples, firstSeed: 1), Render("path", 6, firstSeed: 1001));
        ErrorBudget.Transport.Check(test.P, $"{integrator}: {test}");
    }

    private static ImageSamples Render(string integrator, int samples, long firstSeed) => SceneRuns.RenderText(
        Room,
        s_seeds,
        d => d with { Render = d.Render with { Integrator = Integrator.Known.All.Single(i => i.Name == integrator), SamplesPerPixel = samples } },
        firstSeed);
}
