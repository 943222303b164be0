namespace RayTracer.Scenes;

/// <summary>One step of a <see cref="PropertyPath"/>.</summary>
/// <param name="Key">The key or name; the digits of a number.</param>
/// <param name="Index">The number of an element in brackets, from 0; null for a key or name.</param>
/// <param name="Start">Where it begins in the path's text.</param>
/// <param name="End">Where it ends.</param>
internal readonly record struct PathStep(string Key, int? Index, int Start, int End);
