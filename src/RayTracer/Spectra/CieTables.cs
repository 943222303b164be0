using System.Globalization;

namespace RayTracer.Spectra;

/// <summary>
/// The colour matching functions of the 2° observer (CIE 1931) and the daylight D65 (CIE 15:2004), from 360 to 830 nm in steps of 5 nm.
/// </summary>
internal static class CieTables
{
    private static readonly double[][] s_columns = Columns(EmbeddedTable.Read(typeof(CieTables), "cie.txt"));

    /// <summary>The first wavelength, in nm.</summary>
    public const int First = 360;

    /// <summary>The last wavelength, in nm.</summary>
    public const int Last = 830;

    /// <summary>Between wavelengths, in nm.</summary>
    public const int Step = 5;

    /// <summary>The matching function of X.</summary>
    public static ReadOnlySpan<double> X => s_columns[0];

    /// <summary>The matching function of Y.</summary>
    public static ReadOnlySpan<double> Y => s_columns[1];

    /// <summary>The matching function of Z.</summary>
    public static ReadOnlySpan<double> Z => s_columns[2];

    /// <summary>Relative spectral power of D65, 100 at 560 nm.</summary>
    public static ReadOnlySpan<double> D65 => s_columns[3];

    /// <summary>A table's number at a wavelength, linear in between.</summary>
    /// <param name="table">The table.</param>
    /// <param name="wavelength">In nm, from <see cref="First"/> to <see cref="Last"/>.</param>
    public static double Between(ReadOnlySpan<double> table, double wavelength)
    {
        double place = (wavelength - First) / Step;
        int below = int.Min((int)place, table.Length - 2);
        return table[below] + ((place - below) * (table[below + 1] - table[below]));
    }

    /// <summary>
    /// Linear sRGB (IEC 61966-2-1, section 5.2) of a spectrum, by the sums of CIE 15:2004, section 7.1, over the wavelengths of the tables; 1 everywhere has the luminance 1.
    /// </summary>
    /// <param name="spectrum">Its number at the wavelength of each index of the tables.</param>
    public static (double R, double G, double B) LinearSrgb(Func<int, double> spectrum)
    {
        (double x, double y, double z, double all) = (0, 0, 0, 0);
        for (int i = 0; i < Y.Length; i++)
        {
            double value = spectrum(i);
            (x, y, z, all) = (x + (value * X[i]), y + (value * Y[i]), z + (value * Z[i]), all + Y[i]);
        }

        (x, y, z) = (x / all, y / all, z / all);
        return ((3.240479 * x) - (1.537150 * y) - (0.498535 * z), (-0.969256 * x) + (1.875991 * y) + (0.041556 * z), (0.055648 * x) - (0.204043 * y) + (1.057311 * z));
    }

    // Each line of the file has a wavelength and four numbers.
    private static double[][] Columns(string[][] rows) =>
        [.. Enumerable.Range(1, 4).Select(column => Array.ConvertAll(rows, row => double.Parse(row[column], CultureInfo.InvariantCulture)))];
}
