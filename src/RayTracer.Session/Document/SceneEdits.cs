using System.Numerics;
using RayTracer.Scenes;
using Json = System.Text.Json.Nodes.JsonNode;

namespace RayTracer.Session;

/// <summary>
/// The edits of a scene's things: each is one edit of its text, and one step to undo (edits of one gesture are one step together).
/// </summary>
/// <param name="document">The document.</param>
/// <param name="selection">The selection: it follows things that are renamed.</param>
/// <param name="notices">Shows what else an edit has changed.</param>
/// <param name="view">Shows the things: new ones are put where one looks.</param>
public sealed class SceneEdits(SceneDocument document, Selection selection, NoticeBoard notices, PictureView view)
{
    // The name of the material that was used last.
    private string? _material;

    /// <summary>Writes a value.</summary>
    /// <param name="pointer">The place in the text.</param>
    /// <param name="value">The value; null is written as null.</param>
    /// <param name="gesture">Of which gesture it is a part.</param>
    /// <returns>The text's revision then, as with all edits.</returns>
    /// <exception cref="SessionException">It cannot be written there; so with all edits.</exception>
    public int Set(string pointer, Json? value, string? gesture = null)
    {
        int revision = document.Change(JsonPointer.Last(pointer), gesture, text => text.Set(pointer, value));
        _material = JsonPointer.Last(pointer) == "material" && value?.GetValueKind() == System.Text.Json.JsonValueKind.String ? value.GetValue<string>() : _material;
        return revision;
    }

    /// <summary>Writes a value as its text stands.</summary>
    public int SetText(string pointer, string json, string? gesture = null) =>
        document.Change(JsonPointer.Last(pointer), gesture, text => text.SetText(pointer, json));

    /// <summary>Takes a value out of the text, so that its default counts again.</summary>
    public int Reset(string pointer, string? gesture = null) =>
        document.Change(JsonPointer.Last(pointer), gesture, text => JsonPointer.Find(text.Root, pointer) is null ? text : text.Remove(pointer));

    /// <summary>
    /// Adds a new thing. A shape is put down on what is seen in the picture, of the material that was used last, or of a plain one.
    /// </summary>
    /// <param name="family">shape, light, material, texture or environment.</param>
    /// <param name="type">Its type.</param>
    /// <param name="file">The file that it names; null where it names none.</param>
    /// <param name="at">The pixel at which a shape or light is put; null for the middle of the picture.</param>
    /// <returns>The revision, and the new thing's pointer.</returns>
    public (int Revision, string Pointer) Add(string family, string type, string? file = null, Vector2? at = null)
    {
        PlaceInView? place = view.Shown is { } shown && family is "shape" or "light" ? PlaceInView.At(shown, at) : null;
        Surroundings where = new(place, _material, document.Place.Folder);
        (int revision, string pointer) = Pointed($"add {type}", text => SceneThings.Add(text, family, type, file, where));
        _material = family == "material" ? JsonPointer.Last(pointer) : _material;
        return (revision, pointer);
    }

    /// <summary>
    /// Gives things what has a name: a material, a texture as the colour of their material; or has a light shine on them. One step to undo.
    /// </summary>
    /// <param name="what">The material, texture or light.</param>
    /// <param name="things">The things.</param>
    public int Apply(string what, params IReadOnlyCollection<string> things) => things.Count == 0
        ? throw new SessionException("Select the things that it shall be applied to, too.")
        : Apply(what, [.. things.Select(thing => (thing, IsLight(what) ? TopOf(thing) : default))]);

    /// <summary>The same with the thing that is seen at a pixel.</summary>
    /// <param name="what">The material, texture or light.</param>
    /// <param name="at">The pixel.</param>
    public int Apply(string what, Vector2 at) => Picking.At(view.RequireShown(), at.X, at.Y) is { Pointer: { } thing } seen
        ? Apply(what, [(thing, (seen.Position!.Value, seen.Normal!.Value))])
        : throw new SessionException("There is nothing there that it could be applied to.", SessionFault.Missing);

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
        if (document.IsLocked(pointer))
        {
            throw new SessionException("It is locked: unlock it to move it.");
        }

        string[] all = [.. selection.With(pointer).Where(p => p == pointer || (SceneThings.IsSeen(p) && !document.IsLocked(p)))];
        int? frame = document.IsRecording ? document.Frame : null;
        return document.Change("place", gesture, text => all.Aggregate(text, (now, each) => Placed(now, each, change, frame)), isByHand: true);
    }

    private static bool IsLight(string pointer) => JsonPointer.Parse(pointer) is ["lights", _];

    private int Apply(string what, (string Thing, (Vector3 Point, Vector3 Up) On)[] things)
    {
        int revision = document.Change("apply", null, text => JsonPointer.Find(text.Root, what) is null
            ? throw new SessionException($"there is nothing at {JsonLayout.Quote(what)}")
            : things.Aggregate(text, (now, to) => Applied(now, what, to.Thing, to.On)));
        _material = JsonPointer.Parse(what) is ["materials", var name] ? name : _material;
        return revision;
    }

    private static JsonText Applied(JsonText text, string what, string thing, (Vector3 Point, Vector3 Up) on) => JsonPointer.Parse(what) switch
    {
        ["materials", var name] => Assignment.Material(text, thing, name),
        ["textures", var name] => Assignment.Texture(text, thing, name),
        _ when IsLight(what) => LightDrags.ShineOn(text, what, on),
        _ => throw new SessionException("Only materials, textures and lights can be applied to things."),
    };

    // Asked for before the text is changed: the view asks for the document, too.
    private (Vector3 Point, Vector3 Up) TopOf(string thing)
    {
        Gizmo box = Gizmo.Of(view.RequireShown(), thing);
        return (box.Center with { Y = box.Maximum.Y }, Vector3.UnitY);
    }

    private static JsonText Placed(JsonText text, string pointer, Placement change, int? frame)
    {
        // Of a motion, the keyframe there alone is changed.
        text = frame is { } key ? KeyList.WithKeyframe(text, pointer, key) : text;
        text = change.Scale is { } factors ? ShapePlacement.Scale(text, pointer, factors, change.Center, frame) : text;
        text = change.Rotate is { } turn ? ShapePlacement.Rotate(text, pointer, turn.Axis, turn.Degrees, turn.Center ?? change.Center, frame) : text;
        return change.Translate is { } by ? ShapePlacement.Translate(text, pointer, by, frame) : text;
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
