using RayTracer.Cameras;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>A rule by which parameters of a record have no effect.</summary>
/// <param name="Record">The record's name in scene files.</param>
/// <param name="Parameters">The keys of the parameters.</param>
/// <param name="IsIdle">Whether they have none, in a record that stands in a scene.</param>
/// <param name="Reason">Why, in a sentence for the user.</param>
internal sealed record IdleRule(string Record, IReadOnlyList<string> Parameters, Func<SceneValue, bool> IsIdle, string Reason);

/// <summary>The parameters that have no effect on the picture, as the scene is.</summary>
internal static class IdleFields
{
    /// <summary>All rules; of those that hold, the first one gives the reason.</summary>
    public static IReadOnlyList<IdleRule> Rules { get; } =
    [
        Integrators(IntegratorTraits.PathLimit, "maxDepth", "rouletteDepth"),
        Integrators(IntegratorTraits.StraightThrough, "straightThrough"),
        Integrators(IntegratorTraits.HiddenLights, "hideLights"),
        Integrators(IntegratorTraits.Splits, "splitting"),
        Integrators(IntegratorTraits.MergesPaths, "mergeRadius"),
        Integrators(IntegratorTraits.OcclusionDistance, "occlusionDistance"),
        Integrators(IntegratorTraits.BounceLimits, "maxDiffuseDepth", "maxSpecularDepth"),
        Integrators(IntegratorTraits.WeakenedShadows, "weakenedShadows"),
        Integrators(IntegratorTraits.LiteralNormals, "shadingNormals"),
        Integrators(IntegratorTraits.Light, "sphereLightSampling"),
        new("camera", ["viewSize"], v => Of<CameraDescription>(v).Projection != Projection.Orthographic, Text("orthographic")),
        new("camera", ["fieldOfView"], v => Of<CameraDescription>(v).Projection != Projection.Perspective, Text("perspective")),
        new("camera", ["fieldOfViewAxis"], v => Of<CameraDescription>(v).Projection == Projection.Spherical, Text("allDirections")),
        new("lens", ["blades", "rotation"], v => Of<LensDescription>(v).Shape != LensShape.Bladed, Text("bladed")),
        new("lens", ["jitter"], v => Of<LensDescription>(v).Shape != LensShape.EyeJitter, Text("eyeJitter")),
        new("lens", ["apertureRadius"], v => Of<LensDescription>(v).Shape == LensShape.EyeJitter, Text("jittered")),
        new("lens", ["focusDistance", "blades", "rotation"], v => Of<LensDescription>(v) is { ApertureRadius: 0, Shape: not LensShape.EyeJitter }, Text("pinhole")),
        new("filter", ["deviation"], v => Of<FilterDescription>(v).Shape != FilterShape.Gaussian, Text("gaussian")),
        new("filter", ["b", "c"], v => Of<FilterDescription>(v).Shape != FilterShape.Mitchell, Text("mitchell")),
        new("principled", ["refractiveIndex"], v => v.Child("specular")!.Node is not null, Text("specular")),
        new("principled", ["sheenTint"], v => IsZero(v, "sheen"), Text("noSheen")),
        new("principled", ["filmThickness", "filmIndex"], v => IsZero(v, "iridescence"), Text("noIridescence")),
        new("principled", ["clearcoatRoughness"], v => IsZero(v, "clearcoat"), Text("noClearcoat")),
        new("principled", ["interior"], v => IsZero(v, "transmission"), Text("opaque")),
        new("roughDielectric", ["alpha"], HasBothAlphas, Text("alphas")),
        new("roughConductor", ["alpha"], HasBothAlphas, Text("alphas")),
        new("noise", ["gain"], v => v.Number("octaves") <= 1, Text("oneOctave")),
        new("marble", ["octaves", "seed"], v => v.Number("turbulence") == 0, Text("noTurbulence")),
        new("wood", ["scale", "seed"], v => v.Number("turbulence") == 0, Text("noTurbulence")),
        new("spot", ["pictureUp"], v => v.Child("picture")!.Node is null, Text("noPicture")),
        new("point", ["mapping"], v => v.Child("picture")!.Node is null, Text("noPicture")),
        .. SceneTypes.Shapes.Types.Where(t => t.IsLight).Select(light => new IdleRule(light.Name, ["material"], _ => true, Text("noSurface"))),
    ];

    /// <summary>The parameters of a scene that have no effect, by their pointers, with the reasons.</summary>
    /// <param name="root">The scene. What is animated counts as having an effect.</param>
    public static IReadOnlyDictionary<string, string> Of(JsonNode root)
    {
        string[] animated = [.. KeyedEdit.Tracks(root).OfType<PropertyAddress>().Select(a => JsonPointer.Of(a.Steps))];
        Dictionary<string, string> idle = new(StringComparer.Ordinal);
        foreach (SceneValue value in Records(root).Where(v => !animated.Any(a => Picking.IsWithin(a, v.Pointer))))
        {
            foreach (IdleRule rule in Rules.Where(r => r.Record == value.Type!.Name && r.IsIdle(value)))
            {
                foreach (string key in rule.Parameters)
                {
                    idle.TryAdd(JsonPointer.Append(value.Pointer, key), rule.Reason);
                }
            }
        }

        return idle;
    }

    // Those that rules are about; sections are there even where nothing is written of them.
    private static IEnumerable<SceneValue> Records(JsonNode root)
    {
        SceneValue scene = SceneValue.Scene(root);
        (SceneValue camera, SceneValue render) = (scene.Child("camera")!, scene.Child("render")!);
        IEnumerable<SceneValue> sections = [camera, camera.Child("lens")!, render, render.Child("filter")!];
        HashSet<string> own = [.. sections.Select(s => s.Pointer)];
        HashSet<string> known = [.. Rules.Select(r => r.Record)];
        return sections.Concat(scene.WithInner().Where(v => v is { IsList: false, Type: not null, Node.Kind: JsonKind.Object } && known.Contains(v.Type.Name) && !own.Contains(v.Pointer)));
    }

    private static IdleRule Integrators(IntegratorTraits trait, params string[] parameters)
    {
        string[] names = [.. Integrator.Known.All.Where(i => i.Has(trait)).Select(i => i.Name)];
        string all = names.Length == 1 ? names[0] : $"{string.Join(", ", names[..^1])} or {names[^1]}";
        return new("render", parameters, v => !IntegratorOf(v).Has(trait), SessionTexts.Of("idle.integrator", all));
    }

    private static Integrator IntegratorOf(SceneValue render) =>
        render.Child("integrator")!.Node is { Kind: JsonKind.String } name && Integrator.Known.Find(name.Text) is { } known ? known : new RenderDescription().Integrator;

    private static string Text(string key) => SessionTexts.Of("idle." + key);

    private static T Of<T>(SceneValue value) => (T)value.Record();

    private static bool HasBothAlphas(SceneValue value) => value.Child("alphaU")!.Node is not null && value.Child("alphaV")!.Node is not null;

    private static bool IsZero(SceneValue value, string key) => value.Child(key)!.Node is null or { Number: 0 };
}
