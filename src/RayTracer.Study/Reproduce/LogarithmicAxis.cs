namespace RayTracer.Study;

/// <summary>A logarithmic axis from one power of ten to another, with a tick at each.</summary>
internal sealed class LogarithmicAxis : IChartAxis
{
    private const string Superscripts = "⁰¹²³⁴⁵⁶⁷⁸⁹";
    private readonly int _first;
    private readonly int _last;

    /// <summary>Chooses the powers so that all values lie between them.</summary>
    /// <param name="smallest">The smallest value, above 0.</param>
    /// <param name="largest">The largest value.</param>
    public LogarithmicAxis(double smallest, double largest)
    {
        const double rounding = 1e-6;
        _first = (int)Math.Floor(Exponent(smallest) + rounding);
        _last = Math.Max(_first + 1, (int)Math.Ceiling(Exponent(largest) - rounding));
    }

    /// <inheritdoc/>
    public IEnumerable<(double Value, string Label)> Ticks =>
        Enumerable.Range(_first, _last - _first + 1).Select(e => (Power(e), Label(e)));

    /// <inheritdoc/>
    public double Place(double value) => (Exponent(value) - _first) / (_last - _first);

    /// <inheritdoc/>
    public double ValueAt(double place) => Power(_first + (place * (_last - _first)));

    private static double Exponent(double value) => Math.Log10(value);

    private static double Power(double exponent) => Math.Pow(10, exponent);

    private static string Label(int exponent) =>
        $"10{(exponent < 0 ? "⁻" : "")}{string.Concat(Math.Abs(exponent).ToString(null, null).Select(c => Superscripts[c - '0']))}";
}
