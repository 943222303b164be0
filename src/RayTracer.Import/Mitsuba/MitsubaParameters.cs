using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>The parameters of a scene (<c>default</c>), whose values stand for <c>$name</c> in attributes.</summary>
internal sealed class MitsubaParameters(ImportLog log)
{
    // With values that name parameters, a few lines could make a text without end.
    private const int LongestValue = 1 << 20;

    private readonly SortedDictionary<string, string> _values = new(ImportSettings.Parameters.ToDictionary(), Comparer<string>.Create(LongestFirst));
    private readonly HashSet<string> _used = new(StringComparer.Ordinal);

    /// <summary>Gives a parameter a value, unless it has one.</summary>
    public void SetDefault(string name, string value) => _values.TryAdd(name, value);

    /// <summary>Reports parameters that were given from outside and stand nowhere in the scene.</summary>
    /// <param name="scene">The place of the scene.</param>
    public void Finish(SourcePlace scene)
    {
        foreach (string name in ImportSettings.Parameters.Keys.Where(n => !_used.Contains(n)))
        {
            log.Error(scene, $"the parameter {Quotation.Of(name)} is given a value, but ${name} stands nowhere{Spelling.DidYouMean(name, [.. _used, .. _values.Keys.Where(k => k != name)])}");
        }
    }

    /// <summary>The element with values in place of names; those within it stay as they are.</summary>
    public MitsubaElement Substitute(MitsubaElement element)
    {
        if (!element.Attributes.Values.Any(a => a.Value.Contains('$', StringComparison.Ordinal)))
        {
            return element;
        }

        MitsubaElement substituted = new(element.Name, element.Place) { Children = element.Children };
        foreach ((string name, MitsubaAttribute attribute) in element.Attributes)
        {
            substituted.Attributes[name] = attribute with { Value = Substitute(attribute) };
        }

        return substituted;
    }

    // Where a name begins with another one, the longer one is meant.
    private static int LongestFirst(string? a, string? b) =>
        a!.Length != b!.Length ? b.Length.CompareTo(a.Length) : string.CompareOrdinal(a, b);

    private string Substitute(MitsubaAttribute attribute)
    {
        string text = attribute.Value;
        for (int at = text.IndexOf('$', StringComparison.Ordinal); at >= 0; at = text.IndexOf('$', at))
        {
            string? name = _values.Keys.FirstOrDefault(n => string.CompareOrdinal(text, at + 1, n, 0, n.Length) == 0);
            if (name is null)
            {
                string word = new([.. text[(at + 1)..].TakeWhile(c => char.IsLetterOrDigit(c) || c is '_' or '.')]);
                log.Unknown(attribute.Place, $"there is no parameter {Quotation.Of("$" + word)} (a <default> would define one)", word, _values.Keys);
                return text;
            }

            _used.Add(name);
            string value = _values[name];
            if (text.Length + value.Length > LongestValue)
            {
                log.Error(attribute.Place, "with its parameters filled in, this attribute is too long");
                return "";
            }

            text = string.Concat(text.AsSpan(0, at), value, text.AsSpan(at + 1 + name.Length));
            at += value.Length;
        }

        return text;
    }
}
