using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Materials;

/// <summary>The reflectance of a smooth conductor.</summary>
internal sealed class ConductorFresnel
{
    private readonly Rgb _eta;
    private readonly Rgb _k;
    private readonly bool _isPerfect;

    /// <summary>A conductor of a complex refractive index.</summary>
    /// <param name="eta">Real part, above 0, relative to the outside.</param>
    /// <param name="k">Imaginary part (extinction coefficient), at least 0.</param>
    public ConductorFresnel(Rgb eta, Rgb k)
    {
        _eta = eta;
        _k = k;
    }

    /// <summary>A named metal.</summary>
    /// <param name="metal">Its name.</param>
    /// <param name="outside">Index of what lies on the metal.</param>
    public ConductorFresnel(Metal metal, float outside = 1)
    {
        _isPerfect = metal == Metal.None;
        (_eta, _k) = _isPerfect ? default : MetalTable.Of(metal);
        (_eta, _k) = (_eta * (1 / outside), _k * (1 / outside));
    }

    /// <summary>
    /// Reflectance of unpolarised light (Born &amp; Wolf, Principles of Optics, 7th ed. 1999, section 14.4, in the form of its absolute
    /// squares).
    /// </summary>
    /// <param name="cosine">Cosine of incidence, 0 to 1.</param>
    /// <param name="reflectance">The reflectance.</param>
    public void Evaluate(in FloatW cosine, out RgbW reflectance)
    {
        if (_isPerfect)
        {
            reflectance = Rgb.White;
            return;
        }

        FloatW cos2 = cosine * cosine;
        reflectance = new(Channel(cosine, cos2, _eta.R, _k.R), Channel(cosine, cos2, _eta.G, _k.G), Channel(cosine, cos2, _eta.B, _k.B));
    }

    // a² + b² is the squared magnitude of √((n + ik)² − sin²), and a its real part.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Channel(FloatW cosine, FloatW cos2, float eta, float k)
    {
        FloatW sin2 = 1f - cos2;
        FloatW real = (eta * eta) - (k * k) - sin2;
        FloatW square = FloatW.Sqrt(FloatW.MultiplyAdd(real, real, 4f * eta * eta * k * k));
        FloatW twoA = FloatW.Sqrt(FloatW.Max((square + real) * 0.5f, 0f)) * 2f * cosine;
        FloatW sum = square + cos2;
        FloatW perpendicular = (sum - twoA) / (sum + twoA);
        FloatW product = FloatW.MultiplyAdd(square, cos2, sin2 * sin2);
        FloatW both = twoA * sin2;
        FloatW parallel = perpendicular * ((product - both) / (product + both));
        return (perpendicular + parallel) * 0.5f;
    }
}
