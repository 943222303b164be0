using RayTracer.Description;
using RayTracer.Sampling;

namespace RayTracer.Tests.Sampling;

/// <summary>
/// Over many pixels, no two random decisions of a path know of one another, nor do neighbouring pixels, nor do the pictures of
/// different seeds: by correlation, and by a χ² test of joint cells for dependence of any other form.
/// Covers `Sampler`, `VertexSamples` and `Dimensions`.
/// </summary>
[Trait("Category", "Thorough")]
public class SamplerIndependenceTests
{
    private const int Samples = 16;
    private static readonly int s_draws = TestSettings.Scale(1 << 14, 1 << 17);
    private static readonly uint s_seed = (uint)TestSettings.Seed * 7919u;

    public static TheoryData<SamplerKind> Samplers() => [SamplerKind.Sobol, SamplerKind.Jittered, SamplerKind.Independent];

    [Theory]
    [MemberData(nameof(Samplers))]
    public void Decisions_of_a_path_are_independent_of_one_another(SamplerKind kind)
    {
        Sampler sampler = DrawnNumbers.Sampler(kind, Samples);
        DrawnNumbers[] drawn = [.. PathDimension.All.Select(d => DrawnNumbers.Of(sampler, d, s_draws, i => Hash.PixelKey(s_seed, (uint)i), SampleOf))];
        for (int i = 0; i < drawn.Length; i++)
        {
            (PathDimension first, DrawnNumbers a) = (PathDimension.All[i], drawn[i]);
            if (first.IsPair)
            {
                ErrorBudget.Samplers.Check(PValues.Smallest([Dependence.JointUniformity(a.U, a.V), Dependence.Correlation(a.U, a.V)]), $"{kind}: both numbers of {first}");
            }

            for (int j = i + 1; j < drawn.Length; j++)
            {
                double p = Dependence.Independence(first, a, PathDimension.All[j], drawn[j]);
                ErrorBudget.Samplers.Check(p, $"{kind}: {first} and {PathDimension.All[j]}");
            }
        }
    }

    [Theory]
    [MemberData(nameof(Samplers))]
    public void Neighbouring_pixels_are_independent_of_one_another(SamplerKind kind)
    {
        Check(kind, "a pixel and the next", i => (s_seed, 2 * i), i => (s_seed, (2 * i) + 1));
        foreach (uint width in new[] { 256u, 600u, 640u, 1920u })
        {
            uint Above(uint i) => (i / width * 2 * width) + (i % width);
            Check(kind, $"a pixel and the one below in a picture {width} wide", i => (s_seed, Above(i)), i => (s_seed, Above(i) + width));
        }
    }

    [Theory]
    [MemberData(nameof(Samplers))]
    public void Pictures_of_different_seeds_are_independent_of_one_another(SamplerKind kind)
    {
        Check(kind, "a seed and the next", i => (s_seed, i), i => (s_seed + 1, i));
        Check(kind, "a seed and the next but one", i => (s_seed, i), i => (s_seed + 2, i));
        Check(kind, "the next seed's next pixel", i => (s_seed, i), i => (s_seed + 1, i + 1));
        Check(kind, "the next seed's last pixel", i => (s_seed, i + 1), i => (s_seed + 1, i));
        Check(kind, "seed and pixel exchanged", i => (i, i + 1), i => (i + 1, i));
        for (int bit = 0; bit < 32; bit++)
        {
            Check(kind, $"seeds that differ in bit {bit}", i => (s_seed, i), i => (s_seed ^ (1u << bit), i));
        }
    }

    [Fact]
    public void Successive_samples_are_independent_of_one_another_where_nothing_is_stratified()
    {
        Sampler sampler = DrawnNumbers.Sampler(SamplerKind.Independent, Samples);
        foreach (PathDimension dimension in PathDimension.All)
        {
            DrawnNumbers a = DrawnNumbers.Of(sampler, dimension, s_draws, i => Hash.PixelKey(s_seed, (uint)i / 8), i => (uint)(i % 8 * 2));
            DrawnNumbers b = DrawnNumbers.Of(sampler, dimension, s_draws, i => Hash.PixelKey(s_seed, (uint)i / 8), i => (uint)(i % 8 * 2) + 1);
            ErrorBudget.Samplers.Check(Dependence.Independence(dimension, a, dimension, b), $"independent: a sample and the next, {dimension}");
        }
    }

    // Every sample number takes its turn.
    private static uint SampleOf(int draw) => (uint)draw % Samples;

    private static void Check(SamplerKind kind, string what, Func<uint, (uint Seed, uint Pixel)> first, Func<uint, (uint Seed, uint Pixel)> second)
    {
        Sampler sampler = DrawnNumbers.Sampler(kind, Samples);
        IEnumerable<double> p = new[] { "pixel", "direction of vertex 0" }.Select(name =>
        {
            PathDimension dimension = PathDimension.Named(name);
            DrawnNumbers Draw(Func<uint, (uint Seed, uint Pixel)> place) => DrawnNumbers.Of(
                sampler, dimension, s_draws, i => Hash.PixelKey(place((uint)i).Seed, place((uint)i).Pixel), SampleOf);
            return Dependence.Independence(dimension, Draw(first), dimension, Draw(second));
        });
        ErrorBudget.Samplers.Check(PValues.Smallest(p), $"{kind}: {what}");
    }
}
