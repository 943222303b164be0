using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Tests.Media;

public class HenyeyGreensteinTests
{
    [Theory]
    [InlineData(-0.99f)]
    [InlineData(-0.4f)]
    [InlineData(-0.01f)]
    [InlineData(0f)]
    [InlineData(5e-4f)]
    [InlineData(0.1f)]
    [InlineData(0.25f)]
    [InlineData(0.8f)]
    public void The_mean_cosine_is_g_and_the_phase_function_is_the_density(float g)
    {
        const int count = 1 << 14;
        double mean = 0;
        double area = 0;
        double last = -1;
        for (int i = 0; i < count; i++)
        {
            HenyeyGreenstein.Sample(new(0.6f, 0f, 0.8f), g, (i + 0.5f) / count, 0.3f, out FloatW cosine);
            mean += cosine[0] / count;

            // Between two samples lies the same part of the light, but for the ends.
            area += i == 0 ? 0 : 2 * Math.PI * (cosine[0] - last) * HenyeyGreenstein.Evaluate((FloatW)(float)((cosine[0] + last) / 2), g)[0];
            last = cosine[0];
            if (i is count / 4 or count / 2 or count * 3 / 4)
            {
                Assert.Equal((double)i / count, area, 2e-3);
            }
        }

        Assert.Equal(g, mean, 1e-3);
    }
}
