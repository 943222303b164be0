using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Scenes;

namespace RayTracer.Session;

/// <summary>One way of moving a thing: by a vector, about an axis, by factors, or by a matrix.</summary>
internal abstract record Movement
{
    /// <summary>The map.</summary>
    public abstract Transform Map { get; }

    /// <summary>The same movement as it is seen in a space that a map takes to the space in which this is one.</summary>
    public abstract Movement Within(Transform outer);

    /// <summary>That by a map: by a vector where that is all that it does.</summary>
    public static Movement Of(Transform map) => map is { X: { A: 1, B: 0, C: 0 }, Y: { A: 0, B: 1, C: 0 }, Z: { A: 0, B: 0, C: 1 } }
        ? new Translation(new((float)map.X.D, (float)map.Y.D, (float)map.Z.D)) : new Matrix(map);

    /// <summary>The numbers of a map, row by row.</summary>
    protected static Movement Conjugate(Transform map, Transform outer) => new Matrix(outer.Inverse() * map * outer);

    /// <summary>By a vector.</summary>
    public sealed record Translation(Vector3 By) : Movement
    {
        public override Transform Map => Transform.Translation(By);

        public override Movement Within(Transform outer) => new Translation(outer.Inverse().Vector(By));
    }

    /// <summary>About an axis through a point, in degrees.</summary>
    public sealed record Rotation(Vector3 Axis, float Degrees, Vector3 Center) : Movement
    {
        public override Transform Map => About(Transform.Rotation(Axis, Degrees), Center);

        // A mirrored space turns the other way round.
        public override Movement Within(Transform outer) => outer.UniformScale() is null
            ? Conjugate(Map, outer)
            : new Rotation(outer.Inverse().Vector(Axis).Unit(), outer.Determinant < 0 ? -Degrees : Degrees, outer.Inverse().Point(Center));
    }

    /// <summary>By factors along the axes, from a point.</summary>
    public sealed record Scaling(Vector3 Factors, Vector3 Center) : Movement
    {
        public override Transform Map => About(Transform.Scaling(Factors), Center);

        public bool IsUniform => Factors.X == Factors.Y && Factors.Y == Factors.Z;

        public override Movement Within(Transform outer)
        {
            bool isStraight = outer is { X: { B: 0, C: 0 }, Y: { A: 0, C: 0 }, Z: { A: 0, B: 0 } };
            return isStraight || IsUniform ? new Scaling(Factors, outer.Inverse().Point(Center)) : Conjugate(Map, outer);
        }
    }

    /// <summary>By any map.</summary>
    public sealed record Matrix(Transform By) : Movement
    {
        public override Transform Map => By;

        public override Movement Within(Transform outer) => Conjugate(By, outer);
    }

    private static Transform About(Transform linear, Vector3 center) =>
        Transform.Translation(center) * linear * Transform.Translation(-center);
}
