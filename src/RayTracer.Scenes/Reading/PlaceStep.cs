namespace RayTracer.Scenes;

/// <summary>One step to a <see cref="PropertyPlace"/>.</summary>
/// <param name="Key">The key.</param>
/// <param name="Index">The number of an element of a list, from 0; null for a key.</param>
/// <param name="IsNamed">Whether the path calls that element by its name.</param>
internal readonly record struct PlaceStep(string Key, int? Index, bool IsNamed);
