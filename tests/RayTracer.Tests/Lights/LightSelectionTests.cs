using System.Globalization;
using System.Numerics;
using System.Text;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;
using RayTracer.Shapes;
using RayTracer.Tests.Statistics;

namespace RayTracer.Tests.Lights;

/// <summary>The choice of one light among many.</summary>
[Trait("Category", "Thorough")]
public class LightSelectionTests
{
    // All that may shine, many of them, of strengths over six orders of magnitude.
    private static readonly string s_all = $$"""
        { "objects": { "lamp": { "type": "sphere", "center": [0, 0, 0], "radius": 0.3, "material": { "type": "luminaire" } } },
          "shapes": [
            { "type": "mesh", "positions": [[0, 5, 0], [1, 5, 0], [0, 5, 1], [3, 6, 1]], "triangles": [[0, 1, 2], [1, 2, 3]], "material": { "type": "luminaire", "multiplier": 2 } },
            { "type": "instance", "of": "lamp", "transform": [{ "scale": [1, 2, 1], "translate": [4, 3, 2] }] },
            { "type": "instance", "of": "lamp", "transform": [{ "translate": [-4, 3, 2] }], "motion": [{ "time": 0 }, { "time": 1, "transform": [{ "translate": [9, 0, 0] }] }] } ],
          "lights": [
            { "type": "directional", "direction": [0, -1, 0], "irradiance": [0.02, 0.02, 0.02] },
            { "type": "directional", "direction": [1, -1, 0], "irradiance": [0.03, 0, 0] },
            { "type": "spot", "position": [1, 3, 4], "intensity": [5, 5, 5] },
            {{string.Join(",\n", Enumerable.Range(0, 40).Select(i => string.Create(CultureInfo.InvariantCulture, $$"""{ "type": "point", "position": [{{(i * 7 % 13) - 6}}, {{(i * 5 % 11) - 3}}, {{(i * 3 % 17) - 8}}], "intensity": [{{Math.Pow(10, (i % 7) - 4)}}, 0, 0] }""")))}} ] }
        """;

    private static readonly Vector3[] s_points = [new(0, 0, 0), new(0.4f, -3.2f, 1), new(30, 2, -10), new(-2, 3.5f, 4), new(1000, 1000, 0)];
    private static readonly Vector3[] s_normals = [default, Vector3.UnitY, -Vector3.UnitY, Vector3.Normalize(new(1, 0.2f, -1))];

    public static TheoryData<int, int> Places
    {
        get
        {
            TheoryData<int, int> data = [];
            for (int i = 0; i < s_points.Length * s_normals.Length; i++)
            {
                data.Add(i / s_normals.Length, i % s_normals.Length);
            }

            return data;
        }
    }

    [Theory]
    [MemberData(nameof(Places))]
    public void Lights_are_chosen_with_their_probabilities_whose_sum_is_1(int at, int facing)
    {
        (IReadOnlyList<LightSource> lights, LightSelection selection) = Build(s_all);
        (Vector3 point, Vector3 normal) = (s_points[at], s_normals[facing]);
        double[] probabilities = Probabilities(selection, lights.Count, point, normal);
        Assert.Equal(1, probabilities.Sum(), 1e-5);
        int samples = TestSettings.Scale(1 << 15, 1 << 20);
        double[] counts = new double[lights.Count];
        UnitSquare.AtRandom(samples, (u, _, lane) =>
        {
            selection.Choose(point, normal, u, out UIntW light, out FloatW probability);
            int chosen = (int)light[lane];
            counts[chosen]++;
            Assert.Equal(probabilities[chosen], probability[lane], 1e-5 * probabilities[chosen]);
        });
        ErrorBudget.Lights.Check(PValues.ChiSquared(counts, [.. probabilities.Select(p => p * samples)]), $"lights chosen from {point} towards {normal}");
    }

    [Fact]
    public void Only_what_is_below_the_horizon_or_black_is_never_chosen()
    {
        (IReadOnlyList<LightSource> lights, LightSelection selection) = Build(s_all);
        Random random = new(3 + TestSettings.Seed);
        int forgotten = 0;
        for (int i = 0; i < 200; i++)
        {
            Vector3 point = 10 * new Vector3(random.NextSingle() - 0.5f, random.NextSingle() - 0.5f, random.NextSingle() - 0.5f);
            Vector3 normal = Vector3.Normalize(new(random.NextSingle() - 0.5f, random.NextSingle() - 0.5f, random.NextSingle() - 0.5f));
            double[] probabilities = Probabilities(selection, lights.Count, point, normal);
            for (int light = 0; light < lights.Count; light++)
            {
                forgotten += probabilities[light] == 0 ? 1 : 0;
                for (int k = 0; probabilities[light] == 0 && k < 16; k++)
                {
                    lights[light].Sample(point, (k + 0.5f) / 16, random.NextSingle(), 0f, out ShapeSampleW sample, out _);
                    Assert.True(Vector3D.Of(sample.Direction, 0).Dot(normal) < 1e-4, $"{lights[light]} is seen from {point} above {normal}");
                }
            }
        }

        Assert.True(forgotten > 1000, "the horizon is not looked at");
    }

    [Theory]
    [InlineData("""{ "type": "directional" }, { "type": "directional", "irradiance": [3, 3, 3] }""", 0.25, 0.75)]
    [InlineData("""{ "type": "point" }""", 1, 0)]
    [InlineData("""{ "type": "point", "position": [0, 2, 0] }, { "type": "point", "position": [0, 4, 0] }""", 0.8, 0.2)]
    [InlineData("""{ "type": "point", "position": [0, 2, 0] }, { "type": "directional" }""", 0.2, 0.8)]
    [InlineData("""{ "type": "point", "position": [0, 2, 0] }, { "type": "spot", "position": [0, -2, 0] }""", 1, 0)]
    public void Two_lights_share_by_what_they_bring(string lights, double first, double second)
    {
        (IReadOnlyList<LightSource> both, LightSelection selection) = Build($$"""{ "lights": [{{lights}}] }""");
        double[] probabilities = Probabilities(selection, both.Count, Vector3.Zero, Vector3.UnitY);
        Assert.Equal(first, probabilities[0], 1e-4);
        Assert.Equal(second, both.Count > 1 ? probabilities[1] : 0, 1e-4);
    }

    // 10,000 small lamps over a floor: the spread of one sample, without shadows.
    [Fact]
    public void Among_many_lights_the_choice_has_a_far_smaller_variance_than_an_even_one()
    {
        (IReadOnlyList<LightSource> lights, LightSelection selection) = Build(Lamps(10000));
        (double chosen, double even, double mean) = (0, 0, 0);
        const int points = 64, samples = 256;
        for (int i = 0; i < points; i++)
        {
            Vector3 point = new(((i % 8) * 11.7f) - 45, 0, ((i / 8) * 12.3f) - 45);
            double exact = lights.Sum(l => Irradiance(l, point, 0.5f, 0.5f));
            for (int k = 0; k < samples; k++)
            {
                float u = ((k * 0.6180339f) + (i * 0.37f)) % 1;
                selection.Choose(point, Vector3.UnitY, u, out UIntW light, out FloatW probability);
                double value = Irradiance(lights[(int)light[0]], point, 0.5f, 0.5f) / probability[0];
                chosen += Math.Pow((value / exact) - 1, 2) / (points * samples);
                even += Math.Pow((Irradiance(lights[(int)(u * lights.Count)], point, 0.5f, 0.5f) * lights.Count / exact) - 1, 2) / (points * samples);
                mean += value / exact / (points * samples);
            }
        }

        Assert.Equal(1, mean, 0.02);
        Assert.True(chosen < even / 100, $"variances {chosen} and {even}");
    }

    /// <summary>A scene of many small lamps at the knots of a crooked grid over a floor, of different strengths.</summary>
    internal static string Lamps(int count)
    {
        StringBuilder lamps = new();
        Random random = new(7);
        for (int i = 0; i < count; i++)
        {
            float power = MathF.Pow(10, random.NextSingle() * 2);
            lamps.Append(CultureInfo.InvariantCulture, $$"""{{(i > 0 ? "," : "")}}{ "type": "sphere", "center": [{{(random.NextSingle() * 100) - 50}}, {{0.3f + (random.NextSingle() * 4)}}, {{(random.NextSingle() * 100) - 50}}], "radius": 0.02, "material": { "type": "luminaire", "multiplier": {{power}} } }""");
        }

        return $$"""{ "lights": [{{lamps}}] }""";
    }

    private static double Irradiance(LightSource light, Vector3 point, float u, float v)
    {
        light.Sample(point, u, v, 0f, out ShapeSampleW sample, out RgbW radiance);
        return Math.Max(0, sample.Direction.Y[0]) * radiance.G[0];
    }

    private static double[] Probabilities(LightSelection selection, int count, Vector3 point, Vector3 normal) => [.. Enumerable.Range(0, count).Select(i =>
    {
        selection.Probability(point, normal, (uint)i, out FloatW probability);
        return (double)probability[0];
    })];

    private static (IReadOnlyList<LightSource> Lights, LightSelection Selection) Build(string json)
    {
        Scene scene = TestScenes.Build(json);
        return (scene.Lights, new(scene.Lights, (0, 1)));
    }
}
