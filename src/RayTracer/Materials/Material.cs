using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Materials;

/// <summary>
/// Emission and scattering of light by a surface. The contract, for all methods: directions are in world space and of unit length;
/// <see cref="SurfaceW.Incoming"/> points along the ray, towards the surface; <see cref="SurfaceW.Facing"/> is the unit normal on the side
/// that the ray comes from, <see cref="SurfaceW.Normal"/> the shape's own (outward) one. BRDFs are in 1/sr without the cosine; pdfs are per
/// solid angle. Lanes that are not in use hold numbers too, and their results are ignored.
/// </summary>
public abstract class Material
{
    /// <summary>The most materials that one may consist of.</summary>
    internal const int MostParts = 256;

    /// <summary>The record that it was made from; null where that is not kept.</summary>
    internal Description.MaterialDescription? Source { get; set; }

    /// <summary>Its name in the scene; null where it has none.</summary>
    internal string? Name { get; set; }

    /// <summary>The inputs that its textures depend on, as far as they come from descriptions.</summary>
    internal Textures.TextureInputs Inputs { get; set; }

    /// <summary>The material's constants.</summary>
    public abstract MaterialTraits Traits { get; }

    /// <summary>The number of materials that may have to answer for this one, each as often as it is a part; counted up to one more than <see cref="MostParts"/>.</summary>
    internal virtual int Parts => 1;

    /// <summary>
    /// Whether <see cref="Prepare"/> may depend on the ray: that of the core's own materials does so for maps only
    /// (<see cref="MaterialTraits.TurnsNormal"/>), and what others' do is not known.
    /// </summary>
    internal virtual bool PreparesByRay => GetType().Assembly != typeof(Material).Assembly;

    /// <summary>
    /// Evaluates what several of the other methods need, once, before any of them is called: <see cref="SurfaceW.DiffuseColor"/>.
    /// </summary>
    public virtual void Prepare(ref SurfaceW surface)
    {
    }

    /// <summary>Radiance emitted against the ray (report: EmittedRadiance).</summary>
    /// <param name="cosine">
    /// Cosine between the shape's outward normal and the direction of emission; no light where it is not positive.
    /// </param>
    /// <param name="u">First surface coordinate.</param>
    /// <param name="v">Second surface coordinate.</param>
    /// <param name="radiance">The radiance.</param>
    public virtual void Emission(in FloatW cosine, in FloatW u, in FloatW v, out RgbW radiance) => radiance = default;

    /// <summary>The factor on ambient light (report: AmbientResponse).</summary>
    public virtual void AmbientResponse(in SurfaceW surface, out RgbW response) => response = default;

    /// <summary>
    /// The fraction of the light that the surface sends on, for the auxiliary image of that name: the factor on ambient light,
    /// unless the material is clear.
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
    /// <param name="surface">The point at which the path meets the surface.</param>
    /// <param name="direction">Unit direction away from the surface, to where light would come from.</param>
    /// <param name="bsdf">The BSDF; zero where only a delta lobe scatters.</param>
    public virtual void Bsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf) => bsdf = default;

    /// <summary>
    /// The part of <see cref="Bsdf"/> that is matt: what a surface scatters as if it had no gloss, reflected or let through. Layers of
    /// light separate it from the rest.
    /// </summary>
    /// <param name="surface">The point at which the path meets the surface.</param>
    /// <param name="direction">Unit direction away from the surface, to where light would come from.</param>
    /// <param name="bsdf">The part, in 1/sr without the cosine.</param>
    public virtual void DiffuseBsdf(in SurfaceW surface, in Vec3W direction, out RgbW bsdf)
    {
        Brdf(surface, out bsdf);
        bsdf = (Vec3W.Dot(direction, surface.Facing) > 0f).Select(bsdf, default);
    }

    /// <summary>
    /// The density, per steradian, with which <see cref="Scatter"/> chooses a direction. Its integral falls short of 1
    /// by the share of paths that end (<see cref="ScatterW.Absorbed"/>) and of delta lobes.
    /// </summary>
    /// <param name="surface">The point at which the path meets the surface.</param>
    /// <param name="direction">Unit direction away from the surface.</param>
    /// <param name="pdf">The density.</param>
    public virtual void Pdf(in SurfaceW surface, in Vec3W direction, out FloatW pdf) => pdf = 0f;

    /// <summary><see cref="Bsdf"/> and <see cref="Pdf"/> at once.</summary>
    /// <param name="surface">The point at which the path meets the surface.</param>
    /// <param name="direction">Unit direction away from the surface.</param>
    /// <param name="bsdf">The BSDF.</param>
    /// <param name="pdf">The density.</param>
    public virtual void Evaluate(in SurfaceW surface, in Vec3W direction, out RgbW bsdf, out FloatW pdf)
    {
        Bsdf(surface, direction, out bsdf);
        Pdf(surface, direction, out pdf);
    }

    /// <summary>
    /// What part of the light that comes along the ray goes through the surface, whether it is bent there or not: what weakened shadows are
    /// left with (report, section 4.3.1).
    /// </summary>
    /// <param name="surface">The point at which a ray towards a light meets the surface.</param>
    /// <param name="transparency">The fraction.</param>
    public virtual void Transparency(in SurfaceW surface, out RgbW transparency) => transparency = default;

    /// <summary>
    /// What part of the light goes straight through, as through a hole or a pane: the mean weight of the choices of <see cref="Scatter"/> that are a delta
    /// lobe along <see cref="SurfaceW.Incoming"/>. What refraction bends is no part of it.
    /// </summary>
    /// <param name="surface">The point at which a ray meets the surface.</param>
    /// <param name="share">The fraction.</param>
    public virtual void Straight(in SurfaceW surface, out RgbW share) => share = default;

    /// <summary>Chooses the next ray of a path (report: DiffuseDirection).</summary>
    /// <param name="surface">The point at which the path meets the surface.</param>
    /// <param name="samples">The random numbers of this vertex.</param>
    /// <param name="scatter">
    /// The new direction and its weight, BSDF · |cosine| / pdf of the chosen lobe: where several lobes may choose one direction, the
    /// mean of their weights is <see cref="Bsdf"/> · |cosine| / <see cref="Pdf"/>. Where the surface <see cref="SurfaceW.CarriesLight"/>,
    /// only the weights of delta lobes count.
    /// </param>
    public abstract void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter);
}

/// <summary>The points where paths meet a surface.</summary>
public struct SurfaceW
{
    /// <summary>The point.</summary>
    public Vec3W Point;

    /// <summary>The point in the coordinates in which the shape's own numbers are given; set only where a texture depends on it.</summary>
    public Vec3W Local;

    /// <summary>The shape's own unit normal, outward.</summary>
    public Vec3W Normal;

    /// <summary>
    /// The unit normal with which light is scattered, on the side that the ray comes from: <see cref="Normal"/> or its opposite, unless the
    /// surface is shaded as if it were smoother than it is.
    /// </summary>
    public Vec3W Facing;

    /// <summary>
    /// The outward unit normal with which the surface is shaded, before maps turn it; set only where it may differ from <see cref="Normal"/>.
    /// </summary>
    public Vec3W Shading;

    // What Facing would be without the innermost map, on the side that is seen. Set only by maps.
    internal Vec3W Unmapped;

    /// <summary>
    /// Unit vector along which u grows, perpendicular to <see cref="Facing"/>; set only where <see cref="MaterialTraits.UsesTangent"/>.
    /// </summary>
    public Vec3W Tangent;

    /// <summary>The derivatives of the point by u and by v; set only where <see cref="MaterialTraits.UsesTangent"/>.</summary>
    public Vec3W AlongU, AlongV;

    /// <summary>The factor on the diffuse colour: 1 where surfaces have no colours of their own.</summary>
    public RgbW Tint;

    // What a mesh's second colours are there; set only where a texture shows them.
    internal RgbW SecondTint;

    /// <summary>Unit direction of the ray, towards the surface.</summary>
    public Vec3W Incoming;

    /// <summary>Length of the ray; set only where <see cref="MaterialTraits.UsesDistance"/>.</summary>
    public FloatW Distance;

    /// <summary>
    /// The path's wavelength in µm, or a yellow one where it has none; set only where <see cref="MaterialTraits.Disperses"/>.
    /// </summary>
    public FloatW Wavelength;

    /// <summary>
    /// Refractive index of what is on the other side of the shape, relative to empty space; set only where
    /// <see cref="MaterialTraits.Nesting"/> gives the inside's.
    /// </summary>
    public FloatW ExteriorIndex;

    /// <summary>
    /// Surface coordinates; set only where <see cref="MaterialTraits.UsesUv"/>. In a medium, its number, and the density of being scattered
    /// per length.
    /// </summary>
    public FloatW U, V;

    /// <summary>Cosine between <see cref="Facing"/> and the direction back along the ray; never negative.</summary>
    public FloatW Cosine;

    /// <summary>The ray comes from inside, against the shape's own normal.</summary>
    public MaskW Inside;

    /// <summary>Colour of the diffuse part; set by <see cref="Material.Prepare"/>, then multiplied by <see cref="Tint"/>.</summary>
    public RgbW DiffuseColor;

    /// <summary>
    /// The distance from the point at which a new ray must start, along the normal, so as not to meet the same surface again.
    /// </summary>
    public FloatW Offset;

    // Where an instance shows the surface: which one, and the point, normal and offset in its space, where new rays of the instance start. Set
    // only there.
    internal UIntW Instance;
    internal Vec3W InnerPoint, InnerNormal;
    internal FloatW InnerOffset;

    /// <summary>The shapes of their batch that are met. Behind the registers, for it is no whole number of them.</summary>
    public Acceleration.PrimitiveIndex Primitives;

    // How Facing follows from the ray.
    internal NormalRules Rules;

    /// <summary>
    /// Particles of light come along the ray, not the view: a delta lobe's weight is the part of their power that goes on, without the squared
    /// index by which refraction changes radiance, and what a material does by the side of the camera, it does by the side to which they go.
    /// </summary>
    public bool CarriesLight;

    /// <summary>
    /// Sets <see cref="Tangent"/> to what <see cref="AlongU"/> is beside <see cref="Facing"/>; where that is nothing, or no number, to any
    /// direction there.
    /// </summary>
    public void SetTangent()
    {
        Vec3W beside = Vec3W.NegatedMultiplyAdd(Facing, Vec3W.Dot(AlongU, Facing), AlongU);
        FloatW length2 = Vec3W.Dot(beside, beside);
        Onb.FromNormal(Facing, out Onb any);
        MaskW isGood = length2 > 1e-30f & length2 < 1e30f;
        Tangent = isGood.Select(beside * (1f / FloatW.Sqrt(length2)), any.U);
    }

    /// <summary>The frame in which microfacets are described: W is <see cref="Facing"/>.</summary>
    /// <param name="isTurned">True if U must be <see cref="Tangent"/>; any direction otherwise.</param>
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

/// <summary>The next rays of paths that leave a surface.</summary>
public struct ScatterW
{
    /// <summary>Unit direction of the new ray.</summary>
    public Vec3W Direction;

    /// <summary>Factor on the light that arrives along the new ray.</summary>
    public RgbW Weight;

    /// <summary>
    /// The choice was a mirror-like lobe that light sources are not sampled for: it counts against the specular
    /// depth, and emission met by the new ray counts (report: cel).
    /// </summary>
    public MaskW Specular;

    /// <summary>
    /// The choice was a single direction, which neither <see cref="Material.Bsdf"/> nor <see cref="Material.Pdf"/> holds.
    /// </summary>
    public MaskW Delta;

    /// <summary>The path ends here.</summary>
    public MaskW Absorbed;
}
