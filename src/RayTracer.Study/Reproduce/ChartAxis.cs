namespace RayTracer.Study;

/// <summary>An axis of a chart: the places of values.</summary>
internal interface IChartAxis
{
    /// <summary>The marked values, in ascending order, and how they are written.</summary>
    IEnumerable<(double Value, string Label)> Ticks { get; }

    /// <summary>The place of a value: 0 is the begin of the axis, 1 its end.</summary>
    double Place(double value);

    /// <summary>The value at a place.</summary>
    double ValueAt(double place);
}

/// <summary>An axis from 0, with ticks at multiples of 1, 2 or 5 times a power of ten.</summary>
internal sealed class ChartAxis : IChartAxis
{
    private const int MostTicks = 6;

    /// <summary>Chooses ticks so that the last is not below the largest value.</summary>
    /// <param name="largest">The largest value, above 0.</param>
    public ChartAxis(double largest)
    {
        double power = 1;
        while (power * MostTicks < largest)
        {
            power *= 10;
        }

        while (power * MostTicks >= 10 * largest)
        {
            power /= 10;
        }

        // Now power · 6 ≥ largest > power · 0.6: a smaller step may do.
        Step = new[] { 0.2, 0.5, 1 }.Select(f => f * power).First(s => s * MostTicks >= largest);
        Count = (int)Math.Ceiling((largest / Step) - 1e-9);
    }

    /// <summary>From one tick to the next.</summary>
    public double Step { get; }

    /// <summary>Number of ticks after the one at 0.</summary>
    public int Count { get; }

    /// <summary>The value at the end.</summary>
    public double End => Step * Count;

    /// <inheritdoc/>
    public IEnumerable<(double Value, string Label)> Ticks => Enumerable.Range(0, Count + 1).Select(i => (Step * i, Label(i)));

    /// <inheritdoc/>
    public double Place(double value) => value / End;

    /// <inheritdoc/>
    public double ValueAt(double place) => place * End;

    /// <summary>A tick's value, without the rounding errors of the multiplication.</summary>
    public string Label(int tick) => ((decimal)(Step * tick)).ToString("0.#########", null);
}
