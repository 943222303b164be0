using RayTracer.Numerics;

namespace RayTracer.Lights;

/// <summary>Rays that leave light sources: the starts of light paths.</summary>
internal struct EmittedW
{
    /// <summary>What <see cref="Primitive"/> is where the light has no surface.</summary>
    public const uint NoPrimitive = uint.MaxValue;

    /// <summary>
    /// The points where they start: on the light, moved off it as rays that leave a surface are; for lights infinitely far away, on a disk
    /// outside of the scene (<see cref="SceneBall"/>).
    /// </summary>
    public Vec3W Origin;

    /// <summary>Unit directions in which the light travels.</summary>
    public Vec3W Direction;

    /// <summary>Outward unit normals of the light there; zero for a point; <see cref="Direction"/> for lights infinitely far away.</summary>
    public Vec3W Normal;

    /// <summary>Radiance · <see cref="Cosine"/> / (<see cref="PointPdf"/> · <see cref="DirectionPdf"/>): the mean over all rays is the light's power.</summary>
    public RgbW Power;

    /// <summary>The density per area with which the point was chosen: of the light, or of the disk; 1 where the light is a point.</summary>
    public FloatW PointPdf;

    /// <summary>The density per steradian with which the direction was chosen, once the point was; 1 where there is a single one.</summary>
    public FloatW DirectionPdf;

    /// <summary>The cosine between normal and direction; 1 for points and for lights infinitely far away.</summary>
    public FloatW Cosine;

    /// <summary>The primitives of the scene that the rays leave; <see cref="NoPrimitive"/> where there is none.</summary>
    public UIntW Primitive;

    /// <summary>The instances from whose surfaces they start; 0 for none.</summary>
    public UIntW Instance;

    /// <summary>Where that is in the instance's space, as <see cref="Rendering.PathStream.SetStart"/> takes it.</summary>
    public Vec3W InnerOrigin;

    /// <summary>The lanes in which there is light.</summary>
    public MaskW Exists;

    /// <summary>Rays that leave no surface, of which the origins are still to be set.</summary>
    /// <param name="direction">Unit directions in which the light travels.</param>
    /// <param name="pdf">The density per steradian of these.</param>
    /// <param name="power">The power.</param>
    /// <param name="ray">The rays, whose points have a density of 1.</param>
    public static void OfDirection(in Vec3W direction, in FloatW pdf, in RgbW power, out EmittedW ray)
    {
        ray = default;
        ray.Direction = direction;
        ray.Primitive = NoPrimitive;
        ray.PointPdf = ray.Cosine = 1f;
        ray.Brings(power, pdf);
    }

    /// <summary>Sets the power and the density of the direction, and whether there is light.</summary>
    public void Brings(in RgbW power, in FloatW directionPdf)
    {
        (Power, DirectionPdf) = (power, directionPdf);
        Exists = (power.R + power.G + power.B > 0f) & (directionPdf > 0f) & (PointPdf > 0f);
    }

    /// <summary>Takes some lanes of other rays.</summary>
    public void Take(in MaskW lanes, in EmittedW other)
    {
        Origin = lanes.Select(other.Origin, Origin);
        Direction = lanes.Select(other.Direction, Direction);
        Normal = lanes.Select(other.Normal, Normal);
        Power = lanes.Select(other.Power, Power);
        PointPdf = lanes.Select(other.PointPdf, PointPdf);
        DirectionPdf = lanes.Select(other.DirectionPdf, DirectionPdf);
        Cosine = lanes.Select(other.Cosine, Cosine);
        Primitive = lanes.Select(other.Primitive, Primitive);
        Instance = lanes.Select(other.Instance, Instance);
        InnerOrigin = lanes.Select(other.InnerOrigin, InnerOrigin);
        Exists = lanes.Select(other.Exists, Exists);
    }
}
