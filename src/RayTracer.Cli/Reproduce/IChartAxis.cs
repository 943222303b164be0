namespace RayTracer.Cli.Reproduce;

/// <summary>An axis of a chart: which value stands where.</summary>
internal interface IChartAxis
{
    /// <summary>The marked values, in ascending order, and how they are written.</summary>
    IEnumerable<(double Value, string Label)> Ticks { get; }

    /// <summary>Where a value stands: 0 is the begin of the axis, 1 its end.</summary>
    double Place(double value);

    /// <summary>Which value stands at a place.</summary>
    double ValueAt(double place);
}
