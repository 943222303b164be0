using RayTracer.Numerics;

namespace RayTracer.Materials;

/// <summary>The distributions of the normals of a rough surface's microfacets.</summary>
public enum MicrofacetDistribution
{
    /// <summary>Trowbridge's and Reitz's distribution, with long tails.</summary>
    Ggx,

    /// <summary>Beckmann's distribution: slopes are normally distributed.</summary>
    Beckmann,
}

/// <summary>
/// The microfacets of a rough surface, in the frame whose z is the normal (Walter et al., Microfacet models for refraction through rough
/// surfaces, 2007; anisotropic as by Heitz, Understanding the masking-shadowing function in microfacet-based BRDFs, 2014). Masking is
/// Smith's; that of two directions is the product of both.
/// </summary>
internal readonly struct Microfacets
{
    /// <summary>Roughness below this is taken for this: floats could not resolve the directions.</summary>
    public const float SmallestAlpha = 1e-4f;

    // Walter's Lambda is below 1e-6 from here on.
    private const float Unmasked = 3f;

    private readonly FloatW _alphaU;
    private readonly FloatW _alphaV;
    private readonly MicrofacetDistribution _distribution;

    /// <summary>Microfacets of a roughness.</summary>
    /// <param name="distribution">The distribution of their normals.</param>
    /// <param name="alphaU">Roughness along x: √2 times the root mean square of Beckmann slopes.</param>
    /// <param name="alphaV">Roughness along y.</param>
    public Microfacets(MicrofacetDistribution distribution, FloatW alphaU, FloatW alphaV)
    {
        _distribution = distribution;
        _alphaU = FloatW.Max(alphaU, SmallestAlpha);
        _alphaV = FloatW.Max(alphaV, SmallestAlpha);
    }

    /// <summary>
    /// The density of normals per steradian, times the area that they have a unit of surface (Walter et al. 2007, eqs. 25 and 33).
    /// </summary>
    public FloatW Density(in Vec3W normal)
    {
        FloatW x = normal.X / _alphaU;
        FloatW y = normal.Y / _alphaV;
        FloatW z2 = normal.Z * normal.Z;
        FloatW slope2 = FloatW.MultiplyAdd(x, x, y * y);
        FloatW area = _alphaU * _alphaV * float.Pi;
        FloatW root = slope2 + z2;
        FloatW density = _distribution == MicrofacetDistribution.Beckmann
            ? LaneMath.Exp(-(slope2 / z2)) / (area * z2 * z2)
            : 1f / (area * root * root);
        return (normal.Z > 0f).Select(density, 0f);
    }

    /// <summary>The visible fraction of the microfacets of a normal: G₁ (Heitz 2014, eqs. 43, 63 and 72).</summary>
    /// <param name="direction">Unit direction to look from, on either side.</param>
    /// <param name="normal">The microfacets' unit normal.</param>
    public FloatW Masking(in Vec3W direction, in Vec3W normal)
    {
        FloatW x = direction.X * _alphaU;
        FloatW y = direction.Y * _alphaV;
        FloatW slope2 = FloatW.MultiplyAdd(x, x, y * y) / (direction.Z * direction.Z);
        FloatW masking = _distribution == MicrofacetDistribution.Beckmann ? Beckmann(slope2) : 2f / (1f + FloatW.Sqrt(1f + slope2));
        return (Vec3W.Dot(direction, normal) * direction.Z > 0f).Select(masking, 0f);
    }

    /// <summary>Density per steradian of <see cref="Sample"/>: D·G₁·cos/z (Heitz 2014, eq. 2).</summary>
    /// <param name="view">Unit direction to look from, above the surface.</param>
    /// <param name="normal">The microfacets' unit normal.</param>
    public FloatW VisibleDensity(in Vec3W view, in Vec3W normal) =>
        Density(normal) * Masking(view, normal) * FloatW.Abs(Vec3W.Dot(view, normal)) / view.Z;

    /// <summary>The BRDF of mirrors without loss: D·G₁·G₁/(4·cos·cos) (Walter et al. 2007, eq. 20).</summary>
    /// <param name="view">Unit direction to look from, above the surface.</param>
    /// <param name="light">Unit direction to the light, above the surface.</param>
    /// <param name="normal">Unit vector half-way between.</param>
    public FloatW Reflection(in Vec3W view, in Vec3W light, in Vec3W normal) =>
        Density(normal) * Masking(view, normal) * Masking(light, normal) / (view.Z * light.Z * 4f);

    /// <summary>Density per steradian of directions that are reflected by a <see cref="Sample"/> (Walter et al. 2007, eq. 14).</summary>
    /// <param name="view">Unit direction to look from, above the surface.</param>
    /// <param name="normal">Unit vector half-way to the direction.</param>
    public FloatW ReflectionPdf(in Vec3W view, in Vec3W normal) => Density(normal) * Masking(view, normal) / (view.Z * 4f);

    /// <summary>A normal of the microfacets that are seen, as often as it is seen.</summary>
    /// <param name="view">Unit direction to look from, above the surface.</param>
    /// <param name="u">First random number.</param>
    /// <param name="v">Second random number.</param>
    public Vec3W Sample(in Vec3W view, in FloatW u, in FloatW v)
    {
        Vec3W stretched = Vec3W.Normalize(new(view.X * _alphaU, view.Y * _alphaV, view.Z));
        Vec3W normal = _distribution == MicrofacetDistribution.Beckmann ? BeckmannNormal(stretched, u, v) : GgxNormal(stretched, u, v);
        return Vec3W.Normalize(new(normal.X * _alphaU, normal.Y * _alphaV, normal.Z));
    }

    // 1/(1 + Λ) with a = 1/√slope².
    private static FloatW Beckmann(FloatW slope2)
    {
        FloatW a = 1f / FloatW.Sqrt(FloatW.Max(slope2, 1e-6f));
        FloatW lambda = FloatW.MultiplyAdd(LaneMath.Exp(-(a * a)) / a, 0.5f * 0.5641895835f, (LaneMath.Erf(a) - 1f) * 0.5f);
        return (a < Unmasked).Select(1f / (1f + FloatW.Max(lambda, 0f)), 1f);
    }

    // For roughness 1: the half vector of the view and of a point, evenly distributed, of the cap of the sphere that the view can be reflected to
    // (Dupuy & Benyoub, Sampling visible GGX normals with spherical caps, 2023, listing 3; the distribution is that of Heitz, Sampling the
    // GGX distribution of visible normals, 2018).
    private static Vec3W GgxNormal(in Vec3W view, FloatW u, FloatW v)
    {
        LaneMath.SinCosTurn(v, out FloatW sin, out FloatW cos);
        FloatW height = (1f - u) * (1f + view.Z);
        FloatW z = height - view.Z;
        FloatW r = FloatW.Sqrt(FloatW.Max(FloatW.NegatedMultiplyAdd(z, z, 1f), 0f));
        return new(FloatW.MultiplyAdd(r, cos, view.X), FloatW.MultiplyAdd(r, sin, view.Y), height);
    }

    // For roughness 1: slopes in the frame of the view, the first by inverting its distribution in the variable erf(slope), the second normal
    // (Jakob, An improved visible normal sampling routine for the Beckmann distribution, 2014).
    private static Vec3W BeckmannNormal(in Vec3W view, in FloatW u, in FloatW v)
    {
        const float InverseRootPi = 0.5641895835f;
        FloatW sinTheta = FloatW.Sqrt(FloatW.MultiplyAdd(view.X, view.X, view.Y * view.Y));
        FloatW tan = sinTheta / view.Z;
        FloatW cot = FloatW.Min(view.Z / sinTheta, 10f);
        FloatW largest = LaneMath.Erf(cot);
        FloatW uniform = FloatW.Min(FloatW.Max(u, 1e-6f), 1f - 1e-6f);
        FloatW x = FloatW.NegatedMultiplyAdd(largest + 1f, LaneMath.Erf(FloatW.Sqrt(-LaneMath.Log(uniform))), largest);
        FloatW target = uniform * FloatW.MultiplyAdd(tan * InverseRootPi, LaneMath.Exp(-(cot * cot)), 1f + largest);
        for (int i = 0; i < 4; i++)
        {
            x = FloatW.Min(FloatW.Max(x, -0.9999998f), 0.9999998f);
            FloatW slope = LaneMath.InverseErf(x);
            FloatW value = FloatW.MultiplyAdd(tan * InverseRootPi, LaneMath.Exp(-(slope * slope)), 1f + x) - target;
            x -= value / FloatW.Max(FloatW.NegatedMultiplyAdd(slope, tan, 1f), 1e-4f);
        }

        FloatW along = LaneMath.InverseErf(FloatW.Min(FloatW.Max(x, -0.9999998f), 0.9999998f));
        FloatW across = LaneMath.InverseErf(FloatW.Min(FloatW.Max(FloatW.MultiplyAdd(v, 2f, -1f), -0.9999998f), 0.9999998f));
        MaskW isTilted = sinTheta > 0f;
        FloatW cosPhi = isTilted.Select(view.X / sinTheta, 1f);
        FloatW sinPhi = isTilted.Select(view.Y / sinTheta, 0f);
        return new(
            FloatW.NegatedMultiplyAdd(cosPhi, along, sinPhi * across),
            -FloatW.MultiplyAdd(sinPhi, along, cosPhi * across),
            1f);
    }
}
