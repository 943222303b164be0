using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Description;

/// <summary>A map that an editor works into the numbers of a <see cref="ShapeDescription"/>.</summary>
/// <param name="Map">The map.</param>
/// <param name="ShowsUv">Whether a texture shows how uv lies on the surface.</param>
public readonly record struct ShapeMove(Transform Map, bool ShowsUv)
{
    /// <summary>True where the axes keep their directions.</summary>
    public bool KeepsAxes => Map.KeepsAxes;

    /// <summary>The factor on all lengths; null where there is none, or where the uv of what is round would be turned.</summary>
    public float? RoundScale => ShowsUv && !KeepsAxes ? null : (float?)Map.UniformScale();

    /// <summary>True where the map mirrors.</summary>
    public bool Mirrors => Map.Determinant < 0;

    /// <summary>The image of a point.</summary>
    public Vector3 Point(Vector3 point) => Map.Point(point);

    /// <summary>The image of a difference of points.</summary>
    public Vector3 Vector(Vector3 vector) => Map.Vector(vector);

    /// <summary>The image of a direction of any length: its text stays unchanged if it still points there.</summary>
    public Vector3 Direction(Vector3 written) => Kept(written, Map.Vector(written).Unit());

    /// <summary>The image of a normal, of any length: its text stays unchanged if it still points there.</summary>
    public Vector3 Normal(Vector3 written) => Kept(written, Map.Inverse().TransposedVector(written).Unit());

    private static Vector3 Kept(Vector3 written, Vector3 moved) => (written.Unit() - moved).Norm() < 1e-6f ? written : moved;
}
