using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Lab8;

/// <summary>Eight vectors at once: all x beside each other in one register, then all y, then all z. The place in a register is called a lane.</summary>
public readonly record struct Vectors(Vector256<float> X, Vector256<float> Y, Vector256<float> Z)
{
    /// <summary>The same vector in all lanes.</summary>
    public static Vectors All(float x, float y, float z) => new(Vector256.Create(x), Vector256.Create(y), Vector256.Create(z));

    /// <summary>Eight differences.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vectors operator -(in Vectors a, in Vectors b) => new(a.X - b.X, a.Y - b.Y, a.Z - b.Z);

    /// <summary>Eight products of two vectors.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Dot(in Vectors a, in Vectors b)
    {
        //? Vectors.Dot: x · x + y · y + z · z in each lane, in the order of Scalar.Dot.
        return (a.X * b.X) + (a.Y * b.Y) + (a.Z * b.Z);
        //!
    }
}
