using RayTracer.Textbook;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.Labs.Tests.Facts;

/// <summary>The facts hold for the textbook edition's warps and lights, and mistakes are found.</summary>
public class WarpAndLightFactsTests
{
    private readonly WarpFacts _facts = new(TestSettings.Seed, 1 << 15);

    [Fact]
    public void The_facts_hold_for_warps_that_are_right()
    {
        IEnumerable<Fact> facts =
        [
            .. _facts.Directions(u => Warp.CosineHemisphere(u), d => Warp.CosineHemispherePdf(d.Z)),
            .. _facts.Directions(u => Warp.Sphere(u), _ => 1 / (4 * Math.PI)),
            .. _facts.Directions(u => Warp.Cone(u, 0.01), d => d.Z > 0.99 ? 1 / (2 * Math.PI * 0.01) : 0),
            .. _facts.Directions(u => Warp.CosinePower(u, 200), d => Warp.CosinePowerPdf(d.Z, 200)),
            .. _facts.Points(Area.Disk, u => Warp.Disk(u), (x, y) => (x * x) + (y * y) <= 1 ? 1 / Math.PI : 0),
            .. _facts.Points(Area.Unit, u => Warp.Triangle(u), (x, y) => x + y <= 1 ? 2 : 0),
        ];
        Assert.All(facts, f => Assert.True(f.Holds, $"{f.Name}: {f.Sentence}"));
    }

    [Fact]
    public void Mistakes_of_warps_are_found()
    {
        // A radius that is not rooted crowds points in the middle.
        IReadOnlyList<Fact> polar = _facts.Points(
            Area.Disk, u => (u.U * Math.Cos(2 * Math.PI * u.V), u.U * Math.Sin(2 * Math.PI * u.V)), (x, y) => (x * x) + (y * y) <= 1 ? 1 / Math.PI : 0);
        Assert.Equal([true, true, false], polar.Select(f => f.Holds));
        Assert.NotNull(polar[2].Drawing);
        IReadOnlyList<Fact> sphere = _facts.Directions(u => Warp.CosineHemisphere(u), d => Warp.CosineHemispherePdf(Math.Abs(d.Z)));
        Assert.Equal([true, false, false], sphere.Select(f => f.Holds));
        Assert.Contains("only one hemisphere is sampled", sphere[1].Sentence, StringComparison.Ordinal);
        Assert.False(_facts.Directions(u => Warp.Sphere(u) * 2, _ => 1 / (4 * Math.PI))[0].Holds);
    }

    [Fact]
    public void The_facts_hold_for_lights_that_are_right()
    {
        Sphere ball = new(new(1, 2, 3), 0.5);
        Rectangle square = new(default, new(1, 0, 0), new(0, 1, 0));
        Assert.All(
            (Fact[])[
                .. new LightFacts(new PointLight(new(1, 2, 3), new(5)), Bounds.Around(new Vector(1, 2, 3)), TestSettings.Seed).All(),
                .. new LightFacts(new AreaLight(ball, new(new Solid(new(3)), 2, 0)), ball.Bounds, TestSettings.Seed).All(),
                .. new LightFacts(new AreaLight(square, new(new Solid(new(3)), 2, 4)), square.Bounds, TestSettings.Seed).All(),
            ],
            f => Assert.True(f.Holds, $"{f.Name}: {f.Sentence}"));
    }

    [Fact]
    public void A_light_that_does_not_grow_weaker_is_found_out()
    {
        Fact[] facts = [.. new LightFacts(new Even(), Bounds.Around(default(Vector)), TestSettings.Seed).All()];
        Assert.Equal([true, false], facts.Select(f => f.Holds));
        Assert.Contains("squared distance", facts[1].Sentence, StringComparison.Ordinal);
    }

    private sealed class Even : ILight
    {
        public bool IsPoint => true;

        public double Power => 4 * Math.PI;

        public LightSample? Sample(Vector from, (double U, double V) random) => new LightSample(from * (-1 / from.Length), from.Length, Rgb.White, 1);

        public (Ray Ray, Rgb Power)? Emit(ISampler sampler) => (new(default, Warp.Sphere(sampler.Next2())), new(4 * Math.PI));
    }
}
