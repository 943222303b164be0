namespace RayTracer.Scenes;

/// <summary>Puts a <see cref="SceneSetting"/> into the tree of a scene file, before that is read and checked.</summary>
internal sealed class SettingTree
{
    private readonly SceneSetting _setting;
    private readonly DiagnosticBag _bag;
    private readonly int _offset;

    private SettingTree(SceneSetting setting, SourceText source, DiagnosticBag bag)
    {
        _setting = setting;
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
        SettingTree tree = new(setting, source, bag);
        return tree.Value() is { } value ? tree.With(root, value) : root;
    }

    // An unknown key is left to the reader to report: another setting may give the thing the type that has it.
    private JsonNode With(JsonNode root, JsonNode value)
    {
        PropertyPlace place = PropertyPlace.Find(root, _setting.Property);
        if (place.Complaint is null || place.IsUnknownKey)
        {
            return place.With(value, _offset);
        }

        _bag.Error(_offset + place.ComplaintStart, place.Complaint, DiagnosticRule.UnknownWord);
        return root;
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
}
