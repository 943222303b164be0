namespace RayTracer.Session;

/// <summary>A change of a text.</summary>
/// <param name="Offset">The offset in the text.</param>
/// <param name="Removed">The text before.</param>
/// <param name="Inserted">The text that replaces it.</param>
public readonly record struct TextChange(int Offset, string Removed, string Inserted)
{
    /// <summary>The change that undoes this one.</summary>
    public TextChange Inverse => new(Offset, Inserted, Removed);

    /// <summary>The smallest change that makes one text of another.</summary>
    public static TextChange Between(string before, string after)
    {
        int start = before.AsSpan().CommonPrefixLength(after);
        int shared = Math.Min(before.Length, after.Length) - start;
        int tail = 0;
        while (tail < shared && before[^(tail + 1)] == after[^(tail + 1)])
        {
            tail++;
        }

        return new(start, before[start..^tail], after[start..^tail]);
    }

    /// <summary>The text after the change.</summary>
    public string Apply(string text) => string.Concat(text.AsSpan(0, Offset), Inserted, text.AsSpan(Offset + Removed.Length));

    /// <summary>This change and then another one, as a single change.</summary>
    /// <param name="next">The change that follows.</param>
    /// <param name="between">The text after this change and before the next.</param>
    public TextChange Then(TextChange next, string between)
    {
        // In the text between: the stretch that both together touch.
        int from = Math.Min(Offset, next.Offset);
        int to = Math.Max(Offset + Inserted.Length, next.Offset + next.Removed.Length);
        string before = string.Concat(between.AsSpan(from, Offset - from), Removed, between.AsSpan(Offset + Inserted.Length, to - Offset - Inserted.Length));
        string after = string.Concat(
            between.AsSpan(from, next.Offset - from), next.Inserted, between.AsSpan(next.Offset + next.Removed.Length, to - next.Offset - next.Removed.Length));
        return new(from, before, after);
    }
}
