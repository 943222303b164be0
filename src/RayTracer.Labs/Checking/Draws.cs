using RayTracer.Textbook;

namespace RayTracer.Labs;

/// <summary>The random numbers of which one case is made. The same numbers make the same case, and simpler ones a simpler case.</summary>
public sealed class Draws
{
    private readonly ISampler _random;
    private readonly IReadOnlyList<double> _given;
    private readonly List<double> _numbers = [];
    private readonly List<string> _texts = [];

    /// <summary>Begins a case.</summary>
    /// <param name="random">The source of the numbers.</param>
    /// <param name="given">Numbers to be taken first.</param>
    internal Draws(ISampler random, params IReadOnlyList<double> given) => (_random, _given) = (random, given);

    /// <summary>The case in words: what was drawn, by name.</summary>
    public string Text => string.Join(", ", _texts);

    /// <summary>The numbers that were drawn.</summary>
    internal IReadOnlyList<double> Numbers => _numbers;

    /// <summary>A number.</summary>
    /// <param name="name">What it is.</param>
    /// <param name="low">The smallest.</param>
    /// <param name="high">The largest.</param>
    public double Number(string name, double low, double high) => Named(name, Next(low, high), Answer.Text);

    /// <summary>A whole number.</summary>
    /// <param name="name">What it is.</param>
    /// <param name="low">The smallest.</param>
    /// <param name="high">The largest.</param>
    public int Whole(string name, int low, int high) => (int)Named(name, Math.Floor(Next(low, high + 0.999)), Answer.Text);

    /// <summary>A point in a cube.</summary>
    /// <param name="name">What it is.</param>
    /// <param name="low">The smallest number.</param>
    /// <param name="high">The largest number.</param>
    public Vector Point(string name, double low, double high) => Named(name, new Vector(Next(low, high), Next(low, high), Next(low, high)), v => Answer.Text((Answer)v));

    /// <summary>A unit direction.</summary>
    /// <param name="name">What it is.</param>
    public Vector Direction(string name)
    {
        Vector inCube = new(Next(-1, 1), Next(-1, 1), Next(-1, 1));
        return Named(name, inCube.Length > 1e-3 ? inCube.Unit : new Vector(0, 0, 1), v => Answer.Text((Answer)v));
    }

    /// <summary>A unit direction above the surface, with a height of at least 0.05.</summary>
    /// <param name="name">What it is.</param>
    public Vector DirectionAbove(string name)
    {
        Vector inBox = new(Next(-1, 1), Next(-1, 1), Next(0.1, 1));
        return Named(name, inBox.Unit, v => Answer.Text((Answer)v));
    }

    /// <summary>How far the numbers are from the simplest ones, 0, 1, −1, whole ones, and those with one or two decimals.</summary>
    internal int Complexity => _numbers.Sum(n => Simpler(n).Count());

    /// <summary>The simpler cases that are one step away: each has a number that is simpler.</summary>
    internal IEnumerable<double[]> Simpler()
    {
        for (int i = 0; i < _numbers.Count; i++)
        {
            foreach (double step in Simpler(_numbers[i]))
            {
                yield return [.. _numbers[..i], step, .. _numbers[(i + 1)..]];
            }
        }
    }

    private static IEnumerable<double> Simpler(double number) =>
        new[] { 0, 1, -1, Math.Round(number), Math.Round(number, 1), Math.Round(number, 2) }.TakeWhile(simpler => simpler != number);

    private double Next(double low, double high)
    {
        int i = _numbers.Count;
        double number = i < _given.Count ? Math.Clamp(_given[i], low, high) : low + ((high - low) * _random.Next());
        _numbers.Add(number);
        return number;
    }

    private T Named<T>(string name, T value, Func<T, string> text)
    {
        _texts.Add($"{name} {text(value)}");
        return value;
    }
}
