using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>The input of a tree's construction: a primitive's box, and its number in the fourth lane of the lower corner.</summary>
internal struct PrimitiveReference
{
    // Numbers are stored as ordinary floats, so that no processor stumbles over denormal ones.
    private const int Bias = 0x3F800000;

    /// <summary>Lower corner, and the number.</summary>
    public Vector128<float> Lower;

    /// <summary>Upper corner.</summary>
    public Vector128<float> Upper;

    /// <summary>Number of the primitive.</summary>
    public readonly int Number => Lower.AsInt32()[3] - Bias;

    /// <summary>Twice the middle of the box.</summary>
    public readonly Vector128<float> Middle
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Lower + Upper;
    }

    /// <summary>Refers to a primitive.</summary>
    public static PrimitiveReference Of(in Box4 box, int number) => new()
    {
        Lower = box.Lower.AsInt32().WithElement(3, number + Bias).AsSingle(),
        Upper = box.Upper,
    };
}
