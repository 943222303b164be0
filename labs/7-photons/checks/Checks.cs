using RayTracer.Labs;

namespace Lab7;

/// <summary>The checks of lab 7. By chance, a right answer is taken for a wrong one in fewer than one case of ten million.</summary>
public static class Checks
{
    private const int Sent = 400_000;
    private const double Radius = 0.05;

    [Check("photons leave the lamps", 2)]
    public static void Emission(CheckRun run)
    {
        // Lamps that are all alike send photons that are all alike.
        run.Compare(new Trial<Shared>
        {
            Draw = draws => new(draws.Whole("lamps", 2, 5), draws.Number("radius", 0.2, 1), draws.Number("radiance", 0.5, 5), draws.Whole("photons", 2, 1000)),
            Found = s => Photons.Emit(s.Scene, s.Count, run.Random)?.Power.G,
            Expected = s => s.Lamps * s.Power / s.Count,
            Mistakes =
            [
                ("You have forgotten the chance of the lamp: one of many is chosen, and stands for all, so divide by its chance.", s => s.Power / s.Count),
                ("You have forgotten the number of photons: they share the power, so that each has one part.", s => s.Lamps * s.Power),
                ("You have forgotten both the chance of the lamp and the number of photons: divide by both.", s => s.Power),
                ("You have multiplied by the chance of the lamp: divide by it, so that what is chosen seldom counts more.", s => s.Power / s.Lamps / s.Count),
            ],
        });
        if (Photons.Emit(Scenes.Floor(), 10, run.Random) is not null)
        {
            run.Fail("A photon comes from a scene without lamps: where scene.Lights.Count is 0, there is none.", expected: "nothing", found: "a photon");
        }
    }

    [Check("through glass and mirrors", 3)]
    public static void Following(CheckRun run)
    {
        List<Photon> stored = Stored(run, Scenes.Floor(), new(new(0, 3, 0), new(0, -1, 0)));
        if (stored.Count > 0)
        {
            run.Fail("You store light that comes straight from the lamp: direct light is found by asking the lamps (lab 4), and would be counted twice.", isRecognised: true, "no photon", "one photon", "a lamp above a floor");
        }

        run.Compare(new Trial<Shot>
        {
            Draw = Shot.Draw,
            Found = s => s.Found(Stored(run, Scenes.Mirror(), s.Upwards)),
            Expected = s => (1, Scenes.Mirrored),
            Count = 50,
            Mistakes =
            [
                ("Nothing arrives below the mirror: go on while the lobe is Lobe.Mirror, and store the photon at the first surface that is none.", s => (0, 0)),
                ("You have forgotten what the mirror takes: multiply the power by the ParticleWeight of each mirror.", s => (1, 1)),
                ("You store photons at the mirror, too: a mirror shows what is seen in it, and no light of its own.", s => (2, 1 + Scenes.Mirrored)),
                ("You store photons at the mirror, too: a mirror shows what is seen in it, and no light of its own.", s => (2, 2 * Scenes.Mirrored)),
                ("You multiply by the share of the floor, too: a photon is stored with the power with which it arrives, and the BSDF is taken where it is looked up.", s => (1, 0.5 * Scenes.Mirrored)),
            ],
        });
        run.Compare(new Trial<Shot>
        {
            Draw = Shot.Draw,
            Found = s => Stored(run, Scenes.Mirror(), s.Upwards) is [var photon, ..] ? photon.From : null,
            Expected = s => -s.Reflected,
            Count = 50,
            Mistakes =
            [
                ("From points along the photon's way: turn it around, so that it points back to where the light came from.", s => s.Reflected),
                ("From is in the frame of the surface: it must be in the world.", s => new Frame(new(0, 1, 0)).ToLocal(-s.Reflected)),
            ],
        });

        // What goes into the water keeps its power, though radiance becomes denser there.
        run.Compare(new Trial<Shot>
        {
            Draw = Shot.Draw,
            Found = s => Refracted(run, s.Downwards)?.Power.G,
            Expected = s => 1,
            Count = 50,
            Mistakes = [("Under water your photons have lost power: Weight is that of radiance, which grows in a denser medium; ParticleWeight is that of power.", s => 1 / (Scenes.Water * Scenes.Water))],
        });
    }

    [Check("the photons around a place", 2)]
    public static void Nearness(CheckRun run) => run.Compare(new Trial<Crowd>
    {
        Draw = draws => new(draws.Number("radius", 0.05, 0.5), draws.Point("place", -1, 1), run.Random),
        Found = c => c.Count(new PhotonMap(c.Photons, c.Radius).Near(c.Place)),
        Expected = c => c.Count(c.Photons.Where(p => c.IsNear(p.Point))),
        Count = 100,
        Mistakes =
        [
            ("You look into one cell only: a circle around a point near its edge reaches into the cells around, too.", c => c.Count(c.Photons.Where(p => c.IsNear(p.Point) && c.Steps(p.Point) == 0))),
            ("You take all photons of the cells: those farther away than the radius do not count.", c => c.Count(c.Photons.Where(p => c.Steps(p.Point) <= 1))),
            ("You take all photons of the point's own cell: those farther away than the radius do not count, and some of the cells around do.", c => c.Count(c.Photons.Where(p => c.Steps(p.Point) == 0))),
        ],
    });

    [Check("how bright a place is", 1)]
    public static void Density(CheckRun run) => run.Compare(new Trial<Spot>
    {
        Draw = draws => new(draws.Number("radius", 0.1, 2), draws.Number("albedo", 0.1, 0.9), draws.Number("power", 0.1, 5), draws.Whole("photons", 1, 20)),
        Found = s => s.Found(),
        Expected = s => s.Radiance,
        Mistakes =
        [
            ("You have forgotten the area of the circle: power becomes irradiance when it is divided by π r².", s => s.Radiance * Math.PI * s.Radius * s.Radius),
            ("You have forgotten π in the area of the circle.", s => s.Radiance * Math.PI),
            ("You have divided by the radius, not by its square.", s => s.Radiance * s.Radius),
            ("You have divided by the volume of a ball: the photons lie on a surface, in a circle.", s => s.Radiance / (4.0 / 3 * s.Radius)),
            ("You have forgotten the BSDF: it is the share of the light from photon.From that goes to the viewer.", s => s.Radiance * Math.PI / s.Albedo),
            ("You return the mean of the photons: they add up.", s => s.Radiance / s.Photons),
        ],
    });

    [Check("smaller and smaller circles", 1)]
    public static void Shrinking(CheckRun run) => run.Compare(new Trial<Circle>
    {
        Draw = draws => new(draws.Number("radius", 0.1, 2), draws.Whole("map", 1, 50), draws.Number("kept", 0.1, 0.9)),
        Found = c => Progressive.NextRadius(c.Radius, c.Map, c.Kept),
        Expected = c => c.Radius * Math.Sqrt(c.Shrink),
        Mistakes =
        [
            ("Your radius shrinks as the area should: take the root.", c => c.Radius * c.Shrink),
            ("Your radius shrinks as the area should: take the root.", c => c.Radius * c.Radius * c.Shrink),
            ("Your circles grow: the area shrinks by (map + kept) / (map + 1), which is below 1.", c => c.Radius / Math.Sqrt(c.Shrink)),
        ],
    });

    [Check("a glass ball", 1)]
    public static void GlassBall(CheckRun run)
    {
        Scene scene = Scenes.GlassBall();
        List<Photon> own = [];
        List<Photon> truth = [];
        for (int i = 0; i < Sent; i++)
        {
            if (Photons.Emit(scene, Sent, run.Random) is { } photon)
            {
                Photons.Follow(scene, photon.Ray, photon.Power, run.Random, own.Add);
            }

            Truth(scene, run.Random, truth);
        }

        PhotonMap map = new(own, Radius);
        run.Show(Caustics.Picture(scene, map.Radiance, run.Random));
        (double found, double expected) = (own.Sum(p => p.Power.G), truth.Sum(p => p.Power.G));

        // The photons that arrive are counted: the error of their number is its root (Poisson).
        double most = 6 * expected * Math.Sqrt(2.0 / truth.Count);
        if (!(Math.Abs(found - expected) < most))
        {
            run.Fail("What comes through the glass is not the right amount of light.", expected: $"{expected:G4} ± {most:G2}", found: $"{found:G4}", at: "all photons on the floor below the ball");
        }

        // A bright place of the floor, where half of the photons lie to either side, by the student's circle and by one that asks every photon.
        double Half(Func<Photon, double> along) => truth.Select(along).Order().ElementAt(truth.Count / 2);
        scene.Intersect(new(new(Half(p => p.Point.X), 0.1, Half(p => p.Point.Z)), new(0, -1, 0)), out Hit hit);
        double bright = map.Radiance(hit, new(0, 0, 1)).G;
        Photon[] inside = [.. truth.Where(p => (p.Point - hit.Point).Length < Radius)];
        double right = inside.Sum(p => p.Power.G) * 0.6 / Math.PI / (Math.PI * Radius * Radius);
        double error = 6 * right * Math.Sqrt(2.0 / Math.Max(inside.Length, 1));
        if (!(Math.Abs(bright - right) < error))
        {
            run.Fail("The middle of the light below the ball has not the right brightness.", expected: $"{right:G4} ± {error:G2}", found: $"{bright:G4}", at: $"the floor at {Answer.Text((Answer)hit.Point)}");
        }
    }

    private static List<Photon> Stored(CheckRun run, Scene scene, Ray ray)
    {
        List<Photon> stored = [];
        Photons.Follow(scene, ray, Rgb.White, run.Random, stored.Add);
        return stored;
    }

    // Some of the light is reflected by the water.
    private static Photon? Refracted(CheckRun run, Ray ray)
    {
        for (int tries = 0; tries < 1000; tries++)
        {
            if (Stored(run, Scenes.Pool(), ray) is [var photon, ..])
            {
                return photon;
            }
        }

        return null;
    }

    // The same without the student's code: the textbook's lamps and glass.
    private static void Truth(Scene scene, ISampler random, List<Photon> stored)
    {
        (ILight light, double chance) = scene.ChooseLight(random.Next());
        if (light.Emit(random) is not { } emitted)
        {
            return;
        }

        (Ray ray, Rgb power, int mirrors) = (emitted.Ray, emitted.Power * (1 / (chance * Sent)), 0);
        while (scene.Intersect(ray, out Hit hit) && hit.Thing!.Material.Sample(hit, hit.Frame.ToLocal(-ray.Direction), random) is { } next)
        {
            if (next.Lobe != Lobe.Mirror || ++mirrors > 20)
            {
                stored.AddRange(mirrors is > 0 and <= 20 ? [new Photon(hit.Point, -ray.Direction, power)] : []);
                return;
            }

            (ray, power) = (hit.Leave(hit.Frame.ToWorld(next.Direction)), power * next.ParticleWeight);
        }
    }

    /// <summary>Equal lamps, and the photons that share their power.</summary>
    private sealed record Shared(int Lamps, double Radius, double Radiance, int Count)
    {
        public Scene Scene { get; } = Scenes.Lamps(Lamps, Radius, Radiance);

        /// <summary>What one of them sends: radiance · π from each unit of area.</summary>
        public double Power => Radiance * Math.PI * 4 * Math.PI * Radius * Radius;
    }

    /// <summary>A photon that begins between a floor and a mirror, or above water.</summary>
    private sealed record Shot(Vector Slant)
    {
        public Ray Upwards => new(new(0, 1, 0), Slant);

        public Ray Downwards => new(new(0, 2, 0), Reflected);

        public Vector Reflected => new(Slant.X, -Slant.Y, Slant.Z);

        public static Shot Draw(Draws draws) => new(new Vector(draws.Number("x of its way", -0.5, 0.5), 1, draws.Number("z of its way", -0.5, 0.5)).Unit);

        // How many arrived at the floor and elsewhere, and with how much power in all.
        public Answer Found(List<Photon> stored) => (stored.Count, stored.Sum(p => p.Power.G));
    }

    /// <summary>Many photons, and a place among them.</summary>
    private sealed record Crowd(double Radius, Vector Place, ISampler Random)
    {
        public Photon[] Photons { get; } = [.. Enumerable.Range(1, 400).Select(i => new Photon(new(Next(Random), Next(Random), Next(Random)), new(0, 1, 0), new Rgb(i)))];

        public bool IsNear(Vector point) => (point - Place).Length < Radius;

        // The number of photons, and the sum of their powers.
        public Answer Count(IEnumerable<Photon> photons) => (photons.Count(), photons.Sum(p => p.Power.G));

        // How many cells away.
        public int Steps(Vector point)
        {
            (int x, int y, int z) = PhotonMap.Cell(point, Radius);
            (int cx, int cy, int cz) = PhotonMap.Cell(Place, Radius);
            return Math.Max(Math.Abs(x - cx), Math.Max(Math.Abs(y - cy), Math.Abs(z - cz)));
        }

        private static double Next(ISampler random) => (2 * random.Next()) - 1;
    }

    /// <summary>A place of a floor with some photons in a circle around it, and others outside.</summary>
    private sealed record Spot(double Radius, double Albedo, double Power, int Photons)
    {
        public double Radiance => Photons * Power * Albedo / Math.PI / (Math.PI * Radius * Radius);

        public double Found()
        {
            Vector up = new(0, 1, 0);
            IEnumerable<Photon> inside = Enumerable.Range(0, Photons).Select(i => new Photon(new(0.9 * Radius * i / Photons, 0, 0), up, new Rgb(Power)));
            Scenes.Floor(Albedo).Intersect(new(up, -up), out Hit hit);
            return new PhotonMap(inside.Append(new(new(1.1 * Radius, 0, 0), up, new Rgb(Power))), Radius).Radiance(hit, new(0, 0, 1)).G;
        }
    }

    /// <summary>The circle of a map.</summary>
    private sealed record Circle(double Radius, int Map, double Kept)
    {
        public double Shrink => (Map + Kept) / (Map + 1);
    }
}
