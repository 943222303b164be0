using System.Globalization;
using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>
/// Where in a scene a property stands, as people write it: <c>camera.position</c>, <c>shapes[2].radius</c>, <c>shapes.ball.center[1]</c>,
/// <c>materials["my glass"].refractiveIndex</c>. The property itself need not be written in the file, nor a part such as the camera.
/// </summary>
internal sealed class PropertyPath
{
    private readonly List<(string? Key, int Index)> _steps = [];

    private PropertyPath()
    {
    }

    /// <summary>The keys and the numbers of elements that lead to the property.</summary>
    public IEnumerable<string> Steps => _steps.Select(s => s.Key ?? s.Index.ToString(CultureInfo.InvariantCulture));

    /// <summary>Of each step, whether it is an element of a list that the path calls by its name.</summary>
    public IEnumerable<bool> IsNamed => _steps.Select((s, i) => s.Key is null && !int.TryParse(Words[i], NumberStyles.None, CultureInfo.InvariantCulture, out _));

    private IReadOnlyList<string> Words { get; init; } = [];

    /// <summary>Why there is no such property; null where there is one.</summary>
    public string? Complaint { get; private set; }

    /// <summary>The parameter that the path leads to, or one of whose numbers it leads to; null after a complaint.</summary>
    public RecordParameter? Parameter { get; private set; }

    /// <summary>Whether the path leads to one of the parameter's numbers.</summary>
    public bool IsElement { get; private set; }

    /// <summary>What the file has there; null where it has nothing.</summary>
    public JsonNode? Node { get; private set; }

    /// <summary>Finds a property.</summary>
    /// <param name="root">The scene.</param>
    /// <param name="text">The path.</param>
    public static PropertyPath Find(JsonNode root, string text)
    {
        List<string>? words = Split(text);
        PropertyPath path = new() { Words = words ?? [] };
        if (words is null)
        {
            path.Complaint = $"{Quotation.Of(text)} is no path of a property: expected one like camera.position, shapes[2].radius or materials.glass.color";
            return path;
        }

        path.Node = root;
        path.Complaint = path.Walk(words);
        return path;
    }

    /// <summary>The scene with another value there.</summary>
    public JsonNode Replace(JsonNode root, JsonNode value) => Replace(root, 0, value);

    // Every key or index; null where it is no path.
    private static List<string>? Split(string text)
    {
        List<string> words = [];
        for (int at = 0; at < text.Length;)
        {
            bool isQuoted = text.AsSpan(at).StartsWith("[\"");
            bool isIndex = text[at] == '[';
            int first = isQuoted ? at + 2 : isIndex || (text[at] == '.' && at > 0) ? at + 1 : at;
            int end = isQuoted ? text.IndexOf("\"]", first, StringComparison.Ordinal) : isIndex ? text.IndexOf(']', first) : text.IndexOfAny(['.', '['], first);
            end = end < 0 && !isIndex ? text.Length : end;
            if (end <= first || (at > 0 && !isIndex && text[at] != '.') || (isIndex && !isQuoted && !text.AsSpan(first, end - first).ContainsAnyInRange('0', '9')))
            {
                return null;
            }

            words.Add(text[first..end]);
            at = isQuoted ? end + 2 : isIndex ? end + 1 : end;
        }

        return words.Count > 0 ? words : null;
    }

    private string? Walk(List<string> words)
    {
        RecordType type = SceneTypes.Scene;
        string place = "the scene";
        for (int i = 0; i < words.Count; i++)
        {
            if (type.Find(words[i]) is not { } parameter)
            {
                IEnumerable<string> known = type.Parameters.Select(p => p.Key);
                string hint = Spelling.DidYouMean(words[i], known);
                return $"unknown key {Quotation.Of(words[i])} in {place}{(hint.Length > 0 ? hint : $": it may have {string.Join(", ", known)}")}";
            }

            Step(words[i]);
            Parameter = parameter;
            place = Quotation.Of(string.Join('.', words.Take(i + 1)));
            bool isLast = i == words.Count - 1;
            if (isLast)
            {
                return null;
            }

            if (Elements(parameter.Kind))
            {
                IsElement = true;
                return i == words.Count - 2 ? Item(words[i + 1], place) : $"{place} holds numbers, which have no parts";
            }

            if (parameter.Kind is ParameterKind.NamedMaterials or ParameterKind.NamedShapes or ParameterKind.NamedTextures
                or ParameterKind.Shapes or ParameterKind.Materials or ParameterKind.Records)
            {
                if (Item(words[++i], place) is { } complaint)
                {
                    return complaint;
                }

                place = Quotation.Of(string.Join('.', words.Take(i + 1)));
                if (i == words.Count - 1)
                {
                    return $"{place} is no property, but a whole thing: name one of its properties";
                }
            }

            if (Inner(parameter, place, out string? problem) is not { } inner)
            {
                return problem;
            }

            type = inner;
        }

        return null;
    }

    private static bool Elements(ParameterKind kind) => kind is ParameterKind.Vector2 or ParameterKind.Vector3 or ParameterKind.Color or ParameterKind.Numbers or ParameterKind.Texture;

    // The type of the thing that the path has come to.
    private RecordType? Inner(RecordParameter parameter, string place, out string? problem)
    {
        problem = null;
        if (parameter.RecordType is { } record)
        {
            return RecordType.Of(record);
        }

        TypeFamily? family = parameter.Kind switch
        {
            ParameterKind.Shape or ParameterKind.Shapes or ParameterKind.NamedShapes => SceneTypes.Shapes,
            ParameterKind.Material or ParameterKind.Materials or ParameterKind.NamedMaterials => SceneTypes.Materials,
            ParameterKind.NamedTextures or ParameterKind.Texture => SceneTypes.Textures,
            ParameterKind.Environment => SceneTypes.Environments,
            _ => null,
        };
        problem = family is null ? $"{place} has no parts"
            : Node is null ? $"{place} is not given in the file"
            : Node.Kind == JsonKind.String ? $"{place} is only a name, {Quotation.Of(Node.Text)}: change what is defined under that name"
            : Node.Find("type") is not { Kind: JsonKind.String } name || family.Find(name.Text) is null ? $"{place} is no {family.Noun} with properties"
            : null;
        return problem is null ? family!.Find(Node!.Find("type")!.Text) : null;
    }

    // Goes into a list, by number or by the name of a shape, or to a named thing.
    private string? Item(string word, string place)
    {
        if (Node is null)
        {
            return $"{place} is not given in the file";
        }

        if (Node.Kind == JsonKind.Object)
        {
            IEnumerable<string> names = Node.Members.Select(m => m.Key);
            Step(word);
            return Node is not null ? null : $"there is no {Quotation.Of(word)} in {place}{Spelling.DidYouMean(word, names)}";
        }

        if (!int.TryParse(word, NumberStyles.None, CultureInfo.InvariantCulture, out int index))
        {
            int[] called = [.. Enumerable.Range(0, Node.Items.Count).Where(i => Node.Items[i].Find("name")?.Text == word)];
            if (called.Length != 1)
            {
                IEnumerable<string> names = Node.Items.Select(n => n.Find("name")?.Text).OfType<string>();
                return called.Length > 1 ? $"{called.Length} in {place} are called {Quotation.Of(word)}: use a number, as in [{called[0]}]"
                    : $"nothing in {place} is called {Quotation.Of(word)}{Spelling.DidYouMean(word, names)}";
            }

            index = called[0];
        }

        if (index >= Node.Items.Count)
        {
            return $"{place} has {Node.Items.Count} elements, numbered from 0: there is no [{word}]";
        }

        _steps.Add((null, index));
        Node = Node.Items[index];
        return null;
    }

    private void Step(string key)
    {
        _steps.Add((key, 0));
        Node = Node?.Find(key);
    }

    private JsonNode Replace(JsonNode? node, int step, JsonNode value)
    {
        if (step == _steps.Count)
        {
            return value;
        }

        (string? key, int index) = _steps[step];
        if (key is null)
        {
            return new(JsonKind.Array, node!.Start, node.End) { Items = [.. node.Items.Select((item, i) => i == index ? Replace(item, step + 1, value) : item)] };
        }

        JsonNode there = node ?? new(JsonKind.Object, value.Start, value.End);
        JsonNode changed = Replace(there.Find(key), step + 1, value);
        bool isNew = there.Find(key) is null;
        IEnumerable<JsonMember> members = there.Members.Select(m => m.Key == key ? m with { Value = changed } : m);
        return new(JsonKind.Object, there.Start, there.End) { Members = [.. isNew ? members.Append(new(key, value.Start, value.Start, changed)) : members] };
    }
}
