using System.Collections.Immutable;
using System.Globalization;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>
/// Things of a document that are marked, as hidden or locked. The text knows nothing of it: after a change of the text, a thing is the one that is written as
/// before, in its list or elsewhere, or else the one at its place, if no other has come into its list or gone.
/// </summary>
internal sealed class ThingMarks
{
    /// <summary>No marks.</summary>
    public static readonly ThingMarks None = new([]);

    private readonly ImmutableArray<Mark> _marks;

    private ThingMarks(ImmutableArray<Mark> marks)
    {
        _marks = marks;
        Pointers = [.. marks.Select(m => m.Pointer)];
    }

    /// <summary>The pointers of the marked things.</summary>
    public IReadOnlyList<string> Pointers { get; }

    /// <summary>Returns whether a thing is marked, or one that it is a part of.</summary>
    public bool Has(string? pointer) => Pointers.Any(p => Picking.IsWithin(pointer, p));

    /// <summary>With more marks, or fewer.</summary>
    /// <param name="text">The text.</param>
    /// <param name="pointers">The things.</param>
    /// <param name="areMarked">Whether they shall be marked.</param>
    /// <exception cref="SessionException">There is no such thing, or it is never seen.</exception>
    public ThingMarks With(JsonText text, IEnumerable<string> pointers, bool areMarked)
    {
        string[] wanted = [.. pointers.Distinct(StringComparer.Ordinal)];
        if (Array.Find(wanted, p => !SceneThings.IsSeen(p) || JsonPointer.Find(text.Root, p) is null || SceneValue.At(text.Root, p) is not { Family.Noun: "shape" }) is { } wrong)
        {
            throw new SessionException($"There is nothing at {JsonLayout.Quote(wrong)} that is seen in the picture.");
        }

        ImmutableArray<Mark> others = [.. _marks.Where(m => !wanted.Contains(m.Pointer))];
        return new(areMarked ? others.AddRange(wanted.Select(p => Mark.Of(text, p))) : others);
    }

    /// <summary>The marks in a text that was changed.</summary>
    public ThingMarks In(JsonText text)
    {
        if (_marks.IsEmpty)
        {
            return this;
        }

        HashSet<string> taken = [];
        List<Mark> found = [];
        foreach (Mark mark in _marks)
        {
            if (mark.PlaceIn(text, taken) is { } pointer && taken.Add(pointer))
            {
                found.Add(Mark.Of(text, pointer));
            }
        }

        return new([.. found]);
    }

    // What is written of a thing, and how many things are in its list.
    private sealed record Mark(string Pointer, string Written, int Count)
    {
        public static Mark Of(JsonText text, string pointer)
        {
            JsonNode node = text.At(pointer);
            return new(pointer, text.Text[node.Start..node.End], Siblings(text, pointer));
        }

        public string? PlaceIn(JsonText text, HashSet<string> taken)
        {
            if (IsAt(text, Pointer))
            {
                return Pointer;
            }

            string? moved = Things(text.Root).FirstOrDefault(p => !taken.Contains(p) && IsAt(text, p));
            return moved ?? (JsonPointer.Find(text.Root, Pointer) is not null && Siblings(text, Pointer) == Count ? Pointer : null);
        }

        private bool IsAt(JsonText text, string pointer) => JsonPointer.Find(text.Root, pointer) is { } node
            && node.End - node.Start == Written.Length && text.Text.AsSpan(node.Start, Written.Length).SequenceEqual(Written);

        private static int Siblings(JsonText text, string pointer) => JsonPointer.Find(text.Root, JsonPointer.Parent(pointer)!)?.Items.Count ?? 0;

        private static IEnumerable<string> Things(JsonNode root) => ((string[])["shapes", "lights"]).SelectMany(list => Within(root, "", list));

        private static IEnumerable<string> Within(JsonNode node, string pointer, string list) => node.Find(list) is not { Kind: JsonKind.Array } all ? []
            : all.Items.SelectMany((item, i) =>
            {
                string at = string.Create(CultureInfo.InvariantCulture, $"{pointer}/{list}/{i}");
                return Within(item, at, "shapes").Prepend(at);
            });
    }
}
