using RayTracer.Numerics;
using RayTracer.Spectra;

namespace RayTracer.Tests.Spectra;

/// <summary>How paths get their wavelengths.</summary>
public class WavelengthsTests
{
    private static readonly Wavelengths s_wavelengths = new();

    [Fact]
    public void All_wavelengths_together_are_white()
    {
        double[] sums = new double[3];
        for (int step = 0; step < Wavelengths.Steps; step++)
        {
            s_wavelengths.Sample((step + 0.5f) / Wavelengths.Steps, out _, out RgbW weight);
            double[] channels = [weight.R[0], weight.G[0], weight.B[0]];
            Assert.All(channels, c => Assert.True(c >= 0));
            Assert.Equal(3, channels.Sum(), 1e-5);
            for (int channel = 0; channel < 3; channel++)
            {
                sums[channel] += channels[channel] / Wavelengths.Steps;
            }
        }

        Assert.All(sums, s => Assert.Equal(1, s, 1e-6));
    }

    [Fact]
    public void Long_waves_are_red_and_short_ones_blue()
    {
        float before = 0;
        for (float u = 0; u < 1; u += 1f / 1024)
        {
            s_wavelengths.Sample(u, out FloatW wavelength, out RgbW weight);
            Assert.InRange(wavelength[0], before, 0.83f);
            before = wavelength[0];
            string most = weight.R[0] > 1.5f ? "red" : weight.G[0] > 1.5f ? "green" : weight.B[0] > 1.5f ? "blue" : "mixed";
            string expected = before switch { > 0.61f => "red", > 0.515f and < 0.56f => "green", < 0.485f => "blue", _ => most };
            Assert.Equal((before, expected), (before, most));
        }

        s_wavelengths.Sample(0.99999994f, out FloatW last, out _);
        Assert.InRange(last[0], 0.75f, 0.8301f);
    }

    [Fact]
    public void Weights_are_the_responses_over_the_density_of_wavelengths()
    {
        // Sums of any function over wavelengths, as chosen and weighted, against the integral of it and the response.
        double[] expected = new double[3];
        double[] all = new double[3];
        for (double nanometres = CieTables.First; nanometres < CieTables.Last; nanometres += 0.1)
        {
            double x = CieTables.Between(CieTables.X, nanometres), y = CieTables.Between(CieTables.Y, nanometres), z = CieTables.Between(CieTables.Z, nanometres);
            double[] response = [(3.240479 * x) - (1.537150 * y) - (0.498535 * z), (-0.969256 * x) + (1.875991 * y) + (0.041556 * z), (0.055648 * x) - (0.204043 * y) + (1.057311 * z)];
            for (int channel = 0; channel < 3; channel++)
            {
                all[channel] += Math.Max(0, response[channel]);
                expected[channel] += Math.Max(0, response[channel]) * Math.Cos(nanometres / 20);
            }
        }

        const int count = 1 << 14;
        double[] sums = new double[3];
        for (int i = 0; i < count; i++)
        {
            s_wavelengths.Sample((i + 0.5f) / count, out FloatW wavelength, out RgbW weight);
            double value = Math.Cos(wavelength[0] * 1000 / 20) / count;
            sums[0] += weight.R[0] * value;
            sums[1] += weight.G[0] * value;
            sums[2] += weight.B[0] * value;
        }

        for (int channel = 0; channel < 3; channel++)
        {
            // Within a step, the weights are the same and wavelengths even: wide steps are at both ends only.
            Assert.Equal(expected[channel] / all[channel], sums[channel], 2e-3);
        }
    }
}
