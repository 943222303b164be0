using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Tests.Statistics;

/// <summary>A material whose sampling is tested.</summary>
/// <param name="Name">A name for messages.</param>
/// <param name="Material">The material.</param>
internal sealed record MaterialCase(string Name, Material Material)
{
    /// <summary>Exponent of its lobe around the mirror direction; 0 where there is none.</summary>
    public double Exponent { get; init; }

    /// <summary>Refractive index of its inside.</summary>
    public double Index { get; init; } = 1;

    /// <summary>What part of the light goes on, if known; null where it is not all the same whatever the angle.</summary>
    public Rgb? Albedo { get; init; }

    /// <summary>Whether two lobes may choose the same direction.</summary>
    public bool IsMixture { get; init; }

    /// <summary>All cases: a new material is tested once it has its line here.</summary>
    public static IReadOnlyList<MaterialCase> All { get; } =
    [
        new("white diffuse", Diffuse(1, 1, 1)) { Albedo = Rgb.White },
        new("red diffuse", Diffuse(0.8f, 0.5f, 0.2f)) { Albedo = new(0.8f, 0.5f, 0.2f) },
        new("textured diffuse", new DiffuseMaterial(new UvTexture())) { Albedo = new(SurfaceCase.U, SurfaceCase.V, 1) },
        Metal(0), Metal(0.5f), Metal(1), Metal(5), Metal(20), Metal(100), Metal(1000), Metal(1e4f), Metal(1e5f),
        new("textured metal", new PhongMetalMaterial(new UvTexture(), 30)) { Exponent = 30 },
        new("glass", Glass(1.5f, Rgb.Black)) { Index = 1.5, Albedo = Rgb.White },
        new("glass by Schlick", new DielectricMaterial(1.5f, Rgb.Black, FresnelModel.Schlick)) { Index = 1.5, Albedo = Rgb.White },
        new("diamond", Glass(2.417f, Rgb.Black)) { Index = 2.417, Albedo = Rgb.White },
        new("air in water", Glass(0.75f, Rgb.Black)) { Index = 0.75, Albedo = Rgb.White },
        new("green glass", Glass(1.5f, new(0.5f, 0.1f, 0.5f))) { Index = 1.5 },
        Coat("white polish", Diffuse(1, 1, 1), 10, 0.04f),
        Coat("polish", Diffuse(0.7f, 0.4f, 0.1f), 50, 0.04f),
        Coat("sharp polish", Diffuse(0.7f, 0.4f, 0.1f), 1e4f, 0.3f),
        Coat("polish without base reflectance", Diffuse(0.7f, 0.4f, 0.1f), 5, 0),
        new("glass on white", new DiffuseSpecularMaterial(Diffuse(1, 1, 1), Glass(1.5f, Rgb.Black), 0.2f)) { Index = 1.5, Albedo = Rgb.White, IsMixture = true },
        new("lamp", new LuminaireMaterial(new SolidTexture(Rgb.White), 2, 1, null)) { Albedo = Rgb.Black },
        new("diffuse lamp", new LuminaireMaterial(new SolidTexture(Rgb.White), 2, 1, Diffuse(0.8f, 0.5f, 0.2f))) { Albedo = new(0.8f, 0.5f, 0.2f) },
        new("metal lamp", new LuminaireMaterial(new SolidTexture(Rgb.White), 2, 1, Metal(20).Material)) { Exponent = 20 },
    ];

    /// <summary>The case of a name.</summary>
    public static MaterialCase Of(string name) => All.Single(c => c.Name == name);

    /// <inheritdoc/>
    public override string ToString() => Name;

    private static DiffuseMaterial Diffuse(float r, float g, float b) => new(new SolidTexture(new(r, g, b)));

    private static DielectricMaterial Glass(float index, Rgb extinction) => new(index, extinction, FresnelModel.Exact);

    private static MaterialCase Metal(float exponent) =>
        new($"metal {exponent:G}", new PhongMetalMaterial(new SolidTexture(new(1, 0.9f, 0.5f)), exponent)) { Exponent = exponent };

    private static MaterialCase Coat(string name, Material below, float exponent, float r0) =>
        new(name, new DiffuseSpecularMaterial(below, new PhongMetalMaterial(new SolidTexture(Rgb.White), exponent), r0)) { Exponent = exponent, IsMixture = true };
}
