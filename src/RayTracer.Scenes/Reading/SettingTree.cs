namespace RayTracer.Scenes;

/// <summary>Puts a <see cref="SceneSetting"/> into the tree of a scene file, before that is read and checked.</summary>
internal sealed class SettingTree
{
    private readonly SceneSetting _setting;
    private readonly JsonNode _root;
    private readonly DiagnosticBag _bag;
    private readonly int _offset;

    private SettingTree(SceneSetting setting, JsonNode root, SourceText source, DiagnosticBag bag)
    {
        _setting = setting;
        _root = root;
        _bag = bag;
        _offset = source.Annex($"the option --set {setting.Text.ReplaceLineEndings(" ")}", setting.Text.Length);
    }

    /// <summary>Makes the changed tree.</summary>
    /// <param name="setting">The value and its place.</param>
    /// <param name="root">The tree, which stays as it is.</param>
    /// <param name="source">The file's text.</param>
    /// <param name="bag">Takes what is wrong with the path.</param>
    /// <returns>The changed tree; the same one where the path leads nowhere.</returns>
    public static JsonNode Apply(SceneSetting setting, JsonNode root, SourceText source, DiagnosticBag bag)
    {
        SettingTree tree = new(setting, root, source, bag);
        return tree.Value() is { } value ? tree.Put(root, 0, default, value) ?? root : root;
    }

    // What stands at a place: the parameter, or an element of it; null for the scene itself and for what is unknown.
    private readonly record struct Place(RecordParameter? Parameter, bool IsElement);

    private JsonNode? Put(JsonNode node, int at, Place place, JsonNode value)
    {
        if (at == _setting.Steps.Count)
        {
            return value;
        }

        SettingStep step = _setting.Steps[at];
        return node.Kind switch
        {
            JsonKind.Object when step.Index is null => PutMember(node, at, place, value),
            JsonKind.Object => Error(step, $"{Before(at)} has no elements with numbers{Names(node)}"),
            JsonKind.Array => PutElement(node, at, place, value),
            _ => Error(step, Closed(node, at, place)),
        };
    }

    private JsonNode? PutMember(JsonNode node, int at, Place place, JsonNode value)
    {
        SettingStep step = _setting.Steps[at];
        Place inner = IsNamed(place) ? place with { IsElement = true } : new(TypeOf(node, place, at)?.Find(step.Key), false);
        List<JsonMember> members = [.. node.Members];
        int found = members.FindIndex(m => m.Key == step.Key);
        JsonNode? child = found >= 0 ? Put(members[found].Value, at + 1, inner, value) : Missing(node, at, place, inner, value);
        if (child is null)
        {
            return null;
        }

        if (found >= 0)
        {
            members[found] = members[found] with { Value = child };
        }
        else
        {
            members.Add(new(step.Key, _offset + step.Start, _offset + step.End, child));
        }

        return new(JsonKind.Object, node.Start, node.End) { Members = members };
    }

    // What the file leaves out: it may be set as a whole, or be a record whose other values are the defaults. An unknown key is left to the reader to report.
    private JsonNode? Missing(JsonNode node, int at, Place place, Place inner, JsonNode value)
    {
        SettingStep step = _setting.Steps[at];
        JsonNode empty = new(JsonKind.Object, _offset + step.Start, _offset + step.End);
        if (at + 1 == _setting.Steps.Count)
        {
            return value;
        }

        if (IsNamed(place))
        {
            return Error(step, $"{Before(at)} has no {Quotation.Of(step.Key)}{Spelling.DidYouMean(step.Key, node.Members.Select(m => m.Key))}");
        }

        return inner.Parameter?.Kind switch
        {
            null => empty,
            ParameterKind.Record or ParameterKind.NamedMaterials or ParameterKind.NamedShapes or ParameterKind.NamedTextures => Put(empty, at + 1, inner, value),
            _ => Error(step, $"the scene does not give {Before(at + 1)}, so nothing in it can be set: set it as a whole"),
        };
    }

    private JsonNode? PutElement(JsonNode node, int at, Place place, JsonNode value)
    {
        SettingStep step = _setting.Steps[at];
        List<JsonNode> items = [.. node.Items];
        int index = step.Index ?? items.FindIndex(i => i.Find("name")?.Text == step.Key);
        if (step.Index is null && items.Count(i => i.Find("name")?.Text == step.Key) is > 1 and var called)
        {
            return Error(step, $"{called} in {Before(at)} are called {Quotation.Of(step.Key)}: use a number, as in [{index}]");
        }

        if (index < 0 || index >= items.Count)
        {
            IEnumerable<string> names = items.Select(i => i.Find("name")?.Text).OfType<string>();
            string elements = items.Count == 0 ? "no elements" : items.Count == 1 ? "one element, [0]" : $"{items.Count} elements, [0] to [{items.Count - 1}]";
            return Error(step, step.Index is null && names.Any()
                ? $"nothing in {Before(at)} has the name {Quotation.Of(step.Key)}{Spelling.DidYouMean(step.Key, names)}"
                : $"{Before(at)} has {elements}{(step.Index is null ? $", and none has the name {Quotation.Of(step.Key)}" : "")}");
        }

        if (Put(items[index], at + 1, place with { IsElement = true }, value) is not { } item)
        {
            return null;
        }

        items[index] = item;
        return new(JsonKind.Array, node.Start, node.End) { Items = items };
    }

    // A number, a word or a name, in which nothing can be set.
    private string Closed(JsonNode node, int at, Place place)
    {
        string list = FamilyOf(place) is { } family ? family == SceneTypes.Shapes ? "objects" : $"{family.Noun}s" : "";
        string? rest = _root.Find(list)?.Find(node.Text) is null || node.Kind != JsonKind.String ? null : $"{list}.{node.Text}{_setting.Text[_setting.Steps[at - 1].End.._setting.Steps[^1].End]}";
        return rest is null ? $"{Before(at)} is {(node.Kind == JsonKind.String ? $"the text {Quotation.Of(node.Text)}" : node.Text)}, which has no parts"
            : $"{Before(at)} is the name {Quotation.Of(node.Text)}: set {Quotation.Of(rest)}";
    }

    private JsonNode? Value()
    {
        string text = _setting.Value.Trim();
        int start = _setting.ValueStart + (_setting.Value.Length - _setting.Value.TrimStart().Length);
        if (text.Length == 0)
        {
            _bag.Error(_offset + _setting.ValueStart - 1, "expected a value after \"=\"", DiagnosticRule.Syntax);
            return null;
        }

        (int from, int to) = (_offset + start, _offset + start + text.Length);
        if (text is ['{' or '[' or '"', ..])
        {
            // With blanks in front, offsets are those of the setting.
            SourceText source = new("", new string(' ', start) + text);
            List<Diagnostic> wrong = [];
            JsonNode? node = JsonParser.Parse(source, wrong);
            wrong.ForEach(d => _bag.Error(_offset + source.Offset(d.Line, d.Column), d.Message.Replace("the end of the file", "the end of the value", StringComparison.Ordinal), DiagnosticRule.Syntax));
            return node is null ? null : Move(node);
        }

        return new(JsonParser.IsNumber(text) ? JsonKind.Number : text is "true" or "false" ? JsonKind.Boolean : text is "null" ? JsonKind.Null : JsonKind.String, from, to, text);
    }

    private JsonNode Move(JsonNode node) => new(node.Kind, node.Start + _offset, node.End + _offset, node.Text)
    {
        Items = [.. node.Items.Select(Move)],
        Members = [.. node.Members.Select(m => new JsonMember(m.Key, m.Start + _offset, m.End + _offset, Move(m.Value)))],
    };

    private static RecordType? TypeOf(JsonNode node, Place place, int depth) =>
        depth == 0 ? SceneTypes.Scene
        : FamilyOf(place) is { } family ? node.Find("type") is { Kind: JsonKind.String } type ? family.Find(type.Text) : null
        : place.Parameter?.RecordType is { } record ? RecordType.Of(record) : null;

    private static TypeFamily? FamilyOf(Place place) => place.Parameter?.Kind switch
    {
        ParameterKind.Texture or ParameterKind.NamedTextures => SceneTypes.Textures,
        ParameterKind.Material or ParameterKind.Materials or ParameterKind.NamedMaterials => SceneTypes.Materials,
        ParameterKind.Shape or ParameterKind.Shapes or ParameterKind.NamedShapes => SceneTypes.Shapes,
        ParameterKind.Environment => SceneTypes.Environments,
        _ => null,
    };

    private static bool IsNamed(Place place) =>
        !place.IsElement && place.Parameter?.Kind is ParameterKind.NamedTextures or ParameterKind.NamedMaterials or ParameterKind.NamedShapes;

    private static string Names(JsonNode node) => node.Members.Count == 0 ? "" : $", but {string.Join(", ", node.Members.Take(10).Select(m => m.Key))}{(node.Members.Count > 10 ? ", …" : "")}";

    // The path before a step, as messages call it.
    private string Before(int at) => at == 0 ? "the scene" : Quotation.Of(_setting.Text[.._setting.Steps[at - 1].End]);

    private JsonNode? Error(SettingStep step, string message)
    {
        _bag.Error(_offset + step.Start, message, DiagnosticRule.UnknownWord);
        return null;
    }
}
