using System.Globalization;
using RayTracer.Textbook;

namespace RayTracer.Labs;

/// <summary>What a function returned: some numbers; null for nothing.</summary>
public sealed class Answer
{
    private readonly double[] _numbers;

    private Answer(params double[] numbers) => _numbers = numbers;

    /// <summary>A number.</summary>
    public static implicit operator Answer(double number) => new(number);

    /// <summary>A number or nothing.</summary>
    public static implicit operator Answer?(double? number) => number is { } there ? new(there) : null;

    /// <summary>Two numbers.</summary>
    public static implicit operator Answer((double X, double Y) pair) => new(pair.X, pair.Y);

    /// <summary>Two numbers, or nothing.</summary>
    public static implicit operator Answer?((double X, double Y)? pair) => pair is { } there ? there : null;

    /// <summary>A point or direction.</summary>
    public static implicit operator Answer(Vector vector) => new(vector.X, vector.Y, vector.Z);

    /// <summary>A point or direction, or nothing.</summary>
    public static implicit operator Answer?(Vector? vector) => vector is { } there ? there : null;

    /// <summary>A ray: its origin and its direction.</summary>
    public static implicit operator Answer(Ray ray) =>
        new(ray.Origin.X, ray.Origin.Y, ray.Origin.Z, ray.Direction.X, ray.Direction.Y, ray.Direction.Z);

    /// <summary>A colour.</summary>
    public static implicit operator Answer(Rgb color) => new(color.R, color.G, color.B);

    /// <summary>Returns whether two answers are the same but for rounding.</summary>
    /// <param name="one">One; null for nothing.</param>
    /// <param name="other">The other one.</param>
    /// <param name="tolerance">The largest difference of two numbers, as a share of the larger one or of 1.</param>
    public static bool AreNear(Answer? one, Answer? other, double tolerance)
    {
        if (one is null || other is null)
        {
            return one == other;
        }

        // Infinities are equal to themselves; what is not a number is near to nothing.
        return one._numbers.Length == other._numbers.Length && one._numbers.Zip(other._numbers).All(
            p => p.First == p.Second || Math.Abs(p.First - p.Second) <= tolerance * Math.Max(1, Math.Max(Math.Abs(p.First), Math.Abs(p.Second))));
    }

    /// <summary>The numbers with six digits, or "nothing".</summary>
    public static string Text(Answer? answer) => answer?._numbers switch
    {
        null => "nothing",
        [double one] => Text(one),
        { Length: 6 } ray => $"from {Text(ray[..3])} along {Text(ray[3..])}",
        var numbers => Text(numbers),
    };

    /// <summary>A number, or a list of numbers, as JSON has them.</summary>
    internal string Json => _numbers is [double one] ? Exact(one) : $"[{string.Join(", ", _numbers.Select(Exact))}]";

    /// <summary>A number with six digits.</summary>
    internal static string Text(double number) => number.ToString("G6", CultureInfo.InvariantCulture);

    private static string Exact(double number) => number.ToString("R", CultureInfo.InvariantCulture);

    /// <summary>Numbers in parentheses.</summary>
    internal static string Text(IEnumerable<double> numbers) => $"({string.Join(", ", numbers.Select(Text))})";
}
