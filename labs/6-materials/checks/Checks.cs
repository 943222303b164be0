using RayTracer.Labs;

namespace Lab6;

/// <summary>The checks of lab 6. By chance, a right answer is taken for a wrong one in fewer than one case of a hundred million.</summary>
public static class Checks
{
    private const int Samples = 1 << 13;

    [Check("Oren and Nayar: values", 1)]
    public static void OrenNayarValues(CheckRun run) => run.Compare(new Trial<Pair>
    {
        Draw = draws => Pair.Draw(draws, "sigma", 0, 1),
        Found = p => new OrenNayar(Rgb.White, p.Roughness).Evaluate(default, p.ToViewer, p.ToLight).R,
        Expected = p => p.OrenNayar(),
        Mistakes =
        [
            ("You count grooves that cannot be seen: where the azimuths differ by more than 90°, the cosine is below 0, and 0 is to be taken.", p => p.OrenNayar(isClamped: false)),
            ("You have changed α and β: α is the larger angle, β the smaller one.", p => p.OrenNayar(isChanged: true)),
            ("Your BSDF is π times too large: over the hemisphere the cosine's integral is π.", p => Math.PI * p.OrenNayar()),
            ("You have used σ where σ² is needed.", p => p.OrenNayar(power: 1)),
            ("The cosine of the light is in it, but the BSDF is without it.", p => p.OrenNayar() * p.ToLight.Z),
        ],
    });

    [Check("Oren and Nayar: energy and reciprocity", 1)]
    public static void OrenNayarFacts(CheckRun run) => Require(run, new OrenNayar(new Rgb(0.9), 0.2 + (0.6 * run.Random.Next())), 1);

    [Check("Snell's law", 1)]
    public static void Refract(CheckRun run) => run.Compare(new Trial<Boundary>
    {
        Draw = Boundary.Draw,
        Found = b => Glass.Refract(b.From, b.Eta),
        Expected = b => b.Refracted(b.Eta),
        Mistakes =
        [
            ("Your eta is upside down: it is the index on the side of the light over that of the other, and the sine becomes eta times as large.", b => b.Refracted(1 / b.Eta)),
            ("You have forgotten total reflection: where the sine would be above 1, there is no such direction.", b => b.Refracted(b.Eta) ?? b.From * double.NaN),
            ("Your direction stays on the side that the light comes from: refracted light goes on below the surface.", b => b.Refracted(b.Eta) is { } d ? new Vector(d.X, d.Y, -d.Z) : null),
            ("Your direction does not go on, but turns back: its level part is −eta times that of from.", b => b.Refracted(b.Eta) is { } d ? new Vector(-d.X, -d.Y, d.Z) : null),
        ],
    });

    [Check("Fresnel's equations", 1)]
    public static void Fresnel(CheckRun run) => run.Compare(new Trial<Boundary>
    {
        Draw = draws => Boundary.Draw(draws) is { } b && b.Refracted(b.Eta) is not null ? b : null,
        Found = b => Glass.Fresnel(b.From.Z, b.Below, b.Eta),
        Expected = b => Refraction.Fresnel(b.From.Z, b.Below, b.Eta),
        Mistakes =
        [
            ("Your share is twice too large: half of the light has each polarisation.", b => 2 * Refraction.Fresnel(b.From.Z, b.Below, b.Eta)),
            ("Your eta is upside down: it is the index on the side of the light over that of the other.", b => Refraction.Fresnel(b.From.Z, b.Below, 1 / b.Eta)),
            ("You have forgotten the squares: the equations give amplitudes, and power is their square.", b => b.Amplitudes()),
            ("That is Schlick's approximation: Fresnel's equations are wanted here.", b => Refraction.Schlick(b.Eta > 1 ? b.Below : b.From.Z, Math.Pow((b.Eta - 1) / (b.Eta + 1), 2))),
        ],
    });

    [Check("glass: both directions, and one by chance", 2)]
    public static void GlassFacts(CheckRun run)
    {
        double index = 1.2 + run.Random.Next();
        Glass glass = new(index);
        Vector from = new Vector(0.3, 0.2, 0.9).Unit;
        Hit above = default;
        IReadOnlyList<Scattering> both = glass.Mirrors(above, from);
        double eta = 1 / index;
        Vector down = Refraction.Refract(from, eta)!.Value;
        double share = Refraction.Fresnel(from.Z, -down.Z, eta);
        string at = $"index {index:F3}, seen from outside, from {from}";
        if (both.Count != 2 || (both[0].Direction - Refraction.Reflect(from)).Length > 1e-6 || (both[1].Direction - down).Length > 1e-6)
        {
            run.Fail("Mirrors must give the reflected direction first, and then the refracted one.", at: at, expected: $"{Refraction.Reflect(from)}, {down}", found: string.Join(", ", both.Select(b => b.Direction)));
        }

        double through = both[1].Weight.R;
        if (Math.Abs(through - (1 - share)) < 1e-9)
        {
            run.Fail("You have forgotten eta²: radiance that is refracted is squeezed into other angles, and changes with the squared index.", true, $"{(1 - share) * eta * eta:G6}", $"{through:G6}", at);
        }

        if (Math.Abs(through - ((1 - share) / eta / eta)) < 1e-9)
        {
            run.Fail("Your eta is upside down: seen from outside, it is 1/index.", true, $"{(1 - share) * eta * eta:G6}", $"{through:G6}", at);
        }

        Vector grazing = new Vector(0.95, 0, 0.2).Unit;
        above.Inside = true;
        if (glass.Mirrors(above, grazing) is not [{ Weight.R: 1 }])
        {
            run.Fail("From inside, at a slant, all light is reflected: one direction, with the weight 1.", at: $"index {index:F3}, seen from inside, from {grazing}");
        }

        IReadOnlyList<Fact> facts = new MaterialFacts(glass, new() { RefractiveIndex = index }, Seed(run), Samples).All();
        bool isCountedTwice = Enumerable.Range(0, 100).Select(_ => glass.Sample(default, from, run.Random)!.Value)
            .All(s => Math.Abs(s.Weight.R - (s.Direction.Z > 0 ? both[0] : both[1]).Weight.R) < 1e-9);
        run.Require(
            facts.Select(f => f.Holds || !isCountedTwice ? f : f with { Sentence = "You have counted the share twice: a direction that is chosen with the probability F has the weight F/F = 1." }),
            _ => isCountedTwice);
    }

    [Check("rough metal: tilts and masking", 1)]
    public static void Tilts(CheckRun run)
    {
        run.Compare(new Trial<Pair>
        {
            Draw = draws => Pair.Draw(draws, "alpha", 0.1, 1),
            Found = p => new RoughMetal(p.Roughness).Distribution(p.ToLight),
            Expected = p => p.Tilts(p.Roughness),
            Mistakes =
            [
                ("You have squared α twice: α is the roughness itself here, and α² stands in the formula.", p => p.Tilts(p.Roughness * p.Roughness)),
                ("You have used α where α² is needed.", p => p.Tilts(Math.Sqrt(p.Roughness))),
                ("Your distribution is π times too large: D · cosine must integrate to 1 over the hemisphere.", p => Math.PI * p.Tilts(p.Roughness)),
                ("You have cos²θ in the place of cos⁴θ.", p => p.Tilts(p.Roughness) * p.ToLight.Z * p.ToLight.Z),
            ],
        });
        run.Compare(new Trial<Pair>
        {
            Draw = draws => Pair.Draw(draws, "alpha", 0.1, 1),
            Found = p => new RoughMetal(p.Roughness).Visible(p.ToLight),
            Expected = p => p.Visible(p.ToLight),
            Mistakes = [("That is half of what is seen: the 2 above the fraction is missing.", p => p.Visible(p.ToLight) / 2)],
        });
    }

    [Check("rough metal: values", 1)]
    public static void MetalValues(CheckRun run) => run.Compare(new Trial<Pair>
    {
        Draw = draws => Pair.Draw(draws, "alpha", 0.1, 1),
        Found = p => new RoughMetal(p.Roughness).Evaluate(default, p.ToViewer, p.ToLight).R,
        Expected = p => p.Metal(),
        Mistakes =
        [
            ("The 4 below the fraction is missing: a mirror that is turned by an angle turns the light by twice as much, in both directions.", p => 4 * p.Metal()),
            ("One of the cosines below the fraction is missing.", p => p.Metal() * p.ToLight.Z),
            ("One of the cosines below the fraction is missing.", p => p.Metal() * p.ToViewer.Z),
            ("Both cosines below the fraction are missing.", p => p.Metal() * p.ToLight.Z * p.ToViewer.Z),
            ("Only one of the two directions is masked: G₁ is needed for the viewer and for the light.", p => p.Metal() / p.Visible(p.ToLight)),
            ("Only one of the two directions is masked: G₁ is needed for the viewer and for the light.", p => p.Metal() / p.Visible(p.ToViewer)),
        ],
    });

    [Check("rough metal: sampling, energy and reciprocity", 2)]
    public static void MetalFacts(CheckRun run)
    {
        RoughMetal metal = new(0.25 + (0.5 * run.Random.Next()));
        run.Compare(new Trial<Pair>
        {
            Draw = draws => Pair.Draw(draws, "alpha", 0.1, 1),
            Found = p => new RoughMetal(p.Roughness).Pdf(default, p.ToViewer, p.ToLight),
            Expected = p => p.Pdf(),
            Mistakes =
            [
                ("Your density is that of tilts, not of directions: a mirror turns the light by twice its own angle, so that directions are spread 4 · (from · tilt) times as wide.", p => p.Pdf() * 4 * Vector.Dot(p.ToViewer, p.Tilt)),
                ("The cosine of the tilt is missing: D counts the area of mirrors, of which those that are tilted cover less of the surface.", p => p.Pdf() / p.Tilt.Z),
            ],
        });
        Require(run, metal, 1);
    }

    [Check("three balls", 0)]
    public static void Picture(CheckRun run) => run.Show(Gallery.Picture());

    private static long Seed(CheckRun run) => (long)(run.Random.Next() * int.MaxValue);

    private static void Require(CheckRun run, IMaterial material, double index) =>
        run.Require(new MaterialFacts(material, new() { RefractiveIndex = index }, Seed(run), Samples).All());

    /// <summary>Two directions above a surface, and its roughness.</summary>
    private sealed record Pair(double Roughness, Vector ToViewer, Vector ToLight)
    {
        public Vector Tilt => (ToViewer + ToLight).Unit;

        public static Pair Draw(Draws draws, string roughness, double low, double high) =>
            new(draws.Number(roughness, low, high), draws.DirectionAbove("viewer"), draws.DirectionAbove("light"));

        // By angles, as in the paper.
        public double OrenNayar(bool isClamped = true, bool isChanged = false, double power = 2)
        {
            double s2 = Math.Pow(Roughness, power);
            double a = 1 - (0.5 * s2 / (s2 + 0.33));
            double b = 0.45 * s2 / (s2 + 0.09);
            double viewer = Math.Acos(Math.Min(1, ToViewer.Z));
            double light = Math.Acos(Math.Min(1, ToLight.Z));
            double cosine = Math.Cos(Math.Atan2(ToViewer.Y, ToViewer.X) - Math.Atan2(ToLight.Y, ToLight.X));
            (double alpha, double beta) = (Math.Max(viewer, light), Math.Min(viewer, light));
            (alpha, beta) = isChanged ? (beta, alpha) : (alpha, beta);
            return (a + (b * (isClamped ? Math.Max(0, cosine) : cosine) * Math.Sin(alpha) * Math.Tan(beta))) / Math.PI;
        }

        public double Tilts(double alpha)
        {
            double tan2 = (1 / (ToLight.Z * ToLight.Z)) - 1;
            return alpha * alpha / (Math.PI * Math.Pow(ToLight.Z, 4) * Math.Pow((alpha * alpha) + tan2, 2));
        }

        public double Visible(Vector direction) => 2 / (1 + Math.Sqrt(1 + (Roughness * Roughness * ((1 / (direction.Z * direction.Z)) - 1))));

        // By the textbook's class, without loss.
        public double Metal() => new Ggx(new Solid(new Rgb(Roughness)), new Reflectance(default, default, new Solid(Rgb.White))).Evaluate(default, ToViewer, ToLight).R;

        public double Pdf() => (this with { ToLight = Tilt }).Tilts(Roughness) * Tilt.Z / (4 * Vector.Dot(ToViewer, Tilt));
    }

    /// <summary>A direction above a boundary, and the ratio of the indices.</summary>
    private sealed record Boundary(Vector From, double Eta)
    {
        public double Below => -Refracted(Eta)!.Value.Z;

        public static Boundary? Draw(Draws draws)
        {
            Boundary drawn = new(draws.DirectionAbove("from"), draws.Number("eta", 0.4, 2.5));
            double sine = drawn.Eta * Math.Sqrt(1 - (drawn.From.Z * drawn.From.Z));
            return Math.Abs(sine - 1) > 1e-3 && Math.Abs(drawn.Eta - 1) > 0.05 ? drawn : null;
        }

        // By angles.
        public Vector? Refracted(double eta)
        {
            double level = Math.Sqrt((From.X * From.X) + (From.Y * From.Y));
            double angle = Math.Asin(eta * level);
            return double.IsNaN(angle) ? null : new Vector(-From.X * eta, -From.Y * eta, -Math.Cos(angle));
        }

        public double Amplitudes()
        {
            double parallel = (From.Z - (Eta * Below)) / (From.Z + (Eta * Below));
            double across = ((Eta * From.Z) - Below) / ((Eta * From.Z) + Below);
            return 0.5 * (parallel + across);
        }
    }
}
