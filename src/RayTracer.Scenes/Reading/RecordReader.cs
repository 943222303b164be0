using System.Collections;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>Turns the values of a scene file into description records, by reflection over their parameters.</summary>
internal sealed class RecordReader
{
    /// <summary>The maximum depth of nested textures, materials and shapes. Each level may double the work of shading a point.</summary>
    public const int MaximumNesting = 16;

    private readonly DiagnosticBag _bag;
    private readonly SourceMap _map;
    private readonly NumberReader _numbers;
    private readonly NamedThings<TextureDescription> _textures;
    private readonly NamedThings<MaterialDescription> _materials;
    private readonly NamedThings<ShapeDescription> _objects;
    private int _nesting;

    private RecordReader(DiagnosticBag bag, SourceMap map, JsonNode root)
    {
        _bag = bag;
        _map = map;
        _numbers = new(bag);
        _textures = new("texture", bag, root.Find("textures"), NamedTexture);
        _materials = new("material", bag, root.Find("materials"), m => Material(m.Key, m.Value));
        _objects = new("object", bag, root.Find("objects"), m => Shape(m.Key, m.Value));
    }

    /// <summary>Reads a scene. Values with errors keep their defaults, and their records are marked as incomplete.</summary>
    public static SceneDescription? ReadScene(JsonNode root, DiagnosticBag bag, SourceMap map)
    {
        if (root.Kind != JsonKind.Object)
        {
            bag.Expected(root, "a scene { … }", "");
            return null;
        }

        RecordReader reader = new(bag, map, root);
        var scene = (SceneDescription)reader.Record(root, SceneTypes.Scene);
        new TrackChecker(root, bag, map, reader.Value).Check(scene.Animation);
        return scene;
    }

    private object Record(JsonNode node, RecordType type)
    {
        object record = type.Create();
        _map.Add(record, node);
        foreach (JsonMember member in node.Members)
        {
            RecordParameter? parameter = type.Find(member.Key);
            if (parameter is not null && Value(parameter, member.Value) is { } value)
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

    private object? Value(RecordParameter parameter, JsonNode node)
    {
        switch (parameter.Kind)
        {
            case ParameterKind.Number:
                return _numbers.Number(parameter, node);
            case ParameterKind.Integer:
                return _numbers.Integer(parameter, node);
            case ParameterKind.Boolean:
                return Is(node, JsonKind.Boolean, "true or false", parameter.Key) ? node.Text == "true" : null;
            case ParameterKind.Text:
                return Is(node, JsonKind.String, "a string", parameter.Key) ? node.Text : null;
            case ParameterKind.File:
                return File(parameter, node);
            case ParameterKind.Choice:
                return Choice(parameter, node);
            case ParameterKind.Vector2:
                return _numbers.Vector2(parameter, node);
            case ParameterKind.Vector3:
                return _numbers.Vector3(parameter, node);
            case ParameterKind.Color:
                return _numbers.Color(parameter.Key, node, parameter);
            case ParameterKind.Texture:
                return Texture(parameter, node);
            case ParameterKind.Material:
                return Material(parameter.Key, node);
            case ParameterKind.Materials:
                return List(parameter.Key, node, "materials", item => Material(parameter.Key, item));
            case ParameterKind.Shape:
                return Shape(parameter.Key, node);
            case ParameterKind.Shapes:
                return List(parameter.Key, node, "shapes", item => (ShapeDescription?)Inline(item, SceneTypes.Shapes, parameter.Key));
            case ParameterKind.Environment:
                return Inline(node, SceneTypes.Environments, parameter.Key);
            case ParameterKind.Record:
                return Is(node, JsonKind.Object, "an object { … }", parameter.Key) ? Record(node, RecordType.Of(parameter.ValueType)) : null;
            case ParameterKind.Records:
                return Records(parameter, node);
            case ParameterKind.Numbers when parameter.IsNumber && node.Kind == JsonKind.Number:
                return _numbers.Number(parameter, node) is float number ? (float[])[number] : null;
            case ParameterKind.Numbers when parameter.IsNumber && node.Kind == JsonKind.String:
                return _numbers.Color(parameter.Key, node) is { } color ? (float[])[color.R, color.G, color.B] : null;
            case ParameterKind.Numbers:
                return List(parameter.Key, node, "numbers", item => (float?)_numbers.Number(parameter, item));
            case ParameterKind.Integers:
                return List(parameter.Key, node, "whole numbers", item => _numbers.WholeNumber(parameter.Key, item));
            case ParameterKind.Vector2s:
                return List(parameter.Key, node, "pairs of numbers", item => (Vector2?)_numbers.Vector2(parameter, item));
            case ParameterKind.Vector3s:
                return List(parameter.Key, node, "triples of numbers", item => (Vector3?)_numbers.Vector3(parameter, item));
            case ParameterKind.Triangles:
                return List(parameter.Key, node, "triples of whole numbers", item => _numbers.Triangle(parameter.Key, item));
            case ParameterKind.NamedTextures:
                return Is(node, JsonKind.Object, "an object { … }", parameter.Key) ? _textures.All() : null;
            case ParameterKind.NamedShapes:
                return Is(node, JsonKind.Object, "an object { … }", parameter.Key) ? _objects.All() : null;
            default:
                return Is(node, JsonKind.Object, "an object { … }", parameter.Key) ? _materials.All() : null;
        }
    }

    private bool Is(JsonNode node, JsonKind kind, string expected, string key)
    {
        if (node.Kind != kind)
        {
            _bag.Expected(node, expected, key);
        }

        return node.Kind == kind;
    }

    private string? File(RecordParameter parameter, JsonNode node)
    {
        if (!Is(node, JsonKind.String, "the path of a file", parameter.Key))
        {
            return null;
        }

        if (node.Text.Length == 0 || node.Text.Contains('\0', StringComparison.Ordinal))
        {
            _bag.Error(node, $"{Quotation.Of(node.Text)} is not a file path");
            return null;
        }

        return node.Text;
    }

    private object? Choice(RecordParameter parameter, JsonNode node)
    {
        if (!Is(node, JsonKind.String, $"one of {string.Join(", ", parameter.Choices)}", parameter.Key))
        {
            return null;
        }

        object? value = parameter.Choice(node.Text);
        if (value is null)
        {
            _bag.Unknown(node.Start, $"unknown value {Quotation.Of(node.Text)} for {Quotation.Of(parameter.Key)}", node.Text, parameter.Choices, "expected one of");
        }

        return value;
    }

    // A list of those elements that could be read.
    private List<T>? List<T>(string key, JsonNode node, string things, Func<JsonNode, T?> read)
        where T : class => Is(node, JsonKind.Array, $"a list [ … ] of {things}", key) ? [.. node.Items.Select(read).OfType<T>()] : null;

    private List<T>? List<T>(string key, JsonNode node, string things, Func<JsonNode, T?> read)
        where T : struct => Is(node, JsonKind.Array, $"a list [ … ] of {things}", key) ? [.. node.Items.Select(read).OfType<T>()] : null;

    private IList? Records(RecordParameter parameter, JsonNode node)
    {
        if (!Is(node, JsonKind.Array, "a list [ … ] of objects { … }", parameter.Key))
        {
            return null;
        }

        var records = (IList)Activator.CreateInstance(typeof(List<>).MakeGenericType(parameter.RecordType!))!;
        foreach (JsonNode item in node.Items.Where(i => Is(i, JsonKind.Object, "an object { … }", parameter.Key)))
        {
            records.Add(Record(item, RecordType.Of(parameter.RecordType!)));
        }

        return records;
    }

    private ShapeDescription? Shape(string key, JsonNode node)
    {
        if (node.Kind == JsonKind.String)
        {
            if (_objects.Defines(node.Text))
            {
                return _objects.Find(node.Text, node);
            }

            _bag.Unknown(node.Start, $"unknown object {Quotation.Of(node.Text)}", node.Text, _objects.Names, "");
            return null;
        }

        if (node.Kind == JsonKind.Object)
        {
            return (ShapeDescription?)Inline(node, SceneTypes.Shapes, key);
        }

        _bag.Expected(node, "a shape { \"type\": … } or the name of an object", key);
        return null;
    }

    // Reads { "type": …, … }.
    private object? Inline(JsonNode node, TypeFamily family, string key)
    {
        string things = string.Join(", ", family.Names);
        if (!Is(node, JsonKind.Object, $"{RecordType.WithArticle(family.Noun)} {{ \"type\": … }}", key))
        {
            return null;
        }

        if (node.Find("type") is not { } name)
        {
            _bag.Error(node, $"{RecordType.WithArticle(family.Noun)} needs \"type\": one of {things}", DiagnosticRule.Missing);
            return null;
        }

        if (!Is(name, JsonKind.String, $"one of {things}", "type"))
        {
            return null;
        }

        if (family.Find(name.Text) is not { } type)
        {
            UnknownType(name, family);
            return null;
        }

        if (_nesting == MaximumNesting)
        {
            _bag.Error(node, $"records are nested more than {_nesting} deep");
            return null;
        }

        _nesting++;
        object record = Record(node, type);
        _nesting--;
        return record;
    }

    private void UnknownType(JsonNode name, TypeFamily family)
    {
        TypeFamily? other = SceneTypes.Families.FirstOrDefault(f => f.Find(name.Text) is not null);
        if (other is not null)
        {
            _bag.Error(name, $"{Quotation.Of(name.Text)} is {RecordType.WithArticle(other.Noun)}, but {RecordType.WithArticle(family.Noun)} is expected here", DiagnosticRule.WrongKind);
            return;
        }

        _bag.Unknown(name.Start, $"unknown {family.Noun} type {Quotation.Of(name.Text)}", name.Text, family.Names, "expected one of");
    }

    private MaterialDescription? Material(string key, JsonNode node)
    {
        if (node.Kind == JsonKind.String)
        {
            if (_materials.Defines(node.Text))
            {
                return _materials.Find(node.Text, node);
            }

            _bag.Unknown(node.Start, $"unknown material {Quotation.Of(node.Text)}", node.Text, _materials.Names, "");
            return null;
        }

        if (node.Kind == JsonKind.Object)
        {
            return (MaterialDescription?)Inline(node, SceneTypes.Materials, key);
        }

        _bag.Expected(node, "a material { \"type\": … } or the name of one", key);
        return null;
    }

    private TextureDescription? NamedTexture(JsonMember member)
    {
        if (CssColors.Find(member.Key) is not null || member.Key.StartsWith('#'))
        {
            _bag.Error(member.Start, $"a texture cannot be called {Quotation.Of(member.Key)}, because that is a colour");
        }

        return Texture(member.Key, member.Value, []);
    }

    private TextureDescription? Texture(RecordParameter parameter, JsonNode node)
    {
        if (parameter.IsNumber && node.Kind == JsonKind.Number)
        {
            return _numbers.Number(parameter, node) is float number ? Solid(node, new(number, number, number)) : null;
        }

        TextureDescription? texture = Texture(parameter.Key, node, parameter);
        if (texture is not null && parameter.RangeComplaint(texture) is { } complaint)
        {
            _bag.Error(node, $"{Quotation.Of(parameter.Key)} {complaint}", DiagnosticRule.OutOfRange);
            return null;
        }

        return texture;
    }

    // Bounds are those for a colour that stands here itself, where messages can point at each of its numbers.
    private TextureDescription? Texture(string key, JsonNode node, params ReadOnlySpan<RecordParameter> bounds)
    {
        if (node.Kind == JsonKind.Object)
        {
            return (TextureDescription?)Inline(node, SceneTypes.Textures, key);
        }

        bool isColor = node.Kind == JsonKind.String && (CssColors.Find(node.Text) is not null || node.Text.StartsWith('#'));
        if (node.Kind == JsonKind.Array || isColor)
        {
            return _numbers.Color(key, node, [.. bounds, SceneTypes.SolidColor]) is { } color ? Solid(node, color) : null;
        }

        if (!Is(node, JsonKind.String, "a colour, a texture { \"type\": … } or the name of one", key))
        {
            return null;
        }

        if (_textures.Defines(node.Text))
        {
            return _textures.Find(node.Text, node);
        }

        _bag.Unknown(node.Start, $"unknown colour or texture {Quotation.Of(node.Text)}", node.Text, _textures.Names.Concat(CssColors.Names), "");
        return null;
    }

    private SolidTextureDescription Solid(JsonNode node, Numerics.Rgb color)
    {
        SolidTextureDescription solid = new() { Color = color };
        _map.Add(solid, node);
        return solid;
    }
}
