using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>An axis-aligned box in two registers; the fourth lanes hold nothing of meaning.</summary>
internal struct Box4
{
    /// <summary>Lower corner.</summary>
    public Vector128<float> Lower;

    /// <summary>Upper corner.</summary>
    public Vector128<float> Upper;

    /// <summary>The box that holds nothing.</summary>
    public static Box4 Empty => new()
    {
        Lower = Vector128.Create(float.PositiveInfinity),
        Upper = Vector128.Create(float.NegativeInfinity),
    };

    /// <summary>Half the surface area.</summary>
    public readonly float HalfArea
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            Vector128<float> size = Upper - Lower;
            Vector128<float> faces = size * Vector128.Shuffle(size, Vector128.Create(1, 2, 0, 3));
            return (faces[0] + faces[1]) + faces[2];
        }
    }

    /// <summary>True where all coordinates are numbers within ±10¹⁸, so that products of four of them are finite or nearly so.</summary>
    public readonly bool IsBounded
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get
        {
            Vector128<float> limit = Vector128.Create(1e18f);
            Vector128<float> within = Vector128.LessThanOrEqual(Vector128.Abs(Lower), limit) & Vector128.LessThanOrEqual(Vector128.Abs(Upper), limit);
            return (within.ExtractMostSignificantBits() & 7) == 7;
        }
    }

    /// <summary>Grows to hold another box.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Grow(Vector128<float> lower, Vector128<float> upper)
    {
        Lower = Lanes8.Min(Lower, lower);
        Upper = Lanes8.Max(Upper, upper);
    }

    /// <summary>Grows to hold another box.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Grow(in Box4 other) => Grow(other.Lower, other.Upper);
}
