using RayTracer.Description;
using RayTracer.Sampling;

namespace RayTracer.Tests.Sampling;

/// <summary>
/// Over many pixels, every sample of every decision is uniform by itself.
/// Covers `Sampler` and `VertexSamples`.
/// </summary>
[Trait("Category", "Thorough")]
public class SamplerUniformityTests
{
    private static readonly uint s_seed = (uint)TestSettings.Seed * 7919u;

    public static TheoryData<SamplerKind, int> Samplers() => new()
    {
        { SamplerKind.Sobol, 16 },
        { SamplerKind.Sobol, 24 },
        { SamplerKind.Jittered, 16 },
        { SamplerKind.Jittered, 49 },
        { SamplerKind.Regular, 16 },
        { SamplerKind.Independent, 16 },
    };

    [Theory]
    [MemberData(nameof(Samplers))]
    public void Every_sample_number_is_uniform_in_its_square(SamplerKind kind, int count)
    {
        Sampler sampler = DrawnNumbers.Sampler(kind, count);
        int pixels = TestSettings.Scale(1 << 13, 1 << 15);
        foreach (PathDimension dimension in Decisions(kind))
        {
            IEnumerable<double> p = Enumerable.Range(0, count).Select(sample =>
            {
                DrawnNumbers numbers = DrawnNumbers.Of(sampler, dimension, pixels, Key, _ => (uint)sample);
                return dimension.IsPair ? Dependence.JointUniformity(numbers.U, numbers.V) : Dependence.Uniformity(numbers.U, 256);
            });
            ErrorBudget.Samplers.Check(PValues.Smallest(p), $"{kind} of {count}, {dimension}: each sample number over the pixels");
        }
    }

    [Theory]
    [MemberData(nameof(Samplers))]
    public void Numbers_are_uniform_to_a_thousandth(SamplerKind kind, int count)
    {
        // One sample of each pixel: those of one pixel are not independent of one another.
        Sampler sampler = DrawnNumbers.Sampler(kind, count);
        int draws = TestSettings.Scale(1 << 20, 1 << 22);
        foreach (PathDimension dimension in Decisions(kind))
        {
            DrawnNumbers numbers = DrawnNumbers.Of(sampler, dimension, draws, Key, i => (uint)(i % count));
            double p = PValues.Smallest(numbers.Coordinates(dimension).Select(u => Dependence.Uniformity(u, 1024)));
            ErrorBudget.Samplers.Check(p, $"{kind} of {count}, {dimension}: cells of a thousandth");
        }
    }

    [Theory]
    [MemberData(nameof(Samplers))]
    public void The_mean_of_a_pixel_has_no_bias(SamplerKind kind, int count)
    {
        // Stratified means hardly vary, so that the smallest bias shows.
        Sampler sampler = DrawnNumbers.Sampler(kind, count);
        int pixels = TestSettings.Scale(1 << 19, 1 << 21) / count;
        foreach (PathDimension dimension in Decisions(kind))
        {
            DrawnNumbers numbers = DrawnNumbers.Of(sampler, dimension, pixels * count, i => Key(i / count), i => (uint)(i % count));
            double p = PValues.Smallest(numbers.Coordinates(dimension).Select(u => PValues.Mean([.. u.Chunk(count).Select(Average)], 0.5)));
            ErrorBudget.Samplers.Check(p, $"{kind} of {count}, {dimension}: mean");
        }
    }

    [Fact]
    public void Samples_beyond_the_first_table_are_uniform_too()
    {
        // The Sobol sampler looks the digits of a sample's number up in two tables of 2¹² entries.
        Sampler sampler = DrawnNumbers.Sampler(SamplerKind.Sobol, 1 << 20);
        foreach (PathDimension dimension in Decisions(SamplerKind.Sobol).Where(d => d.IsPair))
        {
            DrawnNumbers numbers = DrawnNumbers.Of(sampler, dimension, 1 << 16, _ => Key(0), i => 4096u + (uint)i);
            double[] p = [Dependence.JointUniformity(numbers.U, numbers.V), .. numbers.Coordinates(dimension).Select(u => Dependence.Uniformity(u, 1024))];
            ErrorBudget.Samplers.Check(PValues.Smallest(p), $"Sobol, {dimension}: 65,536 samples of one pixel");
        }
    }

    private static IEnumerable<PathDimension> Decisions(SamplerKind kind) =>
        from name in new[] { "pixel", "lens", "direction of vertex 0", "light 1 of vertex 0", "choice of vertex 0" }
        where kind != SamplerKind.Regular || !string.Equals(name, "pixel", StringComparison.Ordinal)
        select PathDimension.Named(name);

    private static double Average(float[] numbers) => numbers.Sum(u => (double)u) / numbers.Length;

    private static uint Key(int pixel) => Hash.PixelKey(s_seed, (uint)pixel);
}
