using RayTracer.Description;

namespace RayTracer.Tests.Sampling;

/// <summary>Pixel filters once more, in double precision and from their published formulas.</summary>
internal static class FilterIntegral
{
    private const int Steps = 2000;

    /// <summary>The curve at a distance, up to a factor.</summary>
    /// <param name="filter">The filter, with a radius.</param>
    /// <param name="x">The distance, within the radius.</param>
    public static double Curve(FilterDescription filter, double x)
    {
        double r = filter.Radius;
        double t = Math.Abs(x) / r;
        switch (filter.Shape)
        {
            case FilterShape.Tent:
                return 1 - t;
            case FilterShape.Gaussian:
                double sigma = filter.Deviation > 0 ? filter.Deviation : r / 3;
                return Math.Exp(-x * x / (2 * sigma * sigma)) - Math.Exp(-r * r / (2 * sigma * sigma));
            case FilterShape.Mitchell:
                (double b, double c, double d) = (filter.B, filter.C, 2 * t);
                return d < 1
                    ? (((12 - (9 * b) - (6 * c)) * Math.Pow(d, 3)) + ((-18 + (12 * b) + (6 * c)) * d * d) + (6 - (2 * b))) / 6
                    : (((-b - (6 * c)) * Math.Pow(d, 3)) + (((6 * b) + (30 * c)) * d * d) + (((-12 * b) - (48 * c)) * d) + ((8 * b) + (24 * c))) / 6;
            case FilterShape.BlackmanHarris:
                return 0.35875 + (0.48829 * Math.Cos(Math.PI * t)) + (0.14128 * Math.Cos(2 * Math.PI * t)) + (0.01168 * Math.Cos(3 * Math.PI * t));
            default:
                return 1;
        }
    }

    /// <summary>The curve's integral between two distances over that of the whole curve.</summary>
    public static double Share(FilterDescription filter, double from, double to) => Integral(filter, x => x, from, to) / Integral(filter, x => x, -filter.Radius, filter.Radius);

    /// <summary>The same of the curve's magnitude.</summary>
    public static double MagnitudeShare(FilterDescription filter, double from, double to) =>
        Integral(filter, Math.Abs, from, to) / Integral(filter, Math.Abs, -filter.Radius, filter.Radius);

    private static double Integral(FilterDescription filter, Func<double, double> map, double from, double to)
    {
        from = Math.Clamp(from, -filter.Radius, filter.Radius);
        to = Math.Clamp(to, -filter.Radius, filter.Radius);
        return Enumerable.Range(0, Steps).Sum(i => map(Curve(filter, from + ((i + 0.5) / Steps * (to - from))))) * (to - from) / Steps;
    }
}
