using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Testing;
using RayTracer.Textures;

namespace RayTracer.Tests.Textures;

[Trait("Category", "Thorough")]
public class GradientNoiseTests
{
    // The middles of a cube's edges; those of a tetrahedron among them twice.
    private static readonly (int X, int Y, int Z)[] s_gradients =
    [
        (1, 1, 0), (-1, 1, 0), (1, -1, 0), (-1, -1, 0), (1, 0, 1), (-1, 0, 1), (1, 0, -1), (-1, 0, -1),
        (0, 1, 1), (0, -1, 1), (0, 1, -1), (0, -1, -1), (1, 1, 0), (0, -1, 1), (-1, 1, 0), (0, -1, -1),
    ];

    [Fact]
    public void Noise_is_Perlins_with_gradients_by_hash()
    {
        Random random = new(TestSettings.Seed);
        for (int i = 0; i < 2000; i++)
        {
            double size = Math.Pow(10, random.Next(-1, 4));
            (float x, float y, float z) = (Number(random, size), Number(random, size), Number(random, size));
            uint seed = (uint)random.Next(4);
            Assert.Equal(Reference(x, y, z, seed), GradientNoise.Perlin(new Vec3W(x, y, z), seed)[0], 2e-6);
        }
    }

    // By the rules of pbrt's: of sixteen numbers of a corner, the lowest two are signs, and the others say along which two axes.
    [Fact]
    public void Noise_by_the_table_is_that_of_pbrt()
    {
        Random random = new(TestSettings.Seed);
        for (int i = 0; i < 2000; i++)
        {
            double size = Math.Pow(10, random.Next(-1, 4));
            (float x, float y, float z) = (Number(random, size), Number(random, size), Number(random, size));
            Assert.Equal(Tabled(x, y, z), GradientNoise.Tabled(new Vec3W(x, y, z))[0], 2e-6);
        }
    }

    [Fact]
    public void The_table_holds_each_number_once_and_begins_and_ends_as_Perlins()
    {
        uint[] all = [.. Enumerable.Range(0, 256).Select(Entry)];
        Assert.Equal(Enumerable.Range(0, 256).Select(i => (uint)i), all.Order());
        Assert.Equal([151u, 160, 137, 91, 90, 15], all[..6]);
        Assert.Equal([78u, 66, 215, 61, 156, 180], all[^6..]);
    }

    [Fact]
    public void Noise_vanishes_on_the_grid_and_is_smooth_across_its_planes()
    {
        const float step = 1f / 1024;
        Random random = new(TestSettings.Seed);
        for (int i = 0; i < 200; i++)
        {
            int plane = random.Next(-20, 20);
            (float y, float z) = (Number(random, 9), Number(random, 9));
            Assert.Equal(0, GradientNoise.Perlin(new Vec3W((float)plane, MathF.Floor(y), MathF.Floor(z)), 1)[0]);

            // Differences of second order agree on both sides, and vanish as the fade's second derivative does.
            float At(int steps) => GradientNoise.Perlin(new Vec3W(plane + (steps * step), y, z), 1)[0];
            Assert.Equal(0, At(-2) - (2 * At(-1)) + At(0) - (At(0) - (2 * At(1)) + At(2)), 2e-5f);
        }
    }

    [Fact]
    public void Noise_has_the_mean_zero_and_stays_within_its_bounds()
    {
        Random random = new(TestSettings.Seed + 1);
        List<double> values = [];
        for (int i = 0; i < TestSettings.Scale(20_000, 200_000); i++)
        {
            values.Add(GradientNoise.Perlin(new Vec3W(Number(random, 3e4), Number(random, 3e4), Number(random, 3e4)), 7)[0]);
        }

        Assert.InRange(values.Max(Math.Abs), 0.7, 1.0364);
        ErrorBudget.Filters.Check(PValues.Mean(values, 0), "mean of noise");
    }

    [Fact]
    public void Octaves_are_summed_over_the_sum_of_their_heights()
    {
        Vec3W p = new(0.3f, 1.7f, -2.2f);
        Vec3W second = new(0.6f + 17.375f, 3.4f + 17.375f, -4.4f + 17.375f);
        float a = GradientNoise.Perlin(p, 5)[0];
        float b = GradientNoise.Perlin(second, 6)[0];
        Assert.Equal(a, GradientNoise.Sum(p, 5, 1, 0.5f, isTurbulent: false)[0]);
        Assert.Equal(a, GradientNoise.Sum(p, 5, 4, 0, isTurbulent: false)[0]);
        Assert.Equal((a + (0.7f * b)) / 1.7f, GradientNoise.Sum(p, 5, 2, 0.7f, isTurbulent: false)[0], 1e-6f);
        Assert.Equal((Math.Abs(a) + (0.7f * Math.Abs(b))) / 1.7f, GradientNoise.Sum(p, 5, 2, 0.7f, isTurbulent: true)[0], 1e-6f);
    }

    [Fact]
    public void Noise_of_no_number_is_harmless()
    {
        foreach (float x in new[] { float.NaN, float.PositiveInfinity, -1e30f, 1e30f, float.MaxValue })
        {
            GradientNoise.Perlin(new Vec3W(x, 0.5f, x), 0);
        }
    }

    private static float Number(Random random, double size) => (float)(((2 * random.NextDouble()) - 1) * size);

    private static double Reference(float x, float y, float z, uint seed)
    {
        (double i, double j, double k) = (Math.Floor(x), Math.Floor(y), Math.Floor(z));
        double sum = 0;
        for (int corner = 0; corner < 8; corner++)
        {
            (int a, int b, int c) = (corner & 1, (corner >> 1) & 1, corner >> 2);
            (double dx, double dy, double dz) = (x - i - a, y - j - b, z - k - c);
            uint hash = Hash.Mix(Hash.Mix(Grid(i + a) | (Grid(j + b) << 16)) + (Grid(k + c) * Hash.Golden) + (seed * 0x85EBCA6B)) >> 28;
            (int gx, int gy, int gz) = s_gradients[hash];
            sum += ((gx * dx) + (gy * dy) + (gz * dz)) * Weight(dx) * Weight(dy) * Weight(dz);
        }

        return sum;
    }

    private static double Tabled(float x, float y, float z)
    {
        (double i, double j, double k) = (Math.Floor(x), Math.Floor(y), Math.Floor(z));
        double sum = 0;
        for (int corner = 0; corner < 8; corner++)
        {
            (int a, int b, int c) = (corner & 1, (corner >> 1) & 1, corner >> 2);
            (double dx, double dy, double dz) = (x - i - a, y - j - b, z - k - c);
            uint hash = Entry(Wrapped(k + c) + (int)Entry(Wrapped(j + b) + (int)Entry(Wrapped(i + a)))) & 15;
            (double first, double second) = hash is 12 or 13 ? (dx, dy) : (hash < 8 ? dx : dy, hash < 4 ? dy : dz);
            sum += (((hash & 1) != 0 ? -first : first) + ((hash & 2) != 0 ? -second : second)) * Weight(dx) * Weight(dy) * Weight(dz);
        }

        return sum;
    }

    private static int Wrapped(double i) => (int)(i - (256 * Math.Floor(i / 256)));

    private static unsafe uint Entry(int i) => PermutationTable.Numbers[i & 255];

    private static uint Grid(double i) => (uint)(i - (65536 * Math.Floor(i / 65536)));

    private static double Weight(double d)
    {
        double t = 1 - Math.Abs(d);
        return t * t * t * ((t * ((6 * t) - 15)) + 10);
    }
}
