using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;
using Xunit.Abstractions;

namespace RayTracer.RenderTests.Transport;

/// <summary>
/// A guide that sends half of all paths to a lamp which is asked at each point, too: where the two ways to find its light are not weighed by what
/// guide and surface choose together, it is far too bright or too dark.
/// Covers `GuidedMaterial` and `PathShader`.
/// </summary>
[Trait("Category", "Thorough")]
public class GuidedLampTests(ITestOutputHelper output)
{
    private const string Lamp = """{ "type": "rectangle", "corner": [-1.2, 2.6, -1.2], "edgeU": [2.4, 0, 0], "edgeV": [0, 0, 2.4], "material": { "type": "luminaire", "color": [1, 0.9, 0.7], "multiplier": 4 } }""";
    private const string Room = """{ "type": "box", "a": [-3, -0.01, -3], "b": [3, 6, 6], "material": { "type": "diffuse", "color": [0.95, 0.95, 0.95] } }""";
    private static readonly int s_seeds = TestSettings.Scale(24, 64);

    public static TheoryData<string, string, string> Scenes => new()
    {
        { "a lamp in a room", $"{Room}, {Lamp}", "" },
        { "an even sky", "", """ "environment": { "type": "constant", "radiance": [0.8, 0.9, 1.1] }, """ },
        { "many lamps", string.Join(",\n", Enumerable.Range(0, 10).Select(i => $$"""{ "type": "sphere", "center": [{{-1 + (0.5 * (i % 5))}}, 2.6, {{(i / 5) - 0.5}}], "radius": 0.24, "material": { "type": "luminaire", "multiplier": {{3 + i}} } }""")), "" },
    };

    [Theory]
    [MemberData(nameof(Scenes))]
    public void Lamps_that_are_guided_to_are_as_bright_as_others(string name, string lamps, string environment)
    {
        string text = Scene(lamps, environment);
        PathGuide guide = Upwards();
        BlockTest test = BlockTest.Compare(Render(text, 1, s => s.Guided(guide)), Render(text, 1001, s => s));
        output.WriteLine(test.ToString());
        ErrorBudget.Transport.Check(test.P, $"guided to {name}: {test}", () => text);
    }

    private static string Scene(string lamps, string environment) => $$"""
        {
          "camera": { "position": [0, 5, 4.2], "lookAt": [0, 0.3, 0], "fieldOfView": 16 },
          "render": { "integrator": "path", "width": 12, "height": 12, "samplesPerPixel": 20, "maxDepth": 10, "rouletteDepth": 1 },
          {{environment}}
          "shapes": [
            { "type": "rectangle", "corner": [-2, 0, 2], "edgeU": [4, 0, 0], "edgeV": [0, 0, -4], "material": { "type": "diffuse", "color": [0.9, 0.85, 0.9] } },
            { "type": "sphere", "center": [-0.6, 0.5, 0], "radius": 0.5, "material": { "type": "plastic", "color": [0.3, 0.5, 0.2] } },
            { "type": "sphere", "center": [0.6, 0.5, 0.2], "radius": 0.5, "material": { "type": "roughConductor", "metal": "gold", "alpha": 0.4 } }{{(lamps.Length > 0 ? "," : "")}}
            {{lamps}}
          ]
        }
        """;

    // The same everywhere: light from within 25 degrees of straight above.
    private static PathGuide Upwards()
    {
        GuideSums sums = new(new(-2, 0, -2), new(2, 3, 2));
        for (int pass = 0; pass < 5; pass++)
        {
            for (int i = 0; i < 4000; i++)
            {
                double radius = 0.45 * Math.Sqrt((i + 0.5) / 4000);
                double turn = i * 2.399963;
                Vec3W direction = new Vector3((float)(radius * Math.Cos(turn)), 1, (float)(radius * Math.Sin(turn))).Unit();
                GuideMap.ToSquare(direction, out FloatW u, out FloatW v);
                sums.Add(default, u[0], v[0], 100);
            }

            sums = pass == 4 ? sums : sums.Refined(double.PositiveInfinity);
        }

        return sums.ToGuide();
    }

    private static ImageSamples Render(string text, long firstSeed, Func<Scene, Scene> guide)
    {
        ImageSamples images = new(12, 12);
        for (int i = 0; i < s_seeds; i++)
        {
            long seed = firstSeed + i + (TestSettings.Seed * 1_000_000L);
            images.Add(new RTracer(guide(TestScenes.Build(text.Replace("\"render\": {", $"\"render\": {{ \"seed\": {(uint)seed},", StringComparison.Ordinal)))).Render().Film);
        }

        return images;
    }
}
