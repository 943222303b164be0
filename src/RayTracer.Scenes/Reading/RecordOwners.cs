using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>Finds the records around a record, of which a file in another format has the places where it has none of the record itself.</summary>
/// <param name="scene">The outermost record.</param>
internal sealed class RecordOwners(SceneDescription scene)
{
    private Dictionary<object, object?>? _owners;

    /// <summary>A record, then those around it, the innermost first; of several that hold it, the first.</summary>
    public IEnumerable<object> From(object record)
    {
        _owners ??= RecordType.WithParts(scene).ToDictionary(p => p.Record, p => p.Owner, ReferenceEqualityComparer.Instance);
        for (object? next = record; next is not null; next = _owners.GetValueOrDefault(next))
        {
            yield return next;
        }
    }
}
