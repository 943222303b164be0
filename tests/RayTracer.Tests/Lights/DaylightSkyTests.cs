using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Numerics;

namespace RayTracer.Tests.Lights;

/// <summary>The colours of a sky and its ground. Covers `DaylightSky`, `Atmosphere` and `SkyEnvironment`.</summary>
public class DaylightSkyTests
{
    private static readonly SkyEnvironmentDescription s_noon = new() { Scale = 1, SunElevation = 90, SunScale = 0 };

    [Fact]
    public void Noon_is_white_under_a_blue_sky()
    {
        Rgb sky = Received(s_noon);
        Rgb all = Received(s_noon with { SunScale = 1 });
        Assert.InRange(all.R / all.G, 0.95, 1.05);
        Assert.InRange(all.B / all.G, 0.95, 1.05);
        Assert.InRange(all.Luminance, 100, 130);
        Assert.InRange(sky.Luminance, 15, 45);
        Rgb halfway = At(s_noon, 45);
        Assert.True(halfway.B > 1.3f * halfway.G && halfway.G > 1.2f * halfway.R, $"{halfway}");
        Rgb horizon = At(s_noon, 0.5f);
        Assert.InRange(horizon.R / horizon.G, 0.85, 1.05);
        Assert.InRange(horizon.B / horizon.G, 0.95, 1.15);
    }

    [Fact]
    public void A_low_sun_is_orange_and_the_sky_around_it_too()
    {
        SkyEnvironmentDescription evening = s_noon with { SunElevation = 2, SunAzimuth = 0 };
        Rgb around = At(evening, 1);
        Assert.True(around.R > 1.2f * around.G && around.G > 1.5f * around.B, $"{around}");
        Rgb zenith = At(evening, 90);
        Assert.True(zenith.B > zenith.G && zenith.G > zenith.R, $"{zenith}");
        Rgb sun = new DaylightSky(3, new(0, 0.035f, -0.9994f), Rgb.Black).Sun;
        Assert.True(sun.R > 1.5f * sun.G && sun.G > 2 * sun.B, $"{sun}");
    }

    [Theory]
    [InlineData(2, 0)]
    [InlineData(2, 30)]
    [InlineData(3, 2)]
    [InlineData(5, 10)]
    [InlineData(10, 0)]
    [InlineData(10, 90)]
    public void All_colours_are_finite_and_grow_smoothly_down_to_the_horizon(float turbidity, float elevation)
    {
        SkyEnvironmentDescription sky = s_noon with { Turbidity = turbidity, SunElevation = elevation, SunAzimuth = 180 };
        EnvironmentLight light = Build(sky);
        Rgb last = At(light, 89.9f);
        for (float height = 89.7f; height > 0; height -= 0.2f)
        {
            Rgb here = At(light, height);
            Assert.True(here.Luminance > 0 && float.IsFinite(here.Luminance) && float.Min(here.R, here.B) >= 0, $"{here} at {height}°");
            Assert.InRange(here.Luminance / last.Luminance, 0.85, 1.15);
            last = here;
        }
    }

    [Theory]
    [InlineData(90, 1)]
    [InlineData(40, 1)]
    [InlineData(5, 0)]
    public void The_ground_sends_on_what_it_receives_of_sky_and_sun(float elevation, float sunScale)
    {
        SkyEnvironmentDescription sky = s_noon with { SunElevation = elevation, SunScale = sunScale, Ground = new(0.2f, 0.5f, 0) };
        Rgb received = Received(sky);
        foreach (float height in new[] { -1f, -30, -90 })
        {
            Rgb ground = At(sky, height);
            Assert.Equal(received.R * 0.2 / Math.PI, ground.R, 0.003 * ground.R);
            Assert.Equal(received.G * 0.5 / Math.PI, ground.G, 0.003 * ground.G);
            Assert.Equal(0, ground.B);
        }
    }

    [Fact]
    public void A_bright_ground_brightens_the_sky()
    {
        float Zenith(float ground) => At(s_noon with { SunElevation = 40, Ground = new(ground, ground, ground) }, 90).Luminance;
        Assert.InRange(Zenith(0.9f) / Zenith(0), 1.1, 3);
    }

    private static Rgb At(SkyEnvironmentDescription sky, float degrees) => At(Build(sky), degrees);

    private static Rgb At(EnvironmentLight light, float degrees)
    {
        (double sin, double cos) = Math.SinCos(degrees * Math.PI / 180);
        light.Evaluate(new Vector3(0, (float)sin, (float)-cos), out RgbW radiance);
        return new(radiance.R[0], radiance.G[0], radiance.B[0]);
    }

    // What a horizontal surface receives: an integral over the sky above it, and the sun's disk by its solid angle.
    private static Rgb Received(SkyEnvironmentDescription sky)
    {
        const int Rows = 400, Columns = 64;
        EnvironmentLight light = Build(sky with { SunScale = 0 });
        double[] sum = new double[3];
        for (int i = 0; i < Rows * Columns; i++)
        {
            // Evenly by the square of the sine, as a cosine asks.
            double sine = Math.Sqrt((i / Columns + 0.5) / Rows);
            (double x, double z) = Math.SinCos((i % Columns + 0.5) / Columns * 2 * Math.PI);
            light.Evaluate(new Vector3((float)(sine * x), (float)Math.Sqrt(1 - (sine * sine)), (float)(sine * z)), out RgbW radiance);
            (sum[0], sum[1], sum[2]) = (sum[0] + radiance.R[0], sum[1] + radiance.G[0], sum[2] + radiance.B[0]);
        }

        (double up, double level) = Math.SinCos(sky.SunElevation * Math.PI / 180);
        Rgb sun = new DaylightSky(sky.Turbidity, new(0, (float)up, (float)-level), sky.Ground).Sun * (float)(up * sky.SunScale);
        return new Rgb((float)sum[0], (float)sum[1], (float)sum[2]) * (float)(Math.PI / (Rows * Columns)) + sun;
    }

    private static EnvironmentLight Build(SkyEnvironmentDescription sky) =>
        sky.Build(new SceneBuilder((_, _) => throw new NotSupportedException()))!;
}
