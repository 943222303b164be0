using RayTracer.Numerics;

namespace RayTracer.Materials;

/// <summary>
/// How much light a rough boundary lets through from outside, and how much it reflects from inside: tables by numerical integration over the
/// microfacets that are seen.
/// </summary>
internal sealed unsafe class RoughTransmittance
{
    private const int Angles = 64;
    private const int Side = 64;
    private readonly PinnedBuffer<float> _memory = new(Angles + 1);
    private readonly float* _into;

    /// <summary>Integrates.</summary>
    /// <param name="distribution">The distribution of the microfacets' normals.</param>
    /// <param name="alpha">Roughness.</param>
    /// <param name="refractiveIndex">Index of the inside over that of the outside.</param>
    public RoughTransmittance(MicrofacetDistribution distribution, float alpha, float refractiveIndex)
    {
        Microfacets microfacets = new(distribution, alpha, alpha);
        _into = _memory.Pointer;
        for (int i = 0; i <= Angles; i++)
        {
            Integrate(microfacets, Math.Max(i / (float)Angles, 1e-3f), 1 / refractiveIndex, out _, out _into[i]);
        }

        // Light from all directions alike, from inside: the midpoint rule over the cosine.
        double sum = 0;
        for (int i = 0; i < Angles; i++)
        {
            float cosine = (i + 0.5f) / Angles;
            Integrate(microfacets, cosine, refractiveIndex, out float reflected, out _);
            sum += 2.0 * cosine * reflected / Angles;
        }

        Inner = (float)sum;
    }

    /// <summary>The reflectance from inside, for light from all directions alike.</summary>
    public float Inner { get; }

    /// <summary>The fraction of light that gets in.</summary>
    /// <param name="cosine">Cosine of incidence; taken for 0 below, and for 1 above.</param>
    public FloatW Into(FloatW cosine)
    {
        FloatW place = FloatW.Max(0f, FloatW.Min(cosine, 1f)) * Angles;
        FloatW left = FloatW.Min(FloatW.Floor(place), Angles - 1);
        UIntW index = left.ToIntInRange();
        FloatW.Gather(_into, index, out FloatW a, out FloatW b);
        return FloatW.Mix(a, b, place - left);
    }

    /// <summary>The parts of light that are reflected and let through at a cosine.</summary>
    /// <param name="microfacets">The microfacets.</param>
    /// <param name="cosine">Cosine of incidence, above 0.</param>
    /// <param name="eta">Index of the light's side over that of the other; 0 for mirrors without loss.</param>
    /// <param name="reflected">The fraction that is reflected.</param>
    /// <param name="transmitted">The fraction that is let through.</param>
    public static void Integrate(in Microfacets microfacets, float cosine, float eta, out float reflected, out float transmitted)
    {
        Vec3W view = new(MathF.Sqrt(1 - (cosine * cosine)), 0f, cosine);
        double up = 0;
        double down = 0;
        for (int cell = 0; cell < Side * Side; cell += FloatW.Count)
        {
            UIntW index = UIntW.Iota + (uint)cell;
            FloatW u = ((index & (Side - 1)).ToFloat() + 0.5f) * (1f / Side);
            FloatW v = ((index >> 6).ToFloat() + 0.5f) * (1f / Side);
            Vec3W normal = microfacets.Sample(view, u, v);
            FloatW cosIncident = FloatW.Min(Vec3W.Dot(view, normal), 1f);
            FloatW cosTransmitted = 0f;
            FloatW fresnel = eta == 0 ? 1f : Fresnel.Dielectric(cosIncident, eta, out cosTransmitted);
            Vec3W reflection = Vec3W.MultiplyAdd(normal, cosIncident * 2f, -view);
            Vec3W refraction = Vec3W.MultiplyAdd(normal, FloatW.MultiplyAdd(eta, cosIncident, -cosTransmitted), -view * eta);
            FloatW above = (reflection.Z > 0f).Select(fresnel * microfacets.Masking(reflection, normal), 0f);
            FloatW below = (refraction.Z < 0f).Select((1f - fresnel) * microfacets.Masking(refraction, normal), 0f);

            // Lane by lane, so that the sum is the same at every width.
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                up += above[lane];
                down += below[lane];
            }
        }

        reflected = (float)(up / (Side * Side));
        transmitted = (float)(down / (Side * Side));
    }
}
