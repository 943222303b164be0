using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Media;

/// <summary>The insides of a scene's shapes, by numbers; 0 is empty space.</summary>
internal sealed unsafe class MediumTable
{
    private const int Stride = 8;
    private static readonly Medium s_empty = new(Rgb.Black, Rgb.Black, 0);
    private readonly IReadOnlyList<Interior> _interiors;
    private readonly PinnedBuffer<float> _numbers;
    private readonly PinnedBuffer<float> _absorption;
    private readonly PinnedBuffer<float> _emission;
    private readonly PinnedBuffer<float> _priorities;

    // Those of the media that do not scatter by Henyey and Greenstein's.
    private readonly (uint Number, PhaseFunction Phase)[] _phases;
    private readonly (uint Number, Microflakes Flakes)[] _flakes;

    /// <summary>Makes the table; they have the numbers from 1 in their order.</summary>
    public MediumTable(IReadOnlyList<Interior> interiors)
    {
        _interiors = interiors;
        _numbers = new((interiors.Count + 1L) * Stride);
        _absorption = new((interiors.Count + 1L) * Stride);
        _emission = new((interiors.Count + 1L) * Stride);
        _priorities = new(interiors.Count + 1L);
        _priorities.Pointer[0] = -1;
        List<(uint, VaryingMedium)> varying = [];
        List<(uint, PhaseFunction)> phases = [];
        List<(uint, Microflakes)> flakes = [];
        for (int i = 0; i < interiors.Count; i++)
        {
            (Rgb extinction, Rgb albedo, float anisotropy) = interiors[i].Medium ?? s_empty;
            if (interiors[i].Medium?.Varying is { } field)
            {
                // Followed on its own; where even media are asked for, there is nothing.
                varying.Add(((uint)i + 1, field));
                (extinction, albedo) = (Rgb.Black, Rgb.Black);
            }

            if (interiors[i].Medium?.Phase is { } phase)
            {
                phases.Add(((uint)i + 1, phase));
            }

            if (interiors[i].Medium?.Flakes is { } ofMedium)
            {
                flakes.Add(((uint)i + 1, ofMedium));
            }

            Rgb emission = interiors[i].Medium?.Emission ?? Rgb.Black;
            ReadOnlySpan<float> sent = [emission.R, emission.G, emission.B];
            sent.CopyTo(new Span<float>(_emission.Pointer + ((i + 1) * Stride), Stride));
            EvenShine |= !emission.IsBlack;
            HasEven |= !extinction.IsBlack || !emission.IsBlack;
            ReadOnlySpan<float> numbers = [extinction.R, extinction.G, extinction.B, albedo.R, albedo.G, albedo.B, anisotropy, 0];
            numbers.CopyTo(new Span<float>(_numbers.Pointer + ((i + 1) * Stride), Stride));
            Rgb absorption = interiors[i].Nesting?.Extinction ?? Rgb.Black;
            ReadOnlySpan<float> channels = [absorption.R, absorption.G, absorption.B];
            channels.CopyTo(new Span<float>(_absorption.Pointer + ((i + 1) * Stride), Stride));

            // A medium without a priority counts where it was entered last: before all others when it is entered, behind them afterwards.
            _priorities.Pointer[i + 1] = interiors[i].Nesting?.Priority ?? float.MaxValue;
        }

        (Varying, _phases, _flakes) = ([.. varying], [.. phases], [.. flakes]);
    }

    /// <summary>Those whose density varies, with their numbers.</summary>
    public (uint Number, VaryingMedium Medium)[] Varying { get; }

    /// <summary>True where some are even.</summary>
    public bool HasEven { get; }

    /// <summary>True where some that are even send light.</summary>
    public bool EvenShine { get; }

    /// <summary>True where some send light.</summary>
    public bool Shine => EvenShine || Array.Exists(Varying, m => m.Medium.Emits);

    /// <summary>True where some weaken light of one direction more than that of another.</summary>
    public bool HasFlakes => _flakes.Length > 0;

    /// <summary>Extinction coefficients of the innermost media; 0 where they vary.</summary>
    /// <param name="stack">The stack.</param>
    /// <param name="direction">Unit directions of the rays; used only where some media are of <see cref="Microflakes"/>.</param>
    public RgbW Extinction(UIntW stack, in Vec3W direction)
    {
        RgbW extinction = Color(_numbers.Pointer, stack);
        foreach ((uint number, Microflakes flakes) in _flakes)
        {
            MaskW here = UIntW.Equal(MediumStack.Innermost(stack), number);
            extinction = here.Any ? extinction * here.Select(flakes.Area(default, direction), 1f) : extinction;
        }

        return extinction;
    }

    /// <summary>The light that the innermost media send for each unit of length; 0 where they vary.</summary>
    public RgbW Emission(UIntW stack) => Color(_emission.Pointer, stack);

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
        RgbW extinction = Color(_numbers.Pointer, stack);
        return ScattersAny(stack).Select((extinction.R + extinction.G + extinction.B) * (1f / 3f), 0f);
    }

    /// <summary>The probability, as such a mean, with which they let paths come so far.</summary>
    /// <param name="stack">The stack.</param>
    /// <param name="left">The part of the light that is left so far (<see cref="Transmittance"/>).</param>
    public FloatW MeanPassing(UIntW stack, in RgbW left) => ScattersAny(stack).Select((left.R + left.G + left.B) * (1f / 3f), 1f);

    /// <summary>The fraction of the light that the innermost media scatter by an angle, per steradian, which is also its density (<see cref="PhaseFunction"/>).</summary>
    /// <param name="stack">The stack.</param>
    /// <param name="point">Where.</param>
    /// <param name="before">Unit directions of travel before.</param>
    /// <param name="after">Unit directions of travel afterwards.</param>
    public FloatW Phase(UIntW stack, in Vec3W point, in Vec3W before, in Vec3W after)
    {
        FloatW fraction = ByAngle(stack, point, Vec3W.Dot(before, after));
        foreach ((uint number, Microflakes flakes) in _flakes)
        {
            MaskW here = UIntW.Equal(MediumStack.Innermost(stack), number);
            fraction = here.Any ? here.Select(flakes.Evaluate(point, before, after), fraction) : fraction;
        }

        return fraction;
    }

    private FloatW ByAngle(UIntW stack, in Vec3W point, FloatW cosine)
    {
        FloatW fraction = HenyeyGreenstein.Evaluate(cosine, Anisotropy(stack));
        foreach ((uint number, PhaseFunction phase) in _phases)
        {
            MaskW here = UIntW.Equal(MediumStack.Innermost(stack), number);
            fraction = here.Any ? here.Select(phase.Evaluate(point, cosine), fraction) : fraction;
        }

        return fraction;
    }

    /// <summary>Chooses directions of travel where the innermost media scatter paths, with the density of <see cref="Phase"/>.</summary>
    /// <param name="stack">The stack.</param>
    /// <param name="point">Where.</param>
    /// <param name="before">Unit directions of travel before.</param>
    /// <param name="samples">Random numbers of the vertex.</param>
    /// <param name="pdf">That density.</param>
    public Vec3W Scatter(UIntW stack, in Vec3W point, in Vec3W before, VertexSamples samples, out FloatW pdf)
    {
        samples.Direction(out FloatW u, out FloatW v);
        FloatW cosine = HenyeyGreenstein.Cosine(Anisotropy(stack), u);
        foreach ((uint number, PhaseFunction phase) in _phases)
        {
            MaskW here = UIntW.Equal(MediumStack.Innermost(stack), number);
            cosine = here.Any ? here.Select(phase.Cosine(point, samples.Choice(), u), cosine) : cosine;
        }

        Vec3W after = PhaseFunction.Turned(before, cosine, v);
        pdf = ByAngle(stack, point, cosine);
        foreach ((uint number, Microflakes flakes) in _flakes)
        {
            MaskW here = UIntW.Equal(MediumStack.Innermost(stack), number);
            if (here.Any)
            {
                after = here.Select(flakes.Scatter(point, before, u, v), after);
                pdf = here.Select(flakes.Evaluate(point, before, after), pdf);
            }
        }

        return after;
    }

    /// <summary>The fraction of the light that is left after a distance (Beer 1852).</summary>
    public static RgbW Transmittance(in RgbW extinction, FloatW distance)
    {
        FloatW way = FloatW.Min(distance, 1e30f);
        return new(LaneMath.Exp(-extinction.R * way), LaneMath.Exp(-extinction.G * way), LaneMath.Exp(-extinction.B * way));
    }

    /// <summary>
    /// The length over which a medium that sends light is seen along a way, weakened by what is in front: the integral of the transmittance, (1 − e^(−extinction · distance))/extinction. 0 for
    /// clear ways without an end, which no closed shape has.
    /// </summary>
    public static RgbW Seen(in RgbW extinction, FloatW distance) => new(Seen(extinction.R, distance), Seen(extinction.G, distance), Seen(extinction.B, distance));

    // Where the optical depth is small, the difference of the formula has few digits: its series has all.
    private static FloatW Seen(FloatW extinction, FloatW distance)
    {
        FloatW depth = extinction * FloatW.Min(distance, 1e30f);
        FloatW series = FloatW.MultiplyAdd(depth, FloatW.MultiplyAdd(depth, FloatW.MultiplyAdd(depth, -1f / 24, 1f / 6), -0.5f), 1f);
        FloatW near = (distance < 1e30f).Select(distance * series, 0f);
        return (depth < 0.03f).Select(near, (1f - LaneMath.Exp(-depth)) / extinction);
    }

    private FloatW Anisotropy(UIntW stack) => FloatW.Gather(_numbers.Pointer + 6, MediumStack.Innermost(stack) * Stride);

    private MaskW ScattersAny(UIntW stack)
    {
        RgbW albedo = Albedo(stack);
        return FloatW.Max(albedo.R, FloatW.Max(albedo.G, albedo.B)) > 0f;
    }

    private static RgbW Color(float* from, UIntW stack) => RgbW.Gather(from, MediumStack.Innermost(stack) * Stride);
}
