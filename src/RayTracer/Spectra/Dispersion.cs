using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Spectra;

/// <summary>
/// A refractive index that depends on the wavelength λ: constant + slope / λ² + √(square + Σ strengthᵢ · λ² / (λ² − resonanceᵢ)), with λ in µm.
/// Both usual formulas are of this kind.
/// </summary>
/// <param name="Constant">Cauchy's A.</param>
/// <param name="Slope">Cauchy's B, in µm².</param>
/// <param name="Square">1 for Sellmeier's formula.</param>
/// <param name="Strengths">Sellmeier's B₁ to B₄.</param>
/// <param name="Resonances">Sellmeier's C₁ to C₄, in µm².</param>
public sealed record Dispersion(float Constant, float Slope, float Square, Vector4 Strengths, Vector4 Resonances)
{
    /// <summary>The same index at all wavelengths.</summary>
    public static Dispersion None(float index) => Cauchy(index, 0);

    /// <summary>n = a + b / λ² (Cauchy 1836, the first two terms).</summary>
    public static Dispersion Cauchy(float a, float b) => new(a, b, 0, Vector4.Zero, Vector4.Zero);

    /// <summary>n² = 1 + Σ bᵢ · λ² / (λ² − cᵢ) (Sellmeier 1871).</summary>
    public static Dispersion Sellmeier(Vector4 b, Vector4 c) => new(0, 0, 1, b, c);

    /// <summary>The refractive index.</summary>
    /// <param name="wavelength">Wavelengths in µm, above 0; not used where the index does not depend on them.</param>
    public FloatW Index(FloatW wavelength)
    {
        FloatW square = wavelength * wavelength;
        FloatW index = Slope == 0 ? Constant : Constant + (Slope / square);
        if (Square == 0)
        {
            return index;
        }

        FloatW sum = Square;
        for (int i = 0; i < 4; i++)
        {
            sum += Strengths[i] * square / (square - Resonances[i]);
        }

        return index + FloatW.Sqrt(FloatW.Max(sum, 0f));
    }

    /// <summary>The lowest and the highest index at visible wavelengths; no numbers where one of them is none.</summary>
    public (float Lowest, float Highest) Range()
    {
        (float lowest, float highest) = (float.PositiveInfinity, float.NegativeInfinity);
        for (int nanometres = CieTables.First; nanometres <= CieTables.Last; nanometres++)
        {
            float index = Index(nanometres * 1e-3f)[0];
            (lowest, highest) = (float.Min(lowest, index), float.Max(highest, index));
        }

        return (lowest, highest);
    }
}
