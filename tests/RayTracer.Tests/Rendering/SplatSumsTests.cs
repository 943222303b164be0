using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>Covers <see cref="SplatSums"/> and the light that films hold.</summary>
public class SplatSumsTests
{
    private static readonly FilmPlane[] s_planes = [FilmPlane.Half, FilmPlane.Light, FilmPlane.LightSquare, FilmPlane.LightHalf];

    [Fact]
    public void Light_has_a_mean_of_its_own_which_is_added_to_that_of_the_camera()
    {
        Film film = new(2, 1, s_planes);
        film.AddRow(0, 0, [Units(3), Units(2), Units(1), 0, 0, 0, 0, 0], default, samples: 2, isOfHalf: false);
        SplatSums sums = new(2, 1);
        Splat(sums, 0, new(1, 2, 4));
        Splat(sums, 0, new(0.5f, 0, 0));
        sums.Commit(film, 0);
        for (int sample = 1; sample < 4; sample++)
        {
            Splat(sums, 1, new(0, 1, 0));
            sums.Commit(film, sample);
        }

        Assert.Equal(new(1.875f, 1.5f, 1.5f), film.Mean(0, 0));
        Assert.Equal(new(0, 0.75f, 0), film.Mean(1, 0));
        Assert.Equal([1.875f, 1.5f, 1.5f, 0, 0.75f, 0], film.ToPicture().Pixels);
        Assert.Equal(2u, film.SampleCount(0, 0));
    }

    [Fact]
    public void Threads_in_any_order_give_the_exact_sums()
    {
        // Channels that are ordinary, that fill 64 bits, and that are too bright for them.
        Rgb[] values = [.. Enumerable.Range(0, 4000).Select(i => new Random(i)).Select(r => new Rgb(r.NextSingle(), 262143 * r.NextSingle(), -1e7f * MathF.Round(r.NextSingle())))];
        Int128[] expected = new Int128[2 * FilmPlane.Light.Sums.Count];
        for (int i = 0; i < values.Length * FloatW.Count; i++)
        {
            (int pixel, Rgb value) = (i & 1, values[i / FloatW.Count]);
            expected[4 * pixel] += Units(value.R);
            expected[(4 * pixel) + 1] += Units(value.G);
            expected[(4 * pixel) + 2] += Units(value.B);
        }

        (expected[3], expected[7]) = (1, 1);
        foreach (int threads in (int[])[1, 2, 5])
        {
            Film film = new(2, 1, s_planes);
            SplatSums sums = new(2, 1) { Threads = threads };
            Parallel.For(0, threads, thread =>
            {
                for (int i = thread; i < values.Length; i += threads)
                {
                    sums.Add(FloatW.Count, UIntW.Iota & 1u, values[i]);
                }
            });
            sums.Commit(film, 0);
            Assert.Equal(expected, Plane(film, FilmPlane.Light));
            Assert.Equal(0, sums.Clamped);
        }
    }

    [Theory]
    [InlineData(262143)]
    [InlineData(-262143)]
    [InlineData(Film.SampleLimit)]
    public void The_brightest_light_of_all_paths_fits_into_one_pixel(float brightest)
    {
        // With 64 bits alone, the 8,192nd of the ordinary ones would be negative.
        const int splats = 1 << 15;
        Film film = new(1, 1, FilmPlane.Light);
        SplatSums sums = new(1, 1);
        for (int i = 0; i < splats; i++)
        {
            Splat(sums, 0, new(brightest, 0, brightest));
        }

        sums.Commit(film, 0);
        Assert.Equal([(Int128)Units(brightest) * splats, 0, (Int128)Units(brightest) * splats, 1], Plane(film, FilmPlane.Light));
    }

    [Fact]
    public void A_film_holds_all_samples_of_the_brightest_light()
    {
        Int128 sample = (Int128)Units(Film.SampleLimit) << 46;
        Film film = new(1, 1, s_planes);
        film.AddLight(0, 0, [sample, sample, sample], 0);
        for (int doubling = 0; doubling < 24; doubling++)
        {
            film.Merge(film);
        }

        Assert.Equal(Film.SampleLimit * float.Exp2(46), film.Mean(0, 0).G);
        Assert.Equal([sample << 24, sample << 24, sample << 24, 1 << 24], Plane(film, FilmPlane.Light));
        Assert.True(Plane(film, FilmPlane.LightSquare)[0] > 0);
    }

    [Fact]
    public void Splats_that_are_not_finite_are_left_out_and_bright_ones_clamped()
    {
        Film film = new(1, 1, FilmPlane.Light);
        SplatSums sums = new(1, 1);
        foreach (Rgb value in (Rgb[])[new(float.NaN, 1, 1), new(1, float.PositiveInfinity, 1), new(1, 1, float.NegativeInfinity), new(1e30f, -1e30f, 2)])
        {
            Splat(sums, 0, value);
        }

        sums.Commit(film, 0);
        Assert.Equal((3, 1), (sums.NonFinite, sums.Clamped));
        Assert.Equal(new(Film.SampleLimit, -Film.SampleLimit, 2), film.Mean(0, 0));
    }

    [Fact]
    public void Lanes_that_are_not_in_use_bring_nothing()
    {
        Film film = new(2, 1, FilmPlane.Light);
        SplatSums sums = new(2, 1);
        sums.Add(1, UIntW.Iota & 1u, Rgb.White);
        sums.Commit(film, 0);
        Assert.Equal([Rgb.White, Rgb.Black], [film.Mean(0, 0), film.Mean(1, 0)]);
    }

    [Fact]
    public void Parts_of_the_samples_add_up_to_all_of_them_and_to_their_halves()
    {
        Film all = Lit(0, 16);
        Film film = Lit(8, 16);
        film.Merge(Lit(0, 8));
        Assert.Equal(all.ComputeHash(), film.ComputeHash());
        (Film first, Film second) = film.Halves();
        Film[] halves = [new(3, 2, first.Planes), new(3, 2, first.Planes)];
        for (int sample = 0; sample < 16; sample++)
        {
            Light(halves[FilmPlane.IsOfHalf(sample) ? 0 : 1], sample);
        }

        Assert.Equal(halves.Select(h => h.ComputeHash()), [first.ComputeHash(), second.ComputeHash()]);
        Assert.NotEqual(first.ComputeHash(), second.ComputeHash());
        Assert.Throws<ArgumentException>(() => new Film(1, 1, FilmPlane.Half, FilmPlane.Light).Halves());
    }

    [Fact]
    public void What_is_dropped_or_outside_of_the_area_is_in_no_film()
    {
        Film film = new(3, 2, s_planes);
        string empty = film.ComputeHash();
        SplatSums sums = new(3, 2);
        Splat(sums, 4, Rgb.White);
        Splat(sums, 4, new(1e6f, 0, 0));
        sums.Drop();
        Splat(sums, 0, Rgb.White);
        sums.Commit(film, 0, new(1, 1, 1, 1));
        Int128[] expected = new Int128[24];
        expected[(4 * 4) + 3] = 1;
        Assert.Equal(expected, Plane(film, FilmPlane.Light));
        film.Clear();
        Assert.Equal(empty, film.ComputeHash());
        Assert.Throws<ArgumentException>(() => sums.Commit(new(3, 2), 0));
        Assert.Throws<ArgumentException>(() => sums.Commit(new(2, 3, s_planes), 0));
    }

    [Fact]
    public void The_noise_of_the_mean_is_that_of_camera_and_light()
    {
        Film film = new(1, 1, s_planes);
        Assert.Equal(0, film.MeanVariance(0, 0));
        SplatSums sums = new(1, 1);
        foreach (float value in (float[])[1, 2, 6])
        {
            Splat(sums, 0, new(value, value, value));
            sums.Commit(film, 0);
        }

        Assert.Equal(7f / 3, film.MeanVariance(0, 0), 3);
        SampleAccumulator camera = new(1);
        camera.Begin(film, new(0, 0, 1, 1), 2);
        camera.Add(1, 0u, 0u, (Rgb)new(0, 0, 0));
        camera.Add(1, 0u, 1u, (Rgb)new(4, 4, 4));
        camera.End();
        Assert.Equal(8, film.SampleVariance(0, 0), 3);
        Assert.Equal((7f / 3) + 4, film.MeanVariance(0, 0), 3);
    }

    // A film of light that differs from sample to sample, beside some of the camera.
    private static Film Lit(int first, int end)
    {
        Film film = new(3, 2, s_planes);
        for (int sample = first; sample < end; sample++)
        {
            Light(film, sample);
        }

        return film;
    }

    private static void Light(Film film, int sample)
    {
        SplatSums sums = new(3, 2);
        Random random = new(sample);
        for (int i = 0; i < 20; i++)
        {
            Splat(sums, (uint)random.Next(6), new(random.NextSingle(), 100 * random.NextSingle(), -random.NextSingle()));
        }

        sums.Commit(film, sample);
        film.AddRow(0, 0, [Units(sample), 0, 0, 5], default, samples: 1, FilmPlane.IsOfHalf(sample) && film.Planes.Contains(FilmPlane.Half));
    }

    private static void Splat(SplatSums sums, uint pixel, Rgb value) => sums.Add(1, pixel, value);

    private static long Units(float value) => (long)double.Round(value * Film.ChannelUnits);

    private static Int128[] Plane(Film film, FilmPlane plane)
    {
        Int128[] sums = new Int128[film.Width * film.Height * plane.Sums.Count];
        for (int y = 0; y < film.Height; y++)
        {
            film.ReadPlane(plane, y, sums.AsSpan(y * film.Width * plane.Sums.Count, film.Width * plane.Sums.Count));
        }

        return sums;
    }
}
