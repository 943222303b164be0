using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;
using RayTracer.Tests.Statistics;

namespace RayTracer.Tests.Rendering;

/// <summary>
/// What a guide and a material choose together, tested as materials are by themselves.
/// Covers `GuidedMaterial`, `PathGuide` and `GuideMap`.
/// </summary>
[Trait("Category", "Thorough")]
public sealed class GuidedMaterialTests
{
    // Cells of the square of directions, and points of the quadrature of each, on a side: the guide's own cells are larger.
    private const int Cells = 32;
    private const int Points = 8;
    private const int Side = Cells * Points;
    private static readonly PathGuide s_guide = Lit();
    private static readonly UIntW s_root = s_guide.Find(default(Vector3));

    public static TheoryData<string> Materials => ["red diffuse", "polish", "plastic", "brushed aluminium", "leaf", "glass on white", "iron mesh"];

    [Theory]
    [MemberData(nameof(Materials))]
    public void Directions_are_distributed_by_the_mean_of_both_densities(string name)
    {
        (Material material, GuidedMaterial guided, SurfaceW surface) = Guided(name);
        double[] expected = new double[(Cells * Cells) + 1];
        for (int i = 0; i < Side * Side; i += FloatW.Count)
        {
            Place(i, out FloatW u, out FloatW v);
            Vec3W direction = GuideMap.ToDirection(u, v);
            guided.Evaluate(surface, direction, out RgbW bsdf, out FloatW pdf);
            material.Evaluate(surface, direction, out RgbW ownBsdf, out FloatW own);
            FloatW learned = s_guide.Density(s_root, u, v);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                Assert.Equal((0.5 * own[lane]) + (0.5 * learned[lane] / (4 * Math.PI)), pdf[lane], 1e-4 * (1 + pdf[lane]));
                Assert.Equal(ownBsdf.G[lane], bsdf.G[lane]);
                expected[CellOf(u[lane], v[lane])] += pdf[lane] * 4 * Math.PI / (Side * Side);
            }
        }

        // The last cell counts what goes into single directions, and paths that end.
        int count = TestSettings.Scale(1 << 16, 1 << 18);
        expected[^1] = 1 - expected.Sum();
        expected = [.. expected.Select(p => Math.Max(p, 1e-7) * count)];
        double[] observed = new double[expected.Length];
        ScatterSamples.AtRandom(guided, surface, count, 70, (in ScatterW s, int lane) =>
        {
            GuideMap.ToSquare(s.Direction, out FloatW u, out FloatW v);
            observed[Has(s.Absorbed | s.Delta, lane) ? Cells * Cells : CellOf(u[lane], v[lane])]++;
        });
        ErrorBudget.Materials.Check(PValues.ChiSquared(observed, expected), $"directions of {name} with a guide");
    }

    [Theory]
    [MemberData(nameof(Materials))]
    public void Weights_are_what_is_scattered_over_the_density(string name)
    {
        (_, GuidedMaterial guided, SurfaceW surface) = Guided(name);
        int asked = 0;
        int same = 0;
        ScatterSamples.AtRandom(guided, surface, 1 << 14, 71, (in ScatterW s, int lane) =>
        {
            FloatW chosen = guided.ChosenPdf;
            guided.Evaluate(surface, s.Direction, out RgbW bsdf, out FloatW pdf);
            if (!Has(s.Absorbed | s.Delta, lane))
            {
                double weight = bsdf.G[lane] * Math.Abs(Vec3W.Dot(s.Direction, surface.Facing)[lane]) / pdf[lane];
                asked++;
                same += Math.Abs(weight - s.Weight.G[lane]) <= 1e-4 * weight && Math.Abs(chosen[lane] - pdf[lane]) <= 1e-4 * pdf[lane] ? 1 : 0;
            }
        });

        // But for borders of cells, across which rounding may carry.
        Assert.InRange(same, asked * 0.999, asked);
        Assert.True(asked > 1000);
    }

    [Theory]
    [MemberData(nameof(Materials))]
    public void As_much_is_scattered_as_without_a_guide(string name)
    {
        // Into single directions, and into all others.
        (Material material, GuidedMaterial guided, SurfaceW surface) = Guided(name);
        int count = TestSettings.Scale(1 << 16, 1 << 18);
        foreach (bool isDelta in new[] { true, false })
        {
            double expected = 0;
            ScatterSamples.OnGrid(material, surface, 9, (in ScatterW s, int lane) => expected += Part(s, lane, isDelta) / (1 << 18));
            List<double> found = [];
            ScatterSamples.AtRandom(guided, surface, count, 72, (in ScatterW s, int lane) => found.Add(Part(s, lane, isDelta)));
            ErrorBudget.Materials.Check(PValues.Mean(found, expected, 1e-3 * expected), $"mean weight of {name} with a guide, {(isDelta ? "of single directions" : "of others")}: {found.Average():G6} instead of {expected:G6}");
        }
    }

    private static double Part(in ScatterW scatter, int lane, bool isDelta) => Has(scatter.Absorbed, lane) || Has(scatter.Delta, lane) != isDelta ? 0 : scatter.Weight.G[lane];

    private static (Material Material, GuidedMaterial Guided, SurfaceW Surface) Guided(string name)
    {
        Material material = MaterialCase.All.Single(c => c.Name == name).Material;
        SurfaceW surface = new SurfaceCase(0.6).Prepare(material);
        GuidedMaterial guided = new(s_guide, material);
        guided.Begin(surface);
        return (material, guided, surface);
    }

    // Light from around two directions, a little from everywhere, and nothing from a quarter of the sphere: no half is like the other.
    private static PathGuide Lit()
    {
        GuideSums sums = new(default, Vector3.One);
        for (int pass = 0; pass < 4; pass++)
        {
            for (uint i = 0; i < 6000; i++)
            {
                uint random = Hash.Mix(i);
                (float x, float y) = ((random & 0xfff) / 4096f, (random >> 12 & 0xfff) / 4096f);
                (float u, float v) = (i % 3) switch
                {
                    0 => (0.31f + (0.1f * x), 0.72f + (0.09f * y)),
                    1 => (0.64f + (0.13f * x), 0.17f + (0.2f * y)),
                    _ => (x, x < 0.5f ? 0.5f * y : y),
                };
                sums.Add(default, u, v, i % 3 == 0 ? 30 : 10);
            }

            sums = pass == 3 ? sums : sums.Refined(double.PositiveInfinity);
        }

        return sums.ToGuide();
    }

    private static int CellOf(float u, float v) => ((int)(v * Cells) * Cells) + (int)(u * Cells);

    private static void Place(int i, out FloatW u, out FloatW v)
    {
        FloatW number = (UIntW.Iota + (uint)i).ToFloat() + 0.5f;
        FloatW row = FloatW.Floor(number * (1f / Side));
        u = FloatW.NegatedMultiplyAdd(row, Side, number) * (1f / Side);
        v = (row + 0.5f) * (1f / Side);
    }

    private static bool Has(MaskW mask, int lane) => (mask.Bits >> lane & 1) != 0;
}
