using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Warns of what a scene has and its picture cannot show. Integrators that trace light refuse light that they do not know: with them
/// a scene is chosen for being right where others are only slow.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="description">The description that it was built from.</param>
/// <param name="builder">Takes the warnings.</param>
internal sealed class UnseenParts(Scene scene, SceneDescription description, SceneBuilder builder)
{
    // Lamps are small that seem so large from the camera: twice as large as the sun.
    private const float SmallLamp = 0.02f;
    private static readonly RenderDescription Standard = new();
    private readonly Integrator _integrator = scene.Render.Integrator;
    private readonly bool _refuses = scene.Render.Integrator.Has(IntegratorTraits.TracesLight);

    /// <summary>Returns true where a scene uses what only the report's integrator has.</summary>
    public static bool AreForReport(SceneDescription scene) => !scene.Ambient.IsBlack || scene.Render is not
    {
        WeakenedShadows: false, MaxDiffuseDepth: var diffuse, MaxSpecularDepth: var specular,
    } || (diffuse, specular) != (Standard.MaxDiffuseDepth, Standard.MaxSpecularDepth);

    /// <summary>Warns of what the integrator does not show.</summary>
    public void WarnOfIntegrator()
    {
        WarnOfOtherIntegrators();
        if (!_integrator.Has(IntegratorTraits.Light))
        {
            return;
        }

        WarnOfInsides();
        RefuseVaryingMedia();
        if (_refuses && scene.HasMattes)
        {
            AtIntegrator($"there are holdouts or shadow catchers, for which paths must come from the camera alone: write \"integrator\": {Quotation.Of(Integrator.Path.Name)} or {Quotation.Of(Integrator.VolPath.Name)}");
        }

        if (_integrator is LightTracingIntegrator traced)
        {
            RefuseUntraceable(traced.Strategies);
        }

        if (!_integrator.Has(IntegratorTraits.LitGloss))
        {
            WarnOfGloss();
        }
    }

    /// <summary>Warns of a picture that is black.</summary>
    public void WarnOfDarkness()
    {
        if (!_integrator.Has(IntegratorTraits.Light))
        {
            return;
        }

        if (!Shines())
        {
            builder.Warn(description, null, "nothing shines, so the picture is black: add a light, a luminaire, a \"background\" or an \"environment\"");
        }
        else if (EnclosingThing.IsAround(scene))
        {
            builder.Warn(
                description.Camera, nameof(CameraDescription.Position), "the camera is inside of an opaque thing without a light, so the picture is black");
        }
    }

    private void WarnOfOtherIntegrators()
    {
        WarnOf(
            _refuses,
            (IntegratorTraits.AmbientLight, description, nameof(description.Ambient), !scene.Ambient.IsBlack),
            (IntegratorTraits.WeakenedShadows, scene.Render, nameof(Standard.WeakenedShadows), scene.Render.WeakenedShadows),
            OfRender(IntegratorTraits.BounceLimits, nameof(Standard.MaxDiffuseDepth), r => r.MaxDiffuseDepth),
            OfRender(IntegratorTraits.BounceLimits, nameof(Standard.MaxSpecularDepth), r => r.MaxSpecularDepth));
        WarnOf(
            false,
            OfRender(IntegratorTraits.PathLimit, nameof(Standard.MaxDepth), r => r.MaxDepth),
            OfRender(IntegratorTraits.PathLimit, nameof(Standard.RouletteDepth), r => r.RouletteDepth));
        WarnOf(false, (IntegratorTraits.HiddenLights, scene.Render, nameof(Standard.HideLights), scene.Render.HideLights));
        WarnOf(false, (IntegratorTraits.StraightThrough, scene.Render, nameof(Standard.StraightThrough), scene.Render.StraightThrough));
        WarnOf(false, OfRender(IntegratorTraits.OcclusionDistance, nameof(Standard.OcclusionDistance), r => r.OcclusionDistance));
    }

    private (IntegratorTraits Trait, object Subject, string Property, bool IsGiven) OfRender(
        IntegratorTraits trait, string property, Func<RenderDescription, float> value) =>
        (trait, scene.Render, property, value(scene.Render) != value(Standard));

    // One message for all, with the integrator that has them.
    private void WarnOf(bool isRefused, params (IntegratorTraits Trait, object Subject, string Property, bool IsGiven)[] parts)
    {
        (IntegratorTraits Trait, object Subject, string Property, bool)[] ignored = [.. parts.Where(p => p.IsGiven && !_integrator.Has(p.Trait))];
        if (ignored is not [var first, ..])
        {
            return;
        }

        string[] keys = [.. ignored.Select(p => Quotation.Of(char.ToLowerInvariant(p.Property[0]) + p.Property[1..]))];
        string names = keys is [var only] ? $"{only} has" : $"{string.Join(", ", keys[..^1])} and {keys[^1]} have";
        string advice = keys.Length == 1 ? "leave it out" : "leave them out";
        IntegratorTraits all = ignored.Aggregate(IntegratorTraits.None, (traits, p) => traits | p.Trait);
        string other = Integrator.Known.All.First(i => i.Has(all)).Name;
        Action<object, string?, string> say = isRefused ? builder.Error : builder.Warn;
        say(
            first.Subject,
            first.Property,
            $"{names} no effect with the integrator {_integrator.Name}: {advice}, or write \"integrator\": {Quotation.Of(other)} under \"render\"");
    }

    private void WarnOfInsides()
    {
        if (!scene.HasNesting && Array.Exists(scene.Groups, g => g.Traits.Nesting is not null))
        {
            AtIntegrator($"there are dielectrics with priorities, which {Integrator.Only(IntegratorTraits.Priorities, "support")}");
        }

        if (!scene.HasMedia && Array.Exists(scene.Groups, g => g.Traits.Interior is not null))
        {
            AtIntegrator($"there are media inside shapes, which {Integrator.Only(IntegratorTraits.Media, "show")}");
        }
    }

    private void RefuseVaryingMedia()
    {
        if (scene.HasMedia && !_integrator.Has(IntegratorTraits.VaryingMedia) && (scene.Media.Varying.Length > 0 || scene.Media.Shine || scene.Media.HasFlakes))
        {
            string what = scene.Media.Varying.Length > 0 ? "vary in space" : scene.Media.Shine ? "shine" : "weaken light by its direction";
            builder.Error(
                description.Render, nameof(Standard.Integrator), $"there are media that {what}, which {Integrator.Only(IntegratorTraits.VaryingMedia, "show")}: write \"integrator\": {Quotation.Of(Integrator.Path.Name)}");
        }
    }

    private void AtIntegrator(string message)
    {
        Action<object, string?, string> say = _refuses ? builder.Error : builder.Warn;
        say(description.Render, nameof(Standard.Integrator), message);
    }

    private void RefuseUntraceable(Strategies strategies)
    {
        string other = $"write \"integrator\": {Quotation.Of(Integrator.Path.Name)} under \"render\"";
        if (!scene.Camera.CanLink)
        {
            builder.Error(
                description.Camera,
                nameof(CameraDescription.Projection),
                $"the integrator {_integrator.Name} asks where points are seen, which the projection {Quotation.Of(description.Camera.Projection.Name)} does not say: {other}");
        }

        // Light paths start on a disk just outside of all that has an end, which may lie on either side of such a surface.
        if (!scene.World.IsFinite && scene.SampledLights.Any(l => !IsNear(l)) && scene.Shapes.FirstOrDefault(IsEndlessBoundary) is { } shape)
        {
            builder.Error(
                builder.DescriptionOf(shape.Material) ?? (object)description,
                null,
                $"light from infinitely far away comes through a surface without end that has an inside, where the integrator {_integrator.Name} cannot start light paths: give it an end, or {other}");
        }

        // Where camera paths are followed to their ends, they find all light, if with more noise.
        if ((strategies & Strategies.Connections) == Strategies.None && scene.SampledLights.FirstOrDefault(l => !l.CanEmit) is { } light)
        {
            string name = light.Label?.Name is { } known ? $"the light source {Quotation.Of(known)}" : "a light source without a name";
            AtIntegrator($"no light paths can start at {name}, as the integrator {_integrator.Name} needs: {other}");
        }
    }

    private bool IsNear(LightSource light) => light.Extent((scene.Render.Shutter.X, scene.Render.Shutter.Y)).Box.IsFinite;

    private static bool IsEndlessBoundary(Shapes.Shape shape) =>
        !shape.Bounds.IsFinite && (shape.Material.Traits is { Interior: not null } or { Nesting: not null } or { IsBoundary: true });

    private bool Shines() => !scene.Background.IsBlack || scene.Environment is not null || scene.Lights.Count > 0
        || Array.Exists(scene.Groups, g => g.Traits.Emits) || (scene.HasMedia && scene.Media.Shine) || (!scene.Ambient.IsBlack && _integrator.Has(IntegratorTraits.AmbientLight));

    // Materials that reflect lights by chance alone.
    private void WarnOfGloss()
    {
        LightSource? light = scene.Lights.FirstOrDefault(l => l.IsDelta) ?? scene.Lights.FirstOrDefault(IsSmall);
        if (light is null)
        {
            return;
        }

        string unlit = light.IsDelta ? "lights without extent do not light this material" : "small lamps light this material by rare chance only";
        foreach (Material material in scene.Groups.Where(g => g.Traits is { Specular: SpecularLobe.Glossy, IsLit: false }).Select(g => g.Material).Distinct())
        {
            builder.Warn(
                builder.DescriptionOf(material) ?? (object)description,
                null,
                $"with the integrator {_integrator.Name}, {unlit}: write \"integrator\": {Quotation.Of(Integrator.Path.Name)} under \"render\"");
        }
    }

    private bool IsSmall(LightSource light)
    {
        Bounds box = light.Extent((scene.Render.Shutter.X, scene.Render.Shutter.Y)).Box;
        Vec3W from = scene.Camera.Origin(scene.Render.Shutter.X);
        return box.IsFinite
            && (box.Maximum - box.Minimum).Norm() < SmallLamp * ((box.Minimum * 0.5f) + (box.Maximum * 0.5f) - new System.Numerics.Vector3(from.X[0], from.Y[0], from.Z[0])).Norm();
    }
}
