using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Spectra;

namespace RayTracer.Tests.Materials;

/// <summary>Films against Airy's sum of all reflections, wavelength by wavelength.</summary>
public class ThinFilmTests
{
    public static TheoryData<float, float, float, float, float> Films
    {
        get
        {
            TheoryData<float, float, float, float, float> films = [];
            foreach (float index in new[] { 1f, 1.3f, 1.33f, 1.8f, 2.4f })
            {
                foreach (float thickness in new[] { 0, 60, 180, 400, 1200, 9000f })
                {
                    films.Add(index, thickness, 0.04f, 0.04f, 0.04f);
                    films.Add(index, thickness, 0.95f, 0.6f, 0.2f);
                }
            }

            return films;
        }
    }

    [Theory]
    [MemberData(nameof(Films))]
    public void A_film_reflects_what_Airys_sum_says_over_all_wavelengths(float index, float thickness, float red, float green, float blue)
    {
        ThinFilm film = new(index);
        foreach (float cosine in new[] { 1, 0.9f, 0.6f, 0.3f, 0.05f })
        {
            double[] expected = [Airy(0, index, thickness, cosine, red), Airy(1, index, thickness, cosine, green), Airy(2, index, thickness, cosine, blue)];
            RgbW found = film.Reflectance(cosine, new RgbW(red, green, blue), thickness);
            double[] channels = [found.R[0], found.G[0], found.B[0]];
            for (int channel = 0; channel < 3; channel++)
            {
                Assert.True(double.Abs(expected[channel] - channels[channel]) < 0.01, $"cosine {cosine}, channel {channel}: {channels[channel]}, by Airy's sum {expected[channel]}");
                Assert.InRange(channels[channel], 0, 1);
            }
        }
    }

    [Fact]
    public void Without_thickness_it_is_not_there()
    {
        foreach (float headOn in new[] { 0.02f, 0.04f, 0.2f, 0.5f })
        {
            Assert.Equal(headOn, new ThinFilm(1.4f).Reflectance(1f, new RgbW(headOn, headOn, headOn), 0f).G[0], 2e-3);
            Assert.Equal(headOn, new ThinFilm(1f).Reflectance(1f, new RgbW(headOn, headOn, headOn), 300f).G[0], 1e-4);
        }
    }

    [Fact]
    public void A_mirror_stays_one_and_a_thick_film_has_no_colour()
    {
        RgbW mirror = new ThinFilm(1.5f).Reflectance(0.7f, new RgbW(1f, 1f, 1f), 350f);
        Assert.All(new[] { mirror.R[0], mirror.G[0], mirror.B[0] }, c => Assert.InRange(c, 0.995f, 1));
        RgbW thick = new ThinFilm(1.5f).Reflectance(0.7f, new RgbW(0.1f, 0.1f, 0.1f), 5e4f);
        Assert.Equal(thick.R[0], thick.G[0], 1e-6);
        Assert.Equal(thick.R[0], thick.B[0], 1e-6);
    }

    // The largest and the smallest reflectance of a film of a quarter and of half a wavelength, of 550 nm head-on: ((1 − n²/m)/(1 + n²/m))² and that of the base.
    [Fact]
    public void A_quarter_of_a_wavelength_of_the_root_of_the_index_makes_glass_dark()
    {
        float index = MathF.Sqrt(1.5f);
        RgbW coated = new ThinFilm(index).Reflectance(1f, new RgbW(0.04f, 0.04f, 0.04f), 550 / (4 * index));
        Assert.InRange(coated.G[0], 0, 0.002f);
        Assert.InRange(coated.B[0], 0.0005f, 0.012f);
    }

    private static double Airy(int channel, double index, double thickness, double cosine, double headOn)
    {
        double root = Math.Sqrt(Math.Min(headOn, 0.9999));
        double below = (1 + root) / (1 - root);
        double inside = Math.Sqrt(1 - ((1 - (cosine * cosine)) / (index * index)));
        double outer = Schlick((1 - index) / (1 + index), cosine);
        double inner = Schlick((index - below) / (index + below), inside);
        (double sum, double all) = (0, 0);
        for (double w = CieTables.First; w <= CieTables.Last; w += 0.5)
        {
            // Amplitudes r + t r' t' e^(iφ) (1 + r'(−r) e^(iφ) + …), of which t t' = 1 − r².
            Complex turned = Complex.FromPolarCoordinates(1, 2 * Math.PI * 2 * index * thickness * inside / w);
            Complex amplitude = outer + ((1 - (outer * outer)) * inner * turned / (1 + (outer * inner * turned)));
            double weight = CieTables.Between(CieTables.D65, w) * Response(channel, w);
            sum += weight * amplitude.Magnitude * amplitude.Magnitude;
            all += weight;
        }

        return Math.Clamp(sum / all, 0, 1);
    }

    // The amplitude of Schlick's reflectance, with its sign.
    private static double Schlick(double headOn, double cosine) =>
        (headOn > 0 ? 1 : -1) * Math.Sqrt((headOn * headOn) + ((1 - (headOn * headOn)) * Math.Pow(1 - cosine, 5)));

    private static double Response(int channel, double w)
    {
        (double x, double y, double z) = (CieTables.Between(CieTables.X, w), CieTables.Between(CieTables.Y, w), CieTables.Between(CieTables.Z, w));
        return channel switch
        {
            0 => (3.240479 * x) - (1.537150 * y) - (0.498535 * z),
            1 => (-0.969256 * x) + (1.875991 * y) + (0.041556 * z),
            _ => (0.055648 * x) - (0.204043 * y) + (1.057311 * z),
        };
    }
}
