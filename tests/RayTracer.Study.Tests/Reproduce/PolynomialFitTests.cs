namespace RayTracer.Study.Tests;

public sealed class PolynomialFitTests
{
    [Theory]
    [InlineData(4)]
    [InlineData(15)]
    public void Cubic_is_recovered_exactly(int count)
    {
        double[] expected = [2.5, -0.75, 0.0125, -3e-5];
        double Cubic(double x) => expected[0] + (expected[1] * x) + (expected[2] * x * x) + (expected[3] * x * x * x);
        (double, double)[] points = [.. Enumerable.Range(1, count).Select(n => ((double)n * n, Cubic((double)n * n)))];
        PolynomialFit fit = PolynomialFit.Of(3, points);
        for (int k = 0; k < expected.Length; k++)
        {
            Assert.InRange(fit.Coefficients[k] / expected[k], 1 - 1e-9, 1 + 1e-9);
        }

        Assert.Equal(Cubic(50), fit.At(50), 1e-9);
    }

    [Fact]
    public void Line_has_the_least_squares()
    {
        // Means 1 and 2/3; Sxy = 1, Sxx = 2.
        (double, double)[] points = [(0, 0), (1, 1), (2, 1)];
        PolynomialFit fit = PolynomialFit.Of(1, points);
        Assert.Equal(1.0 / 6, fit.Coefficients[0], 1e-14);
        Assert.Equal(0.5, fit.Coefficients[1], 1e-14);

        // R² = Sxy²/(Sxx·Syy) with Syy = 2/3.
        Assert.Equal(0.75, fit.Determination(points), 1e-14);
    }

    [Fact]
    public void Too_few_different_points_are_refused() =>
        Assert.Throws<ArgumentException>(() => PolynomialFit.Of(3, [(1, 1), (2, 2), (3, 3), (3, 4)]));
}
