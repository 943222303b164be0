using System.Globalization;
using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>The place in a scene that a <see cref="PropertyPath"/> leads to. Neither the property itself nor a part such as the camera needs to be in the file.</summary>
internal sealed class PropertyPlace
{
    private readonly JsonNode _root;
    private readonly PropertyPath _path;
    private readonly List<PlaceStep> _steps = [];

    private PropertyPlace(JsonNode root, PropertyPath path) => (_root, _path, Node) = (root, path, root);

    /// <summary>The keys and numbers of elements that lead there.</summary>
    public IReadOnlyList<PlaceStep> Steps => _steps;

    /// <summary>The reason why there is no such property; null where there is one.</summary>
    public string? Complaint { get; private set; }

    /// <summary>The place in the path of the step that the complaint is about.</summary>
    public int ComplaintStart { get; private set; }

    /// <summary>True where the complaint is one that reading the scene with the property in its place would bring up too.</summary>
    public bool IsUnknownKey { get; private set; }

    /// <summary>The parameter that the path leads to, or an element of which it leads to; null after a complaint, and for "type".</summary>
    public RecordParameter? Parameter { get; private set; }

    /// <summary>True where the path leads to an element of the parameter: a number of a vector, a thing of a list, a thing by its name.</summary>
    public bool IsElement { get; private set; }

    /// <summary>The value in the file; null where there is none.</summary>
    public JsonNode? Node { get; private set; }

    /// <summary>The path that was followed, as it is written.</summary>
    public string Path => _path.Text;

    // The path up to here, as messages call it.
    private string Here => _steps.Count == 0 ? "the scene" : Quotation.Of(Path[.._path.Steps[_steps.Count - 1].End]);

    /// <summary>Follows a path.</summary>
    /// <param name="root">The scene.</param>
    /// <param name="path">The path.</param>
    public static PropertyPlace Find(JsonNode root, PropertyPath path)
    {
        PropertyPlace place = new(root, path);
        place.Complaint = path.Complaint is null ? null : $"{Quotation.Of(path.Text)} is not a property path: {path.Complaint}";
        for (int i = 0; place.Complaint is null && i < path.Steps.Count; i++)
        {
            (place.Complaint, int step) = place.Missing() is { } missing ? (missing, i - 1) : (place.Enter(path.Steps[i]), i);
            place.ComplaintStart = path.Steps[step].Start;
        }

        return place;
    }

    /// <summary>The scene with another value there.</summary>
    /// <param name="value">The value.</param>
    /// <param name="origin">The offset of the path's first character, for the positions of what the scene has not got yet.</param>
    public JsonNode With(JsonNode value, int origin) => With(_root, 0, value, origin);

    private JsonNode With(JsonNode node, int at, JsonNode value, int origin)
    {
        if (at == _steps.Count)
        {
            return value;
        }

        (string key, int? index, _) = _steps[at];
        if (index is not null)
        {
            return new(JsonKind.Array, node.Start, node.End) { Items = [.. node.Items.Select((item, i) => i == index ? With(item, at + 1, value, origin) : item)] };
        }

        List<JsonMember> members = [.. node.Members];
        int found = members.FindIndex(m => m.Key == key);
        if (found < 0)
        {
            (int start, int end) = (origin + _path.Steps[at].Start, origin + _path.Steps[at].End);
            found = members.Count;
            members.Add(new(key, start, end, new(JsonKind.Object, start, end)));
        }

        members[found] = members[found] with { Value = With(members[found].Value, at + 1, value, origin) };
        return new(JsonKind.Object, node.Start, node.End) { Members = members };
    }

    // Of what the file leaves out, only a record has parts: the defaults. All else must be there before something in it can change.
    private string? Missing() => Node is not null || Parameter is { IsRecord: true } or { HasNames: true } ? null
        : $"the scene does not set {Here}: nothing in it can change unless all of it is set";

    private string? Enter(PathStep step) => Node?.Kind switch
    {
        null or JsonKind.Object when step.Index is not null => $"{Here} has no elements with numbers{Keys()}",
        null or JsonKind.Object when Parameter is { HasNames: true } && !IsElement => Named(step),
        null or JsonKind.Object => Member(step),
        JsonKind.Array => Element(step),
        _ => Closed(Node),
    };

    // A thing by its name: a new one may be set as a whole.
    private string? Named(PathStep step)
    {
        if (Node?.Find(step.Key) is null && _steps.Count < _path.Steps.Count - 1)
        {
            return $"{Here} has no {Quotation.Of(step.Key)}{Spelling.DidYouMean(step.Key, Node?.Members.Select(m => m.Key) ?? [])}";
        }

        IsElement = true;
        return Go(new(step.Key, null, false), Node?.Find(step.Key));
    }

    private string? Member(PathStep step)
    {
        RecordType? type = Type();
        Parameter = type?.Find(step.Key);
        IsElement = false;
        string? complaint = type is null ? $"{Here} has no known type" : Parameter is null && !type.IsExtra(step.Key) ? type.Refusal(step.Key) : null;
        IsUnknownKey = complaint is not null;
        return Go(new(step.Key, null, false), Node?.Find(step.Key)) ?? complaint;
    }

    private string? Element(PathStep step)
    {
        IReadOnlyList<JsonNode> items = Node!.Items;
        int[] called = step.Index is null ? [.. Enumerable.Range(0, items.Count).Where(i => items[i].Find("name")?.Text == step.Key)] : [];
        if (called.Length > 1)
        {
            return $"{called.Length} elements of {Here} are called {Quotation.Of(step.Key)}: use a number, as in [{called[0]}]";
        }

        bool isNamed = called.Length == 1;
        int index = isNamed ? called[0] : step.Index ?? (int.TryParse(step.Key, NumberStyles.None, CultureInfo.InvariantCulture, out int number) ? number : int.MaxValue);
        if (index >= items.Count)
        {
            return Outside(step, items);
        }

        IsElement = true;
        return Go(new(step.Key, index, isNamed), items[index]);
    }

    private string Outside(PathStep step, IReadOnlyList<JsonNode> items)
    {
        string[] names = [.. items.Select(i => i.Find("name")?.Text).OfType<string>()];
        string elements = items.Count == 0 ? "no elements" : items.Count == 1 ? "one element, [0]" : $"{items.Count} elements, [0] to [{items.Count - 1}]";
        return step.Index is not null ? $"{Here} has {elements}: there is no [{step.Key}]"
            : names.Length == 0 ? $"{Here} has {elements}, and none has the name {Quotation.Of(step.Key)}"
            : $"nothing in {Here} has the name {Quotation.Of(step.Key)}{Spelling.DidYouMean(step.Key, names)}";
    }

    // A number, a word or a name, which has no parts.
    private string Closed(JsonNode node)
    {
        string list = Parameter?.Family is { } family ? family == SceneTypes.Shapes ? "objects" : $"{family.Noun}s" : "";
        if (node.Kind != JsonKind.String || _root.Find(list)?.Find(node.Text) is null)
        {
            return $"{Here} is {(node.Kind == JsonKind.String ? $"the text {Quotation.Of(node.Text)}" : node.Text)}, which has no parts";
        }

        string rest = Path[_path.Steps[_steps.Count - 1].End..];
        return $"{Here} is the name {Quotation.Of(node.Text)}: use {Quotation.Of(list + PropertyPath.Word(node.Text, false) + rest)}";
    }

    private RecordType? Type() => _steps.Count == 0 ? SceneTypes.Scene
        : Parameter?.Family is { } family ? Node?.Find("type") is { Kind: JsonKind.String } type ? family.Find(type.Text) : null
        : Parameter?.RecordType is { } record ? RecordType.Of(record) : null;

    private string Keys()
    {
        IReadOnlyList<JsonMember> members = Node?.Members ?? [];
        return members.Count == 0 ? "" : $", but {string.Join(", ", members.Take(10).Select(m => m.Key))}{(members.Count > 10 ? ", …" : "")}";
    }

    private string? Go(PlaceStep step, JsonNode? node)
    {
        _steps.Add(step);
        Node = node;
        return null;
    }
}

/// <summary>One step to a <see cref="PropertyPlace"/>.</summary>
/// <param name="Key">The key.</param>
/// <param name="Index">The number of an element of a list, from 0; null for a key.</param>
/// <param name="IsNamed">True where the path calls that element by its name.</param>
internal readonly record struct PlaceStep(string Key, int? Index, bool IsNamed);
