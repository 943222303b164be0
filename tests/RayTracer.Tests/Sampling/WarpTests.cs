using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Tests.Sampling;

public class WarpTests
{
    private const int Side = 512;

    [Fact]
    public void Cosine_hemisphere_has_the_density_of_its_pdf() =>
        AssertMoments(Warp.CosineHemisphere, c => Warp.CosineHemispherePdf((float)c));

    [Theory]
    [InlineData(0)]
    [InlineData(1)]
    [InlineData(10)]
    [InlineData(200)]
    public void Cosine_power_lobe_has_the_density_of_its_pdf(float exponent) =>
        AssertMoments((u, v) => Warp.CosinePowerLobe(u, v, exponent), c => Warp.CosinePowerLobePdf((float)c, exponent));

    [Fact]
    public void A_sharp_lobe_does_not_round_to_steps()
    {
        // The half of the samples nearest to the axis lies within acos(0.5^(1/(n+1))), computed here in double precision.
        const double exponent = 1e6;
        double expected = Math.Sqrt(1 - Math.Pow(0.5, 2 / (exponent + 1)));
        Vec3W w = Warp.CosinePowerLobe(0.5f, 0.25f, (float)exponent);
        double sin = Math.Sqrt((w.X[0] * (double)w.X[0]) + (w.Y[0] * (double)w.Y[0]));
        Assert.InRange(sin, expected * 0.99999, expected * 1.00001);
    }

    [Fact]
    public void Uniform_cone_stays_within_the_cone_and_is_uniform()
    {
        const double height = 0.1;
        double sum = 0;
        ForEachCell((u, v) =>
        {
            Vec3W w = Warp.UniformCone(u, v, (float)height);
            Assert.InRange(w.Z[0], 1 - height - 1e-6, 1);
            sum += w.Z[0];
        });
        Assert.Equal(1 - (height / 2), sum / (Side * Side), 5);
    }

    [Fact]
    public void Concentric_disk_maps_equal_areas_to_equal_areas()
    {
        double inner = 0;
        double right = 0;
        ForEachCell((u, v) =>
        {
            Warp.ConcentricDisk(u, v, out FloatW x, out FloatW y);
            double r2 = (x[0] * (double)x[0]) + (y[0] * (double)y[0]);
            Assert.InRange(r2, 0, 1 + 1e-6);
            inner += r2 < 0.3 ? 1 : 0;
            right += x[0] > 0 && y[0] > 0 ? 1 : 0;
        });
        Assert.Equal(0.3, inner / (Side * Side), 2);
        Assert.Equal(0.25, right / (Side * Side), 2);
    }

    [Fact]
    public void Uniform_triangle_has_the_centroid_as_its_mean()
    {
        double b1 = 0;
        double b2 = 0;
        ForEachCell((u, v) =>
        {
            Warp.UniformTriangle(u, v, out FloatW p, out FloatW q);
            Assert.True(p[0] >= 0 && q[0] >= 0 && p[0] + q[0] <= 1 + 1e-6);
            b1 += p[0];
            b2 += q[0];
        });
        Assert.Equal(1 / 3.0, b1 / (Side * Side), 3);
        Assert.Equal(1 / 3.0, b2 / (Side * Side), 3);
    }

    // Directions are of unit length, and the mean of cos^k over the samples is the integral of pdf · cos^k.
    private static void AssertMoments(Func<FloatW, FloatW, Vec3W> warp, Func<double, double> pdf)
    {
        double[] moments = new double[4];
        ForEachCell((u, v) =>
        {
            Vec3W w = warp(u, v);
            Assert.InRange(Vec3W.Dot(w, w)[0], 1 - 1e-5f, 1 + 1e-5f);
            for (int k = 0; k < 4; k++)
            {
                moments[k] += Math.Pow(w.Z[0], k) / (Side * Side);
            }
        });
        const int steps = 20000;
        for (int k = 0; k < 4; k++)
        {
            double integral = 0;
            for (int i = 0; i < steps; i++)
            {
                double c = (i + 0.5) / steps;
                integral += 2 * Math.PI * pdf(c) * Math.Pow(c, k) / steps;
            }

            Assert.Equal(integral, moments[k], 3);
        }
    }

    private static void ForEachCell(Action<float, float> action)
    {
        for (int i = 0; i < Side; i++)
        {
            for (int j = 0; j < Side; j++)
            {
                action((i + 0.5f) / Side, (j + 0.5f) / Side);
            }
        }
    }
}
