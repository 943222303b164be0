using System.Numerics;
using RayTracer.Adapters;
using RayTracer.Description;
using RayTracer.Textbook;
using Vector = RayTracer.Textbook.Vector;

namespace RayTracer.StudentPlugin;

/// <summary>Describes <see cref="OwnBall"/>.</summary>
[SceneType("ownBall", "A ball around a point.")]
public sealed record OwnBallDescription : TextbookShapeDescription
{
    /// <summary>Its middle.</summary>
    [Parameter("Its middle.", Unit = "scene units")]
    public Vector3 Center { get; init; }

    /// <summary>From the middle to the surface.</summary>
    [Parameter("From the middle to the surface.", Unit = "scene units", Minimum = 0, MinimumIsExclusive = true)]
    public float Radius { get; init; } = 1;

    /// <inheritdoc/>
    public override IShape Make() => new OwnBall(Center, Radius);
}

/// <summary>A ball, met by geometry: the point of the ray nearest to the middle, and half a chord before and behind it.</summary>
/// <param name="middle">The middle.</param>
/// <param name="radius">The radius.</param>
public sealed class OwnBall(Vector middle, double radius) : IShape
{
    /// <inheritdoc/>
    public Bounds Bounds { get; } = new(middle - new Vector(radius, radius, radius), middle + new Vector(radius, radius, radius));

    /// <inheritdoc/>
    public double Area => 4 * Math.PI * radius * radius;

    /// <inheritdoc/>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        double length = ray.Direction.Length;
        Vector direction = ray.Direction * (1 / length);
        double along = Vector.Dot(middle - ray.Origin, direction);
        Vector nearest = ray.Origin + (along * direction) - middle;
        double chord2 = (radius * radius) - Vector.Dot(nearest, nearest);
        if (chord2 < 0)
        {
            return false;
        }

        double half = Math.Sqrt(chord2);
        double t = (along > half ? along - half : along + half) / length;
        if (t <= 0 || t >= hit.Distance)
        {
            return false;
        }

        hit.Distance = t;
        return true;
    }

    /// <inheritdoc/>
    public void Describe(in Ray ray, ref Hit hit)
    {
        hit.Normal = hit.Shading = (ray.At(hit.Distance) - middle).Unit;
        hit.Point = middle + (radius * hit.Normal);
        (hit.U, hit.V) = (0.5 + (Math.Atan2(hit.Normal.X, hit.Normal.Z) / (2 * Math.PI)), Math.Acos(-hit.Normal.Y) / Math.PI);
    }

    /// <inheritdoc/>
    public SurfacePoint PointAt((double U, double V) random)
    {
        Vector normal = Warp.Sphere(random);
        return new(middle + (radius * normal), normal, 0, 0, 1 / Area);
    }
}
