using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Tests.Sampling;

public class SamplerTests
{
    private const uint FirstGroup = Dimensions.FirstVertex;

    public static TheoryData<SamplerKind, int> Samplers() => new()
    {
        { SamplerKind.Sobol, 64 },
        { SamplerKind.Jittered, 64 },
        { SamplerKind.Jittered, 49 },
        { SamplerKind.Regular, 64 },
        { SamplerKind.Independent, 64 },
    };

    [Theory]
    [MemberData(nameof(Samplers))]
    public void Points_lie_in_the_half_open_unit_square(SamplerKind kind, int count)
    {
        for (uint pixel = 0; pixel < 200; pixel++)
        {
            foreach ((float u, float v) in Points(kind, count, pixel, pixel % 9, pixel % 3))
            {
                Assert.InRange(u, 0, FloatBits.OneMinusEpsilon);
                Assert.InRange(v, 0, FloatBits.OneMinusEpsilon);
            }
        }
    }

    [Theory]
    [InlineData("jittered", 16, Dimensions.Pixel)]
    [InlineData("jittered", 25, FirstGroup)]
    [InlineData("jittered", 100, FirstGroup + 5)]
    [InlineData("regular", 36, Dimensions.Pixel)]
    [InlineData("regular", 36, Dimensions.Lens)]
    [InlineData("sobol", 16, Dimensions.Pixel)]
    [InlineData("sobol", 64, Dimensions.Lens)]
    [InlineData("sobol", 64, FirstGroup)]
    public void Every_cell_of_the_grid_gets_one_sample(string sampler, int count, uint group)
    {
        int n = JitteredSampler.Root(count)!.Value;
        for (uint pixel = 0; pixel < 50; pixel++)
        {
            var cells = Points(SamplerKind.Known.Find(sampler)!, count, pixel, group, pair: 2).Select(p => ((int)(p.U * n), (int)(p.V * n)));
            Assert.Equal(count, cells.Distinct().Count());
        }
    }

    [Theory]
    [InlineData(Dimensions.Pixel)]
    [InlineData(FirstGroup)]
    [InlineData(FirstGroup + 5)]
    public void Sobol_pairs_are_nets_in_base_two_for_every_power_of_two_of_samples(uint group)
    {
        foreach (int log in new[] { 0, 1, 2, 3, 4, 5, 6, 7, 8, 14 })
        {
            var points = Points(SamplerKind.Sobol, 1 << log, pixel: 77, group, pair: 1);
            for (int wide = 0; wide <= log; wide++)
            {
                int columns = 1 << wide;
                int rows = 1 << (log - wide);
                Assert.Equal(1 << log, points.Select(p => ((int)(p.U * columns), (int)(p.V * rows))).Distinct().Count());
            }
        }
    }

    [Fact]
    public void Regular_samples_are_the_same_in_every_pixel_but_only_on_the_pixel()
    {
        Assert.Equal(Points(SamplerKind.Regular, 16, 1, Dimensions.Pixel), Points(SamplerKind.Regular, 16, 2, Dimensions.Pixel));
        Assert.NotEqual(Points(SamplerKind.Regular, 16, 1, FirstGroup), Points(SamplerKind.Regular, 16, 2, FirstGroup));
        Assert.Equal((0.125f, 0.125f), Points(SamplerKind.Regular, 16, 1, Dimensions.Pixel)[0]);
    }

    [Theory]
    [InlineData(Dimensions.Pixel, Dimensions.Lens, 6)]
    [InlineData(Dimensions.Pixel, Dimensions.Lens, 8)]
    [InlineData(Dimensions.Pixel, Dimensions.Lens, 11)]
    [InlineData(FirstGroup, FirstGroup + Dimensions.SecondOfFour, 8)]
    [InlineData(FirstGroup + 5, FirstGroup + 5 + Dimensions.SecondOfFour, 8)]
    public void Two_groups_together_are_a_net_in_four_dimensions(uint first, uint second, int log)
    {
        // The polynomials of the first four dimensions have degrees 0, 1, 2 and 3: the quality parameter is the sum of degree − 1, t = 3
        // (Sobol 1967). Each box of volume 2^t/N has then 2^t of N points, however it is cut.
        var halves = Points(SamplerKind.Sobol, 1 << log, 5, first, pair: 0);
        var others = Points(SamplerKind.Sobol, 1 << log, 5, second, pair: 0);
        int free = log - 3;
        for (int cut = 0; cut < 1 << (2 * 4); cut++)
        {
            int[] digits = [cut & 3, (cut >> 2) & 3, (cut >> 4) & 3, 0];
            digits[3] = free - digits.Sum();
            if (digits[3] >= 0)
            {
                var boxes = halves.Zip(others, (p, l) => (
                    (int)(p.U * (1 << digits[0])), (int)(p.V * (1 << digits[1])), (int)(l.U * (1 << digits[2])), (int)(l.V * (1 << digits[3]))));
                Assert.All(boxes.CountBy(b => b), box => Assert.Equal(8, box.Value));
            }
        }
    }

    [Theory]
    [InlineData(Dimensions.Pixel)]
    [InlineData(Dimensions.Lens)]
    [InlineData(FirstGroup)]
    [InlineData(FirstGroup + 3)]
    public void First_Sobol_samples_are_the_same_however_many_follow(uint group) =>
        Assert.Equal(Points(SamplerKind.Sobol, 64, 9, group, pair: 1), Points(SamplerKind.Sobol, 1 << 14, 9, group, pair: 1)[..64]);

    [Theory]
    [InlineData(2435)]
    [InlineData(3000)]
    [InlineData(4096)]
    public void Millions_of_cells_keep_their_points_in_the_unit_square(int root)
    {
        int count = root * root;
        foreach (SamplerKind kind in new[] { SamplerKind.Jittered, SamplerKind.Regular })
        {
            Sampler sampler = kind.Create(count);
            for (int i = 0; i < 200_000; i += FloatW.Count)
            {
                sampler.Begin(Hash.PixelKey(0, 3), UIntW.Iota + (uint)(count - 200_000 + i), Dimensions.Pixel, out SamplePoints points);
                sampler.Pair(points, 0, out FloatW u, out FloatW v);
                MaskW within = (u >= 0f) & (u < 1f) & (v >= 0f) & (v < 1f);
                Assert.Equal(MaskW.All.Bits, within.Bits);
            }
        }
    }

    [Theory]
    [InlineData(15, 9, 16)]
    [InlineData(2, 1, 4)]
    [InlineData(99, 81, 100)]
    public void A_number_that_is_no_square_is_refused_with_its_neighbours(int count, int below, int above)
    {
        string? complaint = SamplerKind.Jittered.Complaint(count);
        Assert.Contains($"use {below} or {above}", complaint, StringComparison.Ordinal);
        Assert.Throws<ArgumentException>(() => new JitteredSampler(count));
        Assert.Null(SamplerKind.Sobol.Complaint(count));
    }

    [Fact]
    public void Sobol_matrices_make_every_dimension_a_permutation_of_the_strata()
    {
        for (int dimension = 0; dimension < SobolMatrix.Dimensions; dimension++)
        {
            uint[] columns = SobolMatrix.Columns(dimension);
            var strata = Enumerable.Range(0, 1024).Select(i =>
            {
                uint digits = 0;
                for (int k = 0; k < 10; k++)
                {
                    digits ^= (i >> k & 1) != 0 ? columns[k] : 0;
                }

                return digits & 1023;
            });
            Assert.Equal(1024, strata.Distinct().Count());
        }
    }

    private static List<(float U, float V)> Points(SamplerKind kind, int count, uint pixel, uint group, uint pair = 0, uint seed = 0)
    {
        Sampler sampler = kind.Create(count);
        List<(float, float)> points = [];
        for (int i = 0; i < count; i += FloatW.Count)
        {
            sampler.Begin(Hash.PixelKey(seed, pixel), UIntW.Iota + (uint)i, group, out SamplePoints prepared);
            sampler.Pair(prepared, pair, out FloatW u, out FloatW v);
            for (int lane = 0; lane < FloatW.Count && i + lane < count; lane++)
            {
                points.Add((u[lane], v[lane]));
            }
        }

        return points;
    }
}
