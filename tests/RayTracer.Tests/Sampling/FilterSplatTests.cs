using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Tests.Sampling;

/// <summary>Which pixels a <see cref="PixelFilter"/> lets light count for that comes to a place of the picture.</summary>
public class FilterSplatTests
{
    // Places in each pixel, and random numbers for each place.
    private const int Places = 128;
    private const int Numbers = 64;
    private const int Reach = 5;
    private static readonly Dictionary<string, FilterDescription> s_filters = new()
    {
        ["none"] = new(),
        ["wide box"] = new() { Shape = FilterShape.Box, Radius = 1.25f },
        ["narrow box"] = new() { Shape = FilterShape.Box, Radius = 0.3f },
        ["tent"] = new() { Shape = FilterShape.Tent, Radius = 1 },
        ["gaussian"] = new() { Shape = FilterShape.Gaussian, Radius = 1.5f },
        ["wide gaussian"] = new() { Shape = FilterShape.Gaussian, Radius = 4, Deviation = 0.75f },
        ["mitchell"] = new() { Shape = FilterShape.Mitchell, Radius = 2 },
        ["large lobes"] = new() { Shape = FilterShape.Mitchell, Radius = 3, B = 0, C = 1 },
        ["Blackman-Harris"] = new() { Shape = FilterShape.BlackmanHarris, Radius = 1.5f },
    };

    public static TheoryData<string> Names => new(s_filters.Keys);

    [Theory]
    [MemberData(nameof(Names))]
    public void Splats_make_the_same_pixel_as_its_own_samples(string name)
    {
        // Of the pixel of number 0, in the mean: a constant, a ramp, a parabola, and steps in many places.
        PixelFilter? filter = PixelFilter.Create(s_filters[name]);
        double[] splats = new double[44];
        for (int i = 0; i < 2 * Reach * Places; i++)
        {
            float place = ((i + 0.5f) / Places) - Reach + 0.5f;
            for (uint j = 0; j < Numbers; j += (uint)FloatW.Count)
            {
                PixelFilter.Splat(filter, place, Number(j, i), out FloatW pixel, out FloatW weight);
                for (int lane = 0; lane < FloatW.Count; lane++)
                {
                    Add(splats, place, pixel[lane] == 0 ? weight[lane] / (double)(Places * Numbers) : 0);
                }
            }
        }

        double[] samples = OwnSamples(filter);
        for (int k = 0; k < samples.Length; k++)
        {
            Assert.True(Math.Abs(samples[k] - splats[k]) < 0.012, $"{k}: {splats[k]} for {samples[k]}");
        }
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Ray_density_is_that_of_the_samples_of_all_pixels(string name)
    {
        const int bins = 10;
        const int count = 1 << 15;
        if (PixelFilter.Create(s_filters[name]) is not { } filter)
        {
            return;
        }

        double[] samples = new double[bins];
        double[] density = new double[bins];
        for (uint i = 0; i < count; i += (uint)FloatW.Count)
        {
            FloatW number = ((UIntW.Iota + i).ToFloat() + 0.5f) * (1f / count);
            FloatW along = number;
            FloatW other = 0.5f;
            filter.Place(ref along, ref other);
            along -= FloatW.Floor(along);

            // Of both axes, the square of one.
            FloatW rays = filter.RayDensity(number + 3f, number - 7f);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                samples[Math.Min((int)(along[lane] * bins), bins - 1)] += (double)bins / count;
                density[(int)(number[lane] * bins)] += Math.Sqrt(rays[lane]) * bins / count;
            }
        }

        for (int k = 0; k < bins; k++)
        {
            Assert.True(Math.Abs(samples[k] - density[k]) < 3e-3, $"{k}: {density[k]} for {samples[k]}");
        }
    }

    [Theory]
    [MemberData(nameof(Names))]
    public void Weights_are_of_the_size_of_the_ray_density(string name)
    {
        if (PixelFilter.Create(s_filters[name]) is not { } filter)
        {
            return;
        }

        float norm = float.Sqrt(filter.Weight(0.5f, 0.5f)[0]);
        for (int i = 0; i < 64; i++)
        {
            PixelFilter.Splat(filter, FloatW.MultiplyAdd(FloatW.Iota, 0.37f, i), Number(0, i), out _, out FloatW weight);
            FloatW rays = filter.RayDensity(FloatW.MultiplyAdd(FloatW.Iota, 0.37f, i), FloatW.MultiplyAdd(FloatW.Iota, 0.37f, i));
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                Assert.Equal(Math.Sqrt(rays[lane]) * norm, Math.Abs(weight[lane]), 1e-5);
            }
        }
    }

    [Fact]
    public void Margin_is_how_far_pixels_reach_beyond_their_squares()
    {
        Assert.Equal(0, PixelFilter.Margin(new()));
        Assert.Equal(0, PixelFilter.Margin(s_filters["narrow box"]));
        Assert.Equal(1.5f, PixelFilter.Margin(new() { Shape = FilterShape.Mitchell }));
    }

    // The same of the samples that belong to the pixel.
    private static double[] OwnSamples(PixelFilter? filter)
    {
        const int count = 1 << 14;
        double[] sums = new double[44];
        for (uint i = 0; i < count; i += (uint)FloatW.Count)
        {
            FloatW u = ((UIntW.Iota + i).ToFloat() + 0.5f) * (1f / count);
            FloatW v = 0.5f;
            FloatW weight = filter is null ? 1f : filter.Weight(u, v) / FloatW.Sqrt(filter.Weight(v, v));
            filter?.Place(ref u, ref v);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                Add(sums, u[lane], weight[lane] / (double)count);
            }
        }

        return sums;
    }

    private static void Add(double[] sums, double place, double weight)
    {
        sums[0] += weight;
        sums[1] += weight * place;
        sums[2] += weight * place * place;
        for (int k = 3; k < sums.Length; k++)
        {
            sums[k] += place > ((k - 23.5) / 5.5) + 0.5 ? weight : 0;
        }
    }

    // Evenly spread, otherwise for each place.
    private static FloatW Number(uint first, int place)
    {
        float shift = (place * 0.618034f) - float.Floor(place * 0.618034f);
        return ((UIntW.Iota + first).ToFloat() + shift) * (1f / Numbers);
    }
}
