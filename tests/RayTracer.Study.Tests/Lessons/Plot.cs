namespace RayTracer.Study.Tests.Lessons;

/// <summary>A pair of axes in a <see cref="Figure"/>.</summary>
internal sealed class Plot
{
    private readonly Figure _figure;
    private readonly (double X, double Y, double Width, double Height) _place;
    private readonly (double From, double To) _x;
    private readonly (double From, double To) _y;
    private int _legend;

    /// <summary>Draws the axes.</summary>
    /// <param name="figure">The drawing.</param>
    /// <param name="place">The rectangle between the axes, in pixels.</param>
    /// <param name="x">The values at the left and at the right.</param>
    /// <param name="y">The values at the bottom and at the top.</param>
    /// <param name="ticks">The marked values of both axes, and how they are written.</param>
    /// <param name="titles">What the axes are.</param>
    public Plot(
        Figure figure, (double X, double Y, double Width, double Height) place, (double From, double To) x, (double From, double To) y,
        (IEnumerable<(double Value, string Label)> X, IEnumerable<(double Value, string Label)> Y) ticks, (string X, string Y) titles)
    {
        (_figure, _place, _x, _y) = (figure, place, x, y);
        foreach ((double value, string label) in ticks.X)
        {
            figure.Line(At(value, y.From), At(value, y.To), "#e6e6e6", 1);
            figure.Text(label, (At(value, 0).X, place.Y + place.Height + 18));
        }

        foreach ((double value, string label) in ticks.Y)
        {
            figure.Line(At(x.From, value), At(x.To, value), "#e6e6e6", 1);
            figure.Text(label, (place.X - 7, At(0, value).Y + 5), "end");
        }

        figure.Line(At(x.From, y.From), At(x.To, y.From), width: 1);
        figure.Line(At(x.From, y.From), At(x.From, y.To), width: 1);
        figure.Text(titles.X, (place.X + (place.Width / 2), place.Y + place.Height + 40));
        double side = place.X - 48;
        figure.Text(titles.Y, (side, place.Y + (place.Height / 2)), turn: -90);
    }

    /// <summary>Numbers as labels.</summary>
    public static IEnumerable<(double Value, string Label)> Ticks(string format, params double[] values) =>
        values.Select(v => (v, v.ToString(format, System.Globalization.CultureInfo.InvariantCulture)));

    /// <summary>The pixel of a pair of values.</summary>
    public (double X, double Y) At(double x, double y) => (
        _place.X + (_place.Width * (x - _x.From) / (_x.To - _x.From)),
        _place.Y + (_place.Height * (_y.To - y) / (_y.To - _y.From)));

    /// <summary>A function's curve, with an entry in the legend.</summary>
    public void Curve(string? name, string colour, Func<double, double> f, string? dash = null, int steps = 160) =>
        Curve(name, colour, Enumerable.Range(0, steps + 1).Select(i => _x.From + ((_x.To - _x.From) * i / steps)).Select(x => (x, f(x))), dash);

    /// <summary>A curve through points; what is above or below the axes is cut off.</summary>
    public void Curve(string? name, string colour, IEnumerable<(double X, double Y)> points, string? dash = null)
    {
        _figure.Polyline(points.Select(p => At(p.X, Math.Clamp(p.Y, _y.From, _y.To))), colour, 2, dash);
        if (name is not null)
        {
            (double x, double y) = (_place.X + _place.Width + 14, _place.Y + 12 + (22 * _legend++));
            _figure.Polyline([(x, y), (x + 22, y)], colour, 2, dash);
            _figure.Text(name, (x + 28, y + 5), "start");
        }
    }

    /// <summary>Bars side by side over the whole axis: the share of some values in each, over the width of a bar, so that all bars have the area 1.</summary>
    public void Histogram(IReadOnlyCollection<double> values, int bars, string colour)
    {
        double width = (_x.To - _x.From) / bars;
        int[] counts = new int[bars];
        foreach (double value in values.Where(v => v >= _x.From && v < _x.To))
        {
            counts[(int)((value - _x.From) / width)]++;
        }

        for (int i = 0; i < bars; i++)
        {
            (double left, double top) = At(_x.From + (width * i), Math.Min(counts[i] / (values.Count * width), _y.To));
            (double right, double bottom) = At(_x.From + (width * (i + 1)), _y.From);
            _figure.Rectangle(left, top, right - left, bottom - top, colour, "#ffffff");
        }
    }
}
