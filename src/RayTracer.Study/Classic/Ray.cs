using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Study;

/// <summary>One ray, for code that follows one at a time.</summary>
/// <param name="Origin">The point from which it starts.</param>
/// <param name="Direction">The direction; distances are in units of its length.</param>
internal readonly record struct Ray(Vector3 Origin, Vector3 Direction)
{
    /// <summary>One over each coordinate of the direction; infinite where that is zero.</summary>
    public Vector3 Inverse { get; } = new(1 / Direction.X, 1 / Direction.Y, 1 / Direction.Z);

    /// <summary>
    /// The part of the ray that lies in a box, by its three pairs of planes (Kay &amp; Kajiya 1986); begins after its end where there is
    /// none.
    /// </summary>
    /// <param name="minimum">The box's corner of the smallest coordinates.</param>
    /// <param name="maximum">The box's corner of the largest coordinates.</param>
    public (float Begin, float End) Within(Vector3 minimum, Vector3 maximum)
    {
        float begin = 0;
        float end = float.PositiveInfinity;
        for (int axis = 0; axis < 3; axis++)
        {
            // A ray along a plane has no distance to it (0/0): then the plane does not shorten it.
            float one = (minimum[axis] - Origin[axis]) * Inverse[axis];
            float other = (maximum[axis] - Origin[axis]) * Inverse[axis];
            float near = one < other ? one : other;
            float far = one < other ? other : one;
            begin = near > begin ? near : begin;
            end = far < end ? far : end;
        }

        return (begin, end * (1 + Slack));
    }

    // What the roundings of a difference and a product may shorten.
    internal const float Slack = 4 * 1.1920929e-7f;
}
