using RayTracer.Rendering;

namespace RayTracer.Jobs;

/// <summary>The name of the program in files.</summary>
public static class ProgramName
{
    /// <summary>Its name and version.</summary>
    public static string Text { get; } = $"raytracer {typeof(Film).Assembly.GetName().Version!.ToString(3)}";
}
