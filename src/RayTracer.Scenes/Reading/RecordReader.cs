using System.Collections;
using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>Turns the values of a scene file into description records, by reflection over their parameters and the <see cref="ParameterForm"/> of each.</summary>
public sealed class RecordReader
{
    /// <summary>The maximum depth of nested textures, materials and shapes. Each level may double the work of shading a point.</summary>
    internal const int MaximumNesting = 16;

    private readonly DiagnosticBag _bag;
    private readonly SourceMap _map;
    private readonly NamedThings<TextureDescription> _textures;
    private readonly NamedThings<MaterialDescription> _materials;
    private readonly NamedThings<ShapeDescription> _objects;
    private int _nesting;

    private RecordReader(DiagnosticBag bag, SourceMap map, JsonNode root)
    {
        _bag = bag;
        _map = map;
        Numbers = new(bag);
        _textures = new("texture", bag, root.Find("textures"), NamedTexture);
        _materials = new("material", bag, root.Find("materials"), m => (MaterialDescription?)Thing(SceneTypes.Materials, m.Key, m.Value));
        _objects = new("object", bag, root.Find("objects"), m => (ShapeDescription?)Thing(SceneTypes.Shapes, m.Key, m.Value));
    }

    internal NumberReader Numbers { get; }

    /// <summary>Reads a scene. Values with errors keep their defaults, and their records are marked as incomplete.</summary>
    internal static SceneDescription? ReadScene(JsonNode root, DiagnosticBag bag, SourceMap map)
    {
        if (root.Kind != JsonKind.Object)
        {
            return bag.Expected<SceneDescription>(root, "a scene { … }", "");
        }

        RecordReader reader = new(bag, map, root);
        var scene = (SceneDescription)reader.Record(root, SceneTypes.Scene);
        new TrackChecker(root, bag, map, (parameter, node) => ParameterForm.Of(parameter).Read(reader, parameter, node)).Check(scene.Animation);
        return scene;
    }

    private object Record(JsonNode node, RecordType type)
    {
        object record = type.Create();
        _map.Add(record, node);
        foreach (JsonMember member in node.Members)
        {
            RecordParameter? parameter = type.Find(member.Key);
            if (parameter is not null && ParameterForm.Of(parameter).Read(this, parameter, member.Value) is { } value)
            {
                parameter.Set(record, value);
            }
            else if (!type.IsExtra(member.Key))
            {
                _map.MarkIncomplete(record);
                if (parameter is null)
                {
                    _bag.Error(member.Start, type.Refusal(member.Key, _bag.GivesHints), DiagnosticRule.UnknownWord);
                }
            }
        }

        foreach (RecordParameter missing in type.Parameters.Where(p => p.Required && node.Find(p.Key) is null))
        {
            _bag.Error(node, $"{type.NameInMessages} needs {Quotation.Of(missing.Key)}", DiagnosticRule.Missing);
            _map.MarkIncomplete(record);
        }

        return record;
    }

    /// <summary>Reports a value that is of another kind.</summary>
    /// <param name="node">The value.</param>
    /// <param name="kind">The kind that it should be of.</param>
    /// <param name="expected">The same in words, for the message.</param>
    /// <param name="key">The key that the value stands under.</param>
    /// <returns>True where it is of that kind.</returns>
    public bool Is(JsonNode node, JsonKind kind, string expected, string key) => node.Kind == kind || _bag.Expected<bool>(node, expected, key);

    /// <summary>Reports what else is wrong with a value.</summary>
    public void Error(JsonNode node, string message) => Error(node, message, null);

    internal void Error(JsonNode node, string message, DiagnosticRule? rule) => _bag.Error(node, message, rule);

    internal object? Unknown(JsonNode word, string message, IEnumerable<string> known, string listTitle = "") =>
        _bag.Unknown<object>(word, message, known, listTitle);

    // A list of those elements that could be read.
    internal IList? List(Type element, string key, JsonNode node, string things, Func<JsonNode, object?> read)
    {
        if (!Is(node, JsonKind.Array, $"a list [ … ] of {things}", key))
        {
            return null;
        }

        return List(element, node.Items, read);
    }

    internal static IList List(Type element, IEnumerable<JsonNode> nodes, Func<JsonNode, object?> read)
    {
        var list = (IList)Activator.CreateInstance(typeof(List<>).MakeGenericType(element))!;
        foreach (object item in nodes.Select(read).OfType<object>())
        {
            list.Add(item);
        }

        return list;
    }

    internal object? Record(string key, JsonNode node, Type type) => Is(node, JsonKind.Object, "an object { … }", key) ? Record(node, RecordType.Of(type)) : null;

    // All definitions of a family.
    internal object Named(TypeFamily family) => family == SceneTypes.Textures ? _textures.All() : family == SceneTypes.Materials ? _materials.All() : _objects.All();

    internal object? Thing(TypeFamily family, string key, JsonNode node) =>
        family == SceneTypes.Materials ? Thing(family, _materials, "one", key, node)
        : family == SceneTypes.Shapes ? Thing(family, _objects, "an object", key, node)
        : Inline(node, family, key);

    private object? Thing<T>(TypeFamily family, NamedThings<T> named, string other, string key, JsonNode node)
        where T : class => node.Kind switch
        {
            JsonKind.Object => Inline(node, family, key),
            JsonKind.String when named.Defines(node.Text) => named.Find(node.Text, node),
            JsonKind.String => Unknown(node, $"unknown {named.Noun} {Quotation.Of(node.Text)}", named.Names),
            _ => _bag.Expected<object>(node, $"a {family.Noun} {{ \"type\": … }} or the name of {other}", key),
        };

    // Reads { "type": …, … }.
    internal object? Inline(JsonNode node, TypeFamily family, string key)
    {
        string things = string.Join(", ", family.Names);
        if (!Is(node, JsonKind.Object, $"{RecordType.WithArticle(family.Noun)} {{ \"type\": … }}", key))
        {
            return null;
        }

        if (node.Find("type") is not { } name)
        {
            return _bag.Fail<object>(node, $"{RecordType.WithArticle(family.Noun)} needs \"type\": one of {things}", DiagnosticRule.Missing);
        }

        if (!Is(name, JsonKind.String, $"one of {things}", "type"))
        {
            return null;
        }

        if (family.Find(name.Text) is not { } type)
        {
            return UnknownType(name, family);
        }

        if (_nesting == MaximumNesting)
        {
            return _bag.Fail<object>(node, $"records are nested more than {_nesting} deep");
        }

        _nesting++;
        object record = Record(node, type);
        _nesting--;
        return record;
    }

    private object? UnknownType(JsonNode name, TypeFamily family) =>
        SceneTypes.Families.FirstOrDefault(f => f.Find(name.Text) is not null) is not { } other
            ? Unknown(name, $"unknown {family.Noun} type {Quotation.Of(name.Text)}", family.Names, "expected one of")
            : _bag.Fail<object>(
                name,
                $"{Quotation.Of(name.Text)} is {RecordType.WithArticle(other.Noun)}, but {RecordType.WithArticle(family.Noun)} is expected here",
                DiagnosticRule.WrongKind);

    private TextureDescription? NamedTexture(JsonMember member)
    {
        if (CssColors.Find(member.Key) is not null || member.Key.StartsWith('#'))
        {
            _bag.Error(member.Start, $"a texture cannot be called {Quotation.Of(member.Key)}, because that is a colour");
        }

        return Texture(member.Key, member.Value, []);
    }

    // Bounds are those for a colour that stands here itself, where messages can point at each of its numbers.
    internal TextureDescription? Texture(string key, JsonNode node, params ReadOnlySpan<RecordParameter> bounds)
    {
        if (node.Kind == JsonKind.Object)
        {
            return (TextureDescription?)Inline(node, SceneTypes.Textures, key);
        }

        bool isColor = node.Kind == JsonKind.String && (CssColors.Find(node.Text) is not null || node.Text.StartsWith('#'));
        if (node.Kind is JsonKind.Array or JsonKind.Number || isColor)
        {
            return Numbers.Color(key, node, [.. bounds, SceneTypes.SolidColor]) is { } color ? Solid(node, color) : null;
        }

        if (!Is(node, JsonKind.String, "a colour, a texture { \"type\": … } or the name of one", key))
        {
            return null;
        }

        return _textures.Defines(node.Text) ? _textures.Find(node.Text, node)
            : (TextureDescription?)Unknown(node, $"unknown colour or texture {Quotation.Of(node.Text)}", _textures.Names.Concat(CssColors.Names));
    }

    internal SolidTextureDescription Solid(JsonNode node, Numerics.Rgb color)
    {
        SolidTextureDescription solid = new() { Color = color };
        _map.Add(solid, node);
        return solid;
    }
}
