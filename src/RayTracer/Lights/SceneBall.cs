using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Lights;

/// <summary>
/// The ball around everything in a scene that has an end. Light from infinitely far away starts on a disk that touches the ball and is
/// perpendicular to the light, so that every ray which meets the ball starts on its disk. What lies outside of the cylinder behind the disk,
/// as most of an infinite plane does, cannot be reached by such rays.
/// </summary>
internal sealed class SceneBall
{
    // Beyond what a point on the ball is rounded by.
    private const float Slack = 1 + 1e-4f;
    private readonly float _radius;

    /// <summary>Makes the ball around a box.</summary>
    /// <param name="box">The box around all that has an end; where there is nothing, so is no light.</param>
    public SceneBall(in Bounds box)
    {
        Center = box.IsFinite ? (0.5f * box.Minimum) + (0.5f * box.Maximum) : default;
        float radius = box.IsFinite ? ((0.5f * box.Maximum) - (0.5f * box.Minimum)).Norm() * Slack : 0;
        _radius = float.IsFinite(float.Pi * radius * radius) ? radius : 0;
    }

    /// <summary>The middle.</summary>
    public Vector3 Center { get; }

    /// <summary>The area of the disk.</summary>
    public float Area => float.Pi * _radius * _radius;

    /// <summary>Light that travels in given directions, from points that are uniform on the disks.</summary>
    /// <param name="direction">The unit directions.</param>
    /// <param name="pdf">The density per steradian with which they were chosen.</param>
    /// <param name="irradiance">Radiance over this density: what a surface receives that faces the light.</param>
    /// <param name="u">First random number.</param>
    /// <param name="v">Second random number.</param>
    /// <param name="ray">The rays.</param>
    public void Emit(in Vec3W direction, in FloatW pdf, in RgbW irradiance, in FloatW u, in FloatW v, out EmittedW ray)
    {
        Warp.ConcentricDisk(u, v, out FloatW x, out FloatW y);
        Onb.FromNormal(direction, out Onb frame);
        EmittedW.OfDirection(direction, pdf, irradiance * Area, out ray);
        ray.Origin = frame.ToWorld(new(x * _radius, y * _radius, -_radius)) + Center;
        ray.Normal = direction;
        ray.PointPdf = 1 / Area;
    }

    /// <summary>The density, per area of the disk, of the ray that arrives at a point; zero where none does.</summary>
    /// <param name="point">The points.</param>
    /// <param name="direction">The unit directions in which the light travels.</param>
    public FloatW PointPdf(in Vec3W point, in Vec3W direction)
    {
        Vec3W fromCenter = point - Center;
        FloatW along = Vec3W.Dot(fromCenter, direction);
        Vec3W across = Vec3W.NegatedMultiplyAdd(direction, along, fromCenter);
        MaskW isCovered = (Vec3W.Dot(across, across) <= _radius * _radius) & (along >= -_radius);
        return isCovered.Select(1 / Area, 0f);
    }
}
