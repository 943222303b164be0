using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace RayTracer.Numerics;

/// <summary>One register of unsigned 32-bit integers, one lane a light path. Arithmetic wraps modulo 2³².</summary>
public readonly unsafe struct UIntW
{
    /// <summary>The register.</summary>
    public readonly Vector<uint> V;

    /// <summary>Wraps a register.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public UIntW(Vector<uint> v) => V = v;

    /// <summary>0, 1, 2 … along the lanes.</summary>
    public static UIntW Iota
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector.CreateSequence(0u, 1u));
    }

    /// <summary>The value of one lane: for tests and for the rare scalar step.</summary>
    public uint this[int lane]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => V[lane];
    }

    /// <summary>The same number in every lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator UIntW(uint u) => new(new Vector<uint>(u));

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW operator +(UIntW a, UIntW b) => new(a.V + b.V);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW operator -(UIntW a, UIntW b) => new(a.V - b.V);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW operator *(UIntW a, UIntW b) => new(a.V * b.V);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW operator ^(UIntW a, UIntW b) => new(a.V ^ b.V);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW operator &(UIntW a, UIntW b) => new(a.V & b.V);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW operator |(UIntW a, UIntW b) => new(a.V | b.V);

    /// <summary>Shifts right; zeros come in.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW operator >>(UIntW a, int n) => new(a.V >> n);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW operator <<(UIntW a, int n) => new(a.V << n);

    /// <summary>True where the lanes are equal.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static MaskW Equal(UIntW a, UIntW b) => new(Vector.AsVectorInt32(Vector.Equals(a.V, b.V)));

    /// <summary>Unsigned comparison.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static MaskW operator <(UIntW a, UIntW b) => new(Vector.AsVectorInt32(Vector.LessThan(a.V, b.V)));

    /// <summary>Unsigned comparison.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static MaskW operator >(UIntW a, UIntW b) => b < a;

    /// <summary>The same bits read as floats.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public FloatW AsFloat() => new(Vector.AsVectorSingle(V));

    /// <summary>The number, read as a signed integer, as a float (rounded to nearest).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public FloatW ToFloat() => new(Vector.ConvertToSingle(Vector.AsVectorInt32(V)));

    /// <summary>The top 24 bits as a fraction in [0, 1): random bits become a uniform random number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public FloatW ToUnit() => (this >> 8).ToFloat() * (1f / 16777216f);

    /// <summary>True where the highest binary digit is one.</summary>
    public MaskW TopDigit
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector.AsVectorInt32(V) >> 31);
    }

    /// <summary>Bit 0 becomes bit 31 and so on: the digits of an index become those of a fraction.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public UIntW ReverseBits()
    {
        if (Vector<uint>.Count == 16 && Gfni.V512.IsSupported && Avx512BW.IsSupported)
        {
            Vector512<byte> reversed = Gfni.V512.GaloisFieldAffineTransform(V.AsVector512().AsByte(), Vector512.Create(BitReversal).AsByte(), 0);
            return new(Avx512BW.Shuffle(reversed, Vector512.Create(ByteReversal)).AsUInt32().AsVector());
        }

        if (Vector<uint>.Count == 8 && Gfni.V256.IsSupported && Avx2.IsSupported)
        {
            Vector256<byte> reversed = Gfni.V256.GaloisFieldAffineTransform(V.AsVector256().AsByte(), Vector256.Create(BitReversal).AsByte(), 0);
            return new(Avx2.Shuffle(reversed, Vector256.Create(ByteReversal)).AsUInt32().AsVector());
        }

        if (Vector<uint>.Count == 8 && Avx2.IsSupported)
        {
            Vector256<byte> v = V.AsVector256().AsByte();
            Vector256<byte> nibble = Vector256.Create((byte)0x0f);
            Vector256<byte> low = Avx2.Shuffle(Vector256.Create(NibbleReversal), v & nibble) << 4;
            Vector256<byte> high = Avx2.Shuffle(Vector256.Create(NibbleReversal), (v.AsUInt16() >> 4).AsByte() & nibble);
            return new(Avx2.Shuffle(low | high, Vector256.Create(ByteReversal)).AsUInt32().AsVector());
        }

        UIntW x = this;
        x = (x >> 1 & 0x55555555u) | (x & 0x55555555u) << 1;
        x = (x >> 2 & 0x33333333u) | (x & 0x33333333u) << 2;
        x = (x >> 4 & 0x0f0f0f0fu) | (x & 0x0f0f0f0fu) << 4;
        x = (x >> 8 & 0x00ff00ffu) | (x & 0x00ff00ffu) << 8;
        return x >> 16 | x << 16;
    }

    /// <summary>Loads as many integers as there are lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW Load(uint* from) => new(Vector.Load(from));

    /// <summary>Stores all lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(uint* to) => Unsafe.WriteUnaligned(to, V);

    /// <summary>table[index[0]], table[index[1]] … for indices that lie in memory.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW Pick(uint* table, uint* index) => FloatW.Pick((float*)table, index).AsUInt();

    /// <summary>table[index] for indices in a register, each below 2³¹.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static UIntW Gather(uint* table, UIntW index) => FloatW.Gather((float*)table, index).AsUInt();

    /// <summary>table[first] and table[first + 1], as <see cref="FloatW.Gather(float*, UIntW, out FloatW, out FloatW)"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Gather(uint* table, UIntW first, out UIntW a, out UIntW b)
    {
        FloatW.Gather((float*)table, first, out FloatW x, out FloatW y);
        (a, b) = (x.AsUInt(), y.AsUInt());
    }

    /// <summary>table[first], table[first + 1] and table[first + 2], as <see cref="FloatW.Gather(float*, UIntW, out FloatW, out FloatW, out FloatW)"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Gather(uint* table, UIntW first, out UIntW a, out UIntW b, out UIntW c)
    {
        FloatW.Gather((float*)table, first, out FloatW x, out FloatW y, out FloatW z);
        (a, b, c) = (x.AsUInt(), y.AsUInt(), z.AsUInt());
    }

    /// <summary>Stores the lanes whose bit is set, next to one another (see <see cref="FloatW.Compress"/>).</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Compress(uint* to, uint bits) => AsFloat().Compress((float*)to, bits);

    // The 8×8 bit matrix that reverses the bits of a byte, one byte a row.
    private const ulong BitReversal = 0x8040201008040201;

    private static ReadOnlySpan<byte> NibbleReversal =>
    [
        0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15, 0, 8, 4, 12, 2, 10, 6, 14, 1, 9, 5, 13, 3, 11, 7, 15,
    ];

    private static ReadOnlySpan<byte> ByteReversal =>
    [
        3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12, 3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12,
        3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12, 3, 2, 1, 0, 7, 6, 5, 4, 11, 10, 9, 8, 15, 14, 13, 12,
    ];
}
