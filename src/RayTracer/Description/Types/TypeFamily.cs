using System.Collections.Immutable;
using System.Reflection;

namespace RayTracer.Description;

/// <summary>The record types that may stand in the same places.</summary>
public sealed class TypeFamily
{
    private ImmutableList<RecordType> _types;

    internal TypeFamily(string noun, Type ancestor)
    {
        Noun = noun;
        Base = ancestor;
        _types = Sorted(ancestor.Assembly.GetTypes().Where(Holds).Select(RecordType.Of));
    }

    /// <summary>The word for each of them: shape, material, texture or environment.</summary>
    public string Noun { get; }

    /// <summary>The types by name.</summary>
    public IReadOnlyList<RecordType> Types => _types;

    /// <summary>The names of the types.</summary>
    public IEnumerable<string> Names => Types.Select(t => t.Name);

    /// <summary>The type of a name; null where there is none.</summary>
    public RecordType? Find(string name) => _types.Find(t => t.Name == name);

    internal Type Base { get; }

    internal bool Holds(Type type) => type.IsSubclassOf(Base) && type.IsDefined(typeof(SceneTypeAttribute));

    internal void Add(RecordType type) => _types = Sorted(_types.Append(type));

    private static ImmutableList<RecordType> Sorted(IEnumerable<RecordType> types) => [.. types.OrderBy(t => t.Name, StringComparer.Ordinal)];
}
