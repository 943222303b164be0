using System.Globalization;
using System.Xml.Linq;

namespace RayTracer.Labs;

/// <summary>Something that must be true of a class, and whether it is.</summary>
/// <param name="Name">The fact in a few words, always the same: "directions follow the pdf".</param>
/// <param name="Holds">True where it is true.</param>
/// <param name="Sentence">What was found, to the person who wrote the class.</param>
public sealed record Fact(string Name, bool Holds, string Sentence)
{
    /// <summary>The simplest case in which it is not true, in words; empty where it holds.</summary>
    public string Case { get; init; } = "";

    /// <summary>What was expected there; not a number where that is none.</summary>
    public double Expected { get; init; } = double.NaN;

    /// <summary>What was found there; not a number where that is none.</summary>
    public double Found { get; init; } = double.NaN;

    /// <summary>A drawing (SVG) of what differs; null where there is nothing to draw.</summary>
    public XDocument? Drawing { get; init; }

    /// <summary>The fact and the case in which it does not hold, on one line.</summary>
    public override string ToString() => Holds ? $"{Name}: it holds" : $"{Name}: {Case}: {Sentence}";

    /// <summary>Checks a fact case by case, the simplest first, and stops at the first that does not hold.</summary>
    /// <typeparam name="T">What a case is.</typeparam>
    /// <param name="name">The name of the fact.</param>
    /// <param name="good">The sentence where it holds in all cases.</param>
    /// <param name="cases">The cases.</param>
    /// <param name="check">Returns what is wrong in a case; null where nothing is.</param>
    /// <returns>The fact. It does not hold where the class throws.</returns>
    internal static Fact Of<T>(string name, string good, IEnumerable<T> cases, Func<T, Fact?> check)
    {
        T? last = default;
        try
        {
            foreach (T one in cases)
            {
                last = one;
                if (check(one) is { } wrong)
                {
                    return wrong with { Name = name, Case = wrong.Case.Length > 0 ? wrong.Case : $"{one}" };
                }
            }

            return new(name, true, good);
        }
        catch (Exception e) when (e is not OutOfMemoryException)
        {
            return new(name, false, $"Your class threw {e.GetType().Name}: {e.Message.ReplaceLineEndings(" ").TrimEnd('.')}.") { Case = $"{last}" };
        }
    }

    /// <summary>What is wrong, with what was expected and found.</summary>
    internal static Fact Wrong(string sentence, double expected = double.NaN, double found = double.NaN, string at = "") =>
        new("", false, sentence) { Expected = expected, Found = found, Case = at };

    /// <summary>A number with four digits, the same in all languages.</summary>
    internal static string Text(double value) => value.ToString("G4", CultureInfo.InvariantCulture);
}
