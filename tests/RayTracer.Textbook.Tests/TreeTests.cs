namespace RayTracer.Textbook.Tests;

/// <summary>All trees find what the plain loop finds, to the bit: they test shapes alike, and may only leave out what is not hit.</summary>
[Trait("Category", "Thorough")]
public class TreeTests
{
    private static readonly (string Name, Func<IReadOnlyList<IShape>, IAccelerator> Build)[] s_trees =
    [
        ("uniform grid", s => new UniformGrid(s)),
        ("kd-tree", s => new KdTree(s)),
        ("octree", s => new Octree(s)),
        ("quadtree", s => new Quadtree(s)),
        ("BSP tree", s => new BspTree(s)),
        ("BVH by median", s => new BoundingVolumes(s, isHalved: true)),
        ("BVH by surface area", s => new BoundingVolumes(s)),
        ("oriented boxes", s => new OrientedBoxes(s)),
    ];

    public static TheoryData<string, int> Sets => new()
    {
        { "soup", 0 }, { "soup", 1 }, { "soup", 2 }, { "soup", 50 }, { "soup", 2000 }, { "flat", 300 }, { "in a row", 100 }, { "far away", 500 }, { "all equal", 20 },
        { "slivers", 400 }, { "balls", 300 },
    };

    [Theory]
    [MemberData(nameof(Sets))]
    public void Every_tree_finds_what_the_loop_finds(string kind, int count)
    {
        IndependentSampler random = Random(kind);
        IShape[] shapes = Create(kind, count, random);
        PlainLoop loop = new(shapes);
        (string Name, IAccelerator Tree)[] trees = Array.ConvertAll(s_trees, t => (t.Name, t.Build(shapes)));
        int hits = 0;
        for (int i = 0; i < TestSettings.Scale(3000, 30_000); i++)
        {
            Ray ray = CreateRay(shapes, random, i);
            double limit = i % 5 == 0 ? 0.5 : double.PositiveInfinity;
            Hit expected = Hit.None(limit);
            bool isHit = loop.Intersect(ray, ref expected);
            hits += isHit ? 1 : 0;
            foreach ((string name, IAccelerator tree) in trees)
            {
                Hit hit = Hit.None(limit);
                Assert.Equal((name, isHit, expected.Distance), (name, tree.Intersect(ray, ref hit), hit.Distance));
                Hit same = Hit.None(limit);
                Assert.True(!isHit || (shapes[hit.Index].Intersect(ray, ref same) && same.Distance == expected.Distance), $"{name}: the wrong shape");
            }
        }

        Assert.True(hits > 50 || count == 0, "the rays miss");
    }

    [Fact]
    public void Trees_ask_few_of_many_shapes()
    {
        IndependentSampler random = Random("many");
        IShape[] shapes = Create("soup", 4000, random);
        Ray[] rays = [.. Enumerable.Range(0, 500).Select(i => CreateRay(shapes, random, (4 * i) + 2))];
        foreach ((string name, Func<IReadOnlyList<IShape>, IAccelerator> build) in s_trees)
        {
            Assert.True(Tests(build(shapes), rays) < 4000 / 10, $"{name} asks {Tests(build(shapes), rays)} of 4000");
        }

        // The heuristic is better than the median; and for rods along a diagonal, boxes that are turned are better than those that are not.
        Hit Sum(IAccelerator tree) => Array.ConvertAll(rays, ray =>
        {
            Hit hit = Hit.None();
            tree.Intersect(ray, ref hit);
            return hit;
        }).Aggregate((x, y) => new() { Tests = x.Tests + y.Tests, Visits = x.Visits + y.Visits });
        (Hit surface, Hit median) = (Sum(new BoundingVolumes(shapes)), Sum(new BoundingVolumes(shapes, isHalved: true)));
        Assert.True(surface.Tests + surface.Visits < median.Tests + median.Visits, $"{surface.Tests} + {surface.Visits} and {median.Tests} + {median.Visits}");
        IShape[] rods = [.. Enumerable.Range(0, 500).Select(_ => Rod(random))];
        (Hit turned, Hit upright) = (Sum(new OrientedBoxes(rods)), Sum(new BoundingVolumes(rods, isHalved: true)));
        Assert.True(turned.Tests < upright.Tests, $"{turned.Tests} and {upright.Tests}");
    }

    private static double Tests(IAccelerator tree, Ray[] rays) => rays.Average(ray =>
    {
        Hit hit = Hit.None();
        tree.Intersect(ray, ref hit);
        return hit.Tests;
    });

    private static MeshTriangle Rod(IndependentSampler random)
    {
        Vector a = Point(random);
        return new([a, a + new Vector(0.5, 0.5, 0), a + new Vector(0.5, 0.51, 0)], 0, 1, 2);
    }

    private static IShape[] Create(string kind, int count, IndependentSampler random)
    {
        double size = 1.5 / Math.Cbrt(Math.Max(count, 1));
        return [.. Enumerable.Range(0, count).Select(i =>
        {
            Vector a = kind switch
            {
                "in a row" => new(i / (double)count, 0.5, 0.5),
                "all equal" => new(0.5, 0.5, 0.5),
                _ => Point(random),
            };
            if (kind == "balls")
            {
                return (IShape)new Sphere(a, 0.2 * size);
            }

            Vector half = new(0.5, 0.5, 0.5);
            (Vector b, Vector c) = kind == "all equal" ? (new Vector(1, 0, 0), new Vector(0, 1, 0)) : ((Point(random) - half) * size, (Point(random) - half) * size);
            c = kind == "slivers" ? (b * 0.999) + (c * 1e-3) : c;
            Vector Moved(Vector p) => kind switch
            {
                "flat" => p with { Y = 0.25 },
                "far away" => p + new Vector(1000, -500, 2000),
                _ => p,
            };
            return new MeshTriangle([Moved(a), Moved(a + b), Moved(a + c)], 0, 1, 2);
        })];
    }

    // To shapes and into the air; some along the axes, and some starting within.
    private static Ray CreateRay(IShape[] shapes, IndependentSampler random, int i)
    {
        Vector Around() => (2 * Point(random)) - new Vector(1, 1, 1);
        Vector to = shapes.Length == 0 ? default : shapes[(int)(random.Next() * shapes.Length)].PointAt(random.Next2()).Point;
        to = i % 3 == 0 ? to + (0.3 * Around()) : to;
        Vector direction = (i % 4) switch { 0 => new(1, 0, 0), 1 => new(0, -1, 0), _ => Around() };
        return new(to - (direction * (i % 7 == 0 ? 0.1 : 2)), direction);
    }

    private static Vector Point(IndependentSampler random) => new(random.Next(), random.Next(), random.Next());

    private static IndependentSampler Random(string kind)
    {
        IndependentSampler random = new(TestSettings.Seed);
        random.Begin(kind.Length, kind[0], 0);
        return random;
    }
}
