using RayTracer.Description;
using RayTracer.Imaging;

namespace RayTracer.Study;

/// <summary>The error of a picture while it is rendered.</summary>
/// <param name="Integrator">The integrator that renders it.</param>
/// <param name="Points">The errors, by time; one at least.</param>
internal sealed record ErrorCurve(Integrator Integrator, IReadOnlyList<ErrorPoint> Points)
{
    // The longest time that is judged by a shorter one.
    private const double Beyond = 2;

    /// <summary>The last point.</summary>
    public ErrorPoint Last => Points[^1];

    /// <summary>
    /// The power of the time with which the error falls, by least squares of the logarithms; independent samples give −1. Null below two
    /// points.
    /// </summary>
    public double? Slope => Logarithms is { Length: > 1 } points ? PolynomialFit.Of(1, points).Coefficients[1] : null;

    private (double X, double Y)[] Logarithms => [.. Points.Where(p => p.Error.Trimmed > 0).Select(p => (Math.Log(p.Seconds), Math.Log(p.Error.Trimmed)))];

    /// <summary>
    /// The error after some time, without the worst pixels: on the straight line, by logarithms, through the two points that are nearest. Null
    /// where they are too far, or there are none.
    /// </summary>
    public double? At(double seconds)
    {
        double x = Math.Log(seconds);
        (double X, double Y)[] near = [.. Logarithms.OrderBy(p => Math.Abs(p.X - x)).Take(2)];
        return near.Length < 2 || seconds > Beyond * Last.Seconds ? null : Math.Exp(PolynomialFit.Of(1, near).At(x));
    }
}

/// <summary>The error of a picture at one time.</summary>
/// <param name="Seconds">The time of rendering.</param>
/// <param name="Samples">The samples in each pixel.</param>
/// <param name="Error">The error.</param>
internal sealed record ErrorPoint(double Seconds, int Samples, RelativeError Error);
