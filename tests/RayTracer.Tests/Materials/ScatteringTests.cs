using System.Numerics;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Tests.Statistics;
using RayTracer.Textures;

namespace RayTracer.Tests.Materials;

/// <summary>
/// What holds for the sampling of every material: the cases of <see cref="MaterialCase"/>.
/// Covers `Material`.
/// </summary>
[Trait("Category", "Thorough")]
public class ScatteringTests
{
    // 1,048,576 cells: what a horizon cuts off is known to a few in 100,000.
    private const int GridBits = 10;
    private static readonly double[] s_everyday = [1, 0.9, 0.6, 0.3, 0.1, 0.01];
    private static readonly double[] s_thorough = [1, 0.95, 0.8, 0.6, 0.4, 0.2, 0.05, 0.01, 0.001];

    public static TheoryData<string> Cases() => [.. MaterialCase.All.Select(c => c.Name)];

    [Theory]
    [MemberData(nameof(Cases))]
    public void Directions_are_distributed_by_the_pdf(string name) => ForEachSurface(name, (material, at) =>
    {
        SurfaceW surface = at.Prepare(material.Material);
        SphericalGrid grid = new(Mirror(surface), Facing(surface), 1 / (material.Exponent + 1), material.QuadraturePoints);
        int count = TestSettings.Scale(1 << 16, 1 << 18);
        double[] expected = new double[SphericalGrid.Count];
        ForEachPoint(grid, surface, material.Material.Pdf, (point, pdf) => expected[point.Cell] += point.Weight * pdf);
        double mass = expected.Sum();
        Assert.True(mass < 1 + 1e-4, $"{material} at {at}: the pdf integrates to {mass}");

        // The last cell counts the paths that end, and those of delta lobes. Rounding may carry a path into any cell.
        expected = [.. expected.Append(1 - mass).Select(p => Math.Max(p, 1e-7) * count)];
        double[] observed = new double[expected.Length];
        ScatterSamples.AtRandom(material.Material, surface, count, Stream(at), (in ScatterW s, int lane) =>
        {
            bool counts = !Has(s.Absorbed, lane) && !Has(s.Delta, lane);
            observed[counts ? grid.CellOf(Vector3D.Of(s.Direction, lane)) : SphericalGrid.Count]++;
        });
        ErrorBudget.Materials.Check(PValues.ChiSquared(observed, expected), $"directions of {material} at {at}");
    });

    [Theory]
    [MemberData(nameof(Cases))]
    public void The_mean_weight_is_the_integral_of_the_bsdf_and_the_cosine(string name) => ForEachSurface(name, (material, at) =>
    {
        // A million samples a surface: of the three pairs of everyday angles, one is looked at, by the seed.
        if (!TestSettings.Thorough && ((Array.IndexOf(s_everyday, at.Cosine) / 2) + TestSettings.Seed) % 3 != 0)
        {
            return;
        }

        SurfaceW surface = at.Prepare(material.Material);
        SphericalGrid grid = new(Mirror(surface), Facing(surface), 1 / (material.Exponent + 1), material.QuadraturePoints);
        double[] sampled = new double[4];
        ScatterSamples.OnGrid(material.Material, surface, GridBits, (in ScatterW s, int lane) =>
        {
            if (!Has(s.Absorbed, lane) && !Has(s.Delta, lane))
            {
                AddMoments(sampled, Vector3D.Of(s.Direction, lane), s.Weight.G[lane] * Cell);
            }
        });

        // Not only the energy but also where it goes on the whole: the mean direction.
        double[] integrals = new double[4];
        Vector3D facing = Facing(surface);
        ForEachPoint(grid, surface, Green(material), (point, green) => AddMoments(integrals, point.Direction, green * Math.Abs(point.Direction.Dot(facing)) * point.Weight));
        for (int k = 0; k < 4; k++)
        {
            AssertNear(integrals[k], sampled[k], material.MeanTolerance, $"moment {k} of {material} at {at}");
        }
    });

    [Theory]
    [MemberData(nameof(Cases))]
    public void No_surface_sends_back_more_than_arrives_and_some_send_all(string name) => ForEachSurface(name, (material, at) =>
    {
        SurfaceW surface = at.Prepare(material.Material);
        Vector3D albedo = default;
        ScatterSamples.OnGrid(material.Material, surface, GridBits - 2, (in ScatterW s, int lane) =>
            albedo += Has(s.Absorbed, lane) ? default : Flux(material, at, surface, s, lane) * Cell * 16);
        double most = material.Material.Traits.MostEnergy + material.AlbedoTolerance;
        Assert.True(material.Material.Traits.MostEnergy == 1 || material.Material.Traits.EnergyException is not null);
        Assert.True(Math.Max(albedo.X, Math.Max(albedo.Y, albedo.Z)) < most, $"{material} at {at} sends back {albedo}");
        if (material.Albedo is { } expected)
        {
            AssertNear(expected.R, albedo.X, material.AlbedoTolerance, $"red of {material} at {at}");
            AssertNear(expected.G, albedo.Y, material.AlbedoTolerance, $"green of {material} at {at}");
            AssertNear(expected.B, albedo.Z, material.AlbedoTolerance, $"blue of {material} at {at}");
        }
    });

    [Fact]
    public void The_principled_material_sends_back_more_than_arrives_where_its_declaration_says()
    {
        SolidTexture one = new(Rgb.White);
        PrincipledMaterial material = new(new() { BaseColor = one, Roughness = one, Sheen = one, Clearcoat = one, ClearcoatRoughness = one }, 10);
        SurfaceCase at = new(0.001);
        SurfaceW surface = at.Prepare(material);
        double albedo = 0;
        ScatterSamples.OnGrid(material, surface, GridBits - 2, (in ScatterW s, int lane) => albedo += Has(s.Absorbed, lane) ? 0 : s.Weight.G[lane] * Cell * 16);
        Assert.InRange(albedo, 1.95, material.Traits.MostEnergy);
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void What_lights_are_sampled_for_is_what_choices_that_are_not_specular_weigh(string name) => ForEachSurface(name, (material, at) =>
    {
        SurfaceW surface = at.Prepare(material.Material);
        double sampled = 0;
        ScatterSamples.OnGrid(material.Material, surface, GridBits - 2, (in ScatterW s, int lane) =>
            sampled += Has(s.Absorbed, lane) || Has(s.Specular, lane) ? 0 : s.Weight.G[lane] * Cell * 16);
        material.Material.Brdf(surface, out RgbW brdf);
        AssertNear(Math.PI * brdf.G[0], sampled, 1e-4, $"{material} at {at}");
        Assert.True(material.Material.Traits.IsLit || brdf.G[0] == 0);
    });

    [Theory]
    [MemberData(nameof(Cases))]
    public void The_matt_part_is_a_part_of_the_bsdf_and_holds_what_lights_are_sampled_for(string name) => ForEachSurface(name, (material, at) =>
    {
        SurfaceW surface = at.Prepare(material.Material);
        material.Material.Brdf(surface, out RgbW brdf);
        ScatterSamples.OnGrid(material.Material, surface, 4, (in ScatterW s, int lane) =>
        {
            Vector3D d = Vector3D.Of(s.Direction, lane);
            Vec3W direction = new((float)d.X, (float)d.Y, (float)d.Z);
            material.Material.Bsdf(surface, direction, out RgbW bsdf);
            material.Material.DiffuseBsdf(surface, direction, out RgbW matt);
            double least = d.Dot(Facing(surface)) > 0 ? brdf.G[0] : 0;
            Assert.True(matt.G[0] >= least * (1 - 1e-5) && matt.G[0] <= bsdf.G[0] * (1 + 1e-5), $"{material} at {at}: {least} ≤ {matt.G[0]} ≤ {bsdf.G[0]}");
        });
    });

    [Fact]
    public void The_matt_part_is_what_is_left_without_gloss()
    {
        SolidTexture color = new(new(0.2f, 0.4f, 0.6f));
        SolidTexture black = new(Rgb.Black);
        SolidTexture half = new(new(0.5f, 0.5f, 0.5f));
        PrincipledMaterial Cloth(float metallic) => new(new() { BaseColor = color, Roughness = half, Sheen = half, Flatness = half, Metallic = new SolidTexture(new(metallic, metallic, metallic)) }, 1.5f);
        (Material Glossy, Material Matt)[] pairs =
        [
            (new PhongMaterial(null, color, new SolidTexture(new(0.3f, 0.3f, 0.3f)), 10), new PhongMaterial(null, color, black, 10)),
            (new RoughPlasticMaterial(color, 1.5f, true, new SolidTexture(Rgb.White), MicrofacetDistribution.Ggx, 0.3f), new RoughPlasticMaterial(color, 1.5f, true, black, MicrofacetDistribution.Ggx, 0.3f)),
            (new MixMaterial(new DiffuseMaterial(color), new RoughConductorMaterial(new(Metal.Gold), new(MicrofacetDistribution.Ggx, new SolidTexture(Rgb.White), new SolidTexture(Rgb.White)), color), color), new MixMaterial(new DiffuseMaterial(color), new DiffuseMaterial(black), color)),
            (new DiffuseSpecularMaterial(new DiffuseMaterial(color), new PhongMetalMaterial(color, 5), 0.1f), new DiffuseSpecularMaterial(new DiffuseMaterial(color), new PhongMetalMaterial(black, 5), 0.1f)),
            (Cloth(0.4f), Cloth(0)),
        ];
        Random random = new(7);
        for (int i = 0; i < pairs.Length; i++)
        {
            SurfaceW surface = new SurfaceCase(0.6, Inside: false).Prepare(pairs[i].Glossy);
            for (int k = 0; k < 20; k++)
            {
                Vector3D d = RandomDirection(random, Facing(surface));
                Vec3W direction = new((float)d.X, (float)d.Y, (float)d.Z);
                pairs[i].Glossy.DiffuseBsdf(surface, direction, out RgbW matt);
                pairs[i].Matt.Bsdf(surface, direction, out RgbW expected);
                double share = 1;
                if (pairs[i].Matt is PrincipledMaterial)
                {
                    // It has gloss still: its matt part is in proportion to what is no metal.
                    pairs[i].Matt.DiffuseBsdf(surface, direction, out expected);
                    share = 0.6;
                }

                AssertNear(share * expected.G[0], matt.G[0], 1e-6, $"{pairs[i].Glossy.GetType().Name} towards {d}");
            }
        }
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Every_weight_is_the_bsdf_times_the_cosine_over_the_pdf(string name) => ForEachSurface(name, (material, at) =>
    {
        SurfaceW surface = at.Prepare(material.Material);
        ScatterSamples.OnGrid(material.Material, surface, 5, (in ScatterW s, int lane) =>
        {
            Vector3D d = Vector3D.Of(s.Direction, lane);
            AssertNear(1, Has(s.Absorbed, lane) ? 1 : d.Length, 1e-5, $"length of a direction of {material} at {at}");
            if (Has(s.Delta, lane))
            {
                Assert.True(Has(s.Specular, lane), $"a delta lobe of {material} does not count as specular");
                return;
            }

            double pdf = Pdf(material, surface, d);

            // What is reflected through the surface ends there, though light may be refracted that way.
            Assert.True(Has(s.Absorbed, lane) ? pdf == 0 || material.Material.Traits.Transmits : pdf > 0, $"{material} at {at}: density {pdf}");
            if (pdf > 0 && !Has(s.Absorbed, lane) && !material.IsMixture)
            {
                // A cosine of two directions in single precision is known to a few units in the last place of 1.
                double cosine = Math.Abs(d.Dot(Facing(surface)));
                Vector3D weight = Bsdf(material, surface, d) * (cosine / pdf);
                Assert.True((weight - Weight(s, lane)).Length < 1e-4 + (4e-7 / cosine), $"{material} at {at}: {Weight(s, lane)} is not {weight}");
            }
        });
    });

    [Theory]
    [MemberData(nameof(Cases))]
    public void Materials_are_reciprocal_or_declare_with_reason_that_they_are_not(string name)
    {
        MaterialCase material = MaterialCase.Of(name);
        SurfaceCase at = new(0.5);
        var random = new Random(TestSettings.Seed);
        double largest = 0;
        Vector3D facing = Facing(at.Prepare(material.Material));
        for (int i = 0; i < 4000; i++)
        {
            Vector3D a = RandomDirection(random, facing);

            // Half of the pairs are near to mirror images of each other: there the narrow lobes are.
            Vector3D mirrored = (facing * (2 * a.Dot(facing))) - a + (RandomDirection(random, facing) * (4 / Math.Sqrt(1 + material.Exponent)));
            Vector3D b = i % 2 == 0 ? RandomDirection(random, facing) : mirrored.Unit;
            double there = Bsdf(material, at, a, b);
            double back = Bsdf(material, at, b, a);
            double difference = Math.Abs(there - back) / Math.Max(1e-6, Math.Max(there, back));
            largest = Math.Max(largest, a.Dot(facing) > 0.05 && b.Dot(facing) > 0.05 && a.Dot(at.Facing) > 0.05 && b.Dot(at.Facing) > 0.05 ? difference : 0);
        }

        string? exception = material.Material.Traits.ReciprocityException;
        Assert.True(exception is null ? largest < 1e-4 : largest > 0.05, $"{material}: there and back differ by {largest}; declared: {exception ?? "reciprocal"}");
    }

    [Theory]
    [MemberData(nameof(Cases))]
    public void Declared_energy_is_what_the_cases_check(string name)
    {
        // A declaration is worth something only if its limit is tested: where all energy is kept, an albedo is known.
        MaterialCase material = MaterialCase.Of(name);
        bool isTested = MaterialCase.All.Any(c => c.Material.GetType() == material.Material.GetType() && c.Material.Traits.KeepsEnergy && c.Albedo is not null);
        Assert.True(!material.Material.Traits.KeepsEnergy || isTested, $"no white case of {material.Material.GetType().Name}");
    }

    [Fact]
    public void Every_material_that_a_scene_can_name_has_cases()
    {
        SceneBuilder builder = new((_, _) => new Picture(1, 1));
        HashSet<Type> tested = [.. MaterialCase.All.Select(c => c.Material.GetType())];
        Assert.Empty(SceneTypes.Materials.Types.Where(t => !tested.Contains(builder.Material((MaterialDescription)t.Create()).GetType())).Select(t => t.Name));
    }

    [Fact]
    public void What_a_material_declares_is_what_it_does()
    {
        foreach (MaterialCase material in MaterialCase.All)
        {
            SurfaceCase at = new(0.6);
            SurfaceW surface = at.Prepare(material.Material);
            bool hasDensity = false;
            bool transmits = false;
            ScatterSamples.OnGrid(material.Material, surface, 4, (in ScatterW scatter, int lane) =>
            {
                Vector3D d = Vector3D.Of(scatter.Direction, lane);
                bool isSeen = !Has(scatter.Absorbed, lane) && Bsdf(material, surface, d).Length > 0;
                hasDensity |= isSeen;
                transmits |= isSeen && d.Dot(Facing(surface)) < 0;
            });
            Assert.True(hasDensity == material.Material.Traits.HasDensity && transmits == material.Material.Traits.Transmits, $"{material}: density {hasDensity}, through the surface {transmits}");
        }
    }

    private static double Cell => Math.Pow(4, -GridBits);

    private static void ForEachSurface(string name, Action<MaterialCase, SurfaceCase> action)
    {
        MaterialCase material = MaterialCase.Of(name);
        double[] cosines = [.. (TestSettings.Thorough ? s_thorough : s_everyday).Where(c => c >= material.SmallestCosine)];
        for (int i = 0; i < cosines.Length; i++)
        {
            // Twice as many points a cell each way make four times the work.
            if (material.QuadraturePoints > 8 && i % 3 != 1)
            {
                continue;
            }

            // Refraction differs by the side; of the others, every second angle is seen from inside.
            bool both = TestSettings.Thorough || material.Index != 1;
            foreach (bool inside in !material.SeenFromBehind ? [false] : both ? [false, true] : new[] { i % 2 == 1 })
            {
                action(material, new(cosines[i], inside));
            }
        }
    }

    // A number for each lane of directions.
    private delegate void Evaluate(in SurfaceW surface, in Vec3W direction, out FloatW value);

    private static Evaluate Green(MaterialCase material) => (in SurfaceW surface, in Vec3W direction, out FloatW green) =>
    {
        material.Material.Bsdf(surface, direction, out RgbW bsdf);
        green = bsdf.G;
    };

    // Values at all points of a grid, which are found a packet at a time.
    private static void ForEachPoint(SphericalGrid grid, in SurfaceW surface, Evaluate evaluate, Action<GridPoint, double> action)
    {
        IReadOnlyList<GridPoint> points = grid.Points();
        float[][] lanes = [new float[FloatW.Count], new float[FloatW.Count], new float[FloatW.Count]];
        for (int first = 0; first < points.Count; first += FloatW.Count)
        {
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                Vector3D d = points[Math.Min(first + lane, points.Count - 1)].Direction;
                (lanes[0][lane], lanes[1][lane], lanes[2][lane]) = ((float)d.X, (float)d.Y, (float)d.Z);
            }

            Vec3W directions = new(new(new Vector<float>(lanes[0])), new(new Vector<float>(lanes[1])), new(new Vector<float>(lanes[2])));
            evaluate(surface, directions, out FloatW value);
            for (int lane = 0; lane < FloatW.Count && first + lane < points.Count; lane++)
            {
                action(points[first + lane], value[lane]);
            }
        }
    }

    // Light is counted as radiance over the square of the refractive index: what refraction does not change.
    private static Vector3D Flux(MaterialCase material, SurfaceCase at, in SurfaceW surface, in ScatterW s, int lane)
    {
        bool isRefracted = Vector3D.Of(s.Direction, lane).Dot(Facing(surface)) < 0;
        double index = at.Inside ? 1 / material.Index : material.Index;
        return Weight(s, lane) * (isRefracted ? index * index : 1);
    }

    private static Vector3D Weight(in ScatterW s, int lane) => new(s.Weight.R[lane], s.Weight.G[lane], s.Weight.B[lane]);

    private static void AddMoments(double[] moments, Vector3D direction, double weight)
    {
        for (int k = 0; k < moments.Length; k++)
        {
            moments[k] += weight * Moment(k, direction);
        }
    }

    private static double Moment(int k, Vector3D d) => k switch { 0 => 1, 1 => d.X, 2 => d.Y, _ => d.Z };

    private static double Pdf(MaterialCase material, in SurfaceW surface, Vector3D direction)
    {
        material.Material.Pdf(surface, (Vector3)direction, out FloatW pdf);
        return pdf[0];
    }

    private static Vector3D Bsdf(MaterialCase material, in SurfaceW surface, Vector3D direction)
    {
        material.Material.Bsdf(surface, (Vector3)direction, out RgbW bsdf);
        return new(bsdf.R[0], bsdf.G[0], bsdf.B[0]);
    }

    private static double Bsdf(MaterialCase material, SurfaceCase at, Vector3D view, Vector3D light)
    {
        SurfaceW surface = at.Prepare(material.Material);
        SurfaceCase.Turn(ref surface, -view);
        material.Material.Prepare(ref surface);
        return Bsdf(material, surface, light).Y;
    }

    private static Vector3D RandomDirection(Random random, Vector3D normal)
    {
        while (true)
        {
            Vector3D d = new((2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1, (2 * random.NextDouble()) - 1);
            if (d.Squared is > 0.01 and < 1 && d.Unit.Dot(normal) > 0.05)
            {
                return d.Unit;
            }
        }
    }

    private static Vector3D Facing(in SurfaceW surface) => Vector3D.Of(surface.Facing, 0);

    private static Vector3D Mirror(in SurfaceW surface) => Vector3D.Of(Vec3W.Reflect(surface.Incoming, surface.Facing), 0).Unit;

    private static int Stream(SurfaceCase at) => (int)(at.Cosine * 10_000) + (at.Inside ? 20_000 : 0);

    private static bool Has(MaskW mask, int lane) => (mask.Bits >> lane & 1) != 0;

    private static void AssertNear(double expected, double actual, double tolerance, string what) =>
        Assert.True(Math.Abs(expected - actual) <= tolerance, $"{what}: {actual:G7} instead of {expected:G7}");
}
