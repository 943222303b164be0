using System.Numerics;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Tests.Statistics;
using RayTracer.Textures;

namespace RayTracer.Tests.Media;

/// <summary>Over which directions media spread what they scatter.</summary>
[Trait("Category", "Thorough")]
public class PhaseFunctionTests
{
    private const int Steps = 1 << 15;
    private static readonly Vec3W s_point = new(0.75f, 0.5f, 0.5f);

    // From 0 to 1 along x: at the point, 3/4.
    private static readonly PlacedGrid s_ramp =
        new(new VolumeGrid(4, 1, 1, 1, [0.125f, 0.375f, 0.625f, 0.875f]), Transform.Identity, GridInterpolation.Trilinear, Wrapping.Clamp);

    private static readonly Dictionary<string, PhaseFunction> s_cases = new()
    {
        ["hg -0.99"] = new HenyeyGreenstein(-0.99f),
        ["hg -0.4"] = new HenyeyGreenstein(-0.4f),
        ["hg -0.01"] = new HenyeyGreenstein(-0.01f),
        ["hg 0"] = new HenyeyGreenstein(0),
        ["hg 0.0005"] = new HenyeyGreenstein(5e-4f),
        ["hg 0.1"] = new HenyeyGreenstein(0.1f),
        ["hg 0.25"] = new HenyeyGreenstein(0.25f),
        ["hg 0.8"] = new HenyeyGreenstein(0.8f),
        ["rayleigh"] = new RayleighPhase(),
        ["table, even"] = new TablePhase([2, 2]),
        ["table, forward"] = new TablePhase([0, 1]),
        ["table, back"] = new TablePhase([7, 1e-3f]),
        ["table with gaps"] = new TablePhase([0, 0, 3, 0, 0, 0.5f, 0, 1, 8, 0, 0]),
        ["table, long"] = new TablePhase([.. Enumerable.Range(0, 1001).Select(i => 1 + float.Abs((i % 100) - 50))]),
        ["mix"] = new MixedPhase(new RayleighPhase(), new HenyeyGreenstein(0.9f), 0.2f, null),
        ["mix of mixes"] = new MixedPhase(
            new MixedPhase(new HenyeyGreenstein(-0.5f), new TablePhase([1, 0, 0, 5]), 0.6f, null), new MixedPhase(new RayleighPhase(), new HenyeyGreenstein(0.7f), 1, s_ramp), 0.4f, null),
        ["mix, first alone"] = new MixedPhase(new RayleighPhase(), new HenyeyGreenstein(0.9f), 0, null),
        ["mix, second alone"] = new MixedPhase(new RayleighPhase(), new HenyeyGreenstein(0.5f), 1, null),
    };

    public static TheoryData<string> Names => [.. s_cases.Keys];

    [Theory]
    [MemberData(nameof(Names))]
    public void All_that_is_scattered_goes_somewhere(string name) =>
        Assert.Equal(1, Cosines().Sum(c => Density(s_cases[name], c)) * 2 / Steps, name.StartsWith("hg -0.99", StringComparison.Ordinal) ? 0.05 : 2e-5);

    [Theory]
    [MemberData(nameof(Names))]
    public void Angles_are_chosen_by_the_phase_function(string name)
    {
        const int bins = 50;
        int count = TestSettings.Scale(1 << 16, 1 << 20);
        double[] expected = new double[bins];
        foreach (double cosine in Cosines())
        {
            expected[(int)((cosine + 1) / 2 * bins)] += Density(s_cases[name], cosine) * 2 / Steps * count;
        }

        // The peak of what scatters nearly all of it straight back is narrower than the steps.
        expected[0] += name == "hg -0.99" ? count - expected.Sum() : 0;
        double[] observed = new double[bins];
        UnitSquare.AtRandom(count, (u, v, lane) => observed[int.Min((int)((s_cases[name].Cosine(s_point, v, u)[lane] + 1) / 2 * bins), bins - 1)]++);
        ErrorBudget.Warps.Check(PValues.ChiSquared(observed, expected), name);
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void No_angle_that_is_chosen_is_impossible(string name)
    {
        foreach (float u in new[] { 0, float.Epsilon, 1e-8f, 0.25f, 0.5f, 0.75f, VertexSamples.LargestBelowOne })
        {
            foreach (float choice in new[] { 0, 0.5f, VertexSamples.LargestBelowOne })
            {
                FloatW cosine = s_cases[name].Cosine(s_point, choice, u);
                Assert.InRange(cosine[0], -1, 1);
                Assert.True(s_cases[name].Evaluate(s_point, cosine)[0] > 0);
            }
        }
    }

    [Theory]
    [InlineData(-0.99f)]
    [InlineData(-0.4f)]
    [InlineData(-0.01f)]
    [InlineData(0f)]
    [InlineData(5e-4f)]
    [InlineData(0.1f)]
    [InlineData(0.25f)]
    [InlineData(0.8f)]
    public void The_mean_cosine_is_g(float g)
    {
        const int count = 1 << 14;
        Assert.Equal(g, Enumerable.Range(0, count).Average(i => HenyeyGreenstein.Cosine((FloatW)g, (i + 0.5f) / count)[0]), 1e-3);
    }

    // Rayleigh's distribution of cosines, (c³ + 3c + 4)/8, at the cosine that is chosen by a number, is that number.
    [Fact]
    public void The_distribution_of_small_particles_is_inverted_to_the_last_digits()
    {
        for (int i = 0; i <= 1000; i++)
        {
            float u = float.Min(i / 1000f, VertexSamples.LargestBelowOne);
            double c = new RayleighPhase().Cosine(s_point, 0f, u)[0];
            Assert.Equal(u, ((c * c * c) + (3 * c) + 4) / 8, 2e-7);
            Assert.Equal(3 / (16 * Math.PI) * (1 + (c * c)), new RayleighPhase().Evaluate(s_point, (float)c)[0], 1e-7);
        }
    }

    // Of the numbers 1, 2, 6: the area under the line is 5.5, so that 1/11 at -1 becomes 2/11 and 6/11.
    [Theory]
    [InlineData(-1, 1)]
    [InlineData(-0.5, 1.5)]
    [InlineData(0, 2)]
    [InlineData(0.25, 3)]
    [InlineData(1, 6)]
    public void A_table_is_linear_between_its_numbers_whatever_their_scale(float cosine, double value)
    {
        foreach (float scale in new[] { 1, 1e-30f, 1e30f })
        {
            Assert.Equal(value / 5.5 / (2 * Math.PI), new TablePhase([scale, 2 * scale, 6 * scale]).Evaluate(s_point, cosine)[0], 1e-6);
        }
    }

    // What Mitsuba 3.9.1 computes for its tabphase, and for a blendphase of hg with g = -0.6 and 0.3 of rayleigh.
    [Theory]
    [InlineData(-1, 0.0278243, 0.592852)]
    [InlineData(-0.7, 0.0111297, 0.121753)]
    [InlineData(-0.1, 0.00417364, 0.0439028)]
    [InlineData(0.5, 0.0876465, 0.0353734)]
    [InlineData(0.95, 0.452145, 0.0430831)]
    public void Tables_and_mixtures_are_Mitsubas(float cosine, double ofTable, double ofMixture)
    {
        Assert.Equal(ofTable, new TablePhase([0.5f, 0.1f, 0, 0.3f, 2, 9]).Evaluate(s_point, cosine)[0], 2e-6);
        Assert.Equal(ofMixture, new MixedPhase(new HenyeyGreenstein(-0.6f), new RayleighPhase(), 0.3f, null).Evaluate(s_point, cosine)[0], 2e-6);
    }

    [Fact]
    public void A_mixture_depends_on_the_place()
    {
        MixedPhase mix = new(new TablePhase([1, 1]), new TablePhase([0, 1]), 0.8f, s_ramp);
        foreach (float x in new[] { 0.25f, 0.5f, 0.75f })
        {
            Assert.Equal((1 + (0.8 * x)) / (4 * Math.PI), mix.Evaluate(new(x, 0.3f, 0.9f), 1f)[0], 1e-6);
        }
    }

    [Fact]
    public void Directions_have_the_angle_and_lie_all_around()
    {
        Vec3W before = new(0.6f, 0f, 0.8f);
        Vector3 sum = Vector3.Zero;
        for (int i = 0; i < 64; i++)
        {
            Vec3W after = PhaseFunction.Turned(before, 0.3f, i / 64f);
            Assert.Equal(0.3, Vec3W.Dot(before, after)[0], 1e-6);
            Assert.Equal(1, Vec3W.Dot(after, after)[0], 1e-6);
            sum += new Vector3(after.X[0], after.Y[0], after.Z[0]) / 64;
        }

        Assert.Equal(0, (sum - (0.3f * new Vector3(0.6f, 0, 0.8f))).Length(), 1e-6);
    }

    private static IEnumerable<double> Cosines() => Enumerable.Range(0, Steps).Select(i => ((i + 0.5) * 2 / Steps) - 1);

    // Per cosine, all around.
    private static double Density(PhaseFunction phase, double cosine) => 2 * Math.PI * phase.Evaluate(s_point, (float)cosine)[0];
}
