namespace RayTracer.Textbook.Tests;

/// <summary>What is chosen at random has the density that is stated; materials create no energy, and those that should be are reciprocal.</summary>
public class SamplingTests
{
    private const int Count = 1 << 17;
    private static readonly Hit s_outside = new() { Normal = new(0, 0, 1), Shading = new(0, 0, 1), Frame = new(new(0, 0, 1)), Distance = 1 };
    private static readonly double[] s_cosines = [1, 0.7, 0.3, 0.05];

    // The lobe's exponent says how fine the grid must be around the mirror direction.
    private static readonly Dictionary<string, (IMaterial Material, double Exponent, bool IsReciprocal)> s_materials = new()
    {
        ["diffuse"] = (new Diffuse(Grey(0.8)), 0, true),
        ["ggx 0.1"] = (new Ggx(Grey(0.1), new(Rgb.Black, Rgb.Black, Grey(1))), 100, true),
        ["ggx 0.5"] = (new Ggx(Grey(0.5), new(new(0.2, 0.9, 1.1), new(3.9, 2.4, 2.1), Grey(1))), 4, true),
        ["phong"] = (new Phong(Grey(0.4), Grey(0.6), 20, null), 20, false),
        ["phongMetal"] = (new Phong(Grey(0), Grey(1), 100, null), 100, false),
        ["coat"] = (new Coated(new Diffuse(Grey(1)), new Phong(Grey(0), Grey(1), 50, null), 0.04), 50, false),
    };

    private static readonly Dictionary<string, IShape> s_shapes = new()
    {
        ["sphere"] = new Sphere(new(0, 0, 3), 1.5),
        ["rectangle"] = new Rectangle(new(-1, -1, 2), new(2, 0, 0.5), new(0, 2, 0)),
        ["triangle"] = new Triangle(new(-1, -1, 2), new(1, -1, 2.5), new(0, 1, 2), default),
        ["disk"] = new Disk(new(-1, -1, 2), new(2, 0, 1), new(0, 2, 0)),
        ["box"] = new Box(new(new(-1, -0.5, 2), new(1, 0.7, 4))),
        ["torus"] = new Placed(new Torus(1, 0.4), Transform.Translation(new(0, 0, 3)).After(Transform.Rotation(new(1, 1, 0), 50))),
        ["mesh"] = new Mesh([new(-1, -1, 2), new(1, -1, 2), new(1, 1, 3), new(-1, 1, 2)], [(0, 1, 2), (0, 2, 3)]),
        ["stretched sphere"] = new Placed(new Sphere(default, 1), Transform.Translation(new(0, 0, 3)).After(Transform.Scaling(new(1.5, 0.5, 1)))),
    };

    public static TheoryData<string> Materials => [.. s_materials.Keys];

    public static TheoryData<string> Shapes => [.. s_shapes.Keys];

    [Theory]
    [MemberData(nameof(Materials))]
    public void Directions_are_distributed_by_the_pdf(string name)
    {
        (IMaterial material, double exponent, _) = s_materials[name];
        foreach (double cosine in s_cosines)
        {
            Vector from = From(cosine);
            SphericalGrid grid = new(Of(Refraction.Reflect(from)), new(0, 0, 1), 1 / (exponent + 1), 16);
            double[] expected = grid.Integrate(d => material.Pdf(s_outside, from, Of(d)));
            double mass = expected.Sum();
            Assert.True(mass < 1 + 1e-3, $"{name}: the pdf integrates to {mass}");
            expected = [.. expected.Append(Math.Max(0, 1 - mass)).Select(p => Math.Max(p, 1e-7) * Count)];
            double[] observed = new double[expected.Length];
            IndependentSampler sampler = Sampler(cosine);
            for (int i = 0; i < Count; i++)
            {
                observed[material.Sample(s_outside, from, sampler) is { } s ? grid.CellOf(Of(s.Direction)) : SphericalGrid.Count]++;
            }

            ErrorBudget.Textbook.Check(PValues.ChiSquared(observed, expected), $"directions of {name} at {cosine}");
        }
    }

    [Theory]
    [MemberData(nameof(Materials))]
    public void The_mean_weight_is_the_integral_of_the_bsdf_and_no_energy_is_created(string name)
    {
        (IMaterial material, double exponent, _) = s_materials[name];
        foreach (double cosine in s_cosines)
        {
            Vector from = From(cosine);
            IndependentSampler sampler = Sampler(cosine);
            double[] weights = new double[Count];
            for (int i = 0; i < Count; i++)
            {
                weights[i] = material.Sample(s_outside, from, sampler)?.Weight.G ?? 0;
            }

            SphericalGrid grid = new(Of(Refraction.Reflect(from)), new(0, 0, 1), 1 / (exponent + 1), 16);
            double integral = grid.Integrate(d => d.Z > 0 ? material.Evaluate(s_outside, from, Of(d)).G * d.Z : 0).Sum();
            ErrorBudget.Textbook.Check(PValues.Mean(weights, integral, tolerance: 1e-3), $"energy of {name} at {cosine}");
            Assert.InRange(integral, 0, 1 + 1e-3);
        }
    }

    [Theory]
    [MemberData(nameof(Materials))]
    public void What_should_be_reciprocal_is(string name)
    {
        (IMaterial material, _, bool isReciprocal) = s_materials[name];
        IndependentSampler sampler = Sampler(0);
        double largest = 0;
        for (int i = 0; i < 1000; i++)
        {
            (Vector a, Vector b) = (Warp.CosineHemisphere(sampler.Next2()), Warp.CosineHemisphere(sampler.Next2()));
            double there = material.Evaluate(s_outside, a, b).G;
            largest = Math.Max(largest, Math.Abs(there - material.Evaluate(s_outside, b, a).G) / (there + 1e-12));
        }

        Assert.Equal(isReciprocal, largest < 1e-9);
    }

    [Theory]
    [InlineData(1.5)]
    [InlineData(2.4)]
    [InlineData(0.7)]
    public void Fresnels_equations_are_those_of_the_books(double index)
    {
        // Along the normal; at Brewster's angle, where none of the light that swings in the plane of incidence is reflected; and at a glance.
        Assert.Equal(Math.Pow((index - 1) / (index + 1), 2), Refraction.Fresnel(1, 1, 1 / index), 12);
        double cosine = 1 / Math.Sqrt(1 + (index * index));
        double transmitted = Math.Sqrt(1 - ((1 - (cosine * cosine)) / (index * index)));
        double perpendicular = ((index * index) - 1) / ((index * index) + 1);
        Assert.Equal(0.5 * perpendicular * perpendicular, Refraction.Fresnel(cosine, transmitted, 1 / index), 12);
        Assert.Equal(1, Refraction.Fresnel(0, 0.5, 1 / index), 12);
    }

    [Fact]
    public void Points_of_lenses_and_of_a_torus_are_uniform()
    {
        // Mean squares of a disk and of a square are 1/4 and 1/3; and of a torus, the outer half has 1/2 + r/πR of the area.
        IndependentSampler sampler = Sampler(3);
        ILens[] lenses = [new RoundLens(new(1, 0, 0), new(0, 1, 0)), new SquareLens(new(1, 0, 0), new(0, 1, 0)), new EyeJitter(Transform.Scaling(new(2, 2, 2)))];
        double[] expected = [0.25, 1.0 / 3, 1.0 / 3];
        for (int lens = 0; lens < lenses.Length; lens++)
        {
            Vector[] points = [.. Enumerable.Range(0, Count).Select(_ => lenses[lens].Point(sampler))];
            ErrorBudget.Textbook.Check(PValues.Mean([.. points.Select(p => p.X * p.X)], expected[lens]), $"lens {lens}, along");
            ErrorBudget.Textbook.Check(PValues.Mean([.. points.Select(p => p.Y * p.Y)], expected[lens]), $"lens {lens}, across");
        }

        Torus torus = new(1, 0.5);
        double[] outer = [.. Enumerable.Range(0, Count).Select(_ => torus.PointAt(sampler.Next2()).Point is var p && Math.Sqrt((p.X * p.X) + (p.Z * p.Z)) > 1 ? 1.0 : 0)];
        ErrorBudget.Textbook.Check(PValues.Mean(outer, 0.5 + (0.5 / Math.PI)), "outer half of a torus");
    }

    [Theory]
    [InlineData(1.5, 0.9)]
    [InlineData(1.5, 0.2)]
    [InlineData(0.7, 0.9)]
    public void Glass_shares_light_out(double index, double cosine)
    {
        Dielectric glass = new(index, Rgb.Black, isSchlick: false, Grey(1), Grey(1));
        IReadOnlyList<Scattering> both = glass.Mirrors(s_outside, From(cosine));
        double eta2 = 1 / (index * index);
        Assert.Equal(1, both.Sum(m => m.Direction.Z > 0 ? m.Weight.G : m.Weight.G / eta2), 12);
        Assert.Equal(1, both.Sum(m => m.ParticleWeight.G), 12);

        // Snell's law: the sines are as the indices.
        Vector refracted = both.FirstOrDefault(m => m.Direction.Z < 0).Direction;
        double sine = Math.Sqrt(1 - (cosine * cosine));
        Assert.Equal(sine < index ? sine / index : 0, Math.Sqrt((refracted.X * refracted.X) + (refracted.Y * refracted.Y)), 12);
    }

    [Theory]
    [MemberData(nameof(Shapes))]
    public void Points_of_lights_are_distributed_by_the_pdf_and_rays_meet_them(string name)
    {
        IShape shape = s_shapes[name];
        IndependentSampler sampler = Sampler(0);
        Vector from = new(0.3, 0.2, 0);

        // 1/pdf over the chosen directions is the solid angle that the shape fills, seen from front and back where both are chosen.
        double[] inverse = new double[Count];
        for (int i = 0; i < Count; i++)
        {
            (SurfacePoint point, double pdf) = shape.PointSeenFrom(from, sampler.Next2());
            Vector direction = (point.Point - from).Unit;
            Hit hit = Hit.None();
            if (!shape.Intersect(new(from, direction), ref hit) && pdf < 1e3 && Math.Abs(Vector.Dot(direction, point.Normal)) > 1e-3)
            {
                Assert.Fail($"{name}: a ray to {point.Point} misses");
            }

            bool isSeen = hit.Distance > (point.Point - from).Length * (1 - 1e-6);
            inverse[i] = isSeen ? 1 / pdf : 0;
            if (isSeen && Math.Abs(Vector.Dot(direction, point.Normal)) > 1e-3)
            {
                shape.Describe(new(from, direction), ref hit);
                Assert.Equal(0, (hit.Point - point.Point).Length, 1e-6);
                Assert.Equal(0, (hit.Normal - point.Normal).Length, 1e-4);
                Assert.Equal(point.U, hit.U, 1e-6);
                Assert.Equal(point.V, hit.V, 1e-6);
                Assert.Equal(1, shape.SeenPdf(from, hit) / pdf, 1e-3);
            }
        }

        // The same by directions that know nothing of the shape.
        sampler = Sampler(1);
        double solid = 0;
        const int Directions = 1 << 20;
        for (int i = 0; i < Directions; i++)
        {
            Hit hit = Hit.None();
            solid += shape.Intersect(new(from, Warp.Sphere(sampler.Next2())), ref hit) ? 4 * Math.PI / Directions : 0;
        }

        double share = solid / (4 * Math.PI);
        ErrorBudget.Textbook.Check(PValues.Mean(inverse, solid, tolerance: 6 * 4 * Math.PI * Math.Sqrt(share * (1 - share) / Directions)), $"solid angle of {name}");
    }

    [Fact]
    public void Warps_are_distributed_by_their_pdfs()
    {
        IndependentSampler sampler = Sampler(7);
        Check("cosine", u => Warp.CosineHemisphere(u), d => Warp.CosineHemispherePdf(d.Z));
        Check("sphere", u => Warp.Sphere(u), _ => 1 / (4 * Math.PI));
        Check("power", u => Warp.CosinePower(u, 7), d => Warp.CosinePowerPdf(d.Z, 7));

        void Check(string name, Func<(double, double), Vector> warp, Func<Vector3D, double> pdf)
        {
            SphericalGrid grid = new(new(0, 0, 1), new(0, 0, 1), 1);
            double[] expected = [.. grid.Integrate(pdf).Select(p => Math.Max(p, 1e-9) * Count)];
            double[] observed = new double[expected.Length];
            for (int i = 0; i < Count; i++)
            {
                observed[grid.CellOf(Of(warp(sampler.Next2())))]++;
            }

            ErrorBudget.Textbook.Check(PValues.ChiSquared(observed, expected), $"warp {name}");
        }
    }

    [Fact]
    public void Stratified_samples_fill_each_cell_once_and_are_uniform()
    {
        const int Side = 7;
        StratifiedSampler sampler = new(Side, seed: 5);
        UnitSquareCounts counts = new();
        for (int pixel = 0; pixel < 400; pixel++)
        {
            HashSet<int> cells = [];
            HashSet<int> strata = [];
            for (int sample = 0; sample < Side * Side; sample++)
            {
                sampler.Begin(pixel, 3, sample);
                strata.Add((int)(sampler.Next() * Side * Side));
                (double u, double v) = sampler.Next2();
                cells.Add(((int)(u * Side) * Side) + (int)(v * Side));
                (double s, double t) = sampler.Next2();
                counts.Add((s * 5) % 1, (t * 3) % 1);
            }

            Assert.Equal(Side * Side, cells.Count);
            Assert.Equal(Side * Side, strata.Count);
        }

        Assert.True(counts.P() > 1e-6);
    }

    private static Solid Grey(double value) => new(new(value));

    private static IndependentSampler Sampler(double stream)
    {
        IndependentSampler sampler = new(TestSettings.Seed);
        sampler.Begin(1, (int)(stream * 100), 0);
        return sampler;
    }

    private static Vector From(double cosine) => new(Math.Sqrt(1 - (cosine * cosine)), 0, cosine);

    private static Vector3D Of(Vector v) => new(v.X, v.Y, v.Z);

    private static Vector Of(Vector3D v) => new(v.X, v.Y, v.Z);
}
