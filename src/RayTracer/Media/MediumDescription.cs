using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>Describes what fills a closed shape, evenly.</summary>
public sealed record MediumDescription
{
    /// <summary>Extinction coefficient; black for empty space.</summary>
    [Parameter("How much of the light is scattered or absorbed on its way, per channel: after a distance d, the fraction e^(−extinction·d) "
        + "is left. Black is empty space.", Unit = "1/scene unit", Minimum = 0)]
    public Rgb Extinction { get; init; }

    /// <summary>The part of it that is scattered; the rest is absorbed.</summary>
    [Parameter("The part of that light that is scattered, per channel; the rest is absorbed.", Minimum = 0, Maximum = 1)]
    public Rgb Albedo { get; init; }

    /// <summary>Mean cosine of the angle of scattering.</summary>
    [Parameter("Mean cosine of the angle by which light is scattered (Henyey and Greenstein's g): 0 scatters equally in all directions, "
        + "above 0 mostly forward, below 0 mostly back.", Minimum = -0.99, Maximum = 0.99)]
    public float Anisotropy { get; init; }

    /// <summary>The medium; null for empty space.</summary>
    public Medium? Build() => Extinction.IsBlack ? null : new(Extinction, Albedo, Anisotropy);
}
