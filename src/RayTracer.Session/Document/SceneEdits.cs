using System.Numerics;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Session;

/// <summary>
/// The edits of a scene's things: each is one edit of its text, and one step to undo (edits of one gesture are one step together).
/// </summary>
/// <param name="document">The document.</param>
/// <param name="selection">The selection: it follows things that are renamed.</param>
/// <param name="notices">Shows what else an edit has changed.</param>
public sealed class SceneEdits(SceneDocument document, Selection selection, NoticeBoard notices)
{
    /// <summary>Writes a value.</summary>
    /// <param name="pointer">The place in the text.</param>
    /// <param name="value">The value; null is written as null.</param>
    /// <param name="gesture">Of which gesture it is a part.</param>
    /// <returns>The text's revision then, as with all edits.</returns>
    /// <exception cref="SessionException">It cannot be written there; so with all edits.</exception>
    public int Set(string pointer, Json? value, string? gesture = null) =>
        document.Change(JsonPointer.Last(pointer), gesture, text => text.Set(pointer, value));

    /// <summary>Writes a value as its text stands.</summary>
    public int SetText(string pointer, string json, string? gesture = null) =>
        document.Change(JsonPointer.Last(pointer), gesture, text => text.SetText(pointer, json));

    /// <summary>Takes a value out of the text, so that its default counts again.</summary>
    public int Reset(string pointer, string? gesture = null) =>
        document.Change(JsonPointer.Last(pointer), gesture, text => JsonPointer.Find(text.Root, pointer) is null ? text : text.Remove(pointer));

    /// <summary>Adds a new thing.</summary>
    /// <param name="family">shape, light, material, texture or environment.</param>
    /// <param name="type">Its type.</param>
    /// <param name="near">The pointer of a thing that it is put beside; null for the middle of the picture.</param>
    /// <param name="file">The file that it names; null where it names none.</param>
    /// <returns>The revision, and the new thing's pointer.</returns>
    public (int Revision, string Pointer) Add(string family, string type, string? near = null, string? file = null) =>
        Pointed($"add {type}", text => SceneThings.Add(text, family, type, near, file));

    /// <summary>Makes copies of things.</summary>
    /// <returns>The revision, and the copies' pointers.</returns>
    public (int Revision, IReadOnlyList<string> Pointers) Duplicate(params string[] pointers)
    {
        string[] copies = [];
        int revision = document.Change("duplicate", null, text =>
        {
            copies = [];
            JsonText before = text;

            // From behind, so that the pointers of what is before stay true; those of the copies behind follow.
            foreach (string pointer in pointers.Distinct(StringComparer.Ordinal).OrderByDescending(p => before.At(p).Start).ToArray())
            {
                (text, string copy) = SceneThings.Duplicate(text, pointer);
                copies = [copy, .. copies.Select(c => JsonPointer.Of(AnimatedProperties.Shifted(JsonPointer.Parse(c), JsonPointer.Parse(copy), 1)))];
            }

            return text;
        });
        return (revision, copies);
    }

    /// <summary>Gives a thing another name; what refers to it follows.</summary>
    /// <returns>The revision, and the thing's pointer now.</returns>
    public (int Revision, string Pointer) Rename(string pointer, string name)
    {
        IReadOnlyList<string> selected = selection.All;
        (int Revision, string Pointer) renamed = Pointed("rename", text => SceneThings.Rename(text, pointer, name));
        selection.SelectAll([.. selected.Select(p => p == pointer ? renamed.Pointer : p)]);

        return renamed;
    }

    /// <summary>Takes things out of the scene.</summary>
    /// <returns>The revision, and what else has changed by that.</returns>
    public (int Revision, IReadOnlyList<string> Notes) Delete(params string[] pointers)
    {
        IReadOnlyList<string> notes = [];
        int revision = document.Change("delete", null, text =>
        {
            (text, notes) = SceneThings.Delete(text, pointers);
            return text;
        });

        // The pointers of what follows have changed; that of what a part was taken out of has not.
        if (selection.Pointer is not { } selected || !pointers.All(p => p != selected && Picking.IsWithin(p, selected)))
        {
            selection.Select(null);
        }

        if (notes.Count > 0)
        {
            notices.Post("info", string.Join("; ", notes));
        }

        return (revision, notes);
    }

    /// <summary>Scales, then turns, then moves a thing, and all others that are selected with it.</summary>
    public int Place(string pointer, Placement change, string? gesture = null)
    {
        string[] all = [.. selection.With(pointer).Where(p => p == pointer || SceneThings.IsSeen(p))];
        return document.Change("place", gesture, text => all.Aggregate(text, (now, each) => Placed(now, each, change)));
    }

    private static JsonText Placed(JsonText text, string pointer, Placement change)
    {
        text = change.Scale is { } factors ? ShapePlacement.Scale(text, pointer, factors, change.Center) : text;
        text = change.Rotate is { } turn ? ShapePlacement.Rotate(text, pointer, turn.Axis, turn.Degrees, turn.Center ?? change.Center) : text;
        return change.Translate is { } by ? ShapePlacement.Translate(text, pointer, by) : text;
    }

    private (int Revision, string Pointer) Pointed(string label, Func<JsonText, (JsonText, string)> change)
    {
        string pointer = "";
        int revision = document.Change(label, null, text =>
        {
            (text, pointer) = change(text);
            return text;
        });
        return (revision, pointer);
    }
}

/// <summary>The movement of a thing; what is null stays.</summary>
/// <param name="Translate">By how much it is moved.</param>
/// <param name="Rotate">The rotation.</param>
/// <param name="Scale">By which factors it grows.</param>
/// <param name="Center">The point that scaling and turning leave where it is; null for the thing's own.</param>
public sealed record Placement(Vector3? Translate = null, Turn? Rotate = null, Vector3? Scale = null, Vector3? Center = null);

/// <summary>A turn about an axis.</summary>
/// <param name="Axis">The axis.</param>
/// <param name="Degrees">The angle, counter-clockwise seen against the axis.</param>
/// <param name="Center">A point on the axis; null for the thing's own.</param>
public sealed record Turn(Vector3 Axis, float Degrees, Vector3? Center = null);
