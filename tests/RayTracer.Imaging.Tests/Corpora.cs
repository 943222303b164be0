namespace RayTracer.Imaging.Tests;

/// <summary>Public test pictures in a folder that the environment variable RAYTRACER_CORPORA names; <c>.ci/fetch-corpora</c> makes one.</summary>
internal static class Corpora
{
    private static readonly string? s_folder = Environment.GetEnvironmentVariable("RAYTRACER_CORPORA");

    /// <summary>The files with an extension, in the order of their names. Skips the test where there is no folder.</summary>
    public static string[] Files(string extension, int atLeast = 21)
    {
        Skip.If(string.IsNullOrEmpty(s_folder), "RAYTRACER_CORPORA names no folder of public test pictures (.ci/fetch-corpora makes one)");
        string[] files = [.. Directory.GetFiles(s_folder!, "*" + extension, SearchOption.AllDirectories).Order(StringComparer.Ordinal)];
        Assert.True(files.Length >= atLeast, $"'{s_folder}' holds {files.Length} files of {extension} only");
        return files;
    }
}
