using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace RayTracer.Numerics;

/// <summary>One truth value a lane: all bits set, or none.</summary>
public readonly struct MaskW
{
    /// <summary>The register.</summary>
    public readonly Vector<int> V;

    /// <summary>Wraps a register whose lanes are 0 or −1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MaskW(Vector<int> v) => V = v;

    /// <summary>True in every lane.</summary>
    public static MaskW All
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector<int>.AllBitsSet);
    }

    /// <summary>True in no lane.</summary>
    public static MaskW None
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector<int>.Zero);
    }

    /// <summary>One bit a lane, lane 0 lowest.</summary>
    public uint Bits
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Vector<int>.Count switch
        {
            8 => V.AsVector256().ExtractMostSignificantBits(),
            16 => (uint)V.AsVector512().ExtractMostSignificantBits(),
            _ => V.AsVector128().ExtractMostSignificantBits(),
        };
    }

    /// <summary>True where any lane is true.</summary>
    public bool Any
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Bits != 0;
    }

    /// <summary>True in the first <paramref name="n"/> lanes (all of them where there are no more).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static MaskW First(int n) => new(Vector.LessThan(Vector.CreateSequence(0, 1), new Vector<int>(n)));

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static MaskW operator &(MaskW a, MaskW b) => new(a.V & b.V);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static MaskW operator |(MaskW a, MaskW b) => new(a.V | b.V);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static MaskW operator ~(MaskW a) => new(~a.V);

    /// <summary>True here and not in <paramref name="b"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MaskW Except(MaskW b) => new(Vector.AndNot(V, b.V));

    /// <summary><paramref name="a"/> where true, else <paramref name="b"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public FloatW Select(FloatW a, FloatW b)
    {
        // One blend instruction instead of and, and-not, or.
        if (Vector<float>.Count == 8 && Avx.IsSupported)
        {
            return new(Avx.BlendVariable(b.V.AsVector256(), a.V.AsVector256(), V.AsVector256().AsSingle()).AsVector());
        }

        return new(Vector.ConditionalSelect(V, a.V, b.V));
    }

    /// <summary><paramref name="a"/> where true, else <paramref name="b"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public UIntW Select(UIntW a, UIntW b) => Select(a.AsFloat(), b.AsFloat()).AsUInt();

    /// <summary><paramref name="a"/> where true, else <paramref name="b"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public MaskW Select(MaskW a, MaskW b) => new(Vector.ConditionalSelect(V, a.V, b.V));

    /// <summary><paramref name="a"/> where true, else <paramref name="b"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vec3W Select(in Vec3W a, in Vec3W b) => new(Select(a.X, b.X), Select(a.Y, b.Y), Select(a.Z, b.Z));

    /// <summary><paramref name="a"/> where true, else <paramref name="b"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public RgbW Select(in RgbW a, in RgbW b) => new(Select(a.R, b.R), Select(a.G, b.G), Select(a.B, b.B));
}
