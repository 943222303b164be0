namespace RayTracer.Import.Tests;

/// <summary>The real models beside the project.</summary>
internal static class SharedModels
{
    /// <summary>A file of the folder; skips the test where there is none.</summary>
    public static string Find(params string[] parts)
    {
        string? path = ProjectFolder.Shared(["data", .. parts]);
        Skip.If(path is null, "there is no folder shared/data with models beside the project");
        return path!;
    }
}
