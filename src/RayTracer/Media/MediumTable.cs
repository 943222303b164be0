using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>The media of a scene by their numbers; 0 is empty space.</summary>
internal sealed unsafe class MediumTable
{
    private const int Stride = 8;
    private readonly PinnedBuffer<float> _numbers;

    /// <summary>Makes the table; the media have the numbers from 1 in their order.</summary>
    public MediumTable(IReadOnlyList<Medium> media)
    {
        _numbers = new((media.Count + 1L) * Stride);
        for (int i = 0; i < media.Count; i++)
        {
            (Rgb extinction, Rgb albedo, float anisotropy) = media[i];
            ReadOnlySpan<float> numbers = [extinction.R, extinction.G, extinction.B, albedo.R, albedo.G, albedo.B, anisotropy, 0];
            numbers.CopyTo(new Span<float>(_numbers.Pointer + ((i + 1) * Stride), Stride));
        }
    }

    /// <summary>Extinction coefficients of the innermost media.</summary>
    public RgbW Extinction(UIntW stack) => Color(stack, 0);

    /// <summary>What part of that is scattered.</summary>
    public RgbW Albedo(UIntW stack) => Color(stack, 3);

    /// <summary>Mean cosines of the angles of scattering.</summary>
    public FloatW Anisotropy(UIntW stack) => FloatW.Gather(_numbers.Pointer + 6, MediumStack.Innermost(stack) * Stride);

    /// <summary>The fraction of the light that is left after a distance (Beer 1852).</summary>
    public static RgbW Transmittance(in RgbW extinction, FloatW distance)
    {
        FloatW way = FloatW.Min(distance, 1e30f);
        return new(LaneMath.Exp(-extinction.R * way), LaneMath.Exp(-extinction.G * way), LaneMath.Exp(-extinction.B * way));
    }

    private RgbW Color(UIntW stack, int first)
    {
        UIntW at = MediumStack.Innermost(stack) * Stride;
        float* from = _numbers.Pointer + first;
        return new(FloatW.Gather(from, at), FloatW.Gather(from + 1, at), FloatW.Gather(from + 2, at));
    }
}
