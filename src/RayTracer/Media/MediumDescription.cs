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

    /// <summary>Over which directions light is scattered; null for <see cref="Anisotropy"/>.</summary>
    [Parameter("Over which directions the medium spreads what it scatters, where anisotropy does not say it: as clear air, by a table, or a mixture. It replaces anisotropy.")]
    public PhaseDescription? Phase { get; init; }

    /// <summary>Factors on the extinction; null for none.</summary>
    [Parameter("Numbers by which the extinction is multiplied: the density of a cloud, from a file. Outside of their box the medium is empty.")]
    public GridDescription? Density { get; init; }

    /// <summary>Noise by which the extinction is multiplied; null for none.</summary>
    [Parameter("As density, but made by noise instead of read from a file.")]
    public DensityNoiseDescription? Noise { get; init; }

    /// <summary>A cumulus cloud by which the extinction is multiplied; null for none.</summary>
    [Parameter("As density, but a cumulus cloud made by noise.")]
    public CloudDescription? Cloud { get; init; }

    /// <summary>Factors on the albedo, where the density varies; null for none.</summary>
    [Parameter("Numbers by which the albedo is multiplied, from a file; only where the density varies.")]
    public GridDescription? AlbedoGrid { get; init; }

    /// <summary>The light that the medium sends itself; black for none.</summary>
    [Parameter("The light that the medium sends in all directions: radiance for each unit of length. It is multiplied by the density, if there is one, or by the emission grid.", Unit = "power per area, steradian and scene unit", Minimum = 0)]
    public Rgb Emission { get; init; }

    /// <summary>Factors on the emission; null for those of the density.</summary>
    [Parameter("Numbers by which the emission is multiplied instead of the density, from a file: the heat of a flame. They count within the box of the density.")]
    public GridDescription? EmissionGrid { get; init; }

    /// <summary>Temperatures, by which the emission is coloured; null for none.</summary>
    [Parameter("Temperatures in kelvins, from a file: the emission is multiplied by the colour of a black body that is so hot, whose radiance is 1 at the wavelength where it is largest. Places of "
        + "100 K and below are dark, and so is what lies outside of the grid's box. Only where the density varies.")]
    public GridDescription? TemperatureGrid { get; init; }

    /// <summary>What is subtracted from the numbers of the temperatures.</summary>
    [Parameter("What is first subtracted from the numbers of the temperature grid.")]
    public float TemperatureOffset { get; init; }

    /// <summary>Kelvins for each unit of the temperatures.</summary>
    [Parameter("Kelvins for each unit of the numbers of the temperature grid.", Minimum = 0)]
    public float TemperatureScale { get; init; } = 1;

    /// <summary>Makes the medium; null for empty space.</summary>
    /// <param name="builder">Gives access to files and takes diagnostics.</param>
    public Medium? Build(SceneBuilder builder)
    {
        bool varies = (Density ?? Noise ?? (object?)Cloud) is not null;
        if (new object?[] { Density, Noise, Cloud }.Count(d => d is not null) > 1)
        {
            builder.Error(this, Cloud is null ? nameof(Noise) : nameof(Cloud), "a medium has one density: from a file, of noise, or of a cloud");
        }

        if (AlbedoGrid is not null && !varies)
        {
            builder.Error(this, nameof(AlbedoGrid), "the albedo varies only where the density does: add \"density\", \"noise\" or \"cloud\"");
        }

        if (EmissionGrid is not null && Emission.IsBlack)
        {
            builder.Error(this, nameof(EmissionGrid), "the numbers are factors on the \"emission\", which is black");
        }

        if (EmissionGrid is not null && !varies)
        {
            builder.Error(this, nameof(EmissionGrid), "the emission varies only where the density does: add \"density\", \"noise\" or \"cloud\"");
        }

        if (TemperatureGrid is not null && (Emission.IsBlack || !varies))
        {
            builder.Error(this, nameof(TemperatureGrid), Emission.IsBlack ? "the temperatures colour the \"emission\", which is black" : "the temperature varies only where the density does: add \"density\", \"noise\" or \"cloud\"");
        }

        if (TemperatureGrid is null && (TemperatureOffset != 0 || TemperatureScale != 1))
        {
            builder.Error(this, TemperatureOffset != 0 ? nameof(TemperatureOffset) : nameof(TemperatureScale), "there is no \"temperatureGrid\"");
        }

        if (Phase is not null && Anisotropy != 0)
        {
            builder.Error(this, nameof(Anisotropy), "a medium has either \"anisotropy\" or \"phase\", not both");
        }

        PlacedGrid? density = Density?.Build(builder) ?? Noise?.Build(builder) ?? Cloud?.Build(builder);
        PlacedGrid? albedo = AlbedoGrid?.Build(builder);
        PlacedGrid? emission = EmissionGrid?.Build(builder);
        PlacedGrid? temperatures = TemperatureGrid?.Build(builder);
        if (temperatures is { Grid.Channels: not 1 })
        {
            builder.Error(this, nameof(TemperatureGrid), "a temperature is one number, but the grid has red, green and blue");
        }

        PhaseFunction? phase = Phase?.Build(builder);
        Microflakes? flakes = Phase?.Flakes(builder, varies);
        return Extinction.IsBlack && Emission.IsBlack ? null : new(Extinction, Albedo, Phase is { Shape: PhaseShape.HenyeyGreenstein, Anisotropy: var g } ? g : Anisotropy)
        {
            Phase = phase is HenyeyGreenstein ? null : phase,
            Flakes = flakes,
            Emission = density is null ? Emission : Rgb.Black,
            Varying = density is null ? null : new(density, albedo, Extinction, Albedo, Emission, emission, flakes)
            {
                Heat = temperatures is null ? null : new(temperatures, TemperatureOffset, TemperatureScale, density),
            },
        };
    }
}
