namespace RayTracer.Import;

/// <summary>What the reader knows: the types of each kind of thing and the properties that each is asked for. It is noted while scenes are read, so that the page which lists them cannot differ from what is read.</summary>
internal sealed class MitsubaRegistry
{
    private static readonly AsyncLocal<MitsubaRegistry?> s_current = new();

    /// <summary>The registry that takes notes where this is called; null where nobody wants them.</summary>
    public static MitsubaRegistry? Current
    {
        get => s_current.Value;
        set => s_current.Value = value;
    }

    /// <summary>The types of each kind.</summary>
    public SortedDictionary<string, SortedSet<string>> Types { get; } = new(StringComparer.Ordinal);

    /// <summary>The properties of each type, and the names of the things within it.</summary>
    public Dictionary<(string Kind, string Type), SortedSet<string>> Properties { get; } = [];

    /// <summary>Notes the types that there are of a kind.</summary>
    public void Add(string kind, params IEnumerable<string> types) => Of(Types, kind).UnionWith(types);

    /// <summary>Notes what a thing was asked for.</summary>
    public void Add(string kind, string type, params IEnumerable<string> names) => Of(Properties, (kind, type)).UnionWith(names.Where(n => n.Length > 0));

    private static SortedSet<string> Of<T>(IDictionary<T, SortedSet<string>> sets, T key)
        where T : notnull => sets.TryGetValue(key, out SortedSet<string>? set) ? set : sets[key] = new(StringComparer.Ordinal);
}
