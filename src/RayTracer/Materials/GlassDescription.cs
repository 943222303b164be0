using System.Numerics;
using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Spectra;

namespace RayTracer.Materials;

/// <summary>The common part of the descriptions of smooth and rough glass.</summary>
public abstract record GlassDescription : MaterialDescription
{
    private const float SmallestIndex = 1e-3f;
    private const float LargestIndex = 100;

    /// <summary>The glass; null where the other parameters describe it.</summary>
    [Parameter("Which glass, from published tables, in place of refractiveIndex: light of each colour is refracted by its own index, as in "
        + "a prism. The surroundings are air.")]
    public Glass? Glass { get; init; }

    /// <summary>Cauchy's A and B.</summary>
    [Parameter("A and B of Cauchy's formula, n = A + B/λ² with the wavelength λ in µm, in place of refractiveIndex: light of each colour "
        + "is refracted by its own index.", Unit = "1, µm²")]
    public Vector2? Cauchy { get; init; }

    /// <summary>Sellmeier's B.</summary>
    [Parameter("B₁, B₂ and B₃ of Sellmeier's formula, n² = 1 + ΣB·λ²/(λ² − C), in place of refractiveIndex; together with sellmeierC.")]
    public Vector3? SellmeierB { get; init; }

    /// <summary>Sellmeier's C.</summary>
    [Parameter("C₁, C₂ and C₃ of Sellmeier's formula; together with sellmeierB.", Unit = "µm²")]
    public Vector3? SellmeierC { get; init; }

    /// <summary>The medium inside.</summary>
    [Parameter("What fills the inside: milk, fog, a coloured liquid. Shown by path, volPath and the integrators that trace light.")]
    public MediumDescription Interior { get; init; } = new();

    /// <summary>
    /// The rank among dielectrics that overlap, of which the highest counts; 0 where the refractive index is relative to what is around.
    /// </summary>
    [Parameter("Of overlapping dielectrics, the one with the highest priority counts, with all integrators of light but report. A "
        + "liquid that reaches into its glass, which has the higher priority, needs no matching boundary. All dielectrics that touch must "
        + "have priorities, and then refractive indices are relative to empty space. 0 is no priority: the index is relative to the "
        + "surroundings.", Minimum = 0, Maximum = 1000)]
    public int Priority { get; init; }

    /// <summary>The inside's place among others; null without a priority.</summary>
    /// <param name="refractiveIndex">The index where it does not depend on the wavelength.</param>
    /// <param name="dispersion">Its dispersion; null where there is none.</param>
    /// <param name="extinction">The absorption of the inside.</param>
    protected Nesting? BuildNesting(float refractiveIndex, Dispersion? dispersion, Rgb extinction) =>
        Priority == 0 ? null : new(Priority, dispersion ?? Dispersion.None(refractiveIndex), extinction);

    /// <summary>The index by wavelength; null where it does not.</summary>
    /// <param name="builder">Takes what is wrong.</param>
    /// <param name="refractiveIndex">The property of the index that does not depend on it.</param>
    /// <param name="isGiven">True if that is another than the one that is used where none is given.</param>
    protected Dispersion? BuildDispersion(SceneBuilder builder, string refractiveIndex, bool isGiven)
    {
        string[] ways = [.. Ways()];
        if (ways.Length > 1)
        {
            builder.Error(this, ways[1], "glass has either a \"glass\", \"cauchy\", or \"sellmeierB\" and \"sellmeierC\", not several of them");
        }
        else if (ways.Length == 1 && isGiven)
        {
            builder.Error(this, refractiveIndex, $"a \"refractiveIndex\" is the same for all colours: give either that or \"{char.ToLowerInvariant(ways[0][0])}{ways[0][1..]}\"");
        }

        if ((SellmeierB is null) != (SellmeierC is null))
        {
            builder.Error(this, SellmeierB is null ? nameof(SellmeierC) : nameof(SellmeierB), "\"sellmeierB\" and \"sellmeierC\" must be given together");
            return null;
        }

        Dispersion? dispersion = Glass is { } glass ? glass.Dispersion()
            : Cauchy is { } ab ? Dispersion.Cauchy(ab.X, ab.Y)
            : SellmeierB is { } b && SellmeierC is { } c ? Dispersion.Sellmeier(new(b, 0), new(c, 0)) : null;
        if (dispersion?.Range() is var (lowest, highest) && !(lowest >= SmallestIndex && highest <= LargestIndex))
        {
            builder.Error(this, ways[0], $"the refractive index must be from {SmallestIndex} to {LargestIndex} at all wavelengths from {CieTables.First} to {CieTables.Last} nm");
        }

        return dispersion;
    }

    private IEnumerable<string> Ways()
    {
        if (Glass is not null)
        {
            yield return nameof(Glass);
        }

        if (Cauchy is not null)
        {
            yield return nameof(Cauchy);
        }

        if (SellmeierB is not null)
        {
            yield return nameof(SellmeierB);
        }
    }
}
