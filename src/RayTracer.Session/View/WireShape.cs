using System.Numerics;

namespace RayTracer.Session;

/// <summary>A thing as lines.</summary>
/// <param name="Pointer">The thing in the text; null where it is not from the text.</param>
/// <param name="Lines">Lines of points, in the world.</param>
public sealed record WireShape(string? Pointer, IReadOnlyList<IReadOnlyList<Vector3>> Lines);
