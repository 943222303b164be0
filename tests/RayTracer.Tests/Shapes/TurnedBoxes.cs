using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Tests.Shapes;

/// <summary>Makes boxes that stand askew.</summary>
internal static class TurnedBoxes
{
    /// <summary>A box turned about its middle.</summary>
    public static TurnedBox Make(Material material, Vector3 center, Vector3 axis, float degrees, Vector3 half)
    {
        Box box = new(material, "", -half, half);
        return (TurnedBox)box.Transformed(Transform.Translation(center) * Transform.Rotation(axis, degrees))!;
    }
}
