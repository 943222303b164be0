namespace RayTracer.Description;

/// <summary>The record types that may stand in the same places.</summary>
/// <param name="Noun">What each of them is: shape, material, texture or environment.</param>
/// <param name="Types">The types by name.</param>
public sealed record TypeFamily(string Noun, IReadOnlyList<RecordType> Types)
{
    /// <summary>The names of the types.</summary>
    public IEnumerable<string> Names => Types.Select(t => t.Name);

    /// <summary>The type of a name; null where there is none.</summary>
    public RecordType? Find(string name) => Types.FirstOrDefault(t => t.Name == name);
}
