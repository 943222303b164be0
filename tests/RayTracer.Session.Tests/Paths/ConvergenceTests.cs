using RayTracer.Numerics;
using RayTracer.Session;

namespace RayTracer.Session.Tests;

public sealed class ConvergenceTests
{
    [Fact]
    public void The_newest_pictures_own_error_is_taken_off()
    {
        // Pictures whose squares differ by σ²·(1/k − 1/n), as those of independent samples do.
        const int newest = 64;
        (int, Rgb[])[] earlier = [.. new[] { 1, 2, 4, 8, 16, 32 }.Select(k => (k, new[] { Grey(MathF.Sqrt((1f / k) - (1f / newest))), Grey(-MathF.Sqrt((1f / k) - (1f / newest))) }))];
        Convergence convergence = Convergence.Of(earlier, [default, default], newest);
        Assert.All(convergence.Points, p => Assert.Equal(1 / Math.Sqrt(p.Samples), p.Error, 1e-6));
        Assert.Equal(-0.5, convergence.Slope!.Value, 1e-5);
    }

    [Fact]
    public void A_single_point_has_no_slope_and_the_newest_picture_is_no_point() =>
        Assert.Null(Convergence.Of([(1, [Grey(1)]), (2, [Grey(0)])], [Grey(0)], 2).Slope);

    private static Rgb Grey(float v) => new(v, v, v);
}
