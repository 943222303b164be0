using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Lights;

/// <summary>A picture of all directions around a light at a point.</summary>
/// <param name="picture">The picture.</param>
/// <param name="mapping">How it shows directions.</param>
/// <param name="motion">The motion of the light's space in the world.</param>
internal sealed unsafe class PictureSphere(Texture picture, DirectionMapping mapping, Motion motion)
{
    // Around, where the mean is measured, at as many heights.
    private const int Points = 96;
    private readonly bool _moves = !motion.IsStill;
    private readonly Transform _back = motion.At(0).Inverse();

    /// <summary>The mean luminance of the picture over all directions.</summary>
    public float Mean { get; } = MeanOf(picture, mapping);

    /// <summary>What the picture shows in a direction.</summary>
    /// <param name="direction">Unit directions away from the light, in the world.</param>
    /// <param name="time">The times in seconds; used only where the light moves.</param>
    /// <param name="color">The picture's colour.</param>
    public void Look(in Vec3W direction, in FloatW time, out RgbW color)
    {
        if (_moves)
        {
            float* memory = stackalloc float[InstanceMaps.Floats];
            InstanceMaps maps = new(memory);
            maps.FillBothWays(motion, time);
            Look(picture, mapping, Vec3W.Normalize(maps.VectorBack(direction)), out color);
            return;
        }

        Vec3W x = _back.Vector(Vector3.UnitX);
        Vec3W y = _back.Vector(Vector3.UnitY);
        Vec3W z = _back.Vector(Vector3.UnitZ);
        Look(picture, mapping, Vec3W.Normalize(Vec3W.MultiplyAdd(x, direction.X, Vec3W.MultiplyAdd(y, direction.Y, z * direction.Z))), out color);
    }

    private static void Look(Texture picture, DirectionMapping mapping, in Vec3W direction, out RgbW color)
    {
        DirectionMap.Find(mapping, direction, out FloatW u, out FloatW v);
        picture.Evaluate(u, v, out RgbW there);
        color = new(FloatW.Max(there.R, 0f), FloatW.Max(there.G, 0f), FloatW.Max(there.B, 0f));
    }

    private static float MeanOf(Texture picture, DirectionMapping mapping)
    {
        double sum = 0;
        for (int i = 0; i < Points * Points; i++)
        {
            float y = ((2 * ((i / Points) + 0.5f)) / Points) - 1;
            LaneMath.SinCosTurn(((i % Points) + 0.5f) / Points, out float sin, out float cos);
            float r = float.Sqrt(1 - (y * y));
            Look(picture, mapping, new(r * sin, y, r * cos), out RgbW color);
            sum += new Rgb(color.R[0], color.G[0], color.B[0]).Luminance;
        }

        return (float)(sum / (Points * Points));
    }
}
