using RayTracer.Numerics;
using RayTracer.Session;

namespace RayTracer.Desktop.ViewModels;

/// <summary>The error against the number of samples, both axes logarithmic, beside the theory's slope.</summary>
/// <param name="dispatcher">Asks the session.</param>
/// <param name="isVisible">Returns whether it is visible: only then does it follow the picture.</param>
internal sealed class ConvergenceViewModel(SessionDispatcher dispatcher, Func<bool> isVisible) : Observable
{
    private const double Left = 60;
    private const double Bottom = 26;
    private const double Edge = 12;
    private static readonly TimeSpan Pause = TimeSpan.FromSeconds(1);
    private IReadOnlyList<ConvergencePoint> _points = [];
    private double? _slope;
    private double _width = 400;
    private double _height = 200;

    /// <summary>The errors' line.</summary>
    public IReadOnlyList<Spot> Curve { get; private set; } = [];

    /// <summary>The theory's line.</summary>
    public IReadOnlyList<Spot> Theory { get; private set; } = [];

    /// <summary>Numbers of samples below the plot, and errors at its left.</summary>
    public IReadOnlyList<PlotTick> Ticks { get; private set; } = [];

    /// <summary>Returns whether there is enough to plot.</summary>
    public bool IsPlotted => _points.Count > 1;

    /// <summary>The slope in words; empty where it is not known.</summary>
    public string Slope => _slope is { } slope ? SessionTexts.Of("convergence.slope", Figures.Short(slope, 3)) : "";

    /// <summary>Follows the picture until it is stopped.</summary>
    public async Task Follow(CancellationToken stop)
    {
        while (!stop.IsCancellationRequested)
        {
            if (isVisible())
            {
                await Load();
            }

            await Task.Delay(Pause, stop);
        }
    }

    /// <summary>Asks for the errors so far.</summary>
    public async Task Load()
    {
        try
        {
            Convergence convergence = await dispatcher.Aside(s => s.View.Loop.Convergence());
            (_points, _slope) = ([.. convergence.Points.Where(p => p.Error > 0)], convergence.Slope);
        }
        catch (SessionException)
        {
            // There is no picture yet.
            (_points, _slope) = ([], null);
        }

        Plot();
    }

    /// <summary>The plot has another size.</summary>
    public void Resize(double width, double height)
    {
        (_width, _height) = (width, height);
        Plot();
    }

    private void Plot()
    {
        if (!IsPlotted)
        {
            (Curve, Theory, Ticks) = ([], [], []);
            OnPropertyChanged("");
            return;
        }

        // As far as the theory's line goes too.
        ConvergencePoint first = _points[0];
        double[] theory = [.. _points.Select(p => first.Error * Math.Sqrt(first.Samples / (double)p.Samples))];
        (double low, double high) = (Math.Min(_points.Min(p => p.Error), theory.Min()), Math.Max(_points.Max(p => p.Error), theory.Max()));
        (double from, double to) = (first.Samples, _points[^1].Samples);
        Spot At(double samples, double error) => new(
            Left + (Part(samples, from, to) * Math.Max(1, _width - Left - Edge)), Edge + ((1 - Part(error, low, high)) * Math.Max(1, _height - Bottom - Edge)));
        Curve = [.. _points.Select(p => At(p.Samples, p.Error))];
        Theory = [.. _points.Zip(theory, (p, e) => At(p.Samples, e))];
        Ticks =
        [
            .. _points.Select(p => new PlotTick(Figures.Short(p.Samples), At(p.Samples, low).X - 4, _height - Bottom + 4)),
            .. new[] { low, high }.Distinct().Select(e => new PlotTick(Figures.Short(e, 2), 2, At(from, e).Y - 8)),
        ];
        OnPropertyChanged("");
    }

    private static double Part(double value, double low, double high) =>
        high > low ? (Log(value) - Log(low)) / (Log(high) - Log(low)) : 0.5;

    private static double Log(double value) => LaneMath.Log((float)value);
}

/// <summary>A number at an axis of a plot.</summary>
/// <param name="Text">The number.</param>
/// <param name="X">The distance from the left.</param>
/// <param name="Y">The distance from the top.</param>
internal sealed record PlotTick(string Text, double X, double Y);
