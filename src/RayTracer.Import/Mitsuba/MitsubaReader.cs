using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>
/// Reads scenes in the XML format of Mitsuba 3 (W. Jakob and others; its documentation, "Scene XML file format") as descriptions. Bad content
/// never throws: it becomes diagnostics, all of them at once.
/// </summary>
public static class MitsubaReader
{
    /// <summary>Reads a file.</summary>
    /// <param name="path">The file's path, by which diagnostics call it too.</param>
    public static SceneReadResult Read(string path)
    {
        ImportReading reading = new();
        MitsubaObject? root = MitsubaDocument.Read(path, reading.Log);
        return new(new SourceText(path, ""), null, root is null ? null : new MitsubaScene(reading).Read(root), reading.Map, reading.Log.Diagnostics);
    }
}
