using RayTracer.Numerics;

namespace RayTracer.Lights;

/// <summary>Rays that meet a light by chance.</summary>
public struct LightHitW
{
    /// <summary>The lit points, where the rays start.</summary>
    public Vec3W From;

    /// <summary>Unit normals there, by which one light of many is chosen; zero where all directions count.</summary>
    public Vec3W FromNormal;

    /// <summary>Unit directions of the rays.</summary>
    public Vec3W Direction;

    /// <summary>Lengths of the rays.</summary>
    public FloatW Distance;

    /// <summary>Cosines between the light's outward normal and the way back; not positive where it is met from behind.</summary>
    public FloatW Cosine;

    /// <summary>Times in seconds; used only where something moves.</summary>
    public FloatW Time;

    /// <summary>The primitives met.</summary>
    public UIntW Primitive;
}
