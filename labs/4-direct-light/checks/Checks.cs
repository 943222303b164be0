using RayTracer.Labs;

namespace Lab4;

/// <summary>The checks of lab 4. By chance, a right answer is taken for a wrong one in fewer than one case of ten million.</summary>
public static class Checks
{
    // Standard deviations that an estimate may be off.
    private const double Far = 6;
    private const int Count = 20_000;

    [Check("one point lamp", 1)]
    public static void Point(CheckRun run) => run.Compare(new Trial<Lit>
    {
        Draw = Lit.Draw,
        Found = l => Lights.FromPoint(l.Place, l.Lamp, l.Intensity),
        Expected = l => l.Radiance(),
        Mistakes =
        [
            ("You have divided by the distance, not by its square: the light is spread over a sphere, whose area grows with the square.", l => l.Radiance() * l.Distance),
            ("You have forgotten the squared distance: the light is spread over a sphere.", l => l.Radiance() * l.Distance * l.Distance),
            ("You have forgotten the cosine: light that comes at a slant is spread over more of the surface.", l => l.Cosine > 0 ? l.Radiance() / l.Cosine : 0),
            ("You have forgotten π: a matt surface sends albedo/π in each direction.", l => l.Radiance() * Math.PI),
            ("Light comes through the surface from behind: where the cosine is below 0, there is none.", l => l.Radiance(isClamped: false)),
            ("Light comes through the surface from behind: where the cosine is below 0, there is none.", l => Math.Abs(l.Radiance(isClamped: false))),
        ],
    });

    [Check("all of many lamps", 1)]
    public static void All(CheckRun run) => run.Compare(new Trial<Lit>
    {
        Draw = Lit.Draw,
        Found = l => Lights.FromAll(l.Place, l.Lamps, l.Intensity),
        Expected = l => l.Radiances.Sum(),
        Mistakes = [("You return the mean of the lamps: each of them shines by itself, and their light adds up.", l => l.Radiances.Average())],
    });

    [Check("one of many lamps, by chance", 1)]
    public static void One(CheckRun run)
    {
        // Where all lamps stand at one place, every estimate is exact.
        run.Compare(new Trial<Lit>
        {
            Draw = Lit.Draw,
            Found = l => Lights.FromOne(l.Place, [.. l.Lamps.Select(_ => l.Lamp)], l.Intensity, run.Random),
            Expected = l => l.Lamps.Length * l.Radiance(),
            Mistakes =
            [
                ("You have forgotten the probability: one of N lamps is chosen with 1/N, so that its light counts N times.", l => l.Radiance()),
                ("You have multiplied by the probability: divide by it, so that what is chosen seldom counts more.", l => l.Radiance() / l.Lamps.Length),
            ],
        });
        Place floor = new(default, new(0, 1, 0), 0.5);
        Vector[] lamps = [.. Enumerable.Range(0, 5).Select(_ => new Vector(run.Random.Next(), 1 + run.Random.Next(), run.Random.Next()))];
        double[] estimates = [.. Enumerable.Range(0, Count).Select(_ => Lights.FromOne(floor, lamps, 10, run.Random))];
        double[] single = [.. lamps.Select(l => new Lit(floor, l, 10, []).Radiance() * lamps.Length)];
        string at = $"a place at (0, 0, 0) with normal (0, 1, 0) and albedo 0.5; lamps of intensity 10 at {string.Join(", ", lamps.Select(l => Answer.Text((Answer)l)))}";
        IsNear(
            run, "all of five lamps", at, single.Average(), estimates, Deviation(single),
            ("You never choose the last lamp: (int)(u · N) is each of 0 to N − 1 equally often.", single[..^1].Average()),
            ("You never choose the first lamp: (int)(u · N) is each of 0 to N − 1 equally often.", single[1..].Average()));
    }

    [Check("a random point of a rectangle", 2)]
    public static void Rectangle(CheckRun run)
    {
        // A rectangle so small that all of its points are as good as one.
        run.Compare(new Trial<Small>
        {
            Draw = Small.Draw,
            Found = s => Lights.FromRectangle(s.Place, s.Panel, (0.5, 0.5)) / s.Panel.Area,
            Expected = s => s.Radiance,
            Tolerance = 1e-3,
            Mistakes =
            [
                ("You have forgotten the area: the density of the point is 1/area, and what is found is divided by that.", s => s.Radiance / s.Panel.Area),
                ("You have forgotten the cosine at the lamp: seen at a slant, it looks narrower.", s => s.There > 0 ? s.Radiance / s.There : 0),
                ("You have forgotten the cosine at the place: light that comes at a slant is spread over more of it.", s => s.Here > 0 ? s.Radiance / s.Here : 0),
                ("You have forgotten the squared distance: far away, a unit of area is a smaller part of what is seen.", s => s.Radiance * s.Distance * s.Distance),
                ("The lamp shines on the side of its normal only: behind it, the cosine there is below 0, and it is dark.", s => s.Here > 0 ? s.Both(Math.Abs(s.There)) : 0),
                ("You have forgotten π: a matt surface sends albedo/π in each direction.", s => s.Radiance * Math.PI),
            ],
        });
        Hall hall = new(run.Random);
        double[] estimates = [.. Enumerable.Range(0, Count).Select(_ => Lights.FromRectangle(hall.Place, hall.Panel, run.Random.Next2()))];
        IsNear(
            run, "a rectangle above a floor", hall.Text, hall.Radiance, estimates, Deviation(estimates),
            ("Your points lie around the corner, but both edges begin there: Corner + U · EdgeU + V · EdgeV.", (hall with { Panel = hall.Panel with { Corner = hall.Panel.Corner - (0.5 * (hall.Panel.EdgeU + hall.Panel.EdgeV)) } }).Radiance));
    }

    [Check("strata", 1)]
    public static void Strata(CheckRun run)
    {
        const int Side = 4;
        Hall hall = new(run.Random);
        run.Show(Hall.Picture(hall.Panel, run.Random));
        double[] single = [.. Enumerable.Range(0, Count / 4).Select(_ => Lights.FromRectangle(hall.Place, hall.Panel, run.Random.Next2()))];
        double[] strata = [.. Enumerable.Range(0, Count / 4).Select(_ => Lights.FromStrata(hall.Place, hall.Panel, Side, run.Random))];
        double ratio = strata.Average() / hall.Radiance;
        if (Math.Abs((ratio / (Side * Side)) - 1) < 0.05)
        {
            run.Fail($"You return the sum over the parts, which is {Side * Side} times too large: it is the mean that is wanted.", isRecognised: true);
        }

        IsNear(run, "a rectangle above a floor, by strata", hall.Text, hall.Radiance, strata, Deviation(single) / Side);
        double noise = Deviation(strata) / (Deviation(single) / Side);
        if (noise > 0.75)
        {
            run.Fail(
                "Your noise is that of independent points: there must be one point in each of side × side parts, (i + a random number)/side along one edge and (j + another)/side along the other.",
                isRecognised: true, "less than half of the noise of 16 independent points", $"{noise:F2} times that");
        }
    }

    [Check("the solid angle of a ball", 1)]
    public static void SolidAngle(CheckRun run) => run.Compare(new Trial<Seen>
    {
        Draw = Seen.Draw,
        Found = s => Lights.SolidAngle(s.Distance, s.Radius),
        Expected = s => 2 * Math.PI * (1 - Math.Cos(s.Rim)),
        Mistakes =
        [
            ("That is the area of the disk over the squared distance: it is nearly right for small balls, but a solid angle is an area on the unit sphere.", s => Math.PI * s.Radius * s.Radius / (s.Distance * s.Distance)),
            ("You have used the sine of the rim for its cosine: cos θ = √(1 − sin²θ).", s => 2 * Math.PI * (1 - Math.Sin(s.Rim))),
            ("You have the angle of a disk in the middle of the ball: the rim that is seen is a tangent, with sin θ = r/d.", s => 2 * Math.PI * (1 - Math.Cos(Math.Atan(s.Radius / s.Distance)))),
            ("Your solid angle is twice too large: a cap of the unit sphere has the area 2π times its height.", s => 4 * Math.PI * (1 - Math.Cos(s.Rim))),
        ],
    });

    [Check("a ball that shines", 1)]
    public static void ShiningBall(CheckRun run)
    {
        Place place = new(default, new(0, 1, 0), 0.7);
        Ball ball = new(new(0.8 + run.Random.Next(), 2, 0.3), 1 + (0.3 * run.Random.Next()), 3);
        double distance = ball.Center.Length;
        double rim = Math.Sqrt(1 - (ball.Radius * ball.Radius / (distance * distance)));
        double[] heights = [.. Enumerable.Range(0, Count).Select(_ => Vector.Dot(Lights.InCone(place, ball, run.Random.Next2()), ball.Center.Unit))];
        if (heights.Min() < rim - 1e-6)
        {
            run.Fail("Some of your directions miss the ball: the cone ends at the cosine of its rim.", expected: $"cosines from {rim:F4} to 1", found: $"{heights.Min():F4}");
        }

        double angle = Math.Acos(rim);
        if (Math.Abs(heights.Average() - (Math.Sin(angle) / angle)) < 0.1 * (1 - rim) / 2)
        {
            run.Fail("Your directions crowd in the middle of the ball: it is the height, the cosine, that is uniform, not the angle.", isRecognised: true, $"a mean cosine of {(1 + rim) / 2:F4}", $"{heights.Average():F4}");
        }

        string at = $"a place at (0, 0, 0) with normal (0, 1, 0) and albedo 0.7; a ball of radiance 3 and radius {ball.Radius:G6} at {Answer.Text((Answer)ball.Center)}";
        IsNear(run, "the mean cosine between your directions and the middle of the ball", at, (1 + rim) / 2, heights, (1 - rim) / Math.Sqrt(12));

        // A ball that is all above the surface lights it as its middle would, with all of its power (Lambert 1760).
        double truth = place.Albedo * ball.Radiance * (ball.Radius * ball.Radius / (distance * distance)) * (ball.Center.Y / distance);
        double[] estimates = [.. Enumerable.Range(0, Count).Select(_ => Lights.FromBall(place, ball, run.Random.Next2()))];
        double solidAngle = 2 * Math.PI * (1 - rim);
        IsNear(
            run, "the light of a ball", at, truth, estimates, Deviation(estimates),
            ("You have forgotten the cosine at the place: light that comes at a slant is spread over more of it.", place.Albedo / Math.PI * ball.Radiance * solidAngle),
            ("You have multiplied by the density, but must divide: it is 1/solid angle.", truth / (solidAngle * solidAngle)),
            ("You have forgotten the density: divide by it, that is, multiply by the solid angle.", truth / solidAngle),
            ("You have forgotten π: a matt surface sends albedo/π in each direction.", truth * Math.PI));
    }

    [Check("the power heuristic", 1)]
    public static void Share(CheckRun run) => run.Compare(new Trial<Seen>
    {
        Draw = Seen.Draw,
        Found = s => Lights.Share(s.Radius, s.Distance),
        Expected = s => 1 / (1 + Math.Pow(s.Distance / s.Radius, 2)),
        Mistakes =
        [
            ("That is the balance heuristic: the power heuristic squares both densities.", s => s.Radius / (s.Radius + s.Distance)),
            ("You have changed the two ways: the denser one gets the larger share.", s => 1 / (1 + Math.Pow(s.Radius / s.Distance, 2))),
        ],
    });

    [Check("both ways at once", 1)]
    public static void Both(CheckRun run)
    {
        Place place = new(default, new(0, 1, 0), 0.7);
        Ball ball = new(new(0.4 + (0.3 * run.Random.Next()), 2, 0.2), 0.5 + (0.2 * run.Random.Next()), 3);
        Lobe lobe = new(new Vector(0.1, 1, 0).Unit, place.Normal, 10);
        double truth = Reference.Light(place, ball, lobe);
        double[] estimates = [.. Enumerable.Range(0, Count).Select(_ => Lights.FromBoth(place, ball, lobe, run.Random))];
        double[] best = [.. Enumerable.Range(0, Count).Select(_ => Reference.Both(place, ball, lobe, run.Random))];
        if (Math.Abs((estimates.Average() / truth) - 2) < 0.1)
        {
            run.Fail("You have counted the ball twice: each way alone finds all of its light, so that both need shares that are 1 together.", isRecognised: true, $"{truth:G4}", $"{estimates.Average():G4}");
        }

        double Light(Func<Vector, double> factor) => Reference.Light(place, ball, lobe, factor);
        IsNear(
            run, "the ball in a shiny surface", $"a ball of radiance 3 and radius {ball.Radius:G6} at {Answer.Text((Answer)ball.Center)}, seen from (0, 0, 0)", truth, estimates, Deviation(estimates),
            ("You have one cosine too many: lobe.Value is BSDF · cosine already.", Light(d => Vector.Dot(d, place.Normal))),
            ("You have multiplied by the albedo: what the shiny surface reflects is lobe.Value alone.", truth * place.Albedo),
            ("You have multiplied by albedo/π: what the shiny surface reflects is lobe.Value alone.", truth * place.Albedo / Math.PI),
            ("You return the mean of the two ways: their shares are 1 together, so that it is the sum that is wanted.", truth / 2));
        if (Deviation(estimates) > 1.4 * Deviation(best))
        {
            run.Fail("Your estimate is right, but with too much noise: does each way get the share of its own density?", isRecognised: true, $"a deviation of {Deviation(best):G3}", $"{Deviation(estimates):G3}");
        }
    }

    // A mistake is named where the mean is what it would be.
    private static void IsNear(
        CheckRun run, string what, string at, double truth, double[] estimates, double deviation, params IEnumerable<(string Sentence, double Mean)> mistakes)
    {
        double found = estimates.Average();
        double most = (Far * deviation / Math.Sqrt(estimates.Length)) + (1e-9 * truth);
        if (!(Math.Abs(found - truth) <= most))
        {
            string? sentence = mistakes.FirstOrDefault(m => Math.Abs(found - m.Mean) <= most).Sentence;
            run.Fail(
                sentence ?? $"Your estimate of {what} is off by more than chance allows.", sentence is not null, $"{truth:G6} ± {most:G2} as the mean of {estimates.Length} estimates",
                $"{found:G6}", at);
        }
    }

    private static double Deviation(double[] values)
    {
        double mean = values.Average();
        return Math.Sqrt(values.Average(v => (v - mean) * (v - mean)));
    }

    /// <summary>A place, a lamp, and others.</summary>
    private sealed record Lit(Place Place, Vector Lamp, double Intensity, Vector[] Lamps)
    {
        public double Distance => (Lamp - Place.Point).Length;

        public double Cosine => Vector.Dot((Lamp - Place.Point).Unit, Place.Normal);

        public IEnumerable<double> Radiances => Lamps.Select(l => (this with { Lamp = l }).Radiance());

        public static Lit? Draw(Draws draws)
        {
            Lit lit = new(
                new(draws.Point("point", -2, 2), draws.Direction("normal"), draws.Number("albedo", 0.1, 1)), draws.Point("lamp", -3, 3), draws.Number("intensity", 1, 9),
                [draws.Point("second lamp", -3, 3), draws.Point("third lamp", -3, 3)]);
            return lit.Lamps.Append(lit.Lamp).All(l => (l - lit.Place.Point).Length > 0.3) && Math.Abs(lit.Cosine) > 0.01 ? lit : null;
        }

        public double Radiance(bool isClamped = true) => (isClamped ? Math.Max(0, Cosine) : Cosine) * Place.Albedo * Intensity / (Math.PI * Math.Pow(Distance, 2));
    }

    /// <summary>A place, and a rectangle that is small.</summary>
    private sealed record Small(Place Place, Panel Panel)
    {
        private Vector To => Panel.Corner + (0.5 * (Panel.EdgeU + Panel.EdgeV)) - Place.Point;

        public double Distance => To.Length;

        public double Here => Vector.Dot(To.Unit, Place.Normal);

        public double There => -Vector.Dot(To.Unit, Panel.Normal);

        /// <summary>What leaves the place, for a unit of area of the lamp.</summary>
        public double Radiance => Here > 0 && There > 0 ? Both(There) : 0;

        public double Both(double there) => Place.Albedo * Panel.Radiance * Here * there / (Math.PI * Math.Pow(Distance, 2));

        public static Small? Draw(Draws draws)
        {
            Frame frame = new(draws.Direction("normal of the lamp"));
            Small small = new(
                new(draws.Point("point", -2, 2), draws.Direction("normal"), draws.Number("albedo", 0.1, 1)),
                new(draws.Point("lamp", -3, 3), 2e-4 * frame.ToWorld(new(1, 0, 0)), 1e-4 * frame.ToWorld(new(0, 1, 0)), draws.Number("radiance", 1, 9)));
            return small.Distance > 0.5 && Math.Abs(small.Here) > 0.05 && Math.Abs(small.There) > 0.05 ? small : null;
        }
    }

    /// <summary>A ball at a distance; or two densities.</summary>
    private sealed record Seen(double Distance, double Radius)
    {
        public double Rim => Math.Asin(Radius / Distance);

        public static Seen? Draw(Draws draws)
        {
            Seen seen = new(draws.Number("distance (or the other density)", 1, 9), draws.Number("radius (or the own density)", 0.1, 5));
            return seen.Radius < 0.95 * seen.Distance ? seen : null;
        }
    }
}
