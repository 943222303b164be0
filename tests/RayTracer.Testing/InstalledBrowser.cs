namespace RayTracer.Testing;

/// <summary>The browser that walks and measurements of the Studio use.</summary>
public static class InstalledBrowser
{
    private static readonly string[] s_names = ["chromium", "chromium-browser", "google-chrome", "google-chrome-stable"];

    /// <summary>Why there is none.</summary>
    public static string WhyNot { get; } = $"no browser: none of {string.Join(", ", s_names)} is installed (RAYTRACER_BROWSER names another one)";

    /// <summary>The program that RAYTRACER_BROWSER names, or else Chromium or Chrome; null where there is none.</summary>
    public static string? Find() =>
        Environment.GetEnvironmentVariable("RAYTRACER_BROWSER") is { Length: > 0 } named ? named
            : s_names.SelectMany(name => (Environment.GetEnvironmentVariable("PATH") ?? "").Split(Path.PathSeparator).Select(folder => Path.Combine(folder, name))).FirstOrDefault(File.Exists);
}
