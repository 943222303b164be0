namespace RayTracer.Desktop.ViewModels;

/// <summary>The one stretch in which two texts differ.</summary>
/// <param name="From">Offset of the first character that goes.</param>
/// <param name="To">Offset behind the last one.</param>
/// <param name="Insert">What comes in their place.</param>
internal sealed record TextStretch(int From, int To, string Insert)
{
    /// <summary>The stretch between two texts; null where they are the same.</summary>
    public static TextStretch? Between(string before, string after)
    {
        if (before == after)
        {
            return null;
        }

        int start = before.AsSpan().CommonPrefixLength(after);
        int end = 0;
        while (end < Math.Min(before.Length, after.Length) - start && before[^(end + 1)] == after[^(end + 1)])
        {
            end++;
        }

        return new(start, before.Length - end, after[start..^end]);
    }

    /// <summary>The text after the change.</summary>
    public string Apply(string text) => $"{text.AsSpan(0, From)}{Insert}{text.AsSpan(To)}";

    /// <summary>The same change after another one of the same text; null where both are about the same characters.</summary>
    public TextStretch? After(TextStretch? other)
    {
        int shift = other is null ? 0 : other.Insert.Length - (other.To - other.From);
        return other is null || other.From >= To ? this
            : other.To <= From ? this with { From = From + shift, To = To + shift }
            : null;
    }
}
