using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Materials;

/// <summary>The treatment of normals that a map turns away from the ray.</summary>
public enum TurnedNormal
{
    /// <summary>It is mirrored across the plane perpendicular to the ray.</summary>
    Mirror,

    /// <summary>
    /// Its slopes change their sign: a facet that cannot be seen is replaced by the one across the valley (after Schüßler et al. 2017).
    /// </summary>
    Flip,

    /// <summary>The surface is seen from behind.</summary>
    Back,
}

/// <summary>
/// A material that answers as another one does on a surface of other normals (Blinn, Simulation of wrinkled surfaces, 1978). Light that
/// would leak through the surface that is really there is dropped by the integrators, as with interpolated normals.
/// </summary>
/// <param name="inner">The other material.</param>
internal abstract class PerturbedMaterial(Material inner) : WrapperMaterial(inner)
{
    /// <inheritdoc/>
    public override MaterialTraits Traits
    {
        get
        {
            MaterialTraits traits = base.Traits with { UsesTangent = true, TurnsNormal = true, MirrorsNormal = Turned == TurnedNormal.Mirror };

            // What is left of light depends on where it comes from, which sampling of lights for a BRDF that is the same for all directions
            // does not know.
            return IsPlain ? traits : traits with
            {
                IsLit = false,
                Specular = traits.HasDensity ? SpecularLobe.Glossy : traits.Specular,
                KeepsEnergy = false,
                ReciprocityException = "what a map turns away depends on the ray, and light is weakened by its angle of arrival",
            };
        }
    }

    /// <summary>The treatment of normals that the map turns away from the ray.</summary>
    public TurnedNormal Turned { get; init; }

    /// <summary>
    /// Whether light that arrives along the surface is weakened where the map turns the normal towards it (Conty Estevez, Lecocq &amp;
    /// Stein 2019).
    /// </summary>
    public bool SoftensShadow { get; init; }

    /// <inheritdoc/>
    public override void Prepare(ref SurfaceW surface)
    {
        // The outward normal with which the surface is shaded so far.
        Vec3W outward = surface.Inside.Select(-surface.Facing, surface.Facing);
        Perturb(surface, outward, out Vec3W normal);
        normal = Vec3W.Normalize(normal);
        MaskW isGood = Vec3W.Dot(normal, normal) > 0.5f & Vec3W.Dot(normal, normal) < 2f;
        normal = isGood.Select(normal, outward);
        Vec3W facing = surface.Inside.Select(-normal, normal);

        FloatW along = Vec3W.Dot(surface.Incoming, facing);
        Face(ref along, facing, ref surface);
        surface.Cosine = FloatW.Min(FloatW.Abs(along), 1f);
        surface.SetTangent();
        Inner.Prepare(ref surface);
    }

    /// <inheritdoc/>
    public override void Brdf(in SurfaceW surface, out RgbW brdf)
    {
        brdf = default;
        if (IsPlain)
        {
            Inner.Brdf(surface, out brdf);
        }
    }

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        base.Scatter(surface, samples, out scatter);
        if (!IsPlain)
        {
            Vec3W light = Light(surface, scatter.Direction);
            scatter.Weight *= Passing(surface, light);
            scatter.Absorbed |= Leaks(surface, light);
            scatter.Specular = MaskW.All;
        }
    }

    /// <inheritdoc/>
    protected override ref readonly SurfaceW See(in SurfaceW surface, ref SurfaceW room)
    {
        if (Turned != TurnedNormal.Back)
        {
            return ref surface;
        }

        // From behind, where the map has turned the surface that far.
        room = surface;
        MaskW isTurned = Vec3W.Dot(surface.Incoming, surface.Unmapped) > 0f;
        room.Inside = (surface.Inside | isTurned).Except(surface.Inside & isTurned);
        return ref room;
    }

    /// <inheritdoc/>
    protected override void Dim(in SurfaceW surface, in Vec3W direction, ref RgbW bsdf, ref FloatW pdf)
    {
        if (!IsPlain)
        {
            Vec3W light = Light(surface, direction);
            bsdf *= Passing(surface, light);
            pdf = Leaks(surface, light).Select(0f, pdf);
        }
    }

    /// <summary>The other normal, of any length.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="outward">Its outward unit normal.</param>
    /// <param name="normal">The other outward normal.</param>
    protected abstract void Perturb(in SurfaceW surface, in Vec3W outward, out Vec3W normal);

    private bool IsPlain => Turned == TurnedNormal.Mirror && !SoftensShadow;

    // Sets the normal on the ray's side, and the surface's own beside it.
    private void Face(ref FloatW along, in Vec3W facing, ref SurfaceW surface)
    {
        Vec3W own = surface.Facing;
        MaskW isTurned = along > 0f;
        switch (Turned)
        {
            case TurnedNormal.Flip:
                Vec3W flipped = Vec3W.MultiplyAdd(own, Vec3W.Dot(own, facing) * 2f, -facing);

                // What the map turns below the surface itself cannot be flipped into view.
                flipped = (Vec3W.Dot(surface.Incoming, flipped) < 0f).Select(flipped, own);
                surface.Facing = isTurned.Select(flipped, facing);
                along = isTurned.Select(Vec3W.Dot(surface.Incoming, flipped), along);
                break;
            case TurnedNormal.Back:
                surface.Facing = isTurned.Select(-facing, facing);
                own = isTurned.Select(-own, own);
                break;
            default:
                surface.Facing = Vec3W.NegatedMultiplyAdd(surface.Incoming, FloatW.Max(along, 0f) * 2f, facing);
                break;
        }

        surface.Unmapped = own;
    }

    // Where the light comes from.
    private static Vec3W Light(in SurfaceW surface, in Vec3W direction) => surface.CarriesLight ? -surface.Incoming : direction;

    // Directions on different sides of the surface and of what it looks like, where integrators may take the normals literally.
    private MaskW Leaks(in SurfaceW surface, in Vec3W direction) => Turned == TurnedNormal.Mirror
        ? MaskW.None
        : Vec3W.Dot(direction, surface.Unmapped) * Vec3W.Dot(direction, surface.Facing) <= 0f;

    // What is left of light from a direction: as microfacets would shade each other whose normals are spread as far as the map turns this
    // one (Conty Estevez, Lecocq & Stein 2019).
    private FloatW Passing(in SurfaceW surface, in Vec3W direction)
    {
        FloatW passing = Leaks(surface, direction).Select(0f, 1f);
        if (!SoftensShadow)
        {
            return passing;
        }

        FloatW turned = SquaredTangent(Vec3W.Dot(surface.Unmapped, surface.Facing));
        FloatW alpha2 = FloatW.Min(turned * 0.125f, 1f);
        FloatW tangent2 = SquaredTangent(Vec3W.Dot(surface.Unmapped, direction));
        return passing * 2f / (1f + FloatW.Sqrt(FloatW.MultiplyAdd(alpha2, tangent2, 1f)));
    }

    private static FloatW SquaredTangent(FloatW cosine)
    {
        FloatW cosine2 = FloatW.Max(cosine * cosine, 1e-12f);
        return FloatW.Max(1f - cosine2, 0f) / cosine2;
    }
}
