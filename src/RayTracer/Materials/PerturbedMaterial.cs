using RayTracer.Numerics;

namespace RayTracer.Materials;

/// <summary>
/// A material that answers as another one does on a surface of other normals (Blinn, Simulation of wrinkled surfaces, 1978). Light that would leak through the
/// surface that is really there is dropped by the integrators, as with interpolated normals.
/// </summary>
/// <param name="inner">The other material.</param>
public abstract class PerturbedMaterial(Material inner) : WrapperMaterial(inner)
{
    /// <inheritdoc/>
    public override ScatteringProperties Scattering { get; } = inner.Scattering;

    /// <inheritdoc/>
    public override bool UsesUv => true;

    /// <inheritdoc/>
    public override bool UsesTangent => true;

    /// <inheritdoc/>
    public override bool TurnsNormal => true;

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

        // Seen from behind, it is mirrored across the plane perpendicular to the ray, so that it is not.
        FloatW along = Vec3W.Dot(surface.Incoming, facing);
        surface.Facing = Vec3W.NegatedMultiplyAdd(surface.Incoming, FloatW.Max(along, 0f) * 2f, facing);
        surface.Cosine = FloatW.Min(FloatW.Abs(along), 1f);
        surface.SetTangent();
        Inner.Prepare(ref surface);
    }

    /// <summary>The other normal, of any length.</summary>
    /// <param name="surface">The surface.</param>
    /// <param name="outward">Its outward unit normal.</param>
    /// <param name="normal">The other outward normal.</param>
    protected abstract void Perturb(in SurfaceW surface, in Vec3W outward, out Vec3W normal);
}
