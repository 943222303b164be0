using RayTracer.Numerics;

namespace RayTracer.Spectra;

/// <summary>
/// Chooses the wavelength of a path where its direction comes to depend on it, and what its three channels are multiplied by then: their responses over the
/// density. The density is the mean of the three responses, so the three weights have the sum 3 (the balance heuristic of Wilkie et al. 2014, with channels in
/// place of wavelengths), and over all wavelengths each has the mean 1: light that does not depend on the wavelength keeps its colour exactly.
/// A channel's response is linear sRGB's to light of a single wavelength (IEC 61966-2-1:1999, section 5.2), without what is negative there,
/// and normalised.
/// </summary>
internal sealed unsafe class Wavelengths
{
    /// <summary>Steps of equal probability, in each of which the weights are the same.</summary>
    public const int Steps = 1024;

    // Steps of the integrals, in nm: the tables are linear in between.
    private const double Width = 0.5;
    private readonly PinnedBuffer<float> _wavelengths = new(Steps + 1);
    private readonly PinnedBuffer<float> _red = new(Steps);
    private readonly PinnedBuffer<float> _green = new(Steps);
    private readonly PinnedBuffer<float> _blue = new(Steps);

    /// <summary>Integrates the responses.</summary>
    public Wavelengths()
    {
        int cells = (int)((CieTables.Last - CieTables.First) / Width);
        double[][] sums = [Cumulative(0, cells), Cumulative(1, cells), Cumulative(2, cells)];
        float*[] weights = [_red.Pointer, _green.Pointer, _blue.Pointer];
        double[] before = new double[3];
        int cell = 0;
        _wavelengths.Pointer[0] = CieTables.First * 1e-3f;
        for (int step = 1; step <= Steps; step++)
        {
            double target = (double)step / Steps;
            while (cell < cells - 1 && All(cell + 1) < target)
            {
                cell++;
            }

            double along = step == Steps ? cells - cell : (target - All(cell)) / (All(cell + 1) - All(cell));
            _wavelengths.Pointer[step] = (float)((CieTables.First + ((cell + along) * Width)) * 1e-3);
            for (int channel = 0; channel < 3; channel++)
            {
                double[] sum = sums[channel];
                double here = step == Steps ? 1 : sum[cell] + (along * (sum[cell + 1] - sum[cell]));
                weights[channel][step - 1] = (float)((here - before[channel]) * Steps);
                before[channel] = here;
            }
        }

        double All(int i) => (sums[0][i] + sums[1][i] + sums[2][i]) / 3;
    }

    /// <summary>Chooses a wavelength.</summary>
    /// <param name="u">A number from 0 up to 1.</param>
    /// <param name="wavelength">The wavelength in µm.</param>
    /// <param name="weight">The factors on the channels.</param>
    public void Sample(FloatW u, out FloatW wavelength, out RgbW weight)
    {
        FloatW scaled = u * Steps;
        UIntW step = scaled.ToIntInRange();
        FloatW.Gather(_wavelengths.Pointer, step, out FloatW from, out FloatW to);
        wavelength = FloatW.Mix(from, to, scaled - step.ToFloat());
        weight = new(FloatW.Gather(_red.Pointer, step), FloatW.Gather(_green.Pointer, step), FloatW.Gather(_blue.Pointer, step));
    }

    // The integral of a channel's response up to each cell, over the whole.
    private static double[] Cumulative(int channel, int cells)
    {
        double[] sum = new double[cells + 1];
        for (int i = 0; i < cells; i++)
        {
            sum[i + 1] = sum[i] + Response(channel, CieTables.First + ((i + 0.5) * Width));
        }

        return [.. sum.Select(s => s / sum[^1])];
    }

    private static double Response(int channel, double nanometres)
    {
        double x = CieTables.Between(CieTables.X, nanometres);
        double y = CieTables.Between(CieTables.Y, nanometres);
        double z = CieTables.Between(CieTables.Z, nanometres);
        double response = channel switch
        {
            0 => (3.240479 * x) - (1.537150 * y) - (0.498535 * z),
            1 => (-0.969256 * x) + (1.875991 * y) + (0.041556 * z),
            _ => (0.055648 * x) - (0.204043 * y) + (1.057311 * z),
        };
        return double.Max(response, 0);
    }
}
