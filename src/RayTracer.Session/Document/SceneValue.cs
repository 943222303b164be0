using System.Globalization;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>
/// A place in a scene's text, and what the scene format says may stand there. Something may be missing there, or stand there wrongly.
/// </summary>
/// <param name="Pointer">The place.</param>
/// <param name="Node">The node at that place; null where there is none.</param>
/// <param name="Parameter">The parameter that it is, or that it is an element of; null for the whole scene.</param>
/// <param name="Family">The family: shape, material or texture; null where it is none.</param>
/// <param name="Type">The type of the record: of a member of a family, by its "type"; null where it is none or it is unknown.</param>
/// <param name="IsList">True if it holds several: elements of a list, or members by name.</param>
public sealed record SceneValue(string Pointer, JsonNode? Node, RecordParameter? Parameter, TypeFamily? Family, RecordType? Type, bool IsList)
{
    /// <summary>The last step of the pointer.</summary>
    public string Key => JsonPointer.Last(Pointer);

    /// <summary>The name by which this refers to a thing that is defined elsewhere; null where it does not.</summary>
    public string? Reference =>
        Family is not null && Node is { Kind: JsonKind.String } name && !(Family == SceneTypes.Textures && (name.Text.StartsWith('#') || CssColors.Find(name.Text) is not null))
            ? name.Text : null;

    /// <summary>The whole scene.</summary>
    public static SceneValue Scene(JsonNode root) => new("", root, null, null, SceneTypes.Scene, false);

    /// <summary>The place of a pointer; null where the format has none.</summary>
    public static SceneValue? At(JsonNode root, string pointer)
    {
        SceneValue? value = Scene(root);
        foreach (string step in JsonPointer.Parse(pointer))
        {
            value = value?.Child(step);
        }

        return value;
    }

    /// <summary>The member under which things of a family are defined by name.</summary>
    public static string Definitions(TypeFamily family) => family == SceneTypes.Shapes ? "objects" : family.Noun + "s";

    /// <summary>A place one step within; null where the format has none.</summary>
    public SceneValue? Child(string step)
    {
        string pointer = JsonPointer.Append(Pointer, step);
        JsonNode? node = Node is null ? null : JsonPointer.Step(Node, step);
        if (IsList)
        {
            return Part(pointer, node, Parameter!);
        }

        return Type?.Find(step) is not { } parameter ? null
            : parameter.HoldsRecords && !(parameter is { IsList: true, RecordType: not null } && node?.Kind == JsonKind.Object) ? new(pointer, node, parameter, null, null, true)
            : Part(pointer, node, parameter);
    }

    /// <summary>All that stands one step within.</summary>
    public IEnumerable<SceneValue> Children() => (Node?.Kind == JsonKind.Array
            ? Node.Items.Select((_, i) => i.ToString(CultureInfo.InvariantCulture))
            : Node?.Members.Select(m => m.Key).Distinct(StringComparer.Ordinal) ?? [])
        .Select(Child).OfType<SceneValue>();

    /// <summary>This and all that stands within it, outer things first.</summary>
    public IEnumerable<SceneValue> WithInner() => Children().SelectMany(c => c.WithInner()).Prepend(this);

    /// <summary>The definition, where this is a reference to one; itself otherwise.</summary>
    /// <param name="root">The whole text.</param>
    public SceneValue Resolved(JsonNode root)
    {
        SceneValue value = this;
        for (int i = 0; i < 16 && value.Reference is { } name; i++)
        {
            if (At(root, JsonPointer.Of(Definitions(value.Family!), name)) is not { Node: not null } definition)
            {
                return value;
            }

            value = definition;
        }

        return value;
    }

    /// <summary>Three numbers of a parameter of this record, or its default.</summary>
    public Vector3 Vector(string key) =>
        Child(key) is { } child ? (child.Written ?? child.Parameter!.Default) as Vector3? ?? default : default;

    /// <summary>A number of a parameter of this record, or its default.</summary>
    public float Number(string key) =>
        Child(key) is { } child ? Convert.ToSingle(child.Written ?? child.Parameter!.Default, CultureInfo.InvariantCulture) : 0;

    /// <summary>A record of this type with the numbers and choices that are written here; what cannot be read keeps its default.</summary>
    public object Record()
    {
        object record = Type!.Create();
        foreach (RecordParameter parameter in Type.Parameters)
        {
            if (Child(parameter.Key)!.Written is { } value)
            {
                parameter.Set(record, value);
            }
        }

        return record;
    }

    private object? Written => Node is null ? null : ParameterForm.Of(Parameter!).Parse(Parameter!, Node);

    // What a parameter is, or consists of.
    private static SceneValue Part(string pointer, JsonNode? node, RecordParameter parameter)
    {
        RecordType? type = parameter.Family is not { } family ? parameter.RecordType is { } record ? RecordType.Of(record) : null
            : node?.Find("type") is { Kind: JsonKind.String } named ? family.Find(named.Text) : null;
        return new(pointer, node, parameter, parameter.Family, type, false);
    }
}
