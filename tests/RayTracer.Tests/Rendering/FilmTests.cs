using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

public class FilmTests
{
    [Fact]
    public void Means_are_those_of_the_samples()
    {
        Film film = Expose(new(1, 2, 3), new(2, 2, 2), new(0, 5, 0.25f));
        Assert.Equal(1, film.Mean(0, 0).R);
        Assert.Equal(3, film.Mean(0, 0).G);
        Assert.Equal(1.75f, film.Mean(0, 0).B);
        Assert.Equal(3u, film.SampleCount(0, 0));
    }

    [Fact]
    public void Variance_is_that_of_the_samples_luminance()
    {
        Film film = Expose(new(1, 1, 1), new(2, 2, 2), new(6, 6, 6));
        Assert.Equal(7, film.SampleVariance(0, 0), 4);
        Assert.Equal(0, Expose(new Rgb(1, 1, 1)).SampleVariance(0, 0));
    }

    [Fact]
    public void Tiny_numbers_are_not_lost_beside_huge_ones()
    {
        // 2²³ and 2⁻³⁰ together need 53 digits; in floats the small one would vanish.
        Film film = Expose(new(8388608, 0, 0), new(-8388608, 0, 0), new(1f / (1 << 30), 0, 0));
        Assert.Equal(1f / (1 << 30) / 3, film.Mean(0, 0).R);
    }

    [Theory]
    [InlineData(0.25f, 0)]
    [InlineData(0.75f, 1)]
    [InlineData(-0.75f, -1)]
    [InlineData(1000.75f, 1001)]
    public void Samples_are_rounded_to_the_nearest_unit(float units, int expected)
    {
        // A sample that was cut off instead would take half a unit from each, on average.
        const float unit = 1f / 65536 / 65536;
        Assert.Equal(expected * unit, Expose(new(units * unit, 0, 0), new(units * unit, 0, 0)).Mean(0, 0).R);
    }

    [Fact]
    public void Order_does_not_matter_to_a_single_bit()
    {
        var random = new Random(4);
        Rgb[] samples = [.. Enumerable.Range(0, 64).Select(_ => new Rgb(random.NextSingle() * 100, random.NextSingle(), random.NextSingle() * 1e-6f))];
        string hash = Expose(samples).ComputeHash();
        random.Shuffle(samples);
        Assert.Equal(hash, Expose(samples).ComputeHash());
        samples[0] = new(samples[0].R, samples[0].G, samples[0].B + 1e-9f);
        Assert.NotEqual(hash, Expose(samples).ComputeHash());
    }

    [Fact]
    public void Samples_that_are_not_finite_are_left_out_and_named()
    {
        SampleAccumulator accumulator = new(4);
        Film film = new(4, 4);
        accumulator.Begin(film, new(2, 1, 2, 2), samples: 1);
        accumulator.Add(3, UIntW.Iota, 7u, new(new FloatW(System.Numerics.Vector<float>.One), Nan(lane: 1), 1f));
        accumulator.End();
        Assert.Equal(1, accumulator.NonFinite);
        BadSample bad = Assert.Single(accumulator.Bad);
        Assert.Equal((3, 1, 7), (bad.X, bad.Y, bad.Sample));
        Assert.Equal(0u, film.SampleCount(3, 1));
        Assert.Equal(1u, film.SampleCount(2, 1));
        Assert.Equal(1u, film.SampleCount(2, 2));
    }

    [Fact]
    public void Samples_beyond_the_limit_are_clamped_and_counted()
    {
        SampleAccumulator accumulator = new(1);
        Film film = new(1, 1);
        accumulator.Begin(film, new(0, 0, 1, 1), samples: 1);
        accumulator.Add(1, 0u, 0u, new(1e30f, -1e30f, 5f));
        accumulator.End();
        Assert.Equal(1, accumulator.Clamped);
        Assert.Equal(new Rgb(Film.SampleLimit, -Film.SampleLimit, 5), film.Mean(0, 0));
    }

    [Fact]
    public void Sixty_four_of_the_largest_samples_do_not_overflow()
    {
        foreach (float value in new[] { 15.999f, Film.SampleLimit })
        {
            Film film = Expose([.. Enumerable.Repeat(new Rgb(value, value, value), SampleAccumulator.MaxSamples)]);
            Assert.Equal(value, film.Mean(0, 0).R);
            Assert.True(film.SampleVariance(0, 0) <= value * value * 1e-12);
        }
    }

    [Fact]
    public void Films_of_different_sizes_do_not_merge() =>
        Assert.Throws<ArgumentException>(() => new Film(2, 2).Merge(new Film(2, 3)));

    [Fact]
    public void Sums_are_exact_from_the_smallest_to_the_largest_samples()
    {
        // Whole numbers of units only, so that nothing is rounded: the mean of all is known to the last digit.
        var random = new Random(5);
        List<Rgb> samples = [];
        System.Numerics.BigInteger[] sums = new System.Numerics.BigInteger[3];
        for (int i = 0; i < SampleAccumulator.MaxSamples; i++)
        {
            float[] channels = new float[3];
            for (int c = 0; c < 3; c++)
            {
                // 24 digits, anywhere from 2⁻³² to 2²⁴, of either sign.
                int exponent = random.Next(-32, 1);
                long digits = random.NextInt64(-(1 << 24), 1 << 24);
                channels[c] = MathF.ScaleB(digits, exponent);
                sums[c] += new System.Numerics.BigInteger(digits) << (exponent + 32);
            }

            samples.Add(new(channels[0], channels[1], channels[2]));
        }

        Film film = Expose([.. samples]);
        Rgb mean = film.Mean(0, 0);
        Assert.Equal((double)sums[0] / 4294967296.0 / samples.Count, mean.R, Math.Abs(mean.R) * 1e-7);
        Assert.Equal((double)sums[1] / 4294967296.0 / samples.Count, mean.G, Math.Abs(mean.G) * 1e-7);
        Assert.Equal((double)sums[2] / 4294967296.0 / samples.Count, mean.B, Math.Abs(mean.B) * 1e-7);

        // Their opposites leave nothing at all.
        film.Merge(Expose([.. samples.Select(c => new Rgb(-c.R, -c.G, -c.B))]));
        Assert.Equal(Rgb.Black, film.Mean(0, 0));
    }

    [Theory]
    [InlineData(15.999999f)]
    [InlineData(16f)]
    [InlineData(16.000002f)]
    [InlineData(1000.123f)]
    public void Bright_samples_take_another_way_to_the_same_sums(float value)
    {
        // Beyond 16, samples go to the film one by one: with a dark one between them, the count and the sums are still whole.
        Film film = Expose(new(value, 0.5f, 0), new(1, 0.5f, 0), new(-value, 0.5f, 0), new(value, 0.5f, value));
        Assert.Equal(4u, film.SampleCount(0, 0));
        Assert.Equal((value + 1.0) / 4, film.Mean(0, 0).R, value * 1e-7);
        Assert.Equal(0.5f, film.Mean(0, 0).G);
        Assert.Equal(value / 4, film.Mean(0, 0).B);
    }

    [Theory]
    [InlineData(0.01f)]
    [InlineData(10f)]
    [InlineData(5000f)]
    public void Variance_is_the_unbiased_one_at_any_brightness_and_in_any_split(float scale)
    {
        var random = new Random(6);
        Rgb[] samples = [.. Enumerable.Range(0, 50).Select(_ => new Rgb(random.NextSingle() * scale, random.NextSingle() * scale, random.NextSingle() * scale))];
        double[] luminances = [.. samples.Select(s => (0.2126 * s.R) + (0.7152 * s.G) + (0.0722 * s.B))];
        double mean = luminances.Average();
        double variance = luminances.Sum(l => (l - mean) * (l - mean)) / 49;
        Assert.Equal(variance, Expose(samples).SampleVariance(0, 0), variance * 1e-5);
        Film merged = Expose(samples[..17]);
        merged.Merge(Expose(samples[17..]));
        Assert.Equal(Expose(samples).SampleVariance(0, 0), merged.SampleVariance(0, 0));
    }

    [Fact]
    public void Merging_is_commutative_and_associative_and_weighs_films_by_their_samples()
    {
        Film[] films = [Expose(new Rgb(1, 2, 3)), Expose(new(5e6f, -1e-8f, 0.1f), new(0.3f, 7, 20)), Expose(new(4, 4, 4), new(5, 5, 5), new(6, 6, 6))];
        string[] hashes = [.. new[] { "012", "021", "102", "120", "201", "210" }.Select(order => Merged([.. order.Select(c => films[c - '0'])]).ComputeHash())];
        Assert.Single(hashes.Distinct());

        // (a + b) + c and a + (b + c).
        Assert.Equal(hashes[0], Merged(Merged(films[0], films[1]), films[2]).ComputeHash());
        Assert.Equal(hashes[0], Merged(films[0], Merged(films[1], films[2])).ComputeHash());
        Film few = Merged(films[0], films[2]);
        Assert.Equal(4u, few.SampleCount(0, 0));
        Assert.Equal(4, few.Mean(0, 0).R);
        Assert.Equal(4, few.TotalSamples);
    }

    [Fact]
    public void Clamping_is_counted_once_a_sample_and_only_beyond_the_limit()
    {
        SampleAccumulator accumulator = new(1);
        accumulator.Begin(new Film(1, 1), new(0, 0, 1, 1), samples: 3);
        accumulator.Add(1, 0u, 0u, new(1e30f, 1e30f, -1e30f));
        accumulator.Add(1, 0u, 1u, new(Film.SampleLimit, -Film.SampleLimit, 100f));
        accumulator.Add(1, 0u, 2u, new(Film.SampleLimit + 2, 0f, 0f));
        Assert.Equal(2, accumulator.Clamped);
        Assert.Equal(0, accumulator.NonFinite);
    }

    [Fact]
    public void The_hash_covers_counts_and_size()
    {
        // Black samples leave no trace in the sums: the counts are part of the hash.
        Assert.NotEqual(Expose(Rgb.Black).ComputeHash(), Expose(Rgb.Black, Rgb.Black).ComputeHash());
        Assert.NotEqual(new Film(2, 3).ComputeHash(), new Film(3, 2).ComputeHash());
    }

    private static Film Merged(params Film[] films)
    {
        Film merged = new(1, 1);
        Array.ForEach(films, merged.Merge);
        return merged;
    }

    private static FloatW Nan(int lane)
    {
        float[] values = new float[FloatW.Count];
        values[lane] = float.NaN;
        return new(new System.Numerics.Vector<float>(values));
    }

    private static Film Expose(params Rgb[] samples)
    {
        Film film = new(1, 1);
        SampleAccumulator accumulator = new(1);
        accumulator.Begin(film, new(0, 0, 1, 1), samples.Length);
        foreach (Rgb sample in samples)
        {
            accumulator.Add(1, 0u, 0u, sample);
        }

        accumulator.End();
        return film;
    }
}
