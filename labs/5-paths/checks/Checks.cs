using RayTracer.Labs;

namespace Lab5;

/// <summary>The checks of lab 5. By chance, a right answer is taken for a wrong one in fewer than one case of ten million.</summary>
public static class Checks
{
    // Standard deviations that an estimate may be off.
    private const double Far = 6;
    private const int Count = 10_000;

    [Check("what shines by itself", 1)]
    public static void Emission(CheckRun run) => run.Compare(new Trial<Furnace>
    {
        Draw = Furnace.Draw,
        Found = f => new Paths(maxEdges: 1, rouletteFrom: 100).Radiance(f.Box, f.Ray, run.Random).G + new Paths(1, 100).Radiance(Rooms.Sky(f.Emission, f.Albedo), new(new(0, 3, 0), new(0, 1, 0)), run.Random).G,
        Expected = f => 2 * f.Emission,
        Mistakes = [("You see the lamps or the sky, but not both: hit.Thing!.Light!.Radiance(ray.Direction, hit) is for what is met, scene.Environment for rays that meet nothing.", f => f.Emission)],
    });

    [Check("edge after edge", 3)]
    public static void Edges(CheckRun run)
    {
        run.Compare(InAFurnace(run));

        // A ray that leaves a ball meets nothing but the sky, and is weakened once.
        const double Albedo = 0.5;
        Scene sky = Rooms.Sky(1, Albedo);
        double[] seen = [.. Enumerable.Range(0, 400).Select(_ => new Paths(9, 100).Radiance(sky, new(new(run.Random.Next() - 0.5, run.Random.Next() - 0.5, 3), new(0, 0, -1)), run.Random).G)];
        double[] wrong = [.. seen.Where(s => !(Math.Abs(s - Albedo) < 1e-9))];
        if (wrong.Length > 0)
        {
            run.Fail(
                wrong.Length == seen.Length ? "Your paths do not get from a ball to the sky: does the new ray go in the direction in the world, and does Around count at its end?"
                    : $"{wrong.Length} of {seen.Length} paths meet again the ball that they leave, by rounding: let hit.Leave make the new ray.",
                isRecognised: true, $"{Albedo}", $"{wrong[0]:G6}", $"a ball of albedo {Albedo} under an even sky of radiance 1");
        }

        // A mirror shows a lamp, if the integrator knows where the path comes from.
        run.Compare(new Trial<Look>
        {
            Draw = Look.AtAMirror,
            Found = l => new Paths(2, rouletteFrom: 100).Radiance(l.Mirror, l.Ray, run.Random).G,
            Expected = l => Rooms.Mirrored,
            Mistakes = [("A mirror sends your path the wrong way: where it comes from is −D, in the frame of the surface, and where it goes must be turned to the world.", l => 0)],
        });
    }

    private static Trial<Furnace> InAFurnace(CheckRun run) => new()
    {
        // Within a closed box whose walls all shine alike, there is no noise: each edge of a path finds the same light.
        Draw = Furnace.Draw,
        Found = f => new Paths(f.MaxEdges, rouletteFrom: 100).Radiance(f.Box, f.Ray, run.Random).G,
        Expected = f => f.Light(f.MaxEdges),
        Count = 40,
        Mistakes =
        [
            ("Your paths have one edge too many: with maxEdges = 1 the lamps alone are seen.", f => f.Light(f.MaxEdges + 1)),
            ("Your paths have one edge too few: with maxEdges = 2 light is reflected once.", f => f.Light(f.MaxEdges - 1)),
            ("You have forgotten the throughput: each surface takes some of the light that comes after it.", f => f.Emission * f.MaxEdges),
            ("Your throughput is that of the last surface alone: what comes back passes all of them, so multiply.", f => f.Emission * (1 + (f.Albedo * (f.MaxEdges - 1)))),
            ("You keep the light of the last edge only: add it to what was found before.", f => f.Emission * Math.Pow(f.Albedo, f.MaxEdges - 1)),
            ("Your path dies at its second surface: is the direction turned to the world, and does hit.Leave make the ray?", f => f.Emission),
        ],
    };

    [Check("roulette", 2)]
    public static void Endings(CheckRun run) => run.Compare(new Trial<Chance>
    {
        Draw = draws => new(draws.Number("red", 0.05, 0.9), draws.Number("green", 0.05, 0.9)),
        Found = c => c.Play(),
        Expected = c => (1, 1),
        Tolerance = 2e-3,
        Mistakes =
        [
            ("Paths that go on do not make up for those that end: divide the throughput by the probability of going on.", c => (c.Survival, 1)),
            ("You multiply by the probability of going on, but must divide: few go on, and each of them stands for many.", c => (c.Survival * c.Survival, 1)),
            ("Your paths go on where they should end: with the probability p a random number is below p.", c => (c.Survival / (1 - c.Survival), 1)),
            ("Your paths never end: the probability of going on must be below 1 for all that is dark.", c => (1, 0)),
        ],
    });

    [Check("the white furnace", 1)]
    public static void WhiteFurnace(CheckRun run)
    {
        Furnace furnace = new(1 + run.Random.Next(), 0.5 + (0.3 * run.Random.Next()), -1);
        Paths paths = new(maxEdges: -1, rouletteFrom: 2);
        double[] estimates = [.. Enumerable.Range(0, Count).Select(_ => paths.Radiance(furnace.Box, furnace.Ray, run.Random).G)];
        IsNear(run, $"a closed box with emission {furnace.Emission:F3} and albedo {furnace.Albedo:F3}, e/(1 − albedo),", furnace.Emission / (1 - furnace.Albedo), estimates);
    }

    [Check("asking the lamps", 2)]
    public static void Lamps(CheckRun run)
    {
        // What was not asked must be met: a lamp before the camera, and one in a mirror.
        run.Compare(new Trial<Look>
        {
            Draw = Look.AtAMirror,
            Found = l => (new LampPaths(2, 100).Radiance(l.Mirror, l.AtLamp, run.Random).G, new LampPaths(2, 100).Radiance(l.Mirror, l.Ray, run.Random).G),
            Expected = _ => (Rooms.LampRadiance, Rooms.Mirrored),
            Mistakes =
            [
                ("Lamps that the camera sees are dark: nobody asked for them before, so that they count where the path meets them.", _ => (0, Rooms.Mirrored)),
                ("Lamps that a mirror shows are dark: a mirror cannot ask for them, so that they count where the path meets them.", _ => (Rooms.LampRadiance, 0)),
            ],
        });
        // A ball under an even sky sends back its albedo of it.
        LampPaths paths = new(maxEdges: -1, rouletteFrom: 100);
        double albedo = 0.3 + (0.6 * run.Random.Next());
        Scene sky = Rooms.Sky(2, albedo);
        double[] estimates = [.. Enumerable.Range(0, Count).Select(_ => paths.Radiance(sky, new(new(0.2, 0.1, 3), new(0, 0, -1)), run.Random).G)];
        FailTwice(run, estimates.Average() / (2 * albedo));
        IsNear(run, $"a ball of albedo {albedo:F3} under an even sky of radiance 2", 2 * albedo, estimates);

        // A floor below two lamps that are balls, which light it as their middles would.
        Ball[] lamps = [new(new(-1, 2, 0), 0.3, 20), new(new(1.2, 1.5 + run.Random.Next(), 0.5), 0.2, 10)];
        (Scene floor, double[] lights) = Rooms.Floor(lamps, albedo);
        Ray down = new(new(0, 1, 2), new Vector(0, -1, -2).Unit);
        if (new LampPaths(1, 100).Radiance(floor, down, run.Random).G != 0)
        {
            run.Fail("You ask the lamps for one edge too many: the one to the lamp counts, too, so that with maxEdges = 1 lamps alone are seen.", isRecognised: true, "0 for a floor", "light");
        }

        double[] plain = [.. Enumerable.Range(0, Count).Select(_ => new Paths(-1, 100).Radiance(floor, down, run.Random).G)];
        estimates = [.. Enumerable.Range(0, Count).Select(_ => paths.Radiance(floor, down, run.Random).G)];
        double expected = lights.Sum();
        FailTwice(run, estimates.Average() / expected);
        double unweighted = lights.Zip(lamps).Sum(l => l.First * l.Second.Power) / lamps.Sum(l => l.Power);
        if (Math.Abs(estimates.Average() - unweighted) < 0.02 * unweighted)
        {
            run.Fail("You have forgotten the chance of the lamp: what is chosen seldom counts more, so divide by it.", isRecognised: true, $"{expected:G5}", $"{estimates.Average():G5}");
        }

        IsNear(run, "a floor below two lamps", expected, estimates);
        if (!(Deviation(estimates) < 0.5 * Deviation(plain)))
        {
            run.Fail("Your paths have as much noise as without asking the lamps: is FromLamps added at each surface?", expected: "less than half of the noise of Paths", found: $"{Deviation(estimates) / Deviation(plain):F2} times that");
        }
    }

    [Check("a room", 1)]
    public static void Room(CheckRun run)
    {
        const int Passes = 9;
        Scene room = Rooms.Room();
        Rgb[][] own = Passed(new LampPaths(8, 4));
        Rgb[][] reference = Passed(new PathIntegrator(8, 4));
        run.Show(Pictures.Beside("your room, that of the textbook, and the difference, which is noise", Rooms.Width, Rooms.Height, Mean(own), Mean(reference)));
        double[] differences = [.. own.SelectMany(p => p).Zip(reference.SelectMany(p => p), (a, b) => a.G - b.G)];
        IsNear(run, "the room, less that of the textbook edition,", 0, differences);

        Rgb[][] Passed(IIntegrator integrator)
        {
            Renderer renderer = new(room, integrator, Rooms.Width, Rooms.Height, stream => new StratifiedSampler(3, stream + (integrator is PathIntegrator ? 2 : 0)));
            return [.. Enumerable.Range(0, Passes).Select(i => renderer.Pass(i))];
        }

        Rgb[] Mean(Rgb[][] passes) => [.. Enumerable.Range(0, Rooms.Width * Rooms.Height).Select(i => passes.Aggregate(Rgb.Black, (sum, p) => sum + (p[i] * (1.0 / Passes))))];
    }

    private static void FailTwice(CheckRun run, double ratio)
    {
        if (Math.Abs(ratio - 2) < 0.05)
        {
            run.Fail("You have counted the lamps twice: a lamp that was asked must not count again where the path meets it. Only what the camera and mirrors see counts.", isRecognised: true, "1", $"{ratio:F3} times the light");
        }
    }

    private static void IsNear(CheckRun run, string what, double truth, double[] estimates)
    {
        double found = estimates.Average();
        double most = (Far * Deviation(estimates) / Math.Sqrt(estimates.Length)) + (1e-6 * truth);
        if (!(Math.Abs(found - truth) <= most))
        {
            run.Fail($"Your estimate of {what} is off by more than chance allows.", expected: $"{truth:G6} ± {most:G2}", found: $"{found:G6}");
        }
    }

    private static double Deviation(double[] values)
    {
        double mean = values.Average();
        return Math.Sqrt(values.Average(v => (v - mean) * (v - mean)));
    }

    /// <summary>A closed box whose walls all shine and reflect alike.</summary>
    private sealed record Furnace(double Emission, double Albedo, int MaxEdges)
    {
        public Scene Box { get; } = Rooms.Box(Emission, Albedo);

        public Ray Ray { get; } = new(new(0.1, 0.2, 0.3), new Vector(0.5, -0.3, 0.8).Unit);

        public static Furnace? Draw(Draws draws) => new(draws.Number("emission", 0.5, 4), draws.Number("albedo", 0.2, 0.9), draws.Whole("maxEdges", 2, 7));

        // e + albedo·e + albedo²·e + …: a geometric series.
        public double Light(int edges) => Emission * (1 - Math.Pow(Albedo, edges)) / (1 - Albedo);
    }

    /// <summary>A ray to a place.</summary>
    private sealed record Look(double X, double Z)
    {
        public Scene Mirror => Rooms.Mirror();

        /// <summary>To where the mirror shows the lamp, from an eye that is as high as that.</summary>
        public Ray Ray => new(new(X, 1, Z), new Vector(Rooms.LampX - X, -2, -Z).Unit);

        /// <summary>At the lamp itself.</summary>
        public Ray AtLamp => new(new(X, 1, Z), new Vector(Rooms.LampX - X, 0, -Z).Unit);

        public static Look? AtAMirror(Draws draws) => new(draws.Number("x of the eye", -1, 0), draws.Number("z of the eye", -1, 1));
    }

    /// <summary>A throughput at the roulette.</summary>
    private sealed record Chance(double Red, double Green)
    {
        /// <summary>The share of those that went on.</summary>
        public double Survival { get; private set; }

        /// <summary>What is left on the mean, over what there was, and 1 where some end.</summary>
        public (double Kept, double Ends) Play()
        {
            const int Tries = 10_000;
            double sum = 0;
            int alive = 0;
            for (int i = 0; i < Tries; i++)
            {
                Rgb throughput = new(Red, Green, 0.01);
                if (Roulette.Survives(ref throughput, (i + 0.5) / Tries))
                {
                    sum += throughput.G / Green;
                    alive++;
                }
            }

            Survival = (double)alive / Tries;
            return (sum / Tries, alive < Tries ? 1 : 0);
        }
    }
}
