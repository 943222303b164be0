using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Lights;

/// <summary>
/// A picture through which a light at a point shines, as a slide stands before a lamp: a rectangle at distance 1, across the light's direction.
/// Its uv are those of a picture as somebody sees it on a wall who stands beside the light.
/// </summary>
/// <param name="picture">The picture, of which what lies between 0 and 1 in uv is used.</param>
/// <param name="axis">The unit direction in which the light shines, in its space.</param>
/// <param name="up">What is upwards in the picture, roughly: not along the axis.</param>
/// <param name="halfWidth">Half of the rectangle's width.</param>
/// <param name="halfHeight">Half of its height.</param>
/// <param name="motion">The motion of the light's space in the world.</param>
internal sealed unsafe class PicturePlane(Texture picture, Vector3 axis, Vector3 up, float halfWidth, float halfHeight, Motion motion)
{
    // Along each side, where the mean is measured.
    private const int Points = 64;

    // cos³ underflows beyond that, where nothing is seen of a rectangle anyway.
    private const float LeastCosine = 1e-6f;

    private readonly bool _moves = !motion.IsStill;
    private readonly (Vector3 Right, Vector3 Top) _sides = Sides(motion.At(0), axis, up);

    /// <summary>The rectangle's area.</summary>
    public float Area { get; } = 4 * halfWidth * halfHeight;

    /// <summary>The mean luminance of the picture, times the weight of each place.</summary>
    /// <param name="weigh">The weight of a place, by the cosine there between the axis and the direction to it.</param>
    public float Mean(Func<float, float> weigh)
    {
        double sum = 0;
        for (int i = 0; i < Points * Points; i++)
        {
            (float u, float v) = (((i % Points) + 0.5f) / Points, ((i / Points) + 0.5f) / Points);
            picture.Evaluate(u, v, out RgbW color);
            (float x, float y) = (((2 * u) - 1) * halfWidth, ((2 * v) - 1) * halfHeight);
            Rgb shown = new(color.R[0], color.G[0], color.B[0]);
            sum += float.Max(shown.Luminance, 0) * weigh(1 / float.Sqrt(1 + (x * x) + (y * y)));
        }

        return (float)(sum / (Points * Points));
    }

    /// <summary>The unit direction through a place of the rectangle.</summary>
    /// <param name="u">First coordinate of the place.</param>
    /// <param name="v">Second coordinate.</param>
    /// <param name="time">The times in seconds; used only where the light moves.</param>
    /// <param name="along">The direction of the light, in the world.</param>
    public Vec3W Direction(in FloatW u, in FloatW v, in FloatW time, in Vec3W along)
    {
        Frame(time, along, out Vec3W right, out Vec3W top);
        FloatW x = FloatW.MultiplyAdd(u, 2 * halfWidth, -halfWidth);
        FloatW y = FloatW.MultiplyAdd(v, 2 * halfHeight, -halfHeight);
        return Vec3W.Normalize(Vec3W.MultiplyAdd(right, x, Vec3W.MultiplyAdd(top, y, along)));
    }

    /// <summary>What is seen of the picture in a direction.</summary>
    /// <param name="direction">Unit directions away from the light.</param>
    /// <param name="time">The times in seconds; used only where the light moves.</param>
    /// <param name="along">The direction of the light, in the world.</param>
    /// <param name="color">The picture's colour; black beside it.</param>
    /// <param name="cosine">The cosine between the two directions.</param>
    public void Look(in Vec3W direction, in FloatW time, in Vec3W along, out RgbW color, out FloatW cosine)
    {
        Frame(time, along, out Vec3W right, out Vec3W top);
        cosine = Vec3W.Dot(direction, along);
        FloatW far = 1f / FloatW.Max(cosine, LeastCosine);
        FloatW u = FloatW.MultiplyAdd(Vec3W.Dot(direction, right) * far, 0.5f / halfWidth, 0.5f);
        FloatW v = FloatW.MultiplyAdd(Vec3W.Dot(direction, top) * far, 0.5f / halfHeight, 0.5f);
        MaskW isWithin = (cosine > LeastCosine) & (u >= 0f) & (u <= 1f) & (v >= 0f) & (v <= 1f);
        picture.Evaluate(isWithin.Select(u, 0f), isWithin.Select(v, 0f), out RgbW there);
        RgbW light = new(FloatW.Max(there.R, 0f), FloatW.Max(there.G, 0f), FloatW.Max(there.B, 0f));
        color = isWithin.Select(light, default);
    }

    /// <summary>The density, per steradian, of a direction through a place that is uniform in the rectangle; 0 beside it.</summary>
    /// <param name="direction">Unit directions away from the light.</param>
    /// <param name="time">The times in seconds; used only where the light moves.</param>
    /// <param name="along">The direction of the light, in the world.</param>
    public FloatW Pdf(in Vec3W direction, in FloatW time, in Vec3W along)
    {
        Frame(time, along, out Vec3W right, out Vec3W top);
        FloatW cosine = Vec3W.Dot(direction, along);
        MaskW isWithin = (cosine > LeastCosine) & (FloatW.Abs(Vec3W.Dot(direction, right)) <= cosine * (halfWidth * 1.00001f))
            & (FloatW.Abs(Vec3W.Dot(direction, top)) <= cosine * (halfHeight * 1.00001f));
        return isWithin.Select(1f / (cosine * cosine * cosine * Area), 0f);
    }

    // In the world, both across the axis. A map that mirrors mirrors the picture.
    private static (Vector3 Right, Vector3 Top) Sides(in Transform place, Vector3 axis, Vector3 up)
    {
        Vector3 across = axis.Cross(up).Unit();
        Vector3 along = place.Vector(axis).Unit();
        Vector3 right = place.Vector(across);
        right = (right - (along * along.Dot(right))).Unit();
        Vector3 top = right.Cross(along);
        return (right, top.Dot(place.Vector(across.Cross(axis))) < 0 ? -top : top);
    }

    private void Frame(in FloatW time, in Vec3W along, out Vec3W right, out Vec3W top)
    {
        (right, top) = (_sides.Right, _sides.Top);
        if (_moves)
        {
            FrameAt(time, along, out right, out top);
        }
    }

    private void FrameAt(in FloatW time, in Vec3W along, out Vec3W right, out Vec3W top)
    {
        float* memory = stackalloc float[InstanceMaps.Floats];
        InstanceMaps maps = new(memory);
        maps.Fill(motion, time);
        Vector3 across = axis.Cross(up).Unit();
        Vec3W mapped = maps.Vector(across);
        right = Vec3W.Normalize(mapped - (along * Vec3W.Dot(along, mapped)));
        top = Vec3W.Cross(right, along);
        MaskW isMirrored = Vec3W.Dot(top, maps.Vector(across.Cross(axis))) < 0f;
        top = isMirrored.Select(-top, top);
    }
}
