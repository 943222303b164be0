using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>The sampling shared by light sources whose points are chosen uniformly by area.</summary>
public static class AreaSample
{
    /// <summary>The density per steradian of a point that was chosen uniformly by area; zero from behind.</summary>
    /// <param name="distance">Distance to the point.</param>
    /// <param name="cosine">Cosine between the normal there and the way back.</param>
    /// <param name="area">The area.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Pdf(FloatW distance, FloatW cosine, FloatW area) => (cosine > 0f).Select(distance * distance / (cosine * area), 0f);

    /// <summary>A light sample from the vector to a point that was chosen uniformly by area.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Sample(in Vec3W to, in Vec3W normal, FloatW area, out ShapeSampleW sample)
    {
        FloatW distance2 = Vec3W.Dot(to, to);
        FloatW inverse = 1f / FloatW.Sqrt(distance2);
        sample.Direction = to * inverse;
        sample.Distance = distance2 * inverse;
        sample.Cosine = -Vec3W.Dot(sample.Direction, normal);
        sample.InversePdf = (sample.Cosine > 0f).Select(sample.Cosine * area * inverse * inverse, 0f);
        sample.U = sample.V = default;
    }
}
