using RayTracer.Labs;

namespace Lab3;

/// <summary>The checks of lab 3. By chance, a right answer is taken for a wrong one in fewer than one case of a hundred million.</summary>
public static class Checks
{
    // Standard deviations that an estimate may be off: by chance it is farther one time in 500 million.
    private const double Far = 6;

    [Check("the mean of random points", 1)]
    public static void Mean(CheckRun run)
    {
        // Of a constant, every estimate is exact.
        run.Compare(new Trial<Constant>
        {
            Draw = Constant.Draw,
            Found = c => Estimators.Mean(_ => c.Height, c.A, c.B, c.N, run.Random),
            Expected = c => c.Height * (c.B - c.A),
            Mistakes =
            [
                ("You have forgotten the length of the interval: the mean of f times (b − a) is the integral.", c => c.Height),
                ("You have forgotten to divide by n: this is the sum, not the mean.", c => c.Height * (c.B - c.A) * c.N),
            ],
        });
        IsNear(run, "∫ x² dx from 0 to 3", 9, 3 * Math.Sqrt((81.0 / 5) - 9), 20_000, n => Estimators.Mean(x => x * x, 0, 3, n, run.Random));
    }

    [Check("the error of an estimate", 2)]
    public static void Error(CheckRun run) => run.Compare(new Trial<Constant>
    {
        // f writes down its values: from them the error follows, however they were chosen.
        Draw = Constant.Draw,
        Found = c =>
        {
            c.Values.Clear();
            return Estimators.WithError(x => c.Note(c.Height * x * x), c.A, c.B, c.N, c.Random());
        },
        Expected = c => c.WithError(c.Deviation / Math.Sqrt(c.N)),
        Mistakes =
        [
            ("You return the deviation of the values, not that of their mean: the variance of a mean of n values is n times smaller, so divide by √n.", c => c.WithError(c.Deviation)),
            ("Your error is a little too small: the values are nearer to their own mean than to the true one, so divide by n − 1, not by n (Bessel).", c => c.WithError(c.Deviation * Math.Sqrt((c.N - 1.0) / c.N / c.N))),
            ("You return the variance: the error is its square root.", c => c.WithError((c.B - c.A) * Math.Pow(c.Deviation / (c.B - c.A), 2) / c.N)),
            ("Your error is not that of the integral: it too must be multiplied by (b − a).", c => c.WithError(c.Deviation / (c.B - c.A) / Math.Sqrt(c.N))),
        ],
    });

    [Check("one point in each stratum", 1)]
    public static void Strata(CheckRun run)
    {
        int n = 8 + (int)(8 * run.Random.Next());
        List<double> points = [];
        double found = Estimators.Stratified(x => Noted(points, x), -1, 2, n, run.Random);
        int[] counts = new int[n];
        points.ForEach(x => counts[Math.Clamp((int)((x + 1) / 3 * n), 0, n - 1)]++);
        string at = $"n {n}, a -1, b 2: points at {string.Join(", ", points.Select(p => p.ToString("F2")))}";
        if (points.Count != n || counts.Any(c => c != 1))
        {
            bool isPlain = points.Count == n && points.Exists(p => p > 0.5) && points.Exists(p => p < 0.5);
            run.Fail(
                isPlain ? "Your points lie anywhere: the i-th must lie in the i-th part, at (i + a random number)/n of the way."
                    : "There is not one point in each of the n parts.",
                isPlain, $"one point in each of {n} parts", $"{string.Join(", ", counts)} points", at);
        }

        if (points.TrueForAll(p => Math.Abs(((p + 1) / 3 * n) - Math.Floor((p + 1) / 3 * n) - 0.5) < 1e-9))
        {
            run.Fail("Your points are in the middle of the parts: without a random number the error is the same every time, and does not go away in the mean.", isRecognised: true, at: at);
        }

        IsNear(run, "∫ (5 + x) dx from −1 to 2", 16.5, 3 * Math.Sqrt(0.75 / n), 1, _ => found);
        IsNear(run, "∫ x² dx from 0 to 3, by strata", 9, 1.2, 1000, k => Enumerable.Range(0, k).Average(_ => Estimators.Stratified(x => x * x, 0, 3, 4, run.Random)));
    }

    [Check("importance", 1)]
    public static void Importance(CheckRun run)
    {
        run.Compare(new Trial<Constant>
        {
            Draw = Constant.Draw,
            Found = c => Estimators.ByImportance(_ => c.Height, u => c.A + ((c.B - c.A) * u), _ => 1 / (c.B - c.A), c.N, run.Random),
            Expected = c => c.Height * (c.B - c.A),
            Mistakes =
            [
                ("You have forgotten the density: where points are dense, each of them stands for less, so that f is divided by the pdf.", c => c.Height),
                ("You multiply by the density: where points are dense, each of them stands for less, so divide.", c => c.Height / (c.B - c.A)),
            ],
        });
        IsNear(run, "∫ x² dx from 0 to 1, with the density 2x", 1.0 / 3, Math.Sqrt(1.0 / 72), 20_000, n => Estimators.ByImportance(x => x * x, Math.Sqrt, x => 2 * x, n, run.Random));
    }

    [Check("how errors fall", 1)]
    public static void Errors(CheckRun run)
    {
        const double Integral = Math.E - 1;
        (string Name, Func<int, double> Estimate, double Slope, string Law)[] ways =
        [
            ("independent", n => Estimators.Mean(Math.Exp, 0, 1, n, run.Random), -0.5, "1/√n"),
            ("strata", n => Estimators.Stratified(Math.Exp, 0, 1, n, run.Random), -1.5, "1/n^(3/2), for a smooth function"),
            ("importance", n => Estimators.ByImportance(Math.Exp, u => Math.Sqrt((3 * u) + 1) - 1, x => 2 * (1 + x) / 3, n, run.Random), -0.5, "1/√n, from lower down"),
        ];
        int[] counts = [4, 16, 64, 256, 1024];
        (string Name, double Error, int N)[] errors =
        [
            .. ways.SelectMany(w => counts.Select(n => (w.Name, Math.Sqrt(Enumerable.Range(0, 100).Average(_ => Math.Pow(w.Estimate(n) - Integral, 2))), n))),
        ];
        run.Show(Pictures.Chart("the error of ∫ eˣ dx from 0 to 1, by the number of points", "points", "error", [.. ways.Select(w => (w.Name, errors.Where(e => e.Name == w.Name).Select(e => ((double)e.N, e.Error)).ToArray()))]));
        foreach ((string name, _, double slope, string law) in ways)
        {
            double[] logs = [.. errors.Where(e => e.Name == name).Select(e => Math.Log(e.Error, 4))];
            double found = Enumerable.Range(0, logs.Length).Sum(i => (i - 2) * logs[i]) / 10;
            if (!(Math.Abs(found - slope) < 0.2))
            {
                run.Fail($"The errors of the points called \"{name}\" do not fall as {law}.", expected: $"n to the power of {slope}", found: $"n to the power of {found:F2}");
            }
        }
    }

    [Check("points of the disk", 1)]
    public static void Disk(CheckRun run)
    {
        double inner = Moments(run, random => Warps.Disk(random) is var p ? (p.X * p.X) + (p.Y * p.Y) : 0);
        Require(run, facts => facts.Points(Area.Disk, Warps.Disk, Warps.DiskPdf), Math.Abs(inner - (1.0 / 3)) < 0.02
            ? "Your points crowd in the middle of the disk: there must be as many within a radius r as there is area, r² of it, so that the radius is a square root." : null);
    }

    [Check("points of the triangle", 1)]
    public static void Triangle(CheckRun run)
    {
        double half = Moments(run, random => Warps.Triangle(random).B);
        double whole = Moments(run, random => Warps.Triangle(random) is var (b, c) && b + c > 1 ? 1 : 0);
        Require(run, facts => facts.Points(Area.Unit, Warps.Triangle, Warps.TrianglePdf),
            Math.Abs(whole - 0.5) < 0.05 ? "Half of your points are outside of the triangle, in the other half of the square: fold them back, to (1 − b, 1 − c)."
                : Math.Abs(half - 0.5) < 0.02 ? "Your points crowd in a corner of the triangle: a strip at b is 1 − b high, so that b must not be uniform." : null);
    }

    [Check("directions of the hemisphere", 1)]
    public static void Hemisphere(CheckRun run)
    {
        double height = Moments(run, random => Warps.Hemisphere(random).Z);
        double below = Moments(run, random => Warps.Hemisphere(random).Z < 0 ? 1 : 0);
        Require(run, facts => facts.Directions(Warps.Hemisphere, Warps.HemispherePdf),
            below > 0.3 ? "Half of your directions go below the surface: only one hemisphere is to be sampled."
                : Math.Abs(height - (2 / Math.PI)) < 0.01 ? "Your directions crowd around the normal: it is the height z that is uniform, not the angle." : null);
    }

    [Check("directions by the cosine", 1)]
    public static void CosineHemisphere(CheckRun run)
    {
        double height = Moments(run, random => Warps.CosineHemisphere(random).Z);
        Require(run, facts => facts.Directions(Warps.CosineHemisphere, Warps.CosineHemispherePdf),
            Math.Abs(height - 0.5) < 0.01 ? "Your directions are uniform, and not in proportion to the cosine: are they the points of the disk, lifted to the sphere?" : null);
    }

    private static void IsNear(CheckRun run, string what, double truth, double deviation, int n, Func<int, double> estimate)
    {
        double found = estimate(n);
        if (!(Math.Abs(found - truth) <= Far * deviation / Math.Sqrt(n)))
        {
            run.Fail($"Your estimate of {what} is off by more than chance allows.", expected: $"{truth:G6} ± {Far * deviation / Math.Sqrt(n):G2}", found: $"{found:G6}");
        }
    }

    private static double Noted(List<double> notes, double x)
    {
        notes.Add(x);
        return 5 + x;
    }

    private static double Moments(CheckRun run, Func<(double U, double V), double> moment) => Enumerable.Range(0, 20_000).Average(_ => moment(run.Random.Next2()));

    // Facts of the tool "raytracer selftest"; a sentence that knows better what is wrong takes the place of theirs where one does not hold.
    private static void Require(CheckRun run, Func<WarpFacts, IReadOnlyList<Fact>> facts, string? better)
    {
        WarpFacts family = new((long)(run.Random.Next() * int.MaxValue), 1 << 14);
        run.Require(
            facts(family).Select(f => f.Holds || better is null || f.Name == WarpFacts.PdfIntegral ? f : f with { Sentence = better }),
            f => f.Sentence == better || (f.Name == WarpFacts.PdfIntegral && !f.Sentence.Contains("times what it should be")));
    }

    /// <summary>An interval, a height, and a number of points.</summary>
    private sealed record Constant(double A, double B, double Height, int N)
    {
        public List<double> Values { get; } = [];

        /// <summary>The deviation of the values that f wrote down, times the length of the interval.</summary>
        public double Deviation => (B - A) * Math.Sqrt(Values.Sum(v => (v - Values.Average()) * (v - Values.Average())) / (Values.Count - 1));

        public static Constant? Draw(Draws draws)
        {
            Constant drawn = new(draws.Number("a", -3, 3), draws.Number("b", -3, 3), draws.Number("height", 1, 5), draws.Whole("n", 2, 9));
            return drawn.B - drawn.A is > 0.3 and var length && Math.Abs(length - 1) > 0.05 ? drawn : null;
        }

        public (double Integral, double Error) WithError(double error) => ((B - A) * Values.Average(), error);

        public double Note(double value)
        {
            Values.Add(value);
            return value;
        }

        public ISampler Random()
        {
            IndependentSampler random = new(BitConverter.DoubleToInt64Bits(A));
            random.Begin(0, 0, 0);
            return random;
        }
    }
}
