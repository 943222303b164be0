using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Shapes;

namespace RayTracer.Jobs;

/// <summary>A kind of things whose bits have changed since films were first written.</summary>
/// <param name="Name">The name.</param>
/// <param name="Version">The version of its bits: the number of the change in <c>hashes.txt</c>, the list of films' hashes, by which they
/// became what they are.</param>
/// <param name="IsIn">True if a scene has one, by all its records.</param>
public sealed record BitVersion(string Name, int Version, Func<SceneDescription, IReadOnlyCollection<object>, bool> IsIn);

/// <summary>
/// The versions of bits: films of a scene with one of these kinds go together only if they were rendered with the same version. All other
/// kinds have their first.
/// </summary>
public static class BitVersions
{
    /// <summary>The kinds that have changed.</summary>
    public static IReadOnlyList<BitVersion> All { get; } =
    [
        new("boundaries inside of other materials", 15, (_, records) => records.Any(
            r => r is MaterialDescription && RecordType.WithParts(r).Skip(1).Any(p => IsBoundary(p.Record)))),
        new("meshes with literal shading normals or materials that transmit", 17, (scene, records) =>
            records.Any(r => Name(r) is "mesh" or "model")
                && (scene.Render.ShadingNormals == ShadingNormals.Literal || records.Any(Transmits))),
        new("boundaries that shadow rays cross", 21, (scene, records) =>
            scene.Render.WeakenedShadows || records.Any(r => IsBoundary(r) || HasPriority(r))),
        new("instances or models with a material", 22, (_, records) => records.Any(
            r => Name(r) is "instance" or "model" && !ReferenceEquals(((ShapeDescription)r).Material, ShapeDescription.DefaultMaterial))),
        new("instances, and shapes that are placed or move", 23, (_, records) => records.Any(r => r is ModelDescription or InstanceDescription
            || (r is ShapeDescription shape && (shape.Transform.Count > 0 || shape.Motion.Count > 0)))),
        new("lights that camera paths sample", 26, (scene, _) =>
            scene.Render.Integrator.Has(IntegratorTraits.SampledEnvironment) && !scene.Render.Integrator.Has(IntegratorTraits.TracesLight)),
        new("many things, some of which may be lights", 26, (scene, records) => scene.Render.Integrator.Has(IntegratorTraits.TracesLight)
            && (records.Count(r => r is ShapeDescription) > 8 || records.Any(r => Name(r) is "instance" or "model"))),
        new("coats", 26, (scene, records) => scene.Render.Integrator.Has(IntegratorTraits.Light) && records.Any(r => Name(r) == "diffuseSpecular")),
        new("samples that share camera rays", 26, (scene, records) => MaySplit(scene) && !records.Any(r => Name(r) is "mesh" or "model" or "instance")),
        new("glTF models", 29, (_, records) => records.Any(r => r is ModelDescription { File: { } file }
            && (file.EndsWith(".gltf", StringComparison.OrdinalIgnoreCase) || file.EndsWith(".glb", StringComparison.OrdinalIgnoreCase)))),
        new("backgrounds in the light of the lamps", 30, (scene, _) => scene.Render.Integrator == Integrator.Light && !scene.Background.IsBlack),
        new("media inside shapes, by path", 33, (scene, records) => scene.Render.Integrator == Integrator.Path && records.Any(
            r => r is MediumDescription { Extinction.IsBlack: false })),
        new("skies", 18, (scene, _) => scene.Environment is { } sky && Name(sky) == "sky"),
    ];

    /// <summary>Those that a scene has.</summary>
    public static IReadOnlyList<BitVersion> Of(SceneDescription scene)
    {
        object[] records = [.. RecordType.WithParts(scene).Select(p => p.Record)];
        return [.. All.Where(v => v.IsIn(scene, records))];
    }

    private static bool MaySplit(SceneDescription scene) => scene.Render is { Splitting: > 1 } render && render.Integrator.Has(IntegratorTraits.Splits)
        && render.Sampler != SamplerKind.Independent && (!render.Sampler.DependsOnCount || render.SamplesPerPixel >= 64);

    private static bool HasPriority(object record) => record is GlassDescription { Priority: > 0 };

    private static bool IsBoundary(object record) => Name(record) == "invisible";

    private static bool Transmits(object record) => Name(record) is "roughDielectric" or "principled" or "translucent";

    private static string Name(object record) => RecordType.Of(record.GetType()).Name;
}
