using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>The insides of a scene's shapes, by numbers; 0 is empty space.</summary>
internal sealed unsafe class MediumTable
{
    private const int Stride = 8;
    private static readonly Medium s_empty = new(Rgb.Black, Rgb.Black, 0);
    private readonly IReadOnlyList<Interior> _interiors;
    private readonly PinnedBuffer<float> _numbers;
    private readonly PinnedBuffer<float> _absorption;
    private readonly PinnedBuffer<float> _priorities;

    /// <summary>Makes the table; they have the numbers from 1 in their order.</summary>
    public MediumTable(IReadOnlyList<Interior> interiors)
    {
        _interiors = interiors;
        _numbers = new((interiors.Count + 1L) * Stride);
        _absorption = new((interiors.Count + 1L) * Stride);
        _priorities = new(interiors.Count + 1L);
        _priorities.Pointer[0] = -1;
        List<(uint, VaryingMedium)> varying = [];
        for (int i = 0; i < interiors.Count; i++)
        {
            (Rgb extinction, Rgb albedo, float anisotropy) = interiors[i].Medium ?? s_empty;
            if (interiors[i].Medium?.Varying is { } field)
            {
                // Followed on its own; where even media are asked for, there is nothing.
                varying.Add(((uint)i + 1, field));
                (extinction, albedo) = (Rgb.Black, Rgb.Black);
            }

            HasEven |= !extinction.IsBlack;
            ReadOnlySpan<float> numbers = [extinction.R, extinction.G, extinction.B, albedo.R, albedo.G, albedo.B, anisotropy, 0];
            numbers.CopyTo(new Span<float>(_numbers.Pointer + ((i + 1) * Stride), Stride));
            Rgb absorption = interiors[i].Nesting?.Extinction ?? Rgb.Black;
            ReadOnlySpan<float> channels = [absorption.R, absorption.G, absorption.B];
            channels.CopyTo(new Span<float>(_absorption.Pointer + ((i + 1) * Stride), Stride));

            // A medium without a priority counts where it was entered last: before all others when it is entered, behind them afterwards.
            _priorities.Pointer[i + 1] = interiors[i].Nesting?.Priority ?? float.MaxValue;
        }

        Varying = [.. varying];
    }

    /// <summary>Those whose density varies, with their numbers.</summary>
    public (uint Number, VaryingMedium Medium)[] Varying { get; }

    /// <summary>True where some are even.</summary>
    public bool HasEven { get; }

    /// <summary>Extinction coefficients of the innermost media; 0 where they vary.</summary>
    public RgbW Extinction(UIntW stack) => Color(_numbers.Pointer, stack);

    /// <summary>Extinction coefficients of the dielectrics themselves.</summary>
    public RgbW Absorption(UIntW stack) => Color(_absorption.Pointer, stack);

    /// <summary>The priorities by number.</summary>
    public float* Priorities => _priorities.Pointer;

    /// <summary>Finds refractive indices of the innermost ones, relative to empty space; 1 where they have none.</summary>
    /// <param name="stack">The stack.</param>
    /// <param name="wavelength">Wavelengths in µm; used only where an index depends on them.</param>
    /// <param name="index">The indices.</param>
    public void Index(in UIntW stack, in FloatW wavelength, out FloatW index)
    {
        UIntW innermost = MediumStack.Innermost(stack);
        index = 1f;
        for (int i = 0; i < _interiors.Count; i++)
        {
            MaskW here = UIntW.Equal(innermost, (uint)i + 1u);
            if (_interiors[i].Nesting is { } nesting && here.Any)
            {
                index = here.Select(nesting.Index.Index(wavelength), index);
            }
        }
    }

    /// <summary>The part of it that is scattered.</summary>
    public RgbW Albedo(UIntW stack) => Color(_numbers.Pointer + 3, stack);

    /// <summary>
    /// The density per length with which the innermost media scatter paths, as a mean over the channels: by which the ways to make a path are weighed,
    /// whatever a path carries of each channel. 0 for media that scatter nothing, through which paths do not come by chance.
    /// </summary>
    public FloatW MeanExtinction(UIntW stack)
    {
        RgbW extinction = Extinction(stack);
        return ScattersAny(stack).Select((extinction.R + extinction.G + extinction.B) * (1f / 3f), 0f);
    }

    /// <summary>The probability, as such a mean, with which they let paths come so far.</summary>
    /// <param name="stack">The stack.</param>
    /// <param name="left">The part of the light that is left so far (<see cref="Transmittance"/>).</param>
    public FloatW MeanPassing(UIntW stack, in RgbW left) => ScattersAny(stack).Select((left.R + left.G + left.B) * (1f / 3f), 1f);

    /// <summary>Mean cosines of the angles of scattering.</summary>
    public FloatW Anisotropy(UIntW stack) => FloatW.Gather(_numbers.Pointer + 6, MediumStack.Innermost(stack) * Stride);

    /// <summary>The fraction of the light that is left after a distance (Beer 1852).</summary>
    public static RgbW Transmittance(in RgbW extinction, FloatW distance)
    {
        FloatW way = FloatW.Min(distance, 1e30f);
        return new(LaneMath.Exp(-extinction.R * way), LaneMath.Exp(-extinction.G * way), LaneMath.Exp(-extinction.B * way));
    }

    private MaskW ScattersAny(UIntW stack)
    {
        RgbW albedo = Albedo(stack);
        return FloatW.Max(albedo.R, FloatW.Max(albedo.G, albedo.B)) > 0f;
    }

    private static RgbW Color(float* from, UIntW stack)
    {
        UIntW at = MediumStack.Innermost(stack) * Stride;
        return new(FloatW.Gather(from, at), FloatW.Gather(from + 1, at), FloatW.Gather(from + 2, at));
    }
}
