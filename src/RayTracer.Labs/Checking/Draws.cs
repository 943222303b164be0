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

    /// <summary>How far the numbers are from simple ones.</summary>
    internal int Complexity => _numbers.Sum(ComplexityOf);

    /// <summary>The simpler cases that are one step away: each has one number that is simpler.</summary>
    internal IEnumerable<double[]> Simpler()
    {
        for (int i = 0; i < _numbers.Count; i++)
        {
            double now = _numbers[i];
            double[] steps = [0, 1, -1, Math.Truncate(now / 2), now - Math.Sign(now), Math.Round(now), Math.Round(now, 1), Math.Round(now, 2)];
            foreach (double step in steps.Where(s => ComplexityOf(s) < ComplexityOf(now)))
            {
                yield return [.. _numbers[..i], step, .. _numbers[(i + 1)..]];
            }
        }
    }

    // 0 is the simplest number, then 1 and −1, then larger whole ones, those with one decimal, with two, and all others.
    private static int ComplexityOf(double number) => number switch
    {
        0 or 1 => (int)number,
        -1 => 2,
        _ when number == Math.Round(number) => 2 + (int)Math.Min(Math.Abs(number), 1000),
        _ when number == Math.Round(number, 1) => 2000,
        _ => number == Math.Round(number, 2) ? 3000 : 4000,
    };

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
