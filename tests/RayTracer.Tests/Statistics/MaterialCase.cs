using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Spectra;
using RayTracer.Textures;
using GlassName = RayTracer.Materials.Glass;
using MetalName = RayTracer.Materials.Metal;

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

    /// <summary>Whether it is not black from behind.</summary>
    public bool SeenFromBehind { get; init; } = true;

    /// <summary>How far a mean over a grid of samples may lie from the albedo.</summary>
    public double AlbedoTolerance { get; init; } = 1e-5;

    /// <summary>How far a moment of a grid of samples may lie from the integral.</summary>
    public double MeanTolerance { get; init; } = 1e-4;

    /// <summary>
    /// The smallest cosine between ray and normal at which it is tested. Closer to the horizon, the quadrature of lobes that it cuts is off by more than
    /// what is tested (measured: a polished metal's integral at 0.001 changes by 0.2 % with three times as many points).
    /// </summary>
    public double SmallestCosine => Material is DiffuseMaterial or PhongMetalMaterial or DielectricMaterial or DiffuseSpecularMaterial or LuminaireMaterial ? 0.001 : 0.01;

    /// <summary>Points of the quadrature of a cell in each direction: more for narrow lobes beside that around the mirror direction.</summary>
    public int QuadraturePoints { get; init; } = 8;

    /// <summary>What part of the light goes on, if known; null where it is not all the same whatever the angle.</summary>
    public Rgb? Albedo { get; init; }

    /// <summary>Whether two lobes may choose the same direction.</summary>
    public bool IsMixture { get; init; }

    // Before all cases, which use it.
    private static readonly Dispersion s_flint = GlassName.Sf11.Dispersion();

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
        new("flint", new DielectricMaterial(1, Rgb.Black, FresnelModel.Exact, dispersion: s_flint)) { Index = s_flint.Index(SurfaceCase.Wavelength)[0], Albedo = Rgb.White },
        new("glass in water", new DielectricMaterial(1.5f, new(9, 9, 9), FresnelModel.Exact, nesting: new(1, Dispersion.None(1.5f), new(9, 9, 9)))) { Index = 1.5 / SurfaceCase.Around, Albedo = Rgb.White },
        new("frosted flint", new RoughDielectricMaterial(1, RoughnessOf(MicrofacetDistribution.Ggx, 0.4f, 0.4f), Solid(1), Solid(1), dispersion: s_flint)) { Index = s_flint.Index(SurfaceCase.Wavelength)[0], Exponent = 1, MeanTolerance = MeanOfTwo, QuadraturePoints = 16 },
        Coat("white polish", Diffuse(1, 1, 1), 10, 0.04f),
        Coat("polish", Diffuse(0.7f, 0.4f, 0.1f), 50, 0.04f),
        Coat("sharp polish", Diffuse(0.7f, 0.4f, 0.1f), 1e4f, 0.3f),
        Coat("polish without base reflectance", Diffuse(0.7f, 0.4f, 0.1f), 5, 0),
        new("glass on white", new DiffuseSpecularMaterial(Diffuse(1, 1, 1), Glass(1.5f, Rgb.Black), 0.2f)) { Index = 1.5, Albedo = Rgb.White, IsMixture = true, AlbedoTolerance = MeanOfTwo },
        new("lamp", new LuminaireMaterial(new SolidTexture(Rgb.White), 2, 1, null)) { Albedo = Rgb.Black },
        new("diffuse lamp", new LuminaireMaterial(new SolidTexture(Rgb.White), 2, 1, Diffuse(0.8f, 0.5f, 0.2f))) { Albedo = new(0.8f, 0.5f, 0.2f) },
        new("mirror", new ConductorMaterial(new(MetalName.None), Solid(1))) { Albedo = Rgb.White },
        new("copper mirror", new ConductorMaterial(new(MetalName.Copper), new UvTexture())),
        Rough("perfect rough metal", MetalName.None, MicrofacetDistribution.Ggx, 0.3f, 0.3f),
        Rough("polished gold", MetalName.Gold, MicrofacetDistribution.Ggx, 0.05f, 0.05f),
        Rough("brushed aluminium", MetalName.Aluminium, MicrofacetDistribution.Ggx, 0.4f, 0.15f),
        Rough("coarse iron", MetalName.Iron, MicrofacetDistribution.Ggx, 1, 1),
        Rough("hammered silver", MetalName.Silver, MicrofacetDistribution.Beckmann, 0.3f, 0.3f),
        Rough("brushed titanium", MetalName.Titanium, MicrofacetDistribution.Beckmann, 0.2f, 0.5f),
        Rough("coarse tungsten", MetalName.Tungsten, MicrofacetDistribution.Beckmann, 0.8f, 0.8f),
        new("textured copper", new RoughConductorMaterial(new(MetalName.Copper), new(MicrofacetDistribution.Ggx, new UvTexture(), new UvTexture()), new UvTexture())) { Exponent = 16 },
        new("compensated mirror", new RoughConductorMaterial(new(MetalName.None), RoughnessOf(MicrofacetDistribution.Ggx, 0.8f, 0.8f), Solid(1), true)) { Exponent = 1, Albedo = Rgb.White, AlbedoTolerance = MeanOfTable },
        new("compensated gold", new RoughConductorMaterial(new(MetalName.Gold), RoughnessOf(MicrofacetDistribution.Beckmann, 0.6f, 0.6f), Solid(1), true)) { Exponent = 1 },
        Frosted("frosted glass", 1.5f, MicrofacetDistribution.Ggx, 0.3f, 0.3f),
        Frosted("frosted bubble", 1 / 1.4f, MicrofacetDistribution.Ggx, 0.4f, 0.4f),
        Frosted("streaked glass", 1.5f, MicrofacetDistribution.Ggx, 0.5f, 0.25f),
        Frosted("rough water", 1.33f, MicrofacetDistribution.Beckmann, 0.4f, 0.4f),
        new("pane", new ThinDielectricMaterial(1.5f, Solid(1), Solid(1))) { Albedo = Rgb.White },
        new("red pane", new ThinDielectricMaterial(1.5f, Solid(1), new UvTexture())),
        new("white plastic", new PlasticMaterial(Solid(1), 1.49f, true, Solid(1))) { Albedo = Rgb.White, AlbedoTolerance = MeanOfTwo },
        new("plastic", new PlasticMaterial(new UvTexture(), 1.6f, false, Solid(0.8f))) { AlbedoTolerance = MeanOfTwo },
        new("deep plastic", new PlasticMaterial(new UvTexture(), 1.3f, true, Solid(1))) { AlbedoTolerance = MeanOfTwo },
        new("white rough plastic", new RoughPlasticMaterial(Solid(1), 1.5f, true, Solid(1), MicrofacetDistribution.Ggx, 0.1f)) { Exponent = 100 },
        new("rough plastic", new RoughPlasticMaterial(new UvTexture(), 1.49f, false, Solid(1), MicrofacetDistribution.Beckmann, 0.3f)) { Exponent = 10 },
        new("lacquered mirror", Lacquered(MetalName.None, 0, 0, Rgb.Black)) { Albedo = Rgb.White, AlbedoTolerance = MeanOfTable },
        new("lacquered copper", Lacquered(MetalName.Copper, 0, 0, new(0.1f, 0.3f, 0.6f))),
        new("lacquered brass", Lacquered(MetalName.Gold, 0.3f, 0, Rgb.Black)) { Exponent = 1, MeanTolerance = MeanOfTails },
        new("candy paint", Lacquered(MetalName.Aluminium, 0.2f, 0.1f, new(0.1f, 0.3f, 0.6f))) { Exponent = 50, MeanTolerance = MeanOfTails },
        new("one-sided plastic", new OneSidedMaterial(new PlasticMaterial(Solid(0.5f), 1.5f, true, Solid(1)))) { SeenFromBehind = false },
        new("holdout", new MatteMaterial(Diffuse(0.2f, 0.5f, 0.8f), MatteRole.Holdout)),
        new("white shadow catcher", new MatteMaterial(Diffuse(1, 1, 1), MatteRole.ShadowCatcher)) { Albedo = Rgb.White },
        new("two-sided", new TwoSidedMaterial(Diffuse(0.2f, 0.5f, 0.8f), new OneSidedMaterial(RoughIron(0.3f)))) { Exponent = 10 },
        new("white on both sides", new TwoSidedMaterial(Diffuse(1, 1, 1), Diffuse(1, 1, 1))) { Albedo = Rgb.White },
        new("mix of white", new MixMaterial(Diffuse(1, 1, 1), Glass(1.5f, Rgb.Black), Solid(0.3f))) { Index = 1.5, Albedo = Rgb.White, IsMixture = true, AlbedoTolerance = MeanOfTwo },
        new("mix of two colours", new MixMaterial(new DiffuseMaterial(new UvTexture()), Diffuse(1, 0.5f, 0), new UvTexture())) { IsMixture = true },
        new("rust", new MixMaterial(Diffuse(0.7f, 0.3f, 0.1f), RoughIron(0.3f), new UvTexture())) { Exponent = 10, IsMixture = true },
        new("mix of mixes", new MixMaterial(new MixMaterial(Diffuse(1, 0.5f, 0), Glass(1.5f, Rgb.Black), Solid(0.3f)), new MixMaterial(Diffuse(0, 0.5f, 1), RoughIron(0.5f), Solid(0.6f)), Solid(0.4f))) { Index = 1.5, Exponent = 4, IsMixture = true },
        new("white lace", new MaskMaterial(Diffuse(1, 1, 1), new UvTexture())) { Albedo = Rgb.White },
        new("iron mesh", new MaskMaterial(RoughIron(0.4f), Solid(0.7f))) { Exponent = 4 },
        new("translucent white", new TranslucentMaterial(Solid(0.3f), Solid(0.7f))) { Albedo = Rgb.White },
        new("leaf", new TranslucentMaterial(new SolidTexture(new(0.1f, 0.3f, 0.1f)), new SolidTexture(new(0.2f, 0.5f, 0.05f)))) { AlbedoTolerance = MeanOfTwo },
        new("phong", new PhongMaterial(null, new SolidTexture(new(0.5f, 0.3f, 0.1f)), Solid(0.4f), 40)) { Exponent = 40, IsMixture = true },
        new("textured phong", new PhongMaterial(Solid(1), Solid(0), new UvTexture(), 10)) { Exponent = 10 },
        new("embossed white", new NormalMapMaterial(Diffuse(1, 1, 1), new SolidTexture(new(0.7f, 0.4f, 0.9f)), 1)) { Albedo = Rgb.White },
        new("embossed copper", new NormalMapMaterial(RoughIron(0.3f), new UvTexture(), 0.5f)) { Exponent = 10 },
        new("wrinkled white", new BumpMapMaterial(Diffuse(1, 1, 1), new UvTexture(), 0.5f)) { Albedo = Rgb.White },
        new("wrinkled plastic", new BumpMapMaterial(new PlasticMaterial(Solid(0.5f), 1.5f, true, Solid(1)), new UvTexture(), -0.7f)),
        new("flipped copper", new NormalMapMaterial(RoughIron(0.3f), new UvTexture(), 0.5f) { Turned = TurnedNormal.Flip, SoftensShadow = true }) { Exponent = 10, QuadraturePoints = 64 },
        new("embossed back", new NormalMapMaterial(Diffuse(0.8f, 0.5f, 0.2f), new SolidTexture(new(0.7f, 0.4f, 0.9f)), 1) { Turned = TurnedNormal.Back, SoftensShadow = true, GreenAlongV = true }) { MeanTolerance = MeanOfTwo, QuadraturePoints = 64 },
        new("softly wrinkled white", new BumpMapMaterial(Diffuse(1, 1, 1), new UvTexture(), 0.5f) { SoftensShadow = true }),
        Principled("principled", new() { BaseColor = new UvTexture(), Roughness = Solid(0.5f) }),
        Principled("principled metal", new() { BaseColor = new UvTexture(), Roughness = Solid(0.6f), Metallic = Solid(1), Anisotropic = Solid(0.5f) }),
        Principled("car paint", new() { BaseColor = Solid(0.3f), Roughness = Solid(0.7f), Metallic = Solid(0.4f), Clearcoat = Solid(1), ClearcoatRoughness = Solid(1) }) with { Exponent = 60 },
        Principled("tempered steel", new() { BaseColor = new UvTexture(), Roughness = Solid(0.6f), Metallic = Solid(1), Iridescence = Solid(1), FilmThickness = Solid(220) }),
        Principled("oil on plastic", new() { BaseColor = Solid(0.3f), Roughness = Solid(0.6f), SpecularTint = Solid(0.5f), Sheen = Solid(0.3f), Iridescence = Solid(0.8f), FilmThickness = Solid(500) }),
        Principled("film on glass", new() { BaseColor = new UvTexture(), Roughness = Solid(0.6f), Transmission = Solid(1), Iridescence = Solid(1), FilmThickness = Solid(300) }) with { Index = 1.5, MeanTolerance = MeanOfTwo, QuadraturePoints = 16 },
        Principled("cloth", new() { BaseColor = Solid(0.3f), Roughness = Solid(0.9f), Sheen = Solid(0.5f), SheenTint = Solid(0.5f), Flatness = Solid(0.5f), SpecularTint = Solid(0.3f) }),
        Principled("principled glass", new() { BaseColor = new UvTexture(), Roughness = Solid(0.6f), Transmission = Solid(1) }) with { Index = 1.5, MeanTolerance = MeanOfTwo, QuadraturePoints = 16 },
        Principled("cloudy glass", new() { BaseColor = Solid(0.4f), Roughness = Solid(0.7f), Transmission = Solid(0.5f), Metallic = Solid(0.2f), Clearcoat = Solid(0.5f), ClearcoatRoughness = Solid(1) }) with { Exponent = 10, Index = 1.5, MeanTolerance = MeanOfTwo, QuadraturePoints = 16 },
        Sheet("paper", new() { BaseColor = new UvTexture(), Roughness = Solid(0.8f), DiffuseTransmission = Solid(0.6f), Sheen = Solid(0.5f), SheenTint = Solid(0.4f), Flatness = Solid(0.3f), RefractiveIndex = Solid(1.5f) }),
        Sheet("frosted pane", new() { BaseColor = new UvTexture(), Roughness = Solid(0.7f), Transmission = Solid(1), Anisotropic = Solid(0.4f), SpecularTint = Solid(0.3f), RefractiveIndex = Solid(1.6f) }),
        Sheet("curtain", new() { BaseColor = Solid(0.7f), Roughness = Solid(0.9f), Transmission = Solid(0.4f), DiffuseTransmission = new UvTexture(), RefractiveIndex = Solid(1.3f) }),
        new("boundary of a cloud", new InvisibleMaterial(null)) { Albedo = Rgb.White },
        new("metal lamp", new LuminaireMaterial(new SolidTexture(Rgb.White), 2, 1, Metal(20).Material)) { Exponent = 20 },
    ];

    /// <summary>The case of a name.</summary>
    public static MaterialCase Of(string name) => All.Single(c => c.Name == name);

    /// <inheritdoc/>
    public override string ToString() => Name;

    // Where lobes of different weights are chosen by the multiples of the golden ratio, beside a grid of directions.
    private const double MeanOfTwo = 4e-4;

    // A table of 128 angles is read by linear interpolation.
    private const double MeanOfTable = 2e-3;

    // The last of 1,024 columns of cells holds all of a distribution's long tail.
    private const double MeanOfTails = 4e-4;

    private static SolidTexture Solid(float value) => new(new(value, value, value));

    private static CoatedConductorMaterial Lacquered(MetalName metal, float alpha, float coatAlpha, Rgb absorption) =>
        new(new ConductorFresnel(metal, 1.5f), alpha, new(coatAlpha, 1.5f, absorption), Solid(1));

    private static Roughness RoughnessOf(MicrofacetDistribution distribution, float alphaU, float alphaV) => new(distribution, Solid(alphaU), Solid(alphaV));

    private static RoughConductorMaterial RoughIron(float alpha) => new(new(MetalName.Iron), RoughnessOf(MicrofacetDistribution.Ggx, alpha, alpha), Solid(1));

    private static MaterialCase Rough(string name, MetalName metal, MicrofacetDistribution distribution, float alphaU, float alphaV) =>
        new(name, new RoughConductorMaterial(new(metal), RoughnessOf(distribution, alphaU, alphaV), Solid(1))) { Exponent = 1 / (alphaU * alphaV), MeanTolerance = MeanOfTails };

    private static MaterialCase Frosted(string name, float index, MicrofacetDistribution distribution, float alphaU, float alphaV) =>
        new(name, new RoughDielectricMaterial(index, RoughnessOf(distribution, alphaU, alphaV), Solid(1), Solid(1))) { Index = index, Exponent = 1, MeanTolerance = MeanOfTwo, QuadraturePoints = 16 };

    private static MaterialCase Principled(string name, PrincipledTextures textures) =>
        new(name, new PrincipledMaterial(textures, 1.5f)) { Exponent = 4, MeanTolerance = MeanOfTails };

    private static MaterialCase Sheet(string name, PrincipledTextures textures) =>
        new(name, new ThinPrincipledMaterial(textures)) { Exponent = 4, MeanTolerance = MeanOfTwo, QuadraturePoints = 16 };

    private static DiffuseMaterial Diffuse(float r, float g, float b) => new(new SolidTexture(new(r, g, b)));

    private static DielectricMaterial Glass(float index, Rgb extinction) => new(index, extinction, FresnelModel.Exact);

    private static MaterialCase Metal(float exponent) =>
        new($"metal {exponent:G}", new PhongMetalMaterial(new SolidTexture(new(1, 0.9f, 0.5f)), exponent)) { Exponent = exponent };

    private static MaterialCase Coat(string name, Material below, float exponent, float r0) =>
        new(name, new DiffuseSpecularMaterial(below, new PhongMetalMaterial(new SolidTexture(Rgb.White), exponent), r0)) { Exponent = exponent, IsMixture = true };
}
