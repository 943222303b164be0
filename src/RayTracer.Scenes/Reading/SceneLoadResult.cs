using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.Scenes;

/// <summary>The result of loading a scene file.</summary>
/// <param name="Scene">The scene, ready to be rendered; null where any diagnostic is an error.</param>
/// <param name="Description">The scene's description; null where any diagnostic of reading it is an error.</param>
/// <param name="Diagnostics">What is wrong, by position.</param>
public sealed record SceneLoadResult(Scene? Scene, SceneDescription? Description, IReadOnlyList<Diagnostic> Diagnostics);
