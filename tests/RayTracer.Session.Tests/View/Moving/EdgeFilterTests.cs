using RayTracer.Rendering;

namespace RayTracer.Session.Tests;

public sealed unsafe class EdgeFilterTests
{
    // No multiple of any register's lanes.
    private const int Width = 45;
    private const int Height = 21;
    private static readonly PaddedRows s_rows = new(Width, Height);

    [Theory]
    [InlineData(1)]
    [InlineData(8)]
    public void Constant_light_stays_constant(int step)
    {
        (MovingPlanes from, MovingGuides guides, MovingPlanes to) = Flat((_, _) => 1, (_, _) => 0.75f);
        EdgeFilter.Smooth(from, guides, step, to, 2);
        Assert.All(Pixels(), p => Assert.Equal(0.75f, to.Green[s_rows.At(p.X, p.Y)], 1e-5f));
    }

    [Fact]
    public void Light_stays_within_its_thing_however_noisy()
    {
        (MovingPlanes from, MovingGuides guides, MovingPlanes to) = Flat((x, _) => x < 20 ? 1 : 2, (x, _) => x < 20 ? 0 : 1);
        Fill(from.Variance, 100);
        EdgeFilter.Smooth(from, guides, 4, to, 1);
        Assert.All(Pixels(), p => Assert.Equal(p.X < 20 ? 0 : 1, to.Red[s_rows.At(p.X, p.Y)], 1e-5f));
    }

    [Fact]
    public void Light_does_not_go_around_corners()
    {
        (MovingPlanes from, MovingGuides guides, MovingPlanes to) = Flat((_, _) => 1, (x, _) => x < 20 ? 0 : 1);
        Fill(from.Variance, 100);
        foreach ((int x, int y) in Pixels().Where(p => p.X >= 20))
        {
            (guides.Seen.Normals(0)[s_rows.At(x, y)], guides.Seen.Normals(2)[s_rows.At(x, y)]) = (1, 0);
        }

        EdgeFilter.Smooth(from, guides, 2, to, 1);
        Assert.All(Pixels(), p => Assert.Equal(p.X < 20 ? 0 : 1, to.Red[s_rows.At(p.X, p.Y)], 1e-5f));
    }

    [Fact]
    public void Differences_that_noise_does_not_explain_stay()
    {
        (MovingPlanes from, MovingGuides guides, MovingPlanes to) = Flat((_, _) => 1, (x, _) => x < 20 ? 0.2f : 1);
        Fill(from.Variance, 1e-4f);
        EdgeFilter.Smooth(from, guides, 1, to, 1);
        Assert.All(Pixels(), p => Assert.Equal(p.X < 20 ? 0.2f : 1, to.Red[s_rows.At(p.X, p.Y)], 1e-5f));
    }

    [Fact]
    public void Noise_becomes_less_and_its_mean_stays()
    {
        Random random = new(7);
        (MovingPlanes from, MovingGuides guides, MovingPlanes to) = Flat((_, _) => 1, (_, _) => random.NextSingle());
        Fill(from.Variance, 1 / 12f);
        float Spread(MovingPlanes planes, out float mean)
        {
            float[] values = [.. Pixels().Select(p => planes.Red[s_rows.At(p.X, p.Y)])];
            float middle = mean = values.Average();
            return values.Average(v => (v - middle) * (v - middle));
        }

        float before = Spread(from, out float meanBefore);
        EdgeFilter.Smooth(from, guides, 1, to, 1);
        EdgeFilter.Smooth(to, guides, 2, from, 1);
        Assert.InRange(Spread(from, out float mean), 0, before / 8);
        Assert.Equal(meanBefore, mean, 0.02f);
    }

    private static void Fill(float* plane, float value) => new Span<float>(plane, s_rows.Size).Fill(value);

    private static IEnumerable<(int X, int Y)> Pixels() => Enumerable.Range(0, Width * Height).Select(i => (i % Width, i / Width));

    private static (MovingPlanes From, MovingGuides Guides, MovingPlanes To) Flat(Func<int, int, int> thing, Func<int, int, float> light)
    {
        MovingPlanes from = new(s_rows);
        MovingGuides guides = new(s_rows);
        foreach ((int x, int y) in Pixels())
        {
            int at = s_rows.At(x, y);
            from.Red[at] = from.Green[at] = from.Blue[at] = light(x, y);
            (guides.Things[at], guides.Seen.Normals(2)[at]) = ((uint)thing(x, y), 1);
        }

        return (from, guides, new(s_rows));
    }
}
