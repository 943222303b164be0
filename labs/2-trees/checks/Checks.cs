using RayTracer.Labs;

namespace Lab2;

/// <summary>The checks of lab 2. Trees are marked by how many shapes they ask, which the shapes count themselves.</summary>
public static class Checks
{
    private const int Rays = 400;

    [Check("the box", 2)]
    public static void Boxes(CheckRun run) => run.Compare(new Trial<Meeting>
    {
        Draw = Meeting.Draw,
        Found = m => Box.Enter(m.Box, m.Ray, m.End),
        Expected = m => m.Enter(),
        Mistakes =
        [
            ("Your rays must go upwards along every axis: where the direction is below 0, the ray meets the higher plane first, so that both change places.", m => m.Enter(isSwapped: false)),
            ("You return boxes that lie behind the ray: the interval begins at 0.", m => m.Enter(begin: double.NegativeInfinity)),
            ("You return boxes beyond the end: the interval ends there.", m => m.Enter(hasEnd: false)),
            ("You have taken the union of the intervals: the ray is inside where all three overlap, from the largest beginning to the smallest end.", m => m.Union()),
            ("Where the ray starts inside, it enters at 0: nothing before that counts.", m => m.Enter() is null ? null : m.Enter(begin: double.NegativeInfinity)),
        ],
        Show = m => RayScene.Show("the box", m.Ray, Box.Enter(m.Box, m.Ray, m.End), m.Enter(), RayScene.Shape("box", "silver", ("a", m.Box.Low), ("b", m.Box.High))),
    });

    [Check("the loop", 1)]
    public static void Loops(CheckRun run) => run.Compare(new Trial<Few>
    {
        Draw = Few.Draw,
        Found = f => Nearest(new Loop(f.Balls), f.Ray),
        Expected = f => Nearest(new PlainLoop(f.Balls), f.Ray),
        Mistakes =
        [
            ("You stop at the first shape that is met: another one may be nearer.", f => f.First()),
            ("You have forgotten hit.Index: it must be the number of the nearest shape.", f => Nearest(new PlainLoop(f.Balls), f.Ray, hasIndex: false)),
        ],
    });

    [Check("the tree, halved: the same hits", 2)]
    public static void Halved(CheckRun run) => SameHits(run, isBySurfaceArea: false);

    [Check("the tree, halved: few tests", 2)]
    public static void HalvedTests(CheckRun run)
    {
        Crowd crowd = Crowd.Even(run.Random, 500);
        Tree tree = new(crowd.Shapes, isBySurfaceArea: false);
        IAccelerator reference = new BoundingVolumes(crowd.Shapes, isHalved: true);
        double loop = crowd.TestsPerRay(new PlainLoop(crowd.Shapes));
        double own = crowd.TestsPerRay(tree);
        double best = crowd.TestsPerRay(reference);
        if (own > 0.5 * loop)
        {
            run.Fail("Your tree asks nearly every shape: does a ray that misses a node's box leave out all that is in it?", isRecognised: true, $"about {best:F1} tests for a ray", $"{own:F1}");
        }

        // What lies beyond a hit need not be looked at: here nothing counts at all.
        double beyond = crowd.TestsPerRay(tree, limit: 1e-6);
        if (beyond > 4)
        {
            run.Fail("You look beyond the nearest hit: a box that the ray enters only after hit.Distance can hold nothing nearer.", isRecognised: true, "one or two tests where the nearest hit is at 0.000001", $"{beyond:F1} for a ray");
        }

        if (own > 1.3 * best)
        {
            run.Fail("Your tree asks more shapes than it must: do you look into the nearer child first? What it finds may hide the other.", isRecognised: true, $"at most {1.3 * best:F1} tests for a ray", $"{own:F1}");
        }
    }

    [Check("where to divide", 2)]
    public static void Splits(CheckRun run) => run.Compare(new Trial<Row>
    {
        Draw = Row.Draw,
        Found = r => Tree.BestSplit(r.Boxes),
        Expected = r => r.Best((box, n) => box.Area * n),
        Mistakes =
        [
            ("You have used volumes: rays meet a box in proportion to its surface area.", r => r.Best((box, n) => box.Size.X * box.Size.Y * box.Size.Z * n)),
            ("You have forgotten the numbers: who meets a part asks all the shapes in it.", r => r.Best((box, _) => box.Area)),
            ("You have forgotten the areas: then the middle is always best.", r => r.Best((_, n) => n * n)),
        ],
    });

    [Check("the tree by surface area", 1)]
    public static void BySurfaceArea(CheckRun run)
    {
        SameHits(run, isBySurfaceArea: true);
        Crowd[] uneven = [.. Enumerable.Range(0, 5).Select(_ => Crowd.Uneven(run.Random, 300))];
        double halved = uneven.Average(c => c.TestsPerRay(new Tree(c.Shapes, isBySurfaceArea: false)));
        double best = uneven.Average(c => c.TestsPerRay(new Tree(c.Shapes, isBySurfaceArea: true)));
        if (best > 0.9 * halved)
        {
            run.Fail("By surface area your tree is no better than halved: is BestSplit used where isBySurfaceArea is true?", isRecognised: true, $"at most {0.9 * halved:F1} tests for a ray", $"{best:F1}");
        }

        int[] counts = [10, 30, 100, 300];
        (string Name, Func<IReadOnlyList<IShape>, IAccelerator> Make)[] ways = [("loop", s => new Loop(s)), ("halved", s => new Tree(s, false)), ("by surface area", s => new Tree(s, true))];
        Crowd[] crowds = [.. counts.Select(n => Crowd.Uneven(run.Random, n))];
        run.Show(Pictures.Chart(
            "shapes that a ray is tested against", "shapes", "tests for a ray",
            [.. ways.Select(w => (w.Name, crowds.Select(c => ((double)c.Shapes.Count, c.TestsPerRay(w.Make(c.Shapes)))).ToArray()))]));
    }

    private static void SameHits(CheckRun run, bool isBySurfaceArea)
    {
        foreach (Crowd crowd in new[] { Crowd.Even(run.Random, 3), Crowd.Even(run.Random, 60), Crowd.Uneven(run.Random, 120) })
        {
            Tree tree = new(crowd.Shapes, isBySurfaceArea);
            PlainLoop loop = new(crowd.Shapes);
            foreach (Ray ray in crowd.Rays(Rays))
            {
                (double Distance, double Index)? expected = Nearest(loop, ray);
                (double Distance, double Index)? found = Nearest(tree, ray);
                if (expected != found)
                {
                    bool isFarther = expected is not null && found?.Distance > expected.Value.Distance;
                    bool isMissed = expected is not null && found is null;
                    run.Show(RayScene.Show("the tree", ray, found?.Distance, expected?.Distance, crowd.Balls.Select(b => RayScene.Shape("sphere", "silver", ("center", b.Center), ("radius", b.Radius)))));
                    run.Fail(
                        isFarther ? "Your tree finds a hit, but not the nearest: both children must be looked at, as their boxes overlap."
                            : isMissed ? "Your tree misses shapes: is each of them in one of the two parts, and is each node's box around all that is in it?"
                            : "Your tree finds something else than the loop.",
                        isFarther || isMissed, Text(expected), Text(found), $"{crowd.Shapes.Count} balls, a ray from {ray.Origin} along {ray.Direction}");
                }
            }
        }

        static string Text((double Distance, double Index)? hit) => hit is { } there ? $"shape {there.Index} at t {there.Distance:G6}" : "nothing";
    }

    private static (double Distance, double Index)? Nearest(IAccelerator shapes, Ray ray, bool hasIndex = true)
    {
        Hit hit = Hit.None();
        hit.Index = -1;
        return shapes.Intersect(ray, ref hit) ? (hit.Distance, hasIndex ? hit.Index : -1) : null;
    }

    /// <summary>A box, a ray, and an end.</summary>
    private sealed record Meeting(Bounds Box, Ray Ray, double End)
    {
        public static Meeting? Draw(Draws draws)
        {
            Bounds box = Bounds.Around(draws.Point("one corner", -2, 2), draws.Point("the other", -2, 2));
            Vector origin = draws.Point("origin", -4, 4);
            Vector aim = draws.Point("towards", -2, 2);
            Meeting drawn = new(box, new(origin, (aim - origin).Unit), draws.Number("end", 0.5, 12));
            double[] cuts = [.. Enumerable.Range(0, 3).SelectMany(a => new[] { drawn.Cut(a).Low, drawn.Cut(a).High }), 0, drawn.End];
            bool isClear = cuts.All(double.IsFinite) && cuts.SelectMany((a, i) => cuts.Skip(i + 1).Select(b => Math.Abs(a - b))).Min() > 1e-3;
            return isClear && box.Size is { X: > 0.1, Y: > 0.1, Z: > 0.1 } ? drawn : null;
        }

        public double? Enter(bool isSwapped = true, double begin = 0, bool hasEnd = true)
        {
            double end = hasEnd ? End : double.PositiveInfinity;
            for (int axis = 0; axis < 3; axis++)
            {
                (double low, double high) = Cut(axis);
                (low, high) = isSwapped && low > high ? (high, low) : (low, high);
                (begin, end) = (Math.Max(begin, low), Math.Min(end, high));
            }

            return begin <= end ? begin : null;
        }

        public double? Union()
        {
            double begin = Enumerable.Range(0, 3).Min(a => Math.Min(Cut(a).Low, Cut(a).High));
            double end = Enumerable.Range(0, 3).Max(a => Math.Max(Cut(a).Low, Cut(a).High));
            return Math.Max(begin, 0) <= Math.Min(end, End) ? Math.Max(begin, 0) : null;
        }

        private (double Low, double High) Cut(int axis) => ((Box.Low[axis] - Ray.Origin[axis]) / Ray.Direction[axis], (Box.High[axis] - Ray.Origin[axis]) / Ray.Direction[axis]);
    }

    /// <summary>Three balls, and a ray.</summary>
    private sealed record Few(Sphere[] Balls, Ray Ray)
    {
        public static Few? Draw(Draws draws)
        {
            Sphere[] balls = [.. new[] { "first", "second", "third" }.Select(n => new Sphere(draws.Point($"{n} centre", -2, 2), draws.Number($"{n} radius", 0.5, 1.5)))];
            Vector origin = draws.Point("origin", -6, 6);
            Vector aim = draws.Point("towards", -1, 1);
            return origin.Length > 5 ? new(balls, new(origin, (aim - origin).Unit)) : null;
        }

        public Answer? First()
        {
            for (int i = 0; i < Balls.Length; i++)
            {
                Hit hit = Hit.None();
                if (Balls[i].Intersect(Ray, ref hit))
                {
                    return (hit.Distance, i);
                }
            }

            return null;
        }
    }

    /// <summary>Boxes in a row.</summary>
    private sealed record Row(Bounds[] Boxes)
    {
        public static Row? Draw(Draws draws)
        {
            int count = draws.Whole("boxes", 2, 7);
            Row row = new([
                .. Enumerable.Range(0, count).Select(i => (Middle: draws.Number($"middle {i}", -9, 9), Half: draws.Number($"half {i}", 0.1, 2), Flat: draws.Number($"height {i}", 0.1, 2)))
                    .OrderBy(b => b.Middle).Select(b => new Bounds(new(b.Middle - b.Half, -b.Flat, -b.Half), new(b.Middle + b.Half, b.Flat, b.Half))),
            ]);

            // Where two ways to divide cost the same, either is right.
            double[] costs = [.. row.Costs((box, n) => box.Area * n).Order()];
            return costs.Length < 2 || costs[1] > 1.001 * costs[0] ? row : null;
        }

        public int Best(Func<Bounds, int, double> cost)
        {
            double[] costs = [.. Costs(cost)];
            return 1 + Array.IndexOf(costs, costs.Min());
        }

        private IEnumerable<double> Costs(Func<Bounds, int, double> cost) => Enumerable.Range(1, Boxes.Length - 1)
            .Select(n => cost(Tree.Around(Boxes.Take(n)), n) + cost(Tree.Around(Boxes.Skip(n)), Boxes.Length - n));
    }
}
