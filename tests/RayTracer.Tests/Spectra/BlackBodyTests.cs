using RayTracer.Numerics;
using RayTracer.Spectra;

namespace RayTracer.Tests.Spectra;

/// <summary>The table of colours of black bodies, against Planck's law in double precision.</summary>
public class BlackBodyTests
{
    [Theory]
    [InlineData(700)]
    [InlineData(1000)]
    [InlineData(1666.6f)]
    [InlineData(2856)]
    [InlineData(6504)]
    [InlineData(11111)]
    [InlineData(250000)]
    public void Colours_are_the_integral_of_Plancks_law_over_its_peak(float temperature)
    {
        // hc/k, in nm K; hc/λkT is 4.965114 at the peak.
        const double second = 1.438776877e7;
        double most = Math.Pow(temperature, 5) * Math.Pow(4.965114231744276 / second, 5) / (Math.Exp(4.965114231744276) - 1);
        (double x, double y, double z, double all) = (0, 0, 0, 0);
        for (int w = CieTables.First; w <= CieTables.Last; w++)
        {
            double value = Math.Pow(w, -5) / (Math.Exp(second / (w * (double)temperature)) - 1) / most;
            x += value * CieTables.Between(CieTables.X, w);
            y += value * CieTables.Between(CieTables.Y, w);
            z += value * CieTables.Between(CieTables.Z, w);
            all += CieTables.Between(CieTables.Y, w);
        }

        double[] expected = [(3.240479 * x) - (1.537150 * y) - (0.498535 * z), (-0.969256 * x) + (1.875991 * y) + (0.041556 * z), (0.055648 * x) - (0.204043 * y) + (1.057311 * z)];
        RgbW found = BlackBody.Color(temperature);
        double[] channels = [found.R[0], found.G[0], found.B[0]];
        for (int channel = 0; channel < 3; channel++)
        {
            Assert.Equal(Math.Max(expected[channel] / all, 0), channels[channel], 5e-3 * expected.Max() / all);
        }
    }

    [Theory]
    [InlineData(-5)]
    [InlineData(0)]
    [InlineData(100)]
    [InlineData(float.NaN)]
    public void What_is_cold_is_dark(float temperature)
    {
        RgbW color = BlackBody.Color(temperature);
        Assert.Equal((0f, 0f, 0f), (color.R[0], color.G[0], color.B[0]));
    }

    [Fact]
    public void Beyond_the_table_colours_stay()
    {
        (RgbW hot, RgbW hotter) = (BlackBody.Color(1e6f), BlackBody.Color(1e30f));
        Assert.Equal(hot.B[0], hotter.B[0], 1e-4 * hot.B[0]);
        Assert.True(hot.B[0] > hot.R[0]);
    }
}
