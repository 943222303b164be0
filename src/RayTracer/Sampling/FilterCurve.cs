using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>The curve of a pixel filter along one axis, up to a factor. It is symmetric.</summary>
internal sealed class FilterCurve
{
    private readonly FilterDescription _filter;
    private readonly float _deviation;
    private readonly double _foot;

    /// <summary>Makes the curve that a description asks for.</summary>
    public FilterCurve(FilterDescription filter)
    {
        _filter = filter;
        float radius = filter.Radius > 0 ? filter.Radius : UsualRadius(filter.Shape);
        Radius = radius;
        _deviation = filter.Deviation > 0 ? filter.Deviation : radius / 3;
        _foot = filter.Shape == FilterShape.Gaussian ? Bell(Radius) : 0;

        // On the outer piece the cubic is (2 − x)²/6 times 2B + 6C − (B + 6C)·x, for x in half radii.
        bool hasNegativeLobe = filter is { Shape: FilterShape.Mitchell, C: > 0 };
        SignChange = hasNegativeLobe ? 0.5 * Radius * ((2.0 * filter.B) + (6.0 * filter.C)) / (filter.B + (6.0 * filter.C)) : Radius;
    }

    /// <summary>The radius at which the curve ends, in pixels.</summary>
    public double Radius { get; }

    /// <summary>Beyond it, up to the radius, the curve is negative; the radius where it is not.</summary>
    public double SignChange { get; }

    /// <summary>The curve's height.</summary>
    /// <param name="x">Distance from the middle, from 0 to the radius.</param>
    public double At(double x) => _filter.Shape switch
    {
        FilterShape.Tent => 1 - (x / Radius),
        FilterShape.Gaussian => Bell(x) - _foot,
        FilterShape.Mitchell => Cubic(2 * x / Radius, _filter.B, _filter.C),
        FilterShape.BlackmanHarris => Window(x / Radius),
        _ => 1,
    };

    /// <summary>Says why there cannot be such a curve, and which property of the description is to blame; null where there can.</summary>
    internal static (string Property, string Complaint)? Fault(FilterDescription filter)
    {
        const float smallest = 0.01f;
        const float mostDeviations = 8;
        if (filter.Radius is > 0 and < smallest)
        {
            return (nameof(FilterDescription.Radius), $"a pixel filter's radius must be 0, for the usual one, or at least {smallest}, but it is {filter.Radius}");
        }

        float radius = filter.Radius > 0 ? filter.Radius : UsualRadius(filter.Shape);
        return filter is { Shape: FilterShape.Gaussian, Deviation: > 0 } && radius > mostDeviations * filter.Deviation
            ? (nameof(FilterDescription.Deviation), $"a filter of radius {radius} must have a deviation of at least {radius / mostDeviations}, but it is {filter.Deviation}")
            : null;
    }

    private static float UsualRadius(FilterShape shape) => shape switch
    {
        FilterShape.Tent => 1,
        FilterShape.Gaussian or FilterShape.BlackmanHarris => 1.5f,
        FilterShape.Mitchell => 2,
        _ => 0.5f,
    };

    // Mitchell & Netravali, Reconstruction filters in computer graphics (1988), eq. 8.
    private static double Cubic(double x, double b, double c) => x < 1
        ? (((((12 - (9 * b) - (6 * c)) * x) - 18 + (12 * b) + (6 * c)) * x * x) + 6 - (2 * b)) / 6
        : ((((((-b - (6 * c)) * x) + (6 * b) + (30 * c)) * x) - (12 * b) - (48 * c)) * x + (8 * b) + (24 * c)) / 6;

    // Harris, On the use of windows for harmonic analysis with the discrete Fourier transform (1978), table 1: four terms, −92 dB.
    private static double Window(double x)
    {
        LaneMath.SinCosTurn((float)(0.5 * x), out _, out float cos1);
        LaneMath.SinCosTurn((float)x, out _, out float cos2);
        LaneMath.SinCosTurn((float)(1.5 * x), out _, out float cos3);
        return double.Max(0, 0.35875 + (0.48829 * cos1) + (0.14128 * cos2) + (0.01168 * cos3));
    }

    private double Bell(double x) => LaneMath.Exp((float)(-0.5 * x * x / ((double)_deviation * _deviation)));
}
