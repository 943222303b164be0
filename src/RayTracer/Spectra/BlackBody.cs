using RayTracer.Numerics;

namespace RayTracer.Spectra;

/// <summary>The light of black bodies (Planck 1901, with the exact constants of the SI).</summary>
internal static unsafe class BlackBody
{
    /// <summary>No body that is colder has a colour.</summary>
    public const float Coldest = 100;

    /// <summary>The hottest body that has a colour of its own, in kelvins.</summary>
    public const float Hottest = 1e6f;

    // Between two numbers of the table, temperatures grow by 0.5 %.
    private const int Steps = 1850;
    private static readonly float s_perStep = LaneMath.Log(Hottest / Coldest) / Steps;
    private static readonly PinnedBuffer<float> s_colors = Colors();

    /// <summary>The radiance, in W/(m² sr nm).</summary>
    /// <param name="nanometres">The wavelength.</param>
    /// <param name="temperature">Its temperature in kelvins.</param>
    public static float Radiance(double nanometres, float temperature)
    {
        const double hc = 6.62607015e-34 * 299792458;
        const double k = 1.380649e-23;
        double length = nanometres * 1e-9;
        double power = hc / (length * k * temperature);
        double others = power > 80 ? double.PositiveInfinity : LaneMath.Exp((float)power) - 1;
        return (float)(2 * hc * 299792458 / (length * length * length * length * length * others) * 1e-9);
    }

    /// <summary>The colours of bodies whose radiance is 1 at the wavelength where it is largest; black below <see cref="Coldest"/>.</summary>
    /// <param name="temperature">Their temperatures in kelvins.</param>
    public static RgbW Color(FloatW temperature)
    {
        FloatW place = FloatW.Max(0f, FloatW.Min(LaneMath.Log(FloatW.Max(temperature, Coldest) * (1 / Coldest)) / s_perStep, Steps - 0.01f));
        FloatW first = FloatW.Floor(place);
        UIntW at = first.ToIntInRange() * 3u;
        MaskW shines = temperature > Coldest;
        return shines.Select(RgbW.Mix(RgbW.Gather(s_colors.Pointer, at), RgbW.Gather(s_colors.Pointer + 3, at), place - first), Rgb.Black);
    }

    private static PinnedBuffer<float> Colors()
    {
        // The wavelength of most radiance, times the temperature in nm K.
        const double displacement = 2.897771955e6;
        PinnedBuffer<float> table = new(3 * (Steps + 1L));
        for (int step = 0; step <= Steps; step++)
        {
            float temperature = Coldest * LaneMath.Exp(step * s_perStep);
            float most = Radiance(displacement / temperature, temperature);
            (double r, double g, double b) = CieTables.LinearSrgb(i => Radiance(CieTables.First + (i * CieTables.Step), temperature) / most);
            ReadOnlySpan<float> color = [(float)double.Max(r, 0), (float)double.Max(g, 0), (float)double.Max(b, 0)];
            color.CopyTo(new Span<float>(table.Pointer + (3 * step), 3));
        }

        return table;
    }
}
