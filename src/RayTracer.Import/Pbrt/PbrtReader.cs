using RayTracer.Scenes;

namespace RayTracer.Import;

/// <summary>
/// Reads scenes in the text format of pbrt-v4 (M. Pharr, W. Jakob, G. Humphreys; its documentation, "pbrt-v4 Input File Format") as descriptions. Bad
/// content never throws: it becomes diagnostics, all of them at once.
/// </summary>
public static class PbrtReader
{
    /// <summary>Reads a file.</summary>
    /// <param name="path">The file's path, by which diagnostics call it too.</param>
    public static SceneReadResult Read(string path)
    {
        ImportReading reading = new();
        PbrtWorld? world = PbrtDocument.Read(path, reading.Log);
        return new(new SourceText(path, ""), null, world is null ? null : new PbrtScene(reading, world).Read(), reading.Map, reading.Log.Diagnostics);
    }
}
