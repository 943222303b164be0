using RayTracer.Description;
using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>The state shared by all readers of a scene: where diagnostics go, and where each record was read.</summary>
internal sealed class ImportReading
{
    /// <summary>Takes what is wrong.</summary>
    public ImportLog Log { get; } = new();

    /// <summary>The place of each record.</summary>
    public SourceMap Map { get; } = new();

    /// <summary>Remembers where a record was read.</summary>
    public T At<T>(SourcePlace place, T record)
        where T : class
    {
        Map.Add(record, place);
        return record;
    }
}
