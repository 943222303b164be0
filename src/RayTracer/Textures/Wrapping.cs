using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>The continuation of a texture outside its picture.</summary>
public enum Wrapping
{
    /// <summary>The picture again and again.</summary>
    Repeat,

    /// <summary>The texels of its edge.</summary>
    Clamp,

    /// <summary>The picture and its mirror image in turn.</summary>
    Mirror,
}

/// <summary>What a wrapping makes of indices.</summary>
internal static class WrappedIndex
{
    /// <summary>The index within the picture or grid that stands for one anywhere; of <see cref="Wrapping.Clamp"/>, as it is, to be clamped by the caller.</summary>
    /// <param name="wrapping">The continuation.</param>
    /// <param name="i">Whole numbers.</param>
    /// <param name="n">The number of texels or points.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Index(this Wrapping wrapping, FloatW i, int n)
    {
        switch (wrapping)
        {
            case Wrapping.Repeat:
                return FloatW.NegatedMultiplyAdd(FloatW.Floor(i / n), n, i);
            case Wrapping.Mirror:
                FloatW inPair = FloatW.NegatedMultiplyAdd(FloatW.Floor(i / (2f * n)), 2f * n, i);
                return FloatW.Min(inPair, (2 * n) - 1 - inPair);
            default:
                return i;
        }
    }
}
