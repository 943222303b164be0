using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>Describes what fills a closed shape.</summary>
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

    /// <summary>Factors on the extinction; null for none.</summary>
    [Parameter("Numbers by which the extinction is multiplied: the density of a cloud, from a file. Outside of their box the medium is empty.")]
    public GridDescription? Density { get; init; }

    /// <summary>Noise by which the extinction is multiplied; null for none.</summary>
    [Parameter("As density, but made by noise instead of read from a file.")]
    public DensityNoiseDescription? Noise { get; init; }

    /// <summary>Factors on the albedo, where the density varies; null for none.</summary>
    [Parameter("Numbers by which the albedo is multiplied, from a file; only together with density or noise.")]
    public GridDescription? AlbedoGrid { get; init; }

    /// <summary>Makes the medium; null for empty space.</summary>
    /// <param name="builder">Gives access to files and takes diagnostics.</param>
    public Medium? Build(SceneBuilder builder)
    {
        if (Density is not null && Noise is not null)
        {
            builder.Error(this, nameof(Noise), "a medium has density from a file or noise, but not both");
        }

        if (AlbedoGrid is not null && Density is null && Noise is null)
        {
            builder.Error(this, nameof(AlbedoGrid), "the albedo varies only where the density does: add \"density\" or \"noise\"");
        }

        PlacedGrid? density = Density?.Build(builder) ?? Noise?.Build(builder);
        PlacedGrid? albedo = AlbedoGrid?.Build(builder);
        return Extinction.IsBlack ? null : new(Extinction, Albedo, Anisotropy) { Varying = density is null ? null : new(density, albedo, Extinction, Albedo) };
    }
}
