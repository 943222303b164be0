using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Tests.Statistics;

namespace RayTracer.Tests.Sampling;

/// <summary>Warps against their distributions: each point is mapped back to the square by the closed form, in double precision.</summary>
[Trait("Category", "Thorough")]
public class WarpTests
{
    [Fact]
    public void Cosine_hemisphere_is_distributed_by_the_cosine() =>
        CheckDirections("cosine hemisphere", Warp.CosineHemisphere, w => 1 - (w.Z * w.Z));

    [Theory]
    [InlineData(0)]
    [InlineData(0.5)]
    [InlineData(1)]
    [InlineData(2)]
    [InlineData(10)]
    [InlineData(65)]
    [InlineData(200)]
    [InlineData(1e4)]
    [InlineData(1e5)]
    [InlineData(1e6)]
    public void Cosine_power_lobe_is_distributed_by_the_power_of_the_cosine(float exponent) =>
        CheckDirections($"cosine to the power of {exponent}", (u, v) => Warp.CosinePowerLobe(u, v, exponent), w => 1 - Math.Pow(Math.Max(0, 1 - Height(w)), exponent + 1.0));

    [Fact]
    public void Uniform_sphere_is_uniform() => CheckDirections("uniform sphere", Warp.UniformSphere, w => (1 - w.Z) / 2);

    [Theory]
    [InlineData(2)]
    [InlineData(1)]
    [InlineData(0.1)]
    [InlineData(1e-3)]
    [InlineData(1e-6)]
    public void Uniform_cone_stays_within_the_cone_and_is_uniform(double height) =>
        CheckDirections($"cone of height {height}", (u, v) => Warp.UniformCone(u, v, (float)height), w => Height(w) / height);

    [Fact]
    public void Concentric_disk_is_uniform_and_keeps_neighbours_together()
    {
        Check("disk", (u, v, lane) =>
        {
            Warp.ConcentricDisk(u, v, out FloatW x, out FloatW y);
            return ((x[lane] * (double)x[lane]) + (y[lane] * (double)y[lane]), Turn(x[lane], y[lane]));
        });

        // The map's derivative is bounded by π/√2 or so: squares become squares, and do not fall to pieces.
        const float step = 1 / 64f;
        for (float u = step / 2; u < 1 - step; u += step)
        {
            for (float v = step / 2; v < 1 - step; v += step)
            {
                Assert.True((Disk(u + step, v) - Disk(u, v)).Length < 3.2 * step);
                Assert.True((Disk(u, v + step) - Disk(u, v)).Length < 3.2 * step);
            }
        }
    }

    [Fact]
    public void Middle_of_the_square_is_the_middle_of_the_disk() => Assert.Equal(0, Disk(0.5f, 0.5f).Length);

    [Fact]
    public void Uniform_triangle_is_uniform() => Check("triangle", (u, v, lane) =>
    {
        Warp.UniformTriangle(u, v, out FloatW b1, out FloatW b2);
        double root = 1 - b1[lane];
        return (root * root, b2[lane] / root);
    });

    [Theory]
    [InlineData(0)]
    [InlineData(0.5)]
    [InlineData(1)]
    [InlineData(30)]
    [InlineData(1000)]
    [InlineData(1e5)]
    public void Pdf_of_the_lobe_is_the_closed_form_and_integrates_to_one(float exponent)
    {
        double Density(Vector3D w) => Warp.CosinePowerLobePdf((float)Height(w), exponent)[0];
        Vector3D axis = new(0, 0, 1);
        Assert.Equal(1, new SphericalGrid(axis, axis, 1 / (exponent + 1.0)).Integrate(Density).Sum(), 5);
        for (double x = 0.01; x < 8; x *= 1.3)
        {
            float height = (float)(x / (exponent + 8));
            double expected = (exponent + 1.0) / (2 * Math.PI) * Math.Pow(1 - (double)height, exponent);
            Assert.InRange(Warp.CosinePowerLobePdf(height, exponent)[0], expected * (1 - 2e-6), expected * (1 + 2e-6));
        }

        Assert.Equal(0, Warp.CosinePowerLobePdf(1.25f, exponent)[0]);
    }

    [Fact]
    public void Pdf_of_the_cosine_hemisphere_is_the_cosine_over_pi_above_and_zero_below()
    {
        Assert.Equal(1 / Math.PI, Warp.CosineHemispherePdf(1f)[0], 6);
        Assert.Equal(0.25 / Math.PI, Warp.CosineHemispherePdf(0.25f)[0], 6);
        Assert.Equal(0, Warp.CosineHemispherePdf(-0.5f)[0]);
    }

    [Theory]
    [InlineData(3, 0)]
    [InlineData(4, 0.1f)]
    [InlineData(5, 0.9f)]
    [InlineData(16, 0.5f)]
    public void Regular_polygon_is_uniform(int corners, float turn) => Check($"polygon of {corners} corners", (u, v, lane) =>
    {
        // Of the sector, which of the similar triangles, by area, and where on its outer side.
        Warp.RegularPolygon(u, v, corners, turn, out FloatW x, out FloatW y);
        double angle = Turn(x[lane], y[lane]) - turn;
        double sector = Math.Floor((angle - Math.Floor(angle)) * corners);
        double middle = 2 * Math.PI * (turn + ((sector + 0.5) / corners));
        double half = Math.PI / corners;
        double height = ((x[lane] * Math.Cos(middle)) + (y[lane] * Math.Sin(middle))) / Math.Cos(half);

        // Next to the middle, all sides are within rounding of one another.
        double along = height < 0.01 ? (2 * v[lane]) - 1 : ((y[lane] * Math.Cos(middle)) - (x[lane] * Math.Sin(middle))) / (Math.Sin(half) * height);
        return (Inside(height * height), Inside((sector + (0.5 * (along + 1))) / corners));
    });

    // What rounding has taken across an edge, back to it.
    private static double Inside(double x)
    {
        Assert.InRange(x, -1e-4, 1 + 1e-4);
        return Math.Clamp(x, 0, Math.BitDecrement(1.0));
    }

    // A direction is tested by the share of the distribution that is nearer to the axis than it, and its turn around the axis.
    private static void CheckDirections(string what, Func<FloatW, FloatW, Vec3W> warp, Func<Vector3D, double> share) => Check(what, (u, v, lane) =>
    {
        Vector3D w = Vector3D.Of(warp(u, v), lane);
        Assert.InRange(w.Length, 1 - 1e-6, 1 + 1e-6);
        return (share(w), Turn(w.X, w.Y));
    });

    private static void Check(string what, Func<FloatW, FloatW, int, (double S, double T)> sample)
    {
        UnitSquareCounts counts = new();
        UnitSquare.AtRandom(TestSettings.Scale(1 << 18, 1 << 21), (u, v, lane) =>
        {
            (double s, double t) = sample(u, v, lane);
            counts.Add(s, t);
        });
        ErrorBudget.Warps.Check(counts.P(), what);
        UnitSquare.AssertPreservesArea(what, sample);
    }

    private static double Height(Vector3D w) => (w - new Vector3D(0, 0, 1)).Squared / 2;

    private static double Turn(double x, double y) => (Math.Atan2(y, x) / (2 * Math.PI)) + (y < 0 ? 1 : 0);

    private static Vector3D Disk(float u, float v)
    {
        Warp.ConcentricDisk(u, v, out FloatW x, out FloatW y);
        return new(x[0], y[0], 0);
    }
}
