using System.Reflection;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;
using RayTracer.Shapes;
using RayTracer.Spectra;
using RayTracer.Tests.Statistics;
using RayTracer.Textures;
using Plane = RayTracer.Shapes.PlaneDescription;
using Sphere = RayTracer.Shapes.SphereDescription;

namespace RayTracer.Tests.Materials;

/// <summary>The traits of materials survive in the materials around them, and so do mean and noise of pictures.</summary>
public class MaterialTraitsTests
{
    private const int Width = 16;
    private const int Height = 12;
    private const int Seeds = 4;

    // Traits that a joined material has only if both parts have them.
    private static readonly string[] s_common = [nameof(MaterialTraits.IsBoundary), nameof(MaterialTraits.KeepsEnergy)];

    // Materials around others that change nothing.
    private static readonly Dictionary<string, Func<Material, Material>> s_neutral = new()
    {
        ["mask"] = m => new MaskMaterial(m, Grey(1)),
        ["bumpMap"] = m => new BumpMapMaterial(m, Grey(0), 1),
        ["soft bumpMap"] = m => new BumpMapMaterial(m, Grey(0), 1) { Turned = TurnedNormal.Flip, SoftensShadow = true },
        ["normalMap"] = m => new NormalMapMaterial(m, new SolidTexture(new(0.5f, 0.5f, 1)), 1),
        ["normalMap with a back"] = m => new NormalMapMaterial(m, new SolidTexture(new(0.5f, 0.5f, 1)), 1) { Turned = TurnedNormal.Back },
        ["mix"] = m => new MixMaterial(m, m, Grey(0.5f)),
        ["mix with nothing else"] = m => new MixMaterial(m, new DiffuseMaterial(Grey(0)), Grey(0)),
        ["twoSided"] = m => new TwoSidedMaterial(m, m),
        ["twoSided of two"] = m => new TwoSidedMaterial(m, new OneSidedMaterial(m)),
        ["oneSided"] = m => new OneSidedMaterial(m),
    };

    // One of each type and set of traits.
    private static readonly MaterialCase[] s_materials =
        [.. MaterialCase.All.Where(c => !c.Material.Traits.Emits).DistinctBy(c => (c.Material.GetType(), c.Material.Traits))];

    public static TheoryData<string> Around => [.. s_neutral.Keys];

    public static TheoryData<string> Lettings => [.. MaterialCase.All.Where(c => c.Material.Traits.IsTransparent || c.Material.Traits.Transmits).Select(c => c.Name)];

    [Theory]
    [MemberData(nameof(Around))]
    public void A_material_that_changes_nothing_leaves_mean_and_noise_of_pictures_as_they_are(string around)
    {
        List<string> others = [];
        foreach (Integrator integrator in new[] { Integrator.VolPath, Integrator.Report })
        {
            foreach (MaterialCase material in s_materials.Where(c => IsNeutral(around, integrator, c)))
            {
                (double mean, double noise) = Render(material.Material, integrator);
                (double wrappedMean, double wrappedNoise) = Render(s_neutral[around](material.Material), integrator);
                double error = Math.Sqrt(((noise * noise) + (wrappedNoise * wrappedNoise)) / (Width * Height * Seeds));
                if (Math.Abs(wrappedMean - mean) > 4 * error || wrappedNoise < 0.6 * noise || wrappedNoise > 1.6 * noise)
                {
                    others.Add($"{integrator} of {material} in {around}: mean {wrappedMean:G5} with noise {wrappedNoise:G3}, alone {mean:G5} with noise {noise:G3}");
                }
            }
        }

        Assert.True(others.Count == 0, string.Join('\n', others));
    }

    [Fact]
    public void Two_materials_together_have_the_traits_that_either_has_or_that_both_have()
    {
        foreach (PropertyInfo trait in typeof(MaterialTraits).GetProperties().Where(p => p.CanWrite))
        {
            object given = trait.Name switch
            {
                nameof(MaterialTraits.Specular) => SpecularLobe.Delta,
                nameof(MaterialTraits.MostEnergy) => 2f,
                nameof(MaterialTraits.Matte) => MatteRole.Holdout,
                nameof(MaterialTraits.Interior) => new Medium(Rgb.White, Rgb.White, 0),
                nameof(MaterialTraits.Nesting) => new Nesting(1, Dispersion.None(1.5f), Rgb.Black),
                _ when trait.PropertyType == typeof(string) => "for a reason",
                _ => true,
            };
            object with = new MaterialTraits();
            trait.SetValue(with, given);
            MaterialTraits one = (MaterialTraits)with;
            MaterialTraits none = new();
            Assert.Equal(given, trait.GetValue(one | one));
            MaterialTraits joined = s_common.Contains(trait.Name) ? none | none : one | one;
            Assert.True(joined == (one | none) && joined == (none | one) && (one | one) != (none | none), trait.Name);
        }

        MaterialTraits glossy = new() { Specular = SpecularLobe.Glossy };
        Assert.Equal(glossy, glossy | new MaterialTraits { Specular = SpecularLobe.Delta });
        Assert.True(new MaterialTraits { UsesTangent = true }.UsesUv);
    }

    [Fact]
    public void Bsdf_and_density_are_the_same_together_and_apart()
    {
        foreach (MaterialCase material in MaterialCase.All)
        {
            foreach (bool inside in new[] { false, true })
            {
                SurfaceW surface = new SurfaceCase(0.6, inside).Prepare(material.Material);
                foreach (Vector3D direction in new Vector3D[] { new(0.3, 0.8, 0.5), new(-0.3, 0.1, 0.7), new(0.2, -0.9, 0.1), new(0.5, -0.3, -0.6) })
                {
                    Vec3W towards = (System.Numerics.Vector3)direction.Unit;
                    material.Material.Bsdf(surface, towards, out RgbW bsdf);
                    material.Material.Pdf(surface, towards, out FloatW pdf);
                    material.Material.Evaluate(surface, towards, out RgbW bsdf2, out FloatW pdf2);
                    Assert.Equal((bsdf.R[0], bsdf.G[0], bsdf.B[0], pdf[0]), (bsdf2.R[0], bsdf2.G[0], bsdf2.B[0], pdf2[0]));
                }
            }
        }
    }

    [Fact]
    public void The_share_that_goes_straight_is_the_mean_weight_of_straight_choices()
    {
        List<string> others = [];
        foreach (MaterialCase material in MaterialCase.All.Where(c => c.Index != 1 || c.Material is not DielectricMaterial))
        {
            foreach (Material around in new[] { material.Material, new MaskMaterial(material.Material, Grey(0.4f)), new OneSidedMaterial(material.Material) })
            {
                foreach (bool inside in new[] { false, true })
                {
                    SurfaceW surface = new SurfaceCase(0.6, inside).Prepare(around);
                    around.Straight(surface, out RgbW share);
                    double mean = MeanOfStraight(around, surface);
                    if (Math.Abs(mean - share.G[0]) > 0.01 || (share.G[0] > 0 && !around.Traits.PassesStraight))
                    {
                        others.Add($"{around.GetType().Name} of {material}, from {(inside ? "behind" : "outside")}: {share.G[0]}, but chosen {mean}");
                    }
                }
            }
        }

        Assert.True(others.Count == 0, string.Join('\n', others));
    }

    [Theory]
    [MemberData(nameof(Lettings))]
    public void What_lets_light_through_has_no_two_sides_whatever_is_around_it(string name)
    {
        Material material = MaterialCase.Of(name).Material;
        foreach (string around in new[] { "mask", "bumpMap", "mix", "oneSided" })
        {
            SceneBuilder builder = new((_, _) => throw new NotSupportedException());
            builder.Material(new TwoSidedMaterialDescription { Front = new GivenDescription(s_neutral[around](material)) });
            Assert.Contains(builder.Complaints, c => c.Message.Contains("no separate sides", StringComparison.Ordinal));
        }
    }

    private static double MeanOfStraight(Material material, SurfaceW surface)
    {
        const int side = 6;
        VertexSamples samples = new(new GridSampler(side));
        double sum = 0;
        for (int i = 0; i < 1 << (2 * side); i++)
        {
            samples.Begin(0u, (uint)i, 0u);
            material.Scatter(surface, samples, out ScatterW scatter);
            bool isStraight = (scatter.Direction.X[0], scatter.Direction.Y[0], scatter.Direction.Z[0]) == (surface.Incoming.X[0], surface.Incoming.Y[0], surface.Incoming.Z[0]);
            sum += isStraight && (scatter.Delta.Bits & ~scatter.Absorbed.Bits & 1) != 0 ? scatter.Weight.G[0] : 0;
        }

        return sum / (1 << (2 * side));
    }

    private static bool IsNeutral(string around, Integrator integrator, MaterialCase material) => around switch
    {
        // Lights are not sampled for it in the report, since it weakens light by its direction.
        "soft bumpMap" or "normalMap with a back" => integrator != Integrator.Report,
        "mix" => !material.Material.Traits.TurnsNormal,
        "mix with nothing else" => material.Material.Traits is { TurnsNormal: false, IsBoundary: false },
        "twoSided" or "twoSided of two" or "oneSided" => material is { Index: 1, Material.Traits: { Transmits: false, IsTransparent: false } },
        _ => true,
    };

    // The mean of a picture, and the mean over its pixels of their standard deviations, which single bright paths change little.
    private static (double Mean, double Noise) Render(Material material, Integrator integrator)
    {
        ImageSamples images = new(Width, Height);
        for (int seed = 1; seed <= Seeds; seed++)
        {
            images.Add(Film(material, integrator, seed));
        }

        BlockEstimate[] pixels = [.. Block.Cut(Width, Height, 1).Select(pixel => images.Estimate(pixel, 1))];
        return (pixels.Average(p => p.Mean), pixels.Average(p => Math.Sqrt(p.Variance * Seeds)));
    }

    // A ball between a lamp and the floor, beside a cloud. In the report, whose glossy surfaces meet lamps by chance only, the lamp has no extent.
    private static Film Film(Material material, Integrator integrator, long seed)
    {
        MediumDescription fog = new() { Extinction = new(0.5f, 0.5f, 0.5f), Albedo = new(0.8f, 0.8f, 0.8f) };
        ShapeDescription[] shapes =
        [
            new Plane { Point = new(0, -1, 0), Normal = new(0, 1, 0), Material = new DiffuseMaterialDescription { Color = new SolidTextureDescription { Color = new(0.5f, 0.5f, 0.5f) } } },
            new Sphere { Center = new(0, 0.2f, 0), Radius = 1, Material = new GivenDescription(material) },
        ];
        SceneDescription scene = new()
        {
            Camera = new() { Position = new(0, 1.5f, 5), LookAt = new(0, 0, 0), FieldOfView = 45 },
            Render = new() { Width = Width, Height = Height, SamplesPerPixel = 4, Seed = seed, Integrator = integrator, MaxDepth = 6 },
            Background = new(0.1f, 0.1f, 0.1f),
        };
        scene = integrator == Integrator.Report
            ? scene with
            {
                Render = scene.Render with { WeakenedShadows = true },
                Lights = [new PointLightDescription { Position = new(0.5f, 3, 0.5f), Intensity = new(4, 4, 4) }],
                Shapes = shapes,
            }
            : scene with
            {
                Lights = [new Sphere { Center = new(0.5f, 4, 0.5f), Radius = 1, Material = new LuminaireMaterialDescription { Multiplier = 2 } }],
                Shapes = [.. shapes, new Sphere { Center = new(1.5f, 0, 0), Radius = 0.5f, Material = new InvisibleMaterialDescription { Interior = fog } }],
            };
        SceneBuilder builder = new((_, _) => throw new NotSupportedException());
        return new RTracer(builder.Build(scene)!, new() { Threads = 1 }).Render().Film;
    }

    private static SolidTexture Grey(float value) => new(new(value, value, value));

    private sealed record GivenDescription(Material Material) : MaterialDescription
    {
        public override Material Build(SceneBuilder builder) => Material;
    }
}
