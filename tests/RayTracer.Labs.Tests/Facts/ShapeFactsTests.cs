using RayTracer.Textbook;

namespace RayTracer.Labs.Tests.Facts;

/// <summary>The facts hold for the textbook edition's shapes, and each mistake is found by the fact that is about it.</summary>
public class ShapeFactsTests
{
    private static readonly Dictionary<string, IShape> s_right = new()
    {
        ["sphere"] = new Sphere(new(1, -2, 3), 1.5),
        ["rectangle"] = new Rectangle(new(-1, -1, 2), new(2, 0, 0.5), new(0, 2, 0)),
        ["triangle"] = new Triangle(new(-1, -1, 2), new(1, -1, 2.5), new(0, 1, 2), default),
        ["disk"] = new Disk(new(-1, -1, 2), new(2, 0, 1), new(0, 2, 0)),
        ["plane"] = new Plane(new(0, 0, 0.3), new(1, 0, 0), new(0, 1, 0.2)),
        ["box"] = new Box(new(new(-1, -0.5, 2), new(1, 0.7, 4))),
        ["torus"] = new Placed(new Torus(1, 0.4), Transform.Translation(new(0, 0, 3)).After(Transform.Rotation(new(1, 1, 0), 50))),
        ["mesh"] = new Mesh([new(-1, -1, 2), new(1, -1, 2), new(1, 1, 3), new(-1, 1, 2)], [(0, 1, 2), (0, 2, 3)]),
    };

    private static readonly Dictionary<string, (IShape Shape, string Fact, string Word)> s_wrong = new()
    {
        ["one root"] = (new Ball { HasFarRoot = false }, ShapeFacts.BothEnds, "must find the far side"),
        ["direction's length"] = (new Ball { CountsLength = false }, ShapeFacts.Lengths, "must be half of that"),
        ["no limit"] = (new Ball { HasLimit = false }, ShapeFacts.Limits, "Something nearer was found before"),
        ["normal's length"] = (new Ball { NormalOf = v => v * 1.5 }, ShapeFacts.Normals, "length is not 1"),
        ["normal's direction"] = (new Ball { NormalOf = _ => new(0, 0, 1) }, ShapeFacts.Normals, "off the plane across it"),
        ["inward normal"] = (new Ball { NormalOf = v => -v }, ShapeFacts.Outwards, "points inwards"),
        ["area"] = (new Ball { AreaFactor = 0.5 }, ShapeFacts.SurfaceArea, "lines in all directions find"),
        ["poles"] = (new Ball { Choose = u => Area.Direction(2 * Math.PI * u.U, Math.Cos(Math.PI * u.V)) }, ShapeFacts.Points, "not as dense"),
        ["points beside it"] = (new Ball { Choose = u => 1.2 * Warp.Sphere(u) }, ShapeFacts.Points, "no ray meets"),
        ["point's pdf"] = (new Ball { PdfFactor = 2 }, ShapeFacts.Points, "PointPdf"),
        ["pdf of directions"] = (new Ball { SeenFactor = 2 }, ShapeFacts.Seen, "but SeenPdf of the same direction is"),
        ["both pdfs of directions"] = (new Ball { PdfFactor = 2, SeenFactor = 2 }, ShapeFacts.Seen, "By the densities of PointSeenFrom, the shape fills"),
        ["small box"] = (new Ball { Box = new(new(-1, -1, -1), new(1, 0.5, 1)) }, ShapeFacts.Hits, "outside of Bounds"),
    };

    public static TheoryData<string> Right => [.. s_right.Keys];

    public static TheoryData<string> Wrong => [.. s_wrong.Keys];

    [Theory]
    [MemberData(nameof(Right))]
    [Trait("Category", "Thorough")]
    public void The_facts_hold_for_shapes_that_are_right(string name)
    {
        for (int seed = 0; seed < TestSettings.Scale(1, 4); seed++)
        {
            IReadOnlyList<Fact> facts = new ShapeFacts(s_right[name], TestSettings.Seed + seed, 8000).All();
            Assert.All(facts, f => Assert.True(f.Holds, $"{name}, seed {seed}: {f}"));
            Assert.Equal(name == "plane" ? 6 : 9, facts.Count);
        }
    }

    [Theory]
    [MemberData(nameof(Wrong))]
    public void A_mistake_is_named_by_the_fact_that_is_about_it(string name)
    {
        (IShape shape, string about, string word) = s_wrong[name];
        Fact fact = new ShapeFacts(shape, TestSettings.Seed, 8000).All().First(f => f.Name == about);
        Assert.False(fact.Holds, fact.Sentence);
        Assert.Contains(word, fact.Sentence, StringComparison.Ordinal);
    }

    [Fact]
    public void The_mistake_of_a_ball_is_in_the_ball() => Assert.All(new ShapeFacts(new Ball(), TestSettings.Seed, 8000).All(), f => Assert.True(f.Holds, $"{f.Name}: {f.Sentence}"));

    /// <summary>A ball of radius 1 with a mistake.</summary>
    private sealed class Ball : IShape
    {
        public bool HasFarRoot { get; init; } = true;

        public bool CountsLength { get; init; } = true;

        public bool HasLimit { get; init; } = true;

        public Func<Vector, Vector> NormalOf { get; init; } = v => v;

        public Func<(double U, double V), Vector> Choose { get; init; } = Warp.Sphere;

        public double AreaFactor { get; init; } = 1;

        public double PdfFactor { get; init; } = 1;

        public double SeenFactor { get; init; } = 1;

        public Bounds Box { get; init; } = new(new(-1, -1, -1), new(1, 1, 1));

        public Bounds Bounds => Box;

        double IShape.Area => 4 * Math.PI * AreaFactor;

        public bool Intersect(in Ray ray, ref Hit hit)
        {
            double a = CountsLength ? Vector.Dot(ray.Direction, ray.Direction) : 1;
            double b = Vector.Dot(ray.Origin, ray.Direction) / a;
            double square = (b * b) - ((Vector.Dot(ray.Origin, ray.Origin) - 1) / a);
            double near = -b - Math.Sqrt(Math.Max(0, square));
            double t = near > 0 || !HasFarRoot ? near : -b + Math.Sqrt(Math.Max(0, square));
            if (square < 0 || t <= 0 || (HasLimit && t >= hit.Distance))
            {
                return false;
            }

            hit.Distance = t;
            return true;
        }

        public void Describe(in Ray ray, ref Hit hit)
        {
            hit.Point = ray.At(hit.Distance);
            hit.Normal = hit.Shading = NormalOf(hit.Point);
        }

        public SurfacePoint PointAt((double U, double V) random) => new(Choose(random), Choose(random), 0, 0, PdfFactor / (4 * Math.PI));

        public double PointPdf(in Hit hit) => 1 / (4 * Math.PI);

        public double SeenPdf(Vector from, in Hit hit) => SeenFactor * PointPdf(hit) * IShape.PerSteradian(from, hit.Point, hit.Normal);
    }
}
