using MathNet.Numerics.Integration;

namespace RayTracer.RenderTests.Analytic;

/// <summary>Integrals of smooth functions in double precision, by Gauss and Legendre's rule.</summary>
internal static class Quadrature
{
    /// <summary>∫ f from a to b.</summary>
    public static double Integrate(double a, double b, int order, Func<double, double> f)
    {
        GaussLegendreRule rule = new(a, b, order);
        double sum = 0;
        for (int i = 0; i < order; i++)
        {
            sum += rule.GetWeight(i) * f(rule.GetAbscissa(i));
        }

        return sum;
    }

    /// <summary>Mean of f over a rectangle.</summary>
    public static double Mean(double x0, double x1, double y0, double y1, int order, Func<double, double, double> f) =>
        Integrate(y0, y1, order, y => Integrate(x0, x1, order, x => f(x, y))) / ((x1 - x0) * (y1 - y0));

    /// <summary>Mean of f over the pixel in the given column and row.</summary>
    public static double Pixel(int x, int y, Func<double, double, double> f) => Mean(x, x + 1, y, y + 1, 5, f);

    /// <summary>Mean of f over the unit disk: even steps around it, equal areas outwards.</summary>
    public static double Disk(int order, Func<double, double, double> f) => Integrate(0, 1, order, squared =>
    {
        double radius = Math.Sqrt(squared);
        double sum = 0;
        for (int i = 0; i < 4 * order; i++)
        {
            (double sin, double cos) = Math.SinCos(2 * Math.PI * (i + 0.5) / (4 * order));
            sum += f(radius * cos, radius * sin);
        }

        return sum / (4 * order);
    });
}
