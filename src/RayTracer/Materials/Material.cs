using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Materials;

/// <summary>
/// How a surface emits and scatters light. The contract, for all methods:
/// directions are in world space and of unit length; <see cref="SurfaceW.Incoming"/> points along the ray, towards the
/// surface; <see cref="SurfaceW.Facing"/> is the unit normal on the side that the ray comes from, <see cref="SurfaceW.Normal"/>
/// the shape's own (outward) one. BRDFs are in 1/sr without the cosine; pdfs are per solid angle. Lanes that are not in use hold numbers too, and their results are ignored.
/// </summary>
public abstract class Material
{
    /// <summary>What it was made from; null where that is not kept.</summary>
    internal Description.MaterialDescription? Source { get; set; }

    /// <summary>What its textures depend on, as far as they come from descriptions.</summary>
    internal Textures.TextureInputs Inputs { get; set; }

    /// <summary>Which laws of scattering the material keeps.</summary>
    public abstract ScatteringProperties Scattering { get; }

    /// <summary>Whether light sources are sampled at hits on it: whether <see cref="Brdf"/> may be other than zero.</summary>
    public virtual bool IsLit => false;

    /// <summary>Whether <see cref="Bsdf"/> and <see cref="Pdf"/> may be other than zero, so that light can come from a direction that is chosen elsewhere.</summary>
    public virtual bool HasDensity => IsLit || Scattering.Specular == SpecularLobe.Glossy;

    /// <summary>Whether <see cref="Bsdf"/> may be other than zero for directions through the surface.</summary>
    public virtual bool Transmits => false;

    /// <summary>What fills the inside of the shape; null for empty space.</summary>
    public virtual Medium? Interior => null;

    /// <summary>How the inside goes with others that overlap it; null for a boundary whose refractive index is relative to what is around.</summary>
    public virtual Nesting? Nesting => null;

    /// <summary>Whether all light goes straight through, so that a path has no vertex here.</summary>
    public virtual bool IsBoundary => false;

    /// <summary>Whether <see cref="Emission"/> may be other than zero.</summary>
    public virtual bool Emits => false;

    /// <summary>Whether any result depends on uv; where not, uv need not be computed.</summary>
    public virtual bool UsesUv => false;

    /// <summary>Whether any result depends on <see cref="SurfaceW.Tangent"/>; then it uses uv too.</summary>
    public virtual bool UsesTangent => false;

    /// <summary>Whether <see cref="Prepare"/> turns <see cref="SurfaceW.Facing"/>.</summary>
    public virtual bool TurnsNormal => false;

    /// <summary>Whether normals that would face away are mirrored into view, which leaves nothing to be taken literally (<see cref="Description.ShadingNormals"/>).</summary>
    public virtual bool MirrorsNormal => false;

    /// <summary>Whether scattering depends on <see cref="SurfaceW.Wavelength"/>.</summary>
    public virtual bool Disperses => false;

    /// <summary>Whether scattering depends on <see cref="SurfaceW.Distance"/>, the length of the ray.</summary>
    public virtual bool UsesDistance => false;

    /// <summary>
    /// Evaluates what several of the other methods need, once, before any of them is called:
    /// <see cref="SurfaceW.DiffuseColor"/>.
    /// </summary>
    public virtual void Prepare(ref SurfaceW surface)
    {
    }

    /// <summary>Radiance emitted against the ray (report: EmittedRadiance).</summary>
    /// <param name="cosine">Cosine between the shape's outward normal and the direction of emission; no light where it is not positive.</param>
    /// <param name="u">First surface coordinate.</param>
    /// <param name="v">Second surface coordinate.</param>
    /// <param name="radiance">The radiance.</param>
    public virtual void Emission(in FloatW cosine, in FloatW u, in FloatW v, out RgbW radiance) => radiance = default;

    /// <summary>What ambient light is multiplied by (report: AmbientResponse).</summary>
    public virtual void AmbientResponse(in SurfaceW surface, out RgbW response) => response = default;

    /// <summary>
    /// The fraction of the light that the surface sends on, for the auxiliary image of that name: what ambient light is multiplied by, unless the
    /// material is clear.
    /// </summary>
    public virtual void Albedo(in SurfaceW surface, out RgbW albedo) => AmbientResponse(surface, out albedo);

    /// <summary>
    /// The part of the BRDF that light sources are sampled for (report: ExplicitBRDF), the same for all directions of
    /// light on the ray's side of the surface. Light that arrives through any other part is met by scattered rays only.
    /// </summary>
    public virtual void Brdf(in SurfaceW surface, out RgbW brdf) => brdf = default;

    /// <summary>
    /// The whole BSDF but for delta lobes, in 1/sr without the cosine: what part of the irradiance from <paramref name="direction"/>
    /// goes back along the ray as radiance. <see cref="Brdf"/> is a part of it.
    /// </summary>
    /// <param name="surface">Where the path meets the surface.</param>
    /// <param name="direction">Unit direction away from the surface, to where light would come from.</param>
    /// <param name="bsdf">The BSDF; zero where only a delta lobe scatters.</param>
    public virtual void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf) => bsdf = default;

    /// <summary>
    /// The part of <see cref="Bsdf"/> that is matt: what a surface scatters as if it had no gloss, reflected or let through. Layers of light tell it
    /// from the rest.
    /// </summary>
    /// <param name="surface">Where the path meets the surface.</param>
    /// <param name="direction">Unit direction away from the surface, to where light would come from.</param>
    /// <param name="bsdf">The part, in 1/sr without the cosine.</param>
    public virtual void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Brdf(surface, out bsdf);
        bsdf = (Vec3W.Dot(direction, surface.Facing) > 0f).Select(bsdf, default);
    }

    /// <summary>
    /// The density, per steradian, with which <see cref="Scatter"/> lets a path go on in a direction. Its integral falls short of 1
    /// by the share of paths that end (<see cref="ScatterW.Absorbed"/>) and of delta lobes.
    /// </summary>
    /// <param name="surface">Where the path meets the surface.</param>
    /// <param name="direction">Unit direction away from the surface.</param>
    /// <param name="pdf">The density.</param>
    public virtual void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf) => pdf = 0f;

    /// <summary><see cref="Bsdf"/> and <see cref="Pdf"/> at once.</summary>
    /// <param name="surface">Where the path meets the surface.</param>
    /// <param name="direction">Unit direction away from the surface.</param>
    /// <param name="bsdf">The BSDF.</param>
    /// <param name="pdf">The density.</param>
    public virtual void Evaluate(in SurfaceW surface, in Vec3W direction, out RgbW bsdf, out FloatW pdf)
    {
        Bsdf(surface, direction, out bsdf);
        Pdf(surface, direction, out pdf);
    }

    /// <summary>Whether <see cref="Transparency"/> may be other than zero.</summary>
    public virtual bool IsTransparent => false;

    /// <summary>
    /// What part of the light that comes along the ray goes through the surface, whether it is bent there or not: what weakened shadows are left with (report, section 4.3.1).
    /// </summary>
    /// <param name="surface">Where a ray towards a light meets the surface.</param>
    /// <param name="transparency">The fraction.</param>
    public virtual void Transparency(in SurfaceW surface, out RgbW transparency) => transparency = default;

    /// <summary>Chooses how a path goes on (report: DiffuseDirection).</summary>
    /// <param name="surface">Where the path meets the surface.</param>
    /// <param name="samples">The random numbers of this vertex.</param>
    /// <param name="scatter">
    /// The new direction and its weight, BSDF · |cosine| / pdf of the chosen lobe: where several lobes may choose one direction, the
    /// mean of their weights is <see cref="Bsdf"/> · |cosine| / <see cref="Pdf"/>.
    /// </param>
    public abstract void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter);
}

/// <summary>Where paths meet a surface.</summary>
public struct SurfaceW
{
    /// <summary>The point.</summary>
    public Vec3W Point;

    /// <summary>The point in the coordinates in which the shape's own numbers are given; set only where a texture depends on it.</summary>
    public Vec3W Local;

    /// <summary>The shape's own unit normal, outward.</summary>
    public Vec3W Normal;

    /// <summary>
    /// The unit normal with which light is scattered, on the side that the ray comes from: <see cref="Normal"/> or its opposite, unless the surface is shaded
    /// as if it were smoother than it is.
    /// </summary>
    public Vec3W Facing;

    /// <summary>The outward unit normal with which the surface is shaded; set only where it may differ from <see cref="Normal"/>.</summary>
    public Vec3W Shading;

    /// <summary>
    /// Unit vector along which u grows, perpendicular to <see cref="Facing"/>; set only where <see cref="Material.UsesTangent"/>.
    /// </summary>
    public Vec3W Tangent;

    /// <summary>How the point moves with u and with v; set only where <see cref="Material.UsesTangent"/>.</summary>
    public Vec3W AlongU, AlongV;

    /// <summary>What the diffuse colour is multiplied by: 1 where surfaces have no colours of their own.</summary>
    public RgbW Tint;

    /// <summary>Unit direction of the ray, towards the surface.</summary>
    public Vec3W Incoming;

    /// <summary>Length of the ray; set only where <see cref="Material.UsesDistance"/>.</summary>
    public FloatW Distance;

    /// <summary>The path's wavelength in µm, or a yellow one where it has none; set only where <see cref="Material.Disperses"/>.</summary>
    public FloatW Wavelength;

    /// <summary>Refractive index of what is on the other side of the shape, relative to empty space; set only where <see cref="Material.Nesting"/> tells the inside's.</summary>
    public FloatW Around;

    /// <summary>Surface coordinates; set only where <see cref="Material.UsesUv"/>.</summary>
    public FloatW U, V;

    /// <summary>Cosine between <see cref="Facing"/> and the direction back along the ray; never negative.</summary>
    public FloatW Cosine;

    /// <summary>Whether the ray comes from inside, against the shape's own normal.</summary>
    public MaskW Inside;

    /// <summary>Colour of the diffuse part; set by <see cref="Material.Prepare"/>, then multiplied by <see cref="Tint"/>.</summary>
    public RgbW DiffuseColor;

    /// <summary>How far a new ray must start from the point, along the normal, so as not to meet the same surface again.</summary>
    public FloatW Offset;

    /// <summary>Which shapes of their batch are met. Last, for it is no whole number of registers.</summary>
    public Acceleration.PrimitiveIndex Primitives;

    /// <summary>Sets <see cref="Tangent"/> to what <see cref="AlongU"/> is beside <see cref="Facing"/>; where that is nothing, or no number, to any direction there.</summary>
    public void SetTangent()
    {
        Vec3W beside = Vec3W.NegatedMultiplyAdd(Facing, Vec3W.Dot(AlongU, Facing), AlongU);
        FloatW length2 = Vec3W.Dot(beside, beside);
        Onb.FromNormal(Facing, out Onb any);
        MaskW isGood = length2 > 1e-30f & length2 < 1e30f;
        Tangent = isGood.Select(beside * (1f / FloatW.Sqrt(length2)), any.U);
    }

    /// <summary>The frame in which microfacets are described: W is <see cref="Facing"/>.</summary>
    /// <param name="isTurned">Whether U must be <see cref="Tangent"/>; any direction otherwise.</param>
    /// <param name="frame">The frame.</param>
    public readonly void Frame(bool isTurned, out Onb frame)
    {
        if (isTurned)
        {
            frame = new(Tangent, Vec3W.Cross(Facing, Tangent), Facing);
            return;
        }

        Onb.FromNormal(Facing, out frame);
    }
}

/// <summary>How paths go on from a surface.</summary>
public struct ScatterW
{
    /// <summary>Unit direction of the new ray.</summary>
    public Vec3W Direction;

    /// <summary>Factor on the light that arrives along the new ray.</summary>
    public RgbW Weight;

    /// <summary>
    /// Whether the choice was a mirror-like lobe that light sources are not sampled for: it counts against the specular
    /// depth, and emission met by the new ray counts (report: cel).
    /// </summary>
    public MaskW Specular;

    /// <summary>Whether the choice was a single direction, which neither <see cref="Material.Bsdf"/> nor <see cref="Material.Pdf"/> holds.</summary>
    public MaskW Delta;

    /// <summary>Whether the path ends here.</summary>
    public MaskW Absorbed;
}
