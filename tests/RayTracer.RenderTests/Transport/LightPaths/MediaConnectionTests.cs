using RayTracer.Description;
using Xunit.Abstractions;

namespace RayTracer.RenderTests.Transport.LightPaths;

/// <summary>
/// Scenes in which one way to make paths, and what it must know of media, lamps and normals, decides the brightness: in others, it has little weight.
/// Covers `Connections`, `CameraSubpaths` and `LightSubpaths`.
/// </summary>
[Trait("Category", "Thorough")]
public class MediaConnectionTests(ITestOutputHelper output)
{
    private static readonly int s_seeds = TestSettings.Scale(24, 64);

    private static readonly Block[] s_blocks = [.. Block.Cut(12, 12, 6), new(0, 0, 12, 12)];

    // Two sheets that let light through, with dark fog between them: nearly all of it comes by connections of one sheet with the other, for few paths
    // come through the fog by chance.
    private const string Sheets = """
        {
          "camera": { "position": [0, 0, 3], "lookAt": [0, 0, 0], "fieldOfView": 16 },
          "render": { "width": 12, "height": 12, "maxDepth": 5 },
          "shapes": [
            { "type": "box", "a": [-2, -2, 0], "b": [2, 2, 0.3], "material": { "type": "invisible", "interior": { "extinction": [5, 5, 5], "albedo": [0.2, 0.3, 0.2] } } },
            { "type": "rectangle", "corner": [-2, -2, 0.29], "edgeU": [4, 0, 0], "edgeV": [0, 4, 0], "material": { "type": "translucent", "color": [0.1, 0.1, 0.1], "transmittance": [0.8, 0.7, 0.8] } },
            { "type": "rectangle", "corner": [-2, -2, 0.01], "edgeU": [4, 0, 0], "edgeV": [0, 4, 0], "material": { "type": "translucent", "color": [0.1, 0.1, 0.1], "transmittance": [0.7, 0.8, 0.8] } },
            { "type": "spot", "position": [0.1, 0, -2], "direction": [0, 0, 1], "intensity": [90, 80, 70], "cutoffAngle": 20, "beamWidth": 15 }
          ]
        }
        """;

    // A lamp in dark fog: nearly all of its light comes by asking for it, for few paths come to it by chance.
    private const string LampInFog = """
        {
          "camera": { "position": [0, 2.5, 2], "lookAt": [0, 0, 0], "fieldOfView": 16 },
          "render": { "width": 12, "height": 12, "maxDepth": 4 },
          "shapes": [
            { "type": "box", "a": [-2, -0.5, -2], "b": [2, 0.5, 2], "material": { "type": "invisible", "interior": { "extinction": [2.5, 2.5, 2.5], "albedo": [0.3, 0.2, 0.2] } } },
            { "type": "rectangle", "corner": [-2, 0, 2], "edgeU": [4, 0, 0], "edgeV": [0, 0, -4], "material": { "type": "diffuse", "color": [0.7, 0.7, 0.7] } },
            { "type": "rectangle", "corner": [-0.8, 0.4, -0.8], "edgeU": [1.6, 0, 0], "edgeV": [0, 0, 1.1], "material": { "type": "luminaire", "multiplier": 9 } }
          ]
        }
        """;

    // Frosted glass in water, and no air: the camera is in the water, too. The spot sees the glass only, and the camera the floor only.
    private const string UnderWater = """
        {
          "camera": { "position": [1.6, 1.4, 0.6], "lookAt": [0.75, 0, 0.1], "fieldOfView": 34 },
          "render": { "width": 12, "height": 12, "maxDepth": 5 },
          "shapes": [
            { "type": "box", "a": [-4, -1, -4], "b": [4, 5, 4], "material": { "type": "dielectric", "refractiveIndex": 1.33, "priority": 1 } },
            { "type": "rectangle", "corner": [-2, 0, 2], "edgeU": [4, 0, 0], "edgeV": [0, 0, -4], "material": { "type": "diffuse", "color": [0.7, 0.7, 0.7] } },
            { "type": "sphere", "center": [0, 0.55, 0], "radius": 0.5, "material": { "type": "roughDielectric", "alpha": 0.6, "refractiveIndex": 1.5, "priority": 2 } },
            { "type": "spot", "position": [-1, 2.4, 0], "direction": [1, -1.85, 0], "intensity": [90, 80, 70], "cutoffAngle": 11, "beamWidth": 10 }
          ]
        }
        """;

    // A cloud in an even light, and nothing else: there is nothing to be merged, but paths scatter many times before they meet the light.
    private const string Cloud = """
        {
          "camera": { "position": [0, 0, 4], "lookAt": [0, 0, 0], "fieldOfView": 24 },
          "render": { "width": 12, "height": 12, "maxDepth": 8 },
          "environment": { "type": "constant", "radiance": [1, 0.9, 0.8] },
          "shapes": [ { "type": "sphere", "center": [0, 0, 0], "radius": 1, "material": { "type": "invisible", "interior": { "extinction": [2, 2, 2], "albedo": [1, 0.9, 1] } } } ]
        }
        """;

    // A cloud upon two lamps that are wider than it: paths meet them as often as they find them by asking, and at all angles.
    private const string CloudOnLamps = """
        {
          "camera": { "position": [0, 2.5, 2.5], "lookAt": [0, 0.3, 0], "fieldOfView": 24 },
          "render": { "width": 12, "height": 12, "maxDepth": 5 },
          "shapes": [
            { "type": "box", "a": [-1.5, 0.02, -1.5], "b": [1.5, 0.7, 1.5], "material": { "type": "invisible", "interior": { "extinction": [1.5, 1.5, 1.5], "albedo": [0.9, 0.9, 0.9] } } },
            { "type": "rectangle", "corner": [-2, 0, 2], "edgeU": [2, 0, 0], "edgeV": [0, 0, -4], "material": { "type": "luminaire", "multiplier": 1 } },
            { "type": "rectangle", "corner": [0, 0, 2], "edgeU": [2, 0, 0], "edgeV": [0, 0, -4], "material": { "type": "luminaire", "multiplier": 0.8 } }
          ]
        }
        """;

    // A sheet that lets light through, beside a floor that is shaded with another normal than its own.
    private const string TurnedFloor = """
        {
          "camera": { "position": [0, 0.6, 2.5], "lookAt": [0, 0, 0], "fieldOfView": 15 },
          "render": { "width": 12, "height": 12, "maxDepth": 3 },
          "shapes": [
            { "type": "rectangle", "corner": [-1, 0, 1], "edgeU": [2, 0, 0], "edgeV": [0, 0, -2], "material": { "type": "normalMap", "map": [0.8, 0.5, 0.9], "material": { "type": "diffuse", "color": [0.9, 0.9, 0.9] } } },
            { "type": "rectangle", "corner": [0.9, 0.1, -0.4], "edgeU": [0, 0.8, 0], "edgeV": [0, 0, 0.8], "material": { "type": "translucent", "color": [0.1, 0.1, 0.1], "transmittance": [0.8, 0.7, 0.8] } },
            { "type": "spot", "position": [2, 0.5, 0], "direction": [-1, 0, 0], "intensity": [90, 80, 70], "cutoffAngle": 18, "beamWidth": 15 }
          ]
        }
        """;

    public static TheoryData<string, string, int, string, int> Cases => new()
    {
        { "two sheets and fog between", "bidirectional", 4, "volPath", 12 },
        { "a lamp in fog", "bidirectional", 16, "volPath", 32 },
        { "frosted glass under water", "bidirectional", 8, "light", 16 },
        { "a cloud in an even light", "photons", 12, "volPath", 12 },
        { "a cloud in an even light", "bidirectional", 12, "volPath", 12 },
        { "a cloud upon two lamps", "bidirectional", 24, "volPath", 16 },
        { "a cloud that scatters in two ways upon two lamps", "bidirectional", 24, "volPath", 16 },
        { "a sheet beside a turned floor", "bidirectional", 6, "light", 32 },
    };

    [Theory]
    [MemberData(nameof(Cases))]
    public void There_is_as_much_light_whatever_way_a_path_is_made(string name, string integrator, int samples, string other, int samplesOfOther)
    {
        string scene = name switch { "two sheets and fog between" => Sheets, "a lamp in fog" => LampInFog, "frosted glass under water" => UnderWater, "a cloud upon two lamps" => CloudOnLamps, "a cloud that scatters in two ways upon two lamps" => Mixed(CloudOnLamps), "a sheet beside a turned floor" => TurnedFloor, _ => Cloud };
        ImageSamples images = Render(scene, integrator, samples, firstSeed: 1);
        ImageSamples others = Render(scene, other, samplesOfOther, firstSeed: 1001);
        IEnumerable<(Block Block, int Channel)> parts = s_blocks.SelectMany(b => Enumerable.Range(0, 3).Select(c => (b, c)));
        double p = PValues.Smallest(parts.Select(t => BlockTest.Welch(images.Estimate(t.Block, t.Channel), others.Estimate(t.Block, t.Channel))));
        BlockEstimate whole = images.Estimate(s_blocks[^1], 1);
        BlockEstimate expected = others.Estimate(s_blocks[^1], 1);
        string found = FormattableString.Invariant($"{name}: {whole.Mean:G5} ± {Math.Sqrt(whole.Variance):G2} by {integrator}, {expected.Mean:G5} ± {Math.Sqrt(expected.Variance):G2} by {other}; p = {p:G3}");
        output.WriteLine(found);
        Assert.True(Math.Sqrt(whole.Variance + expected.Variance) < 0.03 * expected.Mean, $"too noisy: {found}");
        ErrorBudget.Transport.Check(p, found, () => scene);
    }

    // On its left mostly on and back, as a table says, on its right more as fine dust.
    private static string Mixed(string scene) => scene.Replace(
        "\"albedo\": [0.9, 0.9, 0.9]",
        """
        "albedo": [0.9, 0.9, 0.9], "phase": { "shape": "mix", "weight": 0.9, "weightGrid": { "size": [2, 1, 1], "values": [0, 1], "box": [[-1, 0, -1], [1, 1, 1]] },
          "first": { "shape": "table", "values": [3, 0, 0, 1, 9] }, "second": { "shape": "rayleigh" } }
        """,
        StringComparison.Ordinal);

    private static ImageSamples Render(string scene, string integrator, int samples, long firstSeed) => SceneRuns.RenderText(
        scene,
        s_seeds,
        d => d with { Render = d.Render with { Integrator = Integrator.Known.All.Single(i => i.Name == integrator), SamplesPerPixel = samples, MergeRadius = 1e-4f } },
        firstSeed);
}
