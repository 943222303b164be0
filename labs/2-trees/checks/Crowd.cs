namespace Lab2;

/// <summary>Many balls, and rays among them.</summary>
public sealed class Crowd
{
    private const int Measured = 400;
    private readonly Counted[] _counted;
    private readonly ISampler _random;

    private Crowd(ISampler random, IEnumerable<(Vector Center, double Radius)> balls)
    {
        _random = random;
        Balls = [.. balls];
        _counted = [.. Balls.Select(b => new Counted(new(b.Center, b.Radius)))];
    }

    /// <summary>The balls.</summary>
    public IReadOnlyList<(Vector Center, double Radius)> Balls { get; }

    /// <summary>The same as shapes, which count how often they are asked.</summary>
    public IReadOnlyList<IShape> Shapes => _counted;

    /// <summary>Balls of one size, everywhere alike.</summary>
    public static Crowd Even(ISampler random, int count) => new(random, Enumerable.Range(0, count).Select(_ => (InCube(random), 1 / Math.Cbrt(count))));

    /// <summary>Most of them tiny and in a corner, some large.</summary>
    public static Crowd Uneven(ISampler random, int count) => new(random, Enumerable.Range(0, count).Select(
        i => i % 10 == 0 ? (InCube(random), 0.1 + (0.1 * random.Next())) : (new Vector(0.8, 0.8, 0.8) + (0.15 * InCube(random)), 0.01)));

    /// <summary>Rays between points of the cube around all.</summary>
    public IEnumerable<Ray> Rays(int count)
    {
        for (int i = 0; i < count; i++)
        {
            Vector origin = 1.5 * InCube(_random);
            Vector aim = InCube(_random);
            yield return new(origin, (aim - origin).Unit);
        }
    }

    /// <summary>How many shapes are asked for a ray, on the mean; always by the same rays.</summary>
    /// <param name="shapes">A tree of them.</param>
    /// <param name="limit">The distance beyond which nothing counts.</param>
    public double TestsPerRay(IAccelerator shapes, double limit = double.PositiveInfinity)
    {
        IndependentSampler random = new();
        random.Begin(0, 0, 0);
        Array.ForEach(_counted, c => c.Tests = 0);
        foreach (Ray ray in new Crowd(random, []).Rays(Measured))
        {
            Hit hit = Hit.None(limit);
            shapes.Intersect(ray, ref hit);
        }

        return _counted.Sum(c => c.Tests) / (double)Measured;
    }

    private static Vector InCube(ISampler random) => new((2 * random.Next()) - 1, (2 * random.Next()) - 1, (2 * random.Next()) - 1);

    private sealed class Counted(Sphere sphere) : IShape
    {
        public int Tests { get; set; }

        public Bounds Bounds => sphere.Bounds;

        public double Area => sphere.Area;

        public bool Intersect(in Ray ray, ref Hit hit)
        {
            Tests++;
            return sphere.Intersect(ray, ref hit);
        }

        public void Describe(in Ray ray, ref Hit hit) => sphere.Describe(ray, ref hit);

        public SurfacePoint PointAt((double U, double V) random) => sphere.PointAt(random);
    }
}
