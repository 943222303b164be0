using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>Where failed tests leave pictures.</summary>
public static class FailureFolder
{
    /// <summary>The folder that the environment variable <c>RAYTRACER_TEST_OUTPUT</c> names; without it, artifacts/test-failures in the project's folder, or else beside the tests.</summary>
    public static string Default => Environment.GetEnvironmentVariable("RAYTRACER_TEST_OUTPUT") is { Length: > 0 } chosen
        ? Path.GetFullPath(chosen)
        : Path.Combine(ProjectFolder.Found ?? AppContext.BaseDirectory, "artifacts", "test-failures");

    /// <summary>A test's folder: its name, less what file names should not have.</summary>
    internal static string Of(string name, string? output)
    {
        string safe = string.Concat(name.Select(c => char.IsLetterOrDigit(c) || c is '-' or '_' ? c : '_'));
        const int Longest = 100;
        return Path.Combine(output ?? Default, safe.Length == 0 ? "unnamed" : safe[..Math.Min(safe.Length, Longest)]);
    }

    internal static bool SameSize(IImageRows a, IImageRows b) => a.Width == b.Width && a.Height == b.Height;
}
