using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;
using RayTracer.Tests.Statistics;
using RayTracer.Textures;

namespace RayTracer.Tests.Materials;

/// <summary>
/// Scattering of particles of light, of every material: the cases of <see cref="MaterialCase"/>.
/// Covers `Adjoint`.
/// </summary>
[Trait("Category", "Thorough")]
public class AdjointTests
{
    // Quadrature of lobes that horizons cut.
    private const double Quadrature = 2e-3;

    // Where the directions' order matters otherwise than in all those.
    private static readonly MaterialCase[] s_cases =
    [
        .. MaterialCase.All,
        new("one-sided glass", new OneSidedMaterial(new DielectricMaterial(1.5f, Rgb.Black, FresnelModel.Exact))),
        new("one-sided leaf", new OneSidedMaterial(new TranslucentMaterial(Solid(0.3f), Solid(0.5f)))),
        new("embossed glass", new NormalMapMaterial(new DielectricMaterial(1.5f, Rgb.Black, FresnelModel.Exact), new SolidTexture(new(0.85f, 0.5f, 0.75f)), 1) { SoftensShadow = true }),
        new("turned glass", new NormalMapMaterial(new DielectricMaterial(1.5f, Rgb.Black, FresnelModel.Exact), new SolidTexture(new(0.85f, 0.5f, 0.75f)), 1) { Turned = TurnedNormal.Back }),
        new("embossed lace", new BumpMapMaterial(new MaskMaterial(new OneSidedMaterial(new TranslucentMaterial(Solid(0.3f), Solid(0.5f))), Solid(0.5f)), new UvTexture(), 0.5f) { Turned = TurnedNormal.Back }),
        new("velvet behind lace", new MaskMaterial(new Velvet(), Solid(0.8f))),
    ];

    public static TheoryData<string> Cases() => [.. s_cases.Select(c => c.Name)];

    [Theory]
    [MemberData(nameof(Cases))]
    public void What_is_seen_from_the_other_direction_is_what_a_surface_described_from_there_shows(string name)
    {
        Material material = Of(name).Material;
        Random random = new(TestSettings.Seed);
        foreach (ShadedSurface at in ShadedSurface.All)
        {
            for (int i = 0; i < 64; i++)
            {
                bool isParticle = i % 2 == 0;
                Vec3W incoming = -RandomDirections(random);
                SurfaceW surface = at.Meet(material, incoming);
                surface.CarriesLight = isParticle;
                Vec3W direction = i % 4 < 2 ? RandomDirections(random) : NearMirror(random, surface, Of(name).Exponent);
                SurfaceW before = surface;
                Adjoint.ReversePdf(material, ref surface, direction, out FloatW pdf);
                Adjoint.Evaluate(material, ref surface, direction, out RgbW scattered, out FloatW cameraPdf);
                AssertSame(before, surface);

                SurfaceW back = at.Meet(material, -direction);
                material.Evaluate(back, -incoming, out RgbW bsdf, out FloatW expectedCameraPdf);
                back.CarriesLight = !isParticle;
                material.Pdf(back, -incoming, out FloatW expectedPdf);
                for (int lane = 0; lane < FloatW.Count; lane++)
                {
                    Vector3D to = Vector3D.Of(direction, lane);
                    Vector3D from = -Vector3D.Of(incoming, lane);
                    Vector3D facing = Vector3D.Of(back.Facing, lane);
                    if (IsOnEdge(at, to, from, facing))
                    {
                        continue;
                    }

                    bool leaks = at.Leaks(material, to, from, facing);
                    double factor = leaks ? 0 : Math.Abs(from.Dot(facing) / from.Dot(at.Normal) * to.Dot(at.Normal));
                    AssertNear(expectedPdf[lane], pdf[lane], $"reverse density of {name} at {at}");
                    AssertNear(expectedCameraPdf[lane], cameraPdf[lane], $"a camera's density of {name} at {at}");
                    AssertNear(leaks ? 0 : bsdf.G[lane] * factor, scattered.G[lane], $"what {name} at {at} scatters");
                }
            }
        }
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Particles_are_scattered_by_the_pdf_and_weigh_what_the_adjoint_bsdf_scatters(string name)
    {
        MaterialCase material = Of(name);
        ShadedSurface at = ShadedSurface.All[0];
        SurfaceW surface = at.Meet(material.Material, (Vector3)Incoming(at, 0.6, IsFromInside(material)));
        surface.CarriesLight = true;
        int points = Math.Clamp(material.QuadraturePoints / 2, 4, 12);
        SphericalGrid grid = new(Vector3D.Of(Vec3W.Reflect(surface.Incoming, surface.Facing)).Unit, Vector3D.Of(surface.Facing), 1 / (material.Exponent + 1), points);
        double[] expected = new double[SphericalGrid.Count + 1];
        double integral = 0;
        foreach (GridPoint[] packet in grid.Points().Chunk(FloatW.Count))
        {
            Vec3W direction = Load([.. packet.Select(p => p.Direction)]);
            material.Material.Pdf(surface, direction, out FloatW pdf);
            Adjoint.Evaluate(material.Material, ref surface, direction, out RgbW scattered, out _);
            for (int lane = 0; lane < packet.Length; lane++)
            {
                expected[packet[lane].Cell] += pdf[lane] * packet[lane].Weight;
                Assert.True(pdf[lane] > 0 || scattered.G[lane] <= 1e-4 || material.Material.Traits.TurnsNormal, $"{material} scatters {scattered.G[lane]} of particles to {packet[lane].Direction}, but none go there");
                integral += pdf[lane] > 0 ? scattered.G[lane] * packet[lane].Weight : 0;
            }
        }

        int count = TestSettings.Scale(1 << 14, 1 << 16);
        double mass = expected.Sum();
        expected[^1] = 1 - mass;
        expected = [.. expected.Select(p => Math.Max(p * count, 1e-3))];
        double[] observed = new double[expected.Length];
        double[] weights = new double[count];
        VertexSamples samples = new(new IndependentSampler(count));
        for (int first = 0; first < count; first += FloatW.Count)
        {
            samples.Begin(Hash.PixelKey((uint)TestSettings.Seed, 1), UIntW.Iota + (uint)first, 0u);
            Adjoint.Scatter(material.Material, ref surface, samples, out ScatterW scatter, out _, out _);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                bool counts = !Has(scatter.Absorbed | scatter.Delta, lane);
                observed[counts ? grid.CellOf(Vector3D.Of(scatter.Direction, lane)) : SphericalGrid.Count]++;
                weights[first + lane] = counts ? scatter.Weight.G[lane] : 0;
            }
        }

        ErrorBudget.Materials.Check(PValues.ChiSquared(observed, expected), $"directions of particles at {material}");
        double tolerance = Quadrature * (material.Material.Traits.TurnsNormal ? 5 : 1);
        ErrorBudget.Materials.Check(PValues.Mean(weights, integral, (tolerance * integral) + 1e-6), $"mean weight of particles at {material}, {weights.Average():G6} instead of {integral:G6}");
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Particles_bring_the_camera_as_much_light_as_its_paths_find(string name)
    {
        // ∫∫ h(o) f(o, l) g(l) over directions o to the camera and l to the light, with the cosines: by paths from o, and by particles from l.
        // Not by what the inside absorbed on the way here, which differs.
        Material material = Of(name).Material;
        foreach (ShadedSurface at in ShadedSurface.All)
        {
            Random random = new(TestSettings.Seed + 1);
            Pattern g = new(random, at.Normal);
            Pattern h = new(random, default);
            int count = TestSettings.Scale(1 << 13, 1 << 16);
            double[] found = Sample(count, 2, random, (o, samples) =>
            {
                SurfaceW surface = at.Meet(material, -o);
                surface.Distance = 0f;
                material.Scatter(surface, samples, out ScatterW scatter);
                SurfaceW back = at.Meet(material, -scatter.Direction);
                back.CarriesLight = true;
                material.Pdf(back, o, out FloatW particlePdf);
                return lane => IsDropped(at, material, scatter, surface, back, particlePdf, lane) ? 0 : h.At(o, lane) * scatter.Weight.G[lane] * g.At(scatter.Direction, lane) * Cosine(at, o, lane);
            });
            double[] brought = Sample(count, 3, random, (l, samples) =>
            {
                SurfaceW surface = at.Meet(material, -l);
                surface.Distance = 0f;
                Adjoint.Scatter(material, ref surface, samples, out ScatterW scatter, out _, out _);
                return lane => Has(scatter.Absorbed, lane) ? 0 : g.At(l, lane) * scatter.Weight.G[lane] * h.At(scatter.Direction, lane) * Cosine(at, l, lane);
            });
            double z = (found.Average() - brought.Average()) / Math.Sqrt((Variance(found) + Variance(brought)) / count);
            ErrorBudget.Materials.Check(double.IsNaN(z) && found.Max() == 0 && brought.Max() == 0 ? 1 : PValues.Normal(z), $"{name} at {at}: particles bring {brought.Average():G6}, paths find {found.Average():G6}");
        }
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void No_surface_sends_on_more_power_than_arrives_and_clear_ones_send_all(string name)
    {
        MaterialCase material = Of(name);
        MaterialTraits traits = material.Material.Traits;
        if (traits.ReciprocityException is not null || traits.EnergyException is not null || traits.TurnsNormal)
        {
            return;
        }

        ShadedSurface at = ShadedSurface.All[0];
        foreach ((double cosine, bool inside) in ((double, bool)[])[(0.9, false), (0.5, true), (0.3, false), (0.8, true)])
        {
            SurfaceW surface = at.Meet(material.Material, (Vector3)Incoming(at, cosine, inside));
            VertexSamples samples = new(new GridSampler(6));
            double mean = 0;
            for (int first = 0; first < 1 << 12; first += FloatW.Count)
            {
                samples.Begin(0u, UIntW.Iota + (uint)first, 0u);
                Adjoint.Scatter(material.Material, ref surface, samples, out ScatterW scatter, out _, out _);
                for (int lane = 0; lane < FloatW.Count; lane++)
                {
                    mean += Has(scatter.Absorbed, lane) ? 0 : scatter.Weight.G[lane] / (1 << 12);
                }
            }

            Assert.True(mean < 1 + 5e-3, $"{material} at a cosine of {cosine} sends on {mean}");
            Assert.True(material.Albedo != Rgb.White || mean > 1 - 5e-3, $"{material} at a cosine of {cosine} keeps all but {mean}");
        }
    }

    [Fact]
    public void Refraction_leaves_the_power_of_a_particle_as_it_is_but_for_what_the_inside_absorbed_on_its_way()
    {
        Material glass = new DielectricMaterial(1.5f, new(0.1f, 0.5f, 2), FresnelModel.Exact);
        ShadedSurface at = ShadedSurface.All[0];
        foreach (bool inside in new[] { false, true })
        {
            SurfaceW surface = at.Meet(glass, (Vector3)Incoming(at, 0.9, inside));
            VertexSamples samples = new(new GridSampler(4));
            samples.Begin(0u, UIntW.Iota, 0u);
            Adjoint.Scatter(glass, ref surface, samples, out ScatterW scatter, out _, out _);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                Assert.Equal(inside ? Math.Exp(-0.1 * SurfaceCase.Distance) : 1, scatter.Weight.R[lane], 1e-6);
                Assert.Equal(inside ? Math.Exp(-2 * SurfaceCase.Distance) : 1, scatter.Weight.B[lane], 1e-6);
            }
        }
    }

    private static MaterialCase Of(string name) => s_cases.Single(c => c.Name == name);

    private static SolidTexture Solid(float value) => new(new(value, value, value));

    [Fact]
    public void A_refracted_particle_meets_the_coat_as_often_as_the_path_of_a_camera_from_its_other_side()
    {
        Material coat = new DiffuseSpecularMaterial(new DiffuseMaterial(Solid(1)), new DielectricMaterial(1.5f, Rgb.Black, FresnelModel.Exact), 0.1f);
        ShadedSurface at = ShadedSurface.All[0];
        SurfaceW surface = at.Meet(coat, (Vector3)Incoming(at, 0.8, inside: true));
        double outside = Math.Sqrt(1 - (1.5 * 1.5 * (1 - (0.8 * 0.8))));
        int refracted = 0;
        VertexSamples samples = new(new GridSampler(5));
        for (int first = 0; first < 1 << 10; first += FloatW.Count)
        {
            samples.Begin(0u, UIntW.Iota + (uint)first, 0u);
            Adjoint.Scatter(coat, ref surface, samples, out ScatterW scatter, out _, out _);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                if (Has(scatter.Delta, lane) && Vector3D.Of(scatter.Direction, lane).Dot(at.Normal) > 0)
                {
                    // It is chosen by the root of the share on the particle's side.
                    Assert.Equal(Fresnel.Schlick((float)outside, 0.1f)[0], scatter.Weight.G[lane] * Math.Sqrt(Fresnel.Schlick(0.8f, 0.1f)[0]), 1e-5);
                    refracted++;
                }
            }
        }

        Assert.True(refracted > 0);
    }

    // Where a normal was mirrored into view for the camera, particles may not find the way to it.
    private static bool IsDropped(ShadedSurface at, Material material, in ScatterW scatter, in SurfaceW surface, in SurfaceW back, in FloatW particlePdf, int lane)
    {
        Vector3D facing = Vector3D.Of(surface.Facing, lane);
        bool isOther = Math.Abs(facing.Dot(Vector3D.Of(back.Facing, lane))) < 1 - 1e-6;
        return Has(scatter.Absorbed, lane)
            || at.Leaks(material, -Vector3D.Of(surface.Incoming, lane), Vector3D.Of(scatter.Direction, lane), facing)
            || (isOther && (Has(scatter.Delta, lane) || particlePdf[lane] <= 0));
    }

    // Estimates of an integral over the sphere.
    private static double[] Sample(int count, int stream, Random random, Func<Vec3W, VertexSamples, Func<int, double>> estimate)
    {
        VertexSamples samples = new(new IndependentSampler(count));
        double[] values = new double[count];
        for (int first = 0; first < count; first += FloatW.Count)
        {
            samples.Begin(Hash.PixelKey((uint)TestSettings.Seed, (uint)stream), UIntW.Iota + (uint)first, 0u);
            Func<int, double> value = estimate(RandomDirections(random), samples);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                values[first + lane] = value(lane);
            }
        }

        return values;
    }

    private static double Variance(double[] values)
    {
        double mean = values.Average();
        return values.Sum(v => (v - mean) * (v - mean)) / (values.Length - 1);
    }

    private static double Cosine(ShadedSurface at, in Vec3W direction, int lane) => Math.Abs(Vector3D.Of(direction, lane).Dot(at.Normal));

    private static Vector3D Incoming(ShadedSurface at, double cosine, bool inside)
    {
        Vector3D facing = inside ? -at.Normal : at.Normal;
        return (facing * -cosine) + (facing.Perpendicular() * Math.Sqrt(1 - (cosine * cosine)));
    }

    private static bool IsFromInside(MaterialCase material) => material.SeenFromBehind && material.Name.Length % 2 == 1;

    private static Vec3W RandomDirections(Random random) => Load([.. Enumerable.Range(0, FloatW.Count).Select(_ => RandomDirection(random))]);

    private static Vector3D RandomDirection(Random random)
    {
        double z = (2 * random.NextDouble()) - 1;
        double turn = 2 * Math.PI * random.NextDouble();
        double r = Math.Sqrt(1 - (z * z));
        return new(r * Math.Cos(turn), r * Math.Sin(turn), z);
    }

    // Where narrow lobes are.
    private static Vec3W NearMirror(Random random, in SurfaceW surface, double exponent)
    {
        Vec3W mirror = Vec3W.Reflect(surface.Incoming, surface.Facing);
        return Load([.. Enumerable.Range(0, FloatW.Count).Select(lane => (Vector3D.Of(mirror, lane) + (RandomDirection(random) * (2 / Math.Sqrt(1 + exponent)))).Unit)]);
    }

    private static Vec3W Load(Vector3D[] directions)
    {
        float[][] lanes = [new float[FloatW.Count], new float[FloatW.Count], new float[FloatW.Count]];
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            Vector3D d = directions[Math.Min(lane, directions.Length - 1)];
            (lanes[0][lane], lanes[1][lane], lanes[2][lane]) = ((float)d.X, (float)d.Y, (float)d.Z);
        }

        return new(new(new Vector<float>(lanes[0])), new(new Vector<float>(lanes[1])), new(new Vector<float>(lanes[2])));
    }

    // Rounding decides there.
    private static bool IsOnEdge(ShadedSurface at, Vector3D one, Vector3D other, Vector3D facing) =>
        new[] { at.Normal, at.Shading, facing }.Any(n => Math.Abs(n.Dot(one)) < 1e-3 || Math.Abs(n.Dot(other)) < 1e-3);

    private static void AssertSame(in SurfaceW expected, in SurfaceW actual)
    {
        Assert.Equal(Vector3D.Of(expected.Incoming), Vector3D.Of(actual.Incoming));
        Assert.Equal(Vector3D.Of(expected.Facing), Vector3D.Of(actual.Facing));
        Assert.Equal(Vector3D.Of(expected.Tangent), Vector3D.Of(actual.Tangent));
        Assert.Equal(expected.DiffuseColor.G[0], actual.DiffuseColor.G[0]);
        Assert.Equal(expected.Cosine[0], actual.Cosine[0]);
        Assert.Equal(expected.Inside.Bits, actual.Inside.Bits);
        Assert.Equal(expected.CarriesLight, actual.CarriesLight);
    }

    private static bool Has(MaskW mask, int lane) => (mask.Bits >> lane & 1) != 0;

    private static void AssertNear(double expected, double actual, string what) =>
        Assert.True(Math.Abs(expected - actual) <= 1e-6 + (1e-2 * Math.Max(Math.Abs(expected), Math.Abs(actual))), $"{what}: {actual:G7} instead of {expected:G7}");

    // A material of somebody else's, whose preparation depends on the ray.
    private sealed class Velvet : Material
    {
        public override MaterialTraits Traits { get; } = new() { Specular = SpecularLobe.Glossy, ReciprocityException = "it is brighter where it is seen at an angle" };

        public override void Prepare(ref SurfaceW surface)
        {
            FloatW brightness = FloatW.MultiplyAdd(surface.Cosine, -0.8f, 1f);
            surface.DiffuseColor = new(brightness, brightness, brightness);
        }

        public override void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf) =>
            bsdf = (Vec3W.Dot(direction, surface.Facing) > 0f).Select(surface.DiffuseColor * (1f / float.Pi), default);

        public override void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf) =>
            pdf = Warp.CosineHemispherePdf(Vec3W.Dot(direction, surface.Facing));

        public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
        {
            samples.Direction(out FloatW u, out FloatW v);
            Onb.FromNormal(surface.Facing, out Onb frame);
            scatter = new() { Direction = frame.ToWorld(Warp.CosineHemisphere(u, v)), Weight = surface.DiffuseColor, Specular = MaskW.All };
        }
    }

    // A function of directions: smooth, but for a step, and more on one side of the surface.
    private sealed class Pattern(Random random, Vector3D side)
    {
        private readonly Vector3D _slope = RandomDirection(random);
        private readonly Vector3D _ridge = RandomDirection(random);
        private readonly Vector3D _step = RandomDirection(random);

        public double At(in Vec3W direction, int lane)
        {
            Vector3D d = Vector3D.Of(direction, lane);
            double ridge = d.Dot(_ridge);
            return 1 + (0.8 * d.Dot(_slope)) + (ridge * ridge) + (d.Dot(_step) > 0 ? 0.7 : 0) + (d.Dot(side) > 0 ? 2 : 0);
        }
    }
}
