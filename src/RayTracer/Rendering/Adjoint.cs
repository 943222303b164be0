using System.Runtime.CompilerServices;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textures;

namespace RayTracer.Rendering;

/// <summary>
/// Scattering as particles of light see it, which come along the ray and leave in a direction (Veach 1997, sections 3.7, 5.2 and 5.3). A
/// surface is turned for it, so that the ray of a camera comes from that direction: what the material then scatters of the light that comes
/// along the first ray is the adjoint BSDF, whether the material is reciprocal or not. Normals that are mirrored into view are those which
/// that ray would see.
/// </summary>
internal static class Adjoint
{
    // Normals that are found again are the same to the last bits.
    private const float SameNormal = 1e-8f;

    /// <summary>
    /// The density per steradian with which <see cref="Material.Scatter"/> would choose the way back along the ray for what comes from a
    /// direction: particles where a camera's path met the surface, camera paths where particles did (<see cref="SurfaceW.CarriesLight"/>).
    /// </summary>
    /// <param name="material">The material.</param>
    /// <param name="surface">The surface; turned meanwhile.</param>
    /// <param name="direction">Unit direction away from the surface.</param>
    /// <param name="pdf">The density.</param>
    public static void ReversePdf(Material material, ref SurfaceW surface, in Vec3W direction, out FloatW pdf)
    {
        Turn(material, ref surface, direction, carriesLight: !surface.CarriesLight, out Seen before);
        material.Pdf(surface, -before.Incoming, out pdf);
        before.Restore(ref surface);
    }

    /// <summary>
    /// What particles that come along the ray send on to a direction: <see cref="Bsdf"/> times <see cref="Cosines"/>. And the density with
    /// which a camera's path from there would choose their way back.
    /// </summary>
    /// <param name="material">The material.</param>
    /// <param name="surface">The surface that particles meet; turned meanwhile.</param>
    /// <param name="direction">Unit direction away from the surface.</param>
    /// <param name="scattered">The part of their power, per steradian, but for delta lobes.</param>
    /// <param name="reversePdf">The density per steradian.</param>
    public static void Evaluate(Material material, ref SurfaceW surface, in Vec3W direction, out RgbW scattered, out FloatW reversePdf)
    {
        Turn(material, ref surface, direction, carriesLight: false, out Seen before);
        Look(material, surface, before.Incoming, out scattered, out reversePdf);
        before.Restore(ref surface);
    }

    /// <summary>
    /// The adjoint BSDF but for delta lobes, in 1/sr without cosines: what part of the irradiance along the ray leaves to a direction as
    /// radiance. Where the two directions see different normals, it stands for the one that the ray sees.
    /// </summary>
    /// <param name="material">The material.</param>
    /// <param name="surface">The surface that particles meet; turned meanwhile.</param>
    /// <param name="direction">Unit direction away from the surface.</param>
    /// <param name="bsdf">The BSDF.</param>
    public static void Bsdf(Material material, ref SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Evaluate(material, ref surface, direction, out RgbW scattered, out _);
        FloatW cosines = Cosines(surface, direction);
        bsdf = scattered * (cosines > 0f).Select(1f / cosines, 0f);
    }

    /// <summary>
    /// The factor on the BSDF for particles: |from·s| / |from·n| · |to·n|, with n the surface's own normal and s the one with which it is
    /// shaded (Veach 1997, section 5.3).
    /// </summary>
    /// <param name="surface">The surface that particles meet.</param>
    /// <param name="direction">Unit direction in which they leave.</param>
    public static FloatW Cosines(in SurfaceW surface, in Vec3W direction) => CosinesFrom(surface, surface.Incoming, direction);

    /// <summary>Chooses how particles go on.</summary>
    /// <param name="material">The material.</param>
    /// <param name="surface">The surface, which from now on <see cref="SurfaceW.CarriesLight"/>; turned meanwhile.</param>
    /// <param name="samples">The random numbers of this vertex.</param>
    /// <param name="scatter">
    /// As <see cref="Material.Scatter"/> chooses it, with the particles' weight: what is scattered (<see cref="Evaluate"/>) over the pdf; of
    /// delta lobes, the part of the power that goes on.
    /// </param>
    /// <param name="pdf">The density with which the direction was chosen, but for delta lobes (<see cref="Material.Pdf"/>).</param>
    /// <param name="reversePdf">The density with which a camera's path from there would choose the way back.</param>
    public static void Scatter(
        Material material, ref SurfaceW surface, VertexSamples samples, out ScatterW scatter, out FloatW pdf, out FloatW reversePdf)
    {
        surface.CarriesLight = true;
        material.Scatter(surface, samples, out scatter);
        material.Pdf(surface, scatter.Direction, out pdf);
        Turn(material, ref surface, scatter.Direction, carriesLight: false, out Seen before);
        Look(material, surface, before.Incoming, out RgbW scattered, out reversePdf);
        if (scatter.Delta.Any)
        {
            CorrectDelta(surface, before, scatter.Direction, ref scatter.Weight);
        }

        before.Restore(ref surface);
        MaskW isPossible = pdf > 0f;
        scatter.Weight = scatter.Delta.Select(scatter.Weight, isPossible.Select(scattered * (1f / pdf), default));
        scatter.Absorbed |= ~(scatter.Delta | isPossible);
    }

    // The surface as seen along the ray that comes from a direction.
    private static void Turn(Material material, ref SurfaceW surface, in Vec3W direction, bool carriesLight, out Seen before)
    {
        Unsafe.SkipInit(out before);
        before.Keep(surface);
        surface.Incoming = -direction;
        surface.CarriesLight = carriesLight;
        SurfaceShader.TurnToRay(ref surface);
        if ((surface.Rules & NormalRules.Bent) != NormalRules.None)
        {
            SurfaceShader.Face(ref surface);
        }

        if ((surface.Rules & (NormalRules.Mapped | NormalRules.ByRay)) != NormalRules.None)
        {
            material.Prepare(ref surface);
            if ((material.Inputs & TextureInputs.VertexColor) == TextureInputs.None)
            {
                surface.DiffuseColor *= surface.Tint;
            }
        }
    }

    // What goes back along the ray, of the light that comes along another one.
    private static void Look(Material material, in SurfaceW turned, in Vec3W incoming, out RgbW scattered, out FloatW pdf)
    {
        material.Evaluate(turned, -incoming, out RgbW bsdf, out pdf);
        scattered = bsdf * CosinesFrom(turned, incoming, -turned.Incoming);
        scattered = SurfaceShader.Dropped(turned, -incoming).Select(default, scattered);
    }

    private static FloatW CosinesFrom(in SurfaceW surface, in Vec3W incoming, in Vec3W direction)
    {
        if (surface.Rules == NormalRules.InMedium)
        {
            return 1f;
        }

        FloatW cosine = FloatW.Abs(Vec3W.Dot(direction, surface.Normal));
        if ((surface.Rules & NormalRules.Bent) == NormalRules.None)
        {
            return cosine;
        }

        FloatW arriving = FloatW.Abs(Vec3W.Dot(incoming, surface.Normal));
        return (arriving > 0f).Select(FloatW.Abs(Vec3W.Dot(incoming, surface.Facing)) / arriving * cosine, 0f);
    }

    // Of delta lobes, the solid angles of the two directions are as what they project to the shading normal, which leaves
    // |from·s|·|to·n| / (|from·n|·|to·s|), for reflection and refraction alike. Where the way back would see another normal, no path of a
    // camera goes this way.
    private static void CorrectDelta(in SurfaceW turned, in Seen before, in Vec3W direction, ref RgbW weight)
    {
        if ((turned.Rules & NormalRules.Bent) == NormalRules.None)
        {
            return;
        }

        FloatW along = FloatW.Abs(Vec3W.Dot(direction, turned.Facing));
        FloatW kept = (along > 0f).Select(CosinesFrom(turned, before.Incoming, direction) / along, 0f);
        Vec3W off = before.Facing * FloatW.CopySign(1f, Vec3W.Dot(before.Facing, turned.Facing)) - turned.Facing;
        kept = (Vec3W.Dot(off, off) < SameNormal).Select(kept, 0f);
        weight *= SurfaceShader.Dropped(turned, -before.Incoming).Select(0f, kept);
    }

    // What depends on the ray; the second half of it only where rules say so.
    private struct Seen
    {
        private const NormalRules All = NormalRules.Mapped | NormalRules.ByRay | NormalRules.HasTangent;
        public Vec3W Incoming;
        public Vec3W Facing;
        private FloatW _cosine;
        private MaskW _inside;
        private bool _carriesLight;
        private Vec3W _tangent;
        private Vec3W _unmapped;
        private RgbW _diffuseColor;

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Keep(in SurfaceW surface)
        {
            Incoming = surface.Incoming;
            Facing = surface.Facing;
            _cosine = surface.Cosine;
            _inside = surface.Inside;
            _carriesLight = surface.CarriesLight;
            if ((surface.Rules & All) != NormalRules.None)
            {
                _tangent = surface.Tangent;
                _unmapped = surface.Unmapped;
                _diffuseColor = surface.DiffuseColor;
            }
        }

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public readonly void Restore(ref SurfaceW surface)
        {
            surface.Incoming = Incoming;
            surface.Facing = Facing;
            surface.Cosine = _cosine;
            surface.Inside = _inside;
            surface.CarriesLight = _carriesLight;
            if ((surface.Rules & All) != NormalRules.None)
            {
                surface.Tangent = _tangent;
                surface.Unmapped = _unmapped;
                surface.DiffuseColor = _diffuseColor;
            }
        }
    }
}
