using System.Collections.Concurrent;
using System.Reflection;
using System.Text.Json;
using RayTracer.Lights;

namespace RayTracer.Description;

/// <summary>A description record as scene files see it: its name and its parameters.</summary>
public sealed class RecordType
{
    private static readonly ConcurrentDictionary<Type, RecordType> Known = new();

    private readonly Type _type;
    private readonly Dictionary<string, RecordParameter> _byKey;

    private RecordType(Type type)
    {
        _type = type;
        SceneTypeAttribute? named = type.GetCustomAttribute<SceneTypeAttribute>();
        Name = named?.Name ?? JsonNamingPolicy.CamelCase.ConvertName(type.Name.Replace("Description", "", StringComparison.Ordinal));
        Summary = named?.Summary ?? "";
        object? defaults = type.GetConstructor([]) is null ? null : Create();
        Parameters = [.. type.GetProperties()
            .Select(p => (Property: p, Attribute: p.GetCustomAttribute<ParameterAttribute>()))
            .Where(p => p.Attribute is not null)
            .OrderBy(p => p.Property.DeclaringType == type ? 0 : 1)
            .ThenBy(p => p.Property.MetadataToken)
            .Select(p => new RecordParameter(p.Property, p.Attribute!, defaults))];
        _byKey = Parameters.ToDictionary(p => p.Key, StringComparer.Ordinal);
    }

    /// <summary>The name in scene files: what is written after "type", or for a record that has no type the key it stands under.</summary>
    public string Name { get; }

    /// <summary>The summary of the type; empty for a record without a type.</summary>
    public string Summary { get; }

    /// <summary>True where it is a light by itself, whatever its material.</summary>
    public bool IsLight => _type.IsSubclassOf(typeof(PunctualLightDescription));

    /// <summary>The parameters: the record's own, then those that all of its kind have.</summary>
    public IReadOnlyList<RecordParameter> Parameters { get; }

    // A part of it may be of the same kind.
    internal bool HoldsItself => Parameters.Any(p => p.RecordType == _type);

    /// <summary>The type of a description record.</summary>
    /// <param name="record">The record's C# type. Without a constructor that takes nothing, it cannot be made here, and its parameters have
    /// no defaults.</param>
    public static RecordType Of(Type record) => Known.GetOrAdd(record, r => new RecordType(r));

    /// <summary>A record and all that it consists of, each once, with the first record that holds it: null for the record itself.</summary>
    internal static IEnumerable<(object Record, object? Owner)> WithParts(object record)
    {
        HashSet<object> seen = new(ReferenceEqualityComparer.Instance);
        Queue<(object Record, object? Owner)> next = new([(record, null)]);
        while (next.TryDequeue(out (object Record, object? Owner) found))
        {
            if (seen.Add(found.Record))
            {
                yield return found;
                IEnumerable<object> parts = Of(found.Record.GetType()).Parameters.SelectMany(p => p.RecordsIn(p.Get(found.Record)));
                parts.OfType<object>().ToList().ForEach(part => next.Enqueue((part, found.Record)));
            }
        }
    }

    /// <summary>The parameter of a key; null where there is none.</summary>
    public RecordParameter? Find(string key) => _byKey.GetValueOrDefault(key);

    /// <summary>A new record with the default values.</summary>
    public object Create() => Activator.CreateInstance(_type)!;

    // "a sphere", or "camera" for a part that there is only one of.
    internal string NameInMessages => Summary.Length > 0 ? WithArticle(Name) : this == SceneTypes.Scene ? "the scene" : Quotation.Of(Name);

    // A key that is no parameter but may stand: "type", and "$schema" at the top.
    internal bool IsExtra(string key) => (Summary.Length > 0 && key == "type") || (this == SceneTypes.Scene && key == "$schema");

    // What is said of a key that the record has not, with the nearest one or else all.
    internal string Refusal(string key, bool givesHint = true)
    {
        IEnumerable<string> known = Parameters.Select(p => p.Key).DefaultIfEmpty("type");
        string hint = givesHint ? Spelling.DidYouMean(key, known) : "";
        return $"unknown key {Quotation.Of(key)} in {NameInMessages}{(hint.Length > 0 ? hint : $": it may have {string.Join(", ", known)}")}";
    }

    internal static string WithArticle(string noun) => noun[0] is 'a' or 'e' or 'i' or 'o' or 'u' ? $"an {noun}" : $"a {noun}";
}
