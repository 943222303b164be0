using System.Globalization;
using System.Numerics;
using System.Text.Json.Nodes;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;
using JsonNode = RayTracer.Scenes.JsonNode;

namespace RayTracer.Session;

/// <summary>Adds, copies, deletes and renames the things of a scene, with all that refers to them.</summary>
public static class SceneThings
{
    private static readonly string[] Lists = ["shapes", "lights", "materials", "textures", "objects"];

    /// <summary>
    /// Returns whether a pointer is that of something that can be copied, deleted or renamed: a member of a list, or what has a name.
    /// </summary>
    public static bool IsThing(string pointer) => JsonPointer.Parse(pointer) is [var list, _, ..] && Lists.Contains(list);

    /// <summary>Returns whether a pointer is that of something that may be seen in the picture, and moved and turned there.</summary>
    public static bool IsSeen(string pointer) => JsonPointer.Parse(pointer) is ["shapes" or "lights", _, ..];

    /// <summary>Adds a thing.</summary>
    /// <param name="text">The text.</param>
    /// <param name="family">shape, light, material, texture or environment.</param>
    /// <param name="type">Its type.</param>
    /// <param name="file">The file of a model or picture; null where there is none.</param>
    /// <returns>The text, and the thing's pointer.</returns>
    /// <exception cref="SessionException">There is no such type, or it lacks something.</exception>
    public static (JsonText Text, string Pointer) Add(JsonText text, string family, string type, string? file = null) => Add(text, family, type, file, new(null, null, ""));

    /// <summary>Adds a thing to a picture.</summary>
    /// <param name="text">The text.</param>
    /// <param name="family">shape, light, material, texture or environment.</param>
    /// <param name="type">Its type.</param>
    /// <param name="file">The file of a model or picture; null where there is none.</param>
    /// <param name="where">Where shapes are put, and what they are made of.</param>
    internal static (JsonText Text, string Pointer) Add(JsonText text, string family, string type, string? file, Surroundings where)
    {
        bool isLight = family == "light";
        TypeFamily kind = SceneTypes.Families.FirstOrDefault(f => f.Noun == (isLight ? "shape" : family))
            ?? throw new SessionException($"there is no family {JsonLayout.Quote(family)}: expected shape, light, material, texture or environment");
        RecordType record = kind.Find(type) ?? throw new SessionException($"there is no {kind.Noun} of type {JsonLayout.Quote(type)}");
        if (kind == SceneTypes.Environments)
        {
            text = text.Root.Find("background") is null ? text : text.Remove("/background");
            return (text.Set("/environment", NewThing.Plain(record, file)), "/environment");
        }

        if (kind != SceneTypes.Shapes)
        {
            string pointer = JsonPointer.Of(SceneValue.Definitions(kind), FreeName(text.Root, kind, type));
            return (text.Set(pointer, NewThing.Plain(record, file)), pointer);
        }

        SketchView view = (where.Place?.View ?? NewThing.View(text.Root)) with { Shines = isLight, File = file };
        string? objectName = text.Root.Find("objects")?.Members.Select(m => m.Key).FirstOrDefault();
        JsonObject shape = NewThing.Shape(record, view, objectName);
        if (!isLight && NewThing.NeedsMaterial(record))
        {
            (text, string material) = MaterialFor(text, where.Material);
            shape["material"] = material;
        }

        string list = isLight ? "/lights" : "/shapes";
        text = text.Set($"{list}/-", shape);
        string added = JsonEdit.LastOf(text, list);
        return (where.Place is { } place && !record.IsLight ? (place with { View = view }).PutDown(text, added, where.Folder) : text, added);
    }

    /// <summary>Copies a thing: a shape to beside it, a definition under another name.</summary>
    /// <returns>The text, and the copy's pointer.</returns>
    /// <exception cref="SessionException">There is no such thing.</exception>
    public static (JsonText Text, string Pointer) Duplicate(JsonText text, string pointer)
    {
        SceneValue thing = SceneValue.At(text.Root, pointer) is { Node: not null, Family: not null } found
            ? found : throw new SessionException($"there is no shape, material or texture at {JsonLayout.Quote(pointer)}");
        if (SceneReferences.DefinedAt(pointer) is { } family)
        {
            return text.Duplicate(pointer, FreeName(text.Root, family, thing.Key));
        }

        JsonText before = text;
        (text, string copy) = text.Duplicate(pointer);
        text = AnimatedProperties.Inserted(before, text, copy);
        if (thing.Node!.Find("name") is { Kind: JsonKind.String, Text.Length: > 0 } name)
        {
            HashSet<string> taken = [.. Shapes(text.Root).Select(s => s.Node?.Find("name")?.Text).OfType<string>()];
            text = text.Set(copy + "/name", JsonValue.Create(Unlike(name.Text, taken)));
        }

        if (thing.Family == SceneTypes.Shapes && thing.Type is not null)
        {
            SketchView view = NewThing.View(text.Root);
            text = ShapePlacement.Translate(text, copy, view.Right * view.Size);
        }

        return (text, copy);
    }

    /// <summary>
    /// Deletes things. What refers to a material or texture that is deleted gets the default; instances of a deleted object go with it.
    /// </summary>
    /// <returns>The text, and what else has changed, one sentence each.</returns>
    /// <exception cref="SessionException">There is no such thing, or it cannot be missing.</exception>
    public static (JsonText Text, IReadOnlyList<string> Notes) Delete(JsonText text, IReadOnlyCollection<string> pointers)
    {
        List<string> notes = [];

        // From behind, so that the pointers of what is before stay true; definitions last, because they take others with them.
        foreach (string pointer in pointers.Distinct(StringComparer.Ordinal).OrderBy(p => SceneReferences.DefinedAt(p) is not null).ThenByDescending(p => text.At(p).Start).ToArray())
        {
            text = Delete(text, pointer, notes);
        }

        return (text, notes);
    }

    /// <summary>Gives a thing another name: a definition with all that refers to it, a shape by its "name".</summary>
    /// <returns>The text, and the thing's pointer now.</returns>
    /// <exception cref="SessionException">There is no such thing, or the name is taken.</exception>
    public static (JsonText Text, string Pointer) Rename(JsonText text, string pointer, string name)
    {
        SceneValue thing = SceneValue.At(text.Root, pointer) is { Node: not null, Family: not null } found
            ? found : throw new SessionException($"nothing at {JsonLayout.Quote(pointer)} can have a name");
        if (SceneReferences.DefinedAt(pointer) is not { } family)
        {
            return thing.Family != SceneTypes.Shapes ? throw new SessionException("only shapes and what is defined by name can have a name")
                : (AnimatedProperties.Renamed(text, WithName(text, pointer, name), pointer, pointer), pointer);
        }

        if (name.Length == 0)
        {
            throw new SessionException("a name needs at least one character");
        }

        if (family == SceneTypes.Textures && (name.StartsWith('#') || CssColors.Find(name) is not null))
        {
            throw new SessionException($"a texture cannot be called {JsonLayout.Quote(name)}, because that is a colour");
        }

        SceneValue[] references = [.. SceneReferences.To(text.Root, family, thing.Key)];
        string renamed = JsonPointer.Append(JsonPointer.Parent(pointer)!, name);
        JsonText changed = text.With(references.Select(r => new TextEdit(r.Node!.Start, r.Node.End, JsonLayout.Quote(name)))).Rename(pointer, name);
        return (AnimatedProperties.Renamed(text, changed, pointer, renamed), renamed);
    }

    private static JsonText WithName(JsonText text, string pointer, string name) =>
        name.Length > 0 ? text.Set(pointer + "/name", JsonValue.Create(name)) : text.At(pointer).Find("name") is null ? text : text.Remove(pointer + "/name");

    private static JsonText Delete(JsonText text, string pointer, List<string> notes)
    {
        if (SceneValue.At(text.Root, pointer) is { Parameter.Required: true } needed && needed.Key == needed.Parameter.Key)
        {
            throw new SessionException($"{JsonLayout.Quote(needed.Parameter.Key)} is required");
        }

        if (SceneReferences.DefinedAt(pointer) is not { } family)
        {
            return AnimatedProperties.Remove(text, pointer);
        }

        string name = JsonPointer.Last(pointer);
        int count = 0;
        while (SceneReferences.To(text.Root, family, name).LastOrDefault(r => !Within(r.Pointer, pointer)) is { } reference)
        {
            text = Forget(text, reference);
            count++;
        }

        if (count > 0)
        {
            string what = family == SceneTypes.Shapes ? "instance was deleted with it" : "reference to it became the default";
            string many = family == SceneTypes.Shapes ? "instances were deleted with it" : "references to it became the default";
            notes.Add(string.Create(CultureInfo.InvariantCulture, $"deleted the {(family == SceneTypes.Shapes ? "object" : family.Noun)} {JsonLayout.Quote(name)}: {count} {(count == 1 ? what : many)}"));
        }

        return AnimatedProperties.Remove(text, pointer);
    }

    // A reference to what is no more.
    private static JsonText Forget(JsonText text, SceneValue reference)
    {
        string parent = JsonPointer.Parent(reference.Pointer)!;
        bool isMember = reference.Key == reference.Parameter!.Key && SceneValue.At(text.Root, parent) is { IsList: false };
        if (reference.Family == SceneTypes.Shapes)
        {
            return isMember ? Delete(text, parent, []) : AnimatedProperties.Remove(text, reference.Pointer);
        }

        return isMember && !reference.Parameter.Required ? AnimatedProperties.Remove(text, reference.Pointer)
            : text.Set(reference.Pointer, reference.Family == SceneTypes.Materials ? new JsonObject { ["type"] = "diffuse" } : new JsonArray(0.5, 0.5, 0.5));
    }

    private static bool Within(string pointer, string outer) =>
        pointer == outer || pointer.StartsWith(outer + "/", StringComparison.Ordinal);

    private static IEnumerable<SceneValue> Shapes(JsonNode root) =>
        SceneValue.Scene(root).WithInner().Where(v => v is { Family.Noun: "shape", Node.Kind: JsonKind.Object });

    // The material that was used last, or a plain one, which the scene may have already.
    private static (JsonText Text, string Name) MaterialFor(JsonText text, string? last)
    {
        string? TypeOf(string name) => SceneValue.At(text.Root, JsonPointer.Of("materials", name)) is { Node: not null } found ? found.Resolved(text.Root).Type?.Name : null;
        if (last is not null && TypeOf(last) is not (null or "luminaire"))
        {
            return (text, last);
        }

        const string plain = "matt";
        if (TypeOf(plain) == "diffuse")
        {
            return (text, plain);
        }

        string name = FreeName(text.Root, SceneTypes.Materials, plain);
        return (text.Set(JsonPointer.Of("materials", name), NewThing.Plain(SceneTypes.Materials.Find("diffuse")!, null)), name);
    }

    private static string FreeName(JsonNode root, TypeFamily family, string name)
    {
        HashSet<string> taken = [.. root.Find(SceneValue.Definitions(family))?.Members.Select(m => m.Key) ?? []];
        return taken.Contains(name) ? Unlike(name, taken) : name;
    }

    // "glass", "glass 2", "glass 3" …
    private static string Unlike(string name, HashSet<string> taken)
    {
        string stem = name.TrimEnd("0123456789".ToCharArray()).TrimEnd();
        stem = stem.Length == 0 || !name[stem.Length..].StartsWith(' ') ? name : stem;
        for (int i = 2; ; i++)
        {
            string candidate = string.Create(CultureInfo.InvariantCulture, $"{stem} {i}");
            if (!taken.Contains(candidate))
            {
                return candidate;
            }
        }
    }
}

/// <summary>Where new shapes are put, and what they are made of.</summary>
/// <param name="Place">The place in the picture; null for what the camera in the text looks at.</param>
/// <param name="Material">The name of the material that was used last; null where none was.</param>
/// <param name="Folder">The folder from which files are looked for.</param>
internal sealed record Surroundings(PlaceInView? Place, string? Material, string Folder);
