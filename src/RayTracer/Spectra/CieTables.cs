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

    // Each line of the file has a wavelength and four numbers.
    private static double[][] Columns(string[][] rows) =>
        [.. Enumerable.Range(1, 4).Select(column => Array.ConvertAll(rows, row => double.Parse(row[column], CultureInfo.InvariantCulture)))];
}
