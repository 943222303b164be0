using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>What all that reads a scene of XML files shares: where diagnostics go, and where each record was read.</summary>
internal sealed class MitsubaReading
{
    /// <summary>Takes what is wrong.</summary>
    public MitsubaLog Log { get; } = new();

    /// <summary>Where each record stands.</summary>
    public SourceMap Map { get; } = new();

    /// <summary>Remembers where a record was read.</summary>
    public T At<T>(SourcePlace place, T record)
        where T : class
    {
        Map.Add(record, place);
        return record;
    }
}
