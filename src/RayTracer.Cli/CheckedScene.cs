using RayTracer.Scenes;

namespace RayTracer.Cli;

/// <summary>What is wrong with a scene file.</summary>
/// <param name="Path">The file.</param>
/// <param name="Diagnostics">All that is wrong, by position.</param>
/// <param name="Status">One of <see cref="ExitStatus"/>.</param>
internal sealed record CheckedScene(string Path, IReadOnlyList<Diagnostic> Diagnostics, int Status);
