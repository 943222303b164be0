using RayTracer.Description;
using RayTracer.Imaging;

namespace RayTracer.Study.Tests;

public class ErrorCurveTests
{
    [Fact]
    public void Power_of_the_time_is_found_and_values_between_points_follow_it()
    {
        // 3 / t².
        ErrorCurve curve = Of((1, 3), (2, 0.75), (4, 0.1875));
        Assert.Equal(-2, curve.Slope!.Value, 1e-9);
        Assert.Equal(3 / 9.0, curve.At(3)!.Value, 1e-9);
        Assert.Equal(3 / 25.0, curve.At(5)!.Value, 1e-9);
        Assert.Equal(4, curve.Last.Seconds);
    }

    [Fact]
    public void Nothing_is_said_where_too_little_was_measured()
    {
        Assert.Null(Of((1, 3), (2, 2)).At(5));
        Assert.Equal((null, null), (Of((1, 3)).Slope, Of((1, 3)).At(1)));
        Assert.Equal((null, null), (Of((1, 0), (2, 0)).Slope, Of((1, 0), (2, 0)).At(1)));
        Assert.Null(ConvergenceChart.Draw("Title", [Of((1, 0), (2, double.NaN))]));
        Assert.Equal(2, ConvergenceChart.Draw("Title", [Of((1, 0), (2, 1), (3, 1))])!.Descendants().Count(e => e.Name.LocalName == "circle"));
    }

    private static ErrorCurve Of(params (double Seconds, double Error)[] points) =>
        new(Integrator.Path, [.. points.Select(p => new ErrorPoint(p.Seconds, 1, new RelativeError(p.Error, p.Error)))]);
}
