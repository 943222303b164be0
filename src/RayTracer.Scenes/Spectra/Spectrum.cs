using RayTracer.Numerics;
using RayTracer.Spectra;

namespace RayTracer.Scenes;

/// <summary>Numbers at wavelengths, linear in between and 0 beyond; and the colours that they are.</summary>
/// <param name="wavelengths">In nm, rising.</param>
/// <param name="values">As many numbers.</param>
internal sealed class Spectrum(float[] wavelengths, float[] values)
{
    /// <summary>The number at a wavelength.</summary>
    public double At(double wavelength)
    {
        if (!(wavelength >= wavelengths[0] && wavelength <= wavelengths[^1]))
        {
            return 0;
        }

        int next = Array.BinarySearch(wavelengths, (float)wavelength);
        next = next >= 0 ? next : ~next;
        if (next == 0)
        {
            return values[0];
        }

        double along = (wavelength - wavelengths[next - 1]) / ((double)wavelengths[next] - wavelengths[next - 1]);
        return values[next - 1] + (along * ((double)values[next] - values[next - 1]));
    }

    /// <summary>The radiance of a black body, in W/(m² sr nm), by Planck's law; nothing beyond two wavelengths.</summary>
    /// <param name="temperature">Its temperature in kelvins.</param>
    /// <param name="first">Shortest wavelength in nm.</param>
    /// <param name="last">Longest wavelength in nm.</param>
    public static Spectrum BlackBody(float temperature, float first, float last)
    {
        float[] wavelengths = [.. Enumerable.Range(CieTables.First, CieTables.Last - CieTables.First + 1).Select(w => (float)w)];
        return new(wavelengths, [.. wavelengths.Select(w => w < first || w > last ? 0 : Spectra.BlackBody.Radiance(w, temperature))]);
    }

    /// <summary>The colour of light of this spectral radiance: 1 at all wavelengths has the luminance 1.</summary>
    public Rgb Light() => Color(static _ => 1);

    /// <summary>The colour of what reflects daylight (D65) so, or of a number that depends on the wavelength: 1 at all wavelengths is white.</summary>
    public Rgb Reflectance() => Color(static w => CieTables.Between(CieTables.D65, w));

    // The integrals of CIE 15:2004, section 7.1, in steps of 1 nm, and linear sRGB of them (IEC 61966-2-1, section 5.2).
    private Rgb Color(Func<double, double> illuminant)
    {
        (double x, double y, double z, double all) = (0, 0, 0, 0);
        for (int w = CieTables.First; w <= CieTables.Last; w++)
        {
            double light = illuminant(w);
            double value = light * At(w);
            double luminance = CieTables.Between(CieTables.Y, w);
            x += value * CieTables.Between(CieTables.X, w);
            y += value * luminance;
            z += value * CieTables.Between(CieTables.Z, w);
            all += light * luminance;
        }

        (x, y, z) = (x / all, y / all, z / all);
        return new(
            Positive((3.240479 * x) - (1.537150 * y) - (0.498535 * z)),
            Positive((-0.969256 * x) + (1.875991 * y) + (0.041556 * z)),
            Positive((0.055648 * x) - (0.204043 * y) + (1.057311 * z)));
    }

    // Colours that screens do not have.
    private static float Positive(double channel) => (float)double.Max(channel, 0);
}
