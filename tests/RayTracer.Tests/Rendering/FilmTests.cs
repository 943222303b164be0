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
        accumulator.Begin(film, new(2, 1, 2, 2));
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
        accumulator.Begin(film, new(0, 0, 1, 1));
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
        accumulator.Begin(film, new(0, 0, 1, 1));
        foreach (Rgb sample in samples)
        {
            accumulator.Add(1, 0u, 0u, sample);
        }

        accumulator.End();
        return film;
    }
}
