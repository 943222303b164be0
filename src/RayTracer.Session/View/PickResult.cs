using System.Numerics;

namespace RayTracer.Session;

/// <summary>What is seen at a pixel.</summary>
/// <param name="Pointer">The thing in the text; null where nothing is seen.</param>
/// <param name="Distance">How far away; null where nothing is seen.</param>
/// <param name="Position">Where, in the world.</param>
/// <param name="Normal">The normal there, towards the camera.</param>
/// <param name="Material">The thing's material in the text; null where it is not from the text.</param>
public sealed record PickResult(string? Pointer, float? Distance, Vector3? Position, Vector3? Normal, string? Material);
