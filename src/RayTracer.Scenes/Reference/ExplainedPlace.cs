using RayTracer.Description;

namespace RayTracer.Scenes;

/// <summary>A place in scene files, as <see cref="SceneExplanation"/> finds it.</summary>
/// <param name="Path">How it is written.</param>
/// <param name="Parameter">The parameter that stands there; null where it is a type.</param>
/// <param name="Types">The types of things that may stand there, or in its elements.</param>
/// <param name="HasNames">Whether a name or number comes before their keys.</param>
internal sealed record ExplainedPlace(string Path, RecordParameter? Parameter, IReadOnlyList<RecordType> Types, bool HasNames);
