using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;
using Xunit.Abstractions;

namespace RayTracer.RenderTests.References;

/// <summary>
/// The comparison with the references sees small faults: scenes that are a little wrong must fail it. Where that were left to
/// chance, this test would fail by chance; so the faults are such that their p-values are many powers of ten below the level.
/// Covers `ReportShader` and `PathShader`.
/// </summary>
[Trait("Category", "Thorough")]
public class ReferenceSensitivityTests(ITestOutputHelper output)
{
    private static readonly Dictionary<string, Fault> s_faults = new()
    {
        ["one bounce too few"] = new("cornell", null, -1),
        ["one bounce too many"] = new("cornell", null, 1),
        ["one bounce too few in a bright room"] = new("room_depth5", null, -1),
        ["one bounce too many in a bright room"] = new("room_depth5", null, 1),
        ["0.7 % too much reflected"] = new("room_depth5", Brighter(1.007f)),
        ["0.7 % too much reflected by the floor"] = new("thinlens", d => d with { Shapes = [Brighter(d.Shapes[0], 1.007f), .. d.Shapes.Skip(1)] }),
        ["0.5 % lost by the mirror"] = new("mirror", d => d with { Shapes = [.. d.Shapes.Select(Duller)] }),
        ["refractive index 1.51 for 1.5"] = new("glass", d => d with { Shapes = [.. d.Shapes.Select(Denser)] }),
        ["field of view 0.1 degrees too large"] = new("sphere_lights", d => d with { Camera = d.Camera with { FieldOfView = d.Camera.FieldOfView + 0.1f } }),
        ["small lamp's radius 2 % too large"] = new("sphere_lights", d => d with { Lights = [.. d.Lights.Select(Larger)] }),
        ["sun 1 % too bright"] = new("directional", d => d with { Lights = [.. d.Lights.Select(l => l with { Material = (LuminaireMaterialDescription)l.Material with { Multiplier = 1.01f } })] }),
        ["lens radius 0.17 for 0.15"] = new("thinlens", d => d with { Camera = d.Camera with { Lens = d.Camera.Lens! with { ApertureRadius = 0.17f } } }),
        ["nearest texels for bilinear"] = new("tex_bilinear_scaled", d => d with { Shapes = [.. d.Shapes.Select(Unfiltered)] }),
    };

    public static TheoryData<string> Faults => new(s_faults.Keys);

    [SkippableTheory]
    [Trait("Category", "Slow")]
    [MemberData(nameof(Faults))]
    public void The_comparison_sees_small_faults(string name)
    {
        Skip.IfNot(TestSettings.Thorough, "only in a thorough run");
        string? folder = ProjectFolder.Shared("references");
        Skip.If(folder is null, "the other renderer's images are not here");
        Fault fault = s_faults[name];
        ReferenceCase scene = ReferenceCase.All.Single(c => c.Name == fault.Scene);
        ReferenceCase wrong = scene with { Lower = [.. scene.Lower.Select(t => t with { MaxDiffuseDepth = t.MaxDiffuseDepth + fault.Bounces })] };
        ReferenceRenders renders = wrong.Render(seeds: 64, samplesPerPixel: 16, fault.Change);
        BlockTest test = ReferenceComparison.Of(renders, ReferenceComparison.Read(folder, fault.Scene)).Select(c => c.Test()).MinBy(t => t.P)!;
        output.WriteLine(test.ToString());
        Assert.True(test.P < ErrorBudget.References.Level, $"not seen: {name}, {test}");
    }

    private static Func<SceneDescription, SceneDescription> Brighter(float factor) =>
        d => d with { Shapes = [.. d.Shapes.Select(s => Brighter(s, factor))] };

    private static ShapeDescription Brighter(ShapeDescription shape, float factor) =>
        shape.Material is DiffuseMaterialDescription { Color: SolidTextureDescription { Color: Rgb c } } matt
            ? shape with { Material = matt with { Color = new SolidTextureDescription { Color = new(c.R * factor, c.G * factor, c.B * factor) } } }
            : shape;

    private static ShapeDescription Duller(ShapeDescription shape) =>
        shape.Material is PhongMetalMaterialDescription metal
            ? shape with { Material = metal with { Color = new SolidTextureDescription { Color = new(0.995f, 0.995f, 0.995f) } } }
            : shape;

    private static ShapeDescription Denser(ShapeDescription shape) =>
        shape.Material is DielectricMaterialDescription glass ? shape with { Material = glass with { RefractiveIndex = 1.51f } } : shape;

    private static ShapeDescription Larger(ShapeDescription shape) =>
        shape is SphereDescription { Radius: < 0.1f } sphere ? sphere with { Radius = sphere.Radius * 1.02f } : shape;

    private static ShapeDescription Unfiltered(ShapeDescription shape) =>
        shape.Material is DiffuseMaterialDescription { Color: ImageTextureDescription image } matt
            ? shape with { Material = matt with { Color = image with { Interpolation = Interpolation.Nearest } } }
            : shape;

    private sealed record Fault(string Scene, Func<SceneDescription, SceneDescription>? Change, int Bounces = 0);
}
