using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using System.Runtime.Intrinsics.X86;

namespace RayTracer.Numerics;

/// <summary>
/// One register of floats, one lane a light path. Arithmetic is IEEE 754 single precision, lane by lane, so a picture
/// has the same bits at every register width.
/// </summary>
public readonly unsafe struct FloatW
{
    /// <summary>The register.</summary>
    public readonly Vector<float> V;

    /// <summary>Wraps a register.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public FloatW(Vector<float> v) => V = v;

    /// <summary>Number of lanes: 4, 8 or 16, by the machine.</summary>
    public static int Count
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => Vector<float>.Count;
    }

    /// <summary>0, 1, 2 … along the lanes.</summary>
    public static FloatW Iota
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => new(Vector.CreateSequence(0f, 1f));
    }

    /// <summary>The value of one lane: for tests and for the rare scalar step.</summary>
    public float this[int lane]
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => V[lane];
    }

    /// <summary>The same number in every lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator FloatW(float f) => new(new Vector<float>(f));

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW operator +(FloatW a, FloatW b) => new(a.V + b.V);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW operator -(FloatW a, FloatW b) => new(a.V - b.V);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW operator *(FloatW a, FloatW b) => new(a.V * b.V);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW operator /(FloatW a, FloatW b) => new(a.V / b.V);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW operator -(FloatW a) => new(-a.V);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static MaskW operator <(FloatW a, FloatW b) => new(Vector.LessThan(a.V, b.V));

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static MaskW operator >(FloatW a, FloatW b) => new(Vector.GreaterThan(a.V, b.V));

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static MaskW operator <=(FloatW a, FloatW b) => new(Vector.LessThanOrEqual(a.V, b.V));

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static MaskW operator >=(FloatW a, FloatW b) => new(Vector.GreaterThanOrEqual(a.V, b.V));

    /// <summary>a·b + c with one rounding.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW MultiplyAdd(FloatW a, FloatW b, FloatW c) => new(Vector.FusedMultiplyAdd(a.V, b.V, c.V));

    /// <summary>c − a·b with one rounding.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW NegatedMultiplyAdd(FloatW a, FloatW b, FloatW c)
    {
        // One instruction; the compiler would spend another on the sign.
        if (Vector<float>.Count == 8 && Fma.IsSupported)
        {
            return new(Fma.MultiplyAddNegated(a.V.AsVector256(), b.V.AsVector256(), c.V.AsVector256()).AsVector());
        }

        if (Vector<float>.Count == 16 && Avx512F.IsSupported)
        {
            return new(Avx512F.FusedMultiplyAddNegated(a.V.AsVector512(), b.V.AsVector512(), c.V.AsVector512()).AsVector());
        }

        return new(Vector.FusedMultiplyAdd(-a.V, b.V, c.V));
    }

    /// <summary>The square root; NaN below zero.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Sqrt(FloatW a) => new(Vector.SquareRoot(a.V));

    /// <summary>Exactly a &lt; b ? a : b, so b where either is NaN or both are zeros.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Min(FloatW a, FloatW b)
    {
        // Vector.Min handles NaN in several instructions; the machine's own minimum is a < b ? a : b by definition.
        if (Vector<float>.Count == 8 && Avx.IsSupported)
        {
            return new(Avx.Min(a.V.AsVector256(), b.V.AsVector256()).AsVector());
        }

        if (Vector<float>.Count == 16 && Avx512F.IsSupported)
        {
            return new(Avx512F.Min(a.V.AsVector512(), b.V.AsVector512()).AsVector());
        }

        return new(Vector.ConditionalSelect(Vector.LessThan(a.V, b.V), a.V, b.V));
    }

    /// <summary>Exactly a &gt; b ? a : b, so b where either is NaN or both are zeros.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Max(FloatW a, FloatW b)
    {
        if (Vector<float>.Count == 8 && Avx.IsSupported)
        {
            return new(Avx.Max(a.V.AsVector256(), b.V.AsVector256()).AsVector());
        }

        if (Vector<float>.Count == 16 && Avx512F.IsSupported)
        {
            return new(Avx512F.Max(a.V.AsVector512(), b.V.AsVector512()).AsVector());
        }

        return new(Vector.ConditionalSelect(Vector.GreaterThan(a.V, b.V), a.V, b.V));
    }

    /// <summary>The magnitude.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Abs(FloatW a) => new(Vector.Abs(a.V));

    /// <summary>The largest integer not above the number.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Floor(FloatW a) => new(Vector.Floor(a.V));

    /// <summary>The nearest integer, ties to even.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Round(FloatW a) => new(Vector.Round(a.V));

    /// <summary>The magnitude of <paramref name="a"/> with the sign of <paramref name="sign"/>.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW CopySign(FloatW a, FloatW sign) =>
        new(Vector.ConditionalSelect(Vector.AsVectorSingle(new Vector<uint>(0x80000000u)), sign.V, a.V));

    /// <summary>The same bits read as unsigned integers.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public UIntW AsUInt() => new(Vector.AsVectorUInt32(V));

    /// <summary>
    /// The integer part as a signed integer in two's complement, towards zero; NaN gives 0 and what does not fit gives the
    /// nearest integer that does.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public UIntW ToInt() => new(Vector.AsVectorUInt32(Vector.ConvertToInt32(V)));

    /// <summary>
    /// As <see cref="ToInt"/>, in fewer instructions: only for numbers that are known to lie within ±2³¹. Of others the result varies with
    /// the machine.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public UIntW ToIntInRange() => new(Vector<float>.Count == 8 && Avx.IsSupported
        ? Avx.ConvertToVector256Int32WithTruncation(V.AsVector256()).AsUInt32().AsVector()
        : Vector.AsVectorUInt32(Vector.ConvertToInt32Native(V)));

    /// <summary>The numbers in double precision: those of the first half of the lanes, and of the second.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal void Widen(out Vector<double> low, out Vector<double> high)
    {
        if (Vector<float>.Count == 8 && Avx.IsSupported)
        {
            low = Avx.ConvertToVector256Double(V.AsVector256().GetLower()).AsVector();
            high = Avx.ConvertToVector256Double(V.AsVector256().GetUpper()).AsVector();
        }
        else
        {
            Vector.Widen(V, out low, out high);
        }
    }

    /// <summary>Loads as many floats as there are lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Load(float* from) => new(Vector.Load(from));

    /// <summary>Stores all lanes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Store(float* to) => Unsafe.WriteUnaligned(to, V);

    /// <summary>
    /// table[index[0]], table[index[1]] … for indices that lie in memory and grow, but for those of lanes that do not count, at the end.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Pick(float* table, uint* index)
    {
        // Neighbours most often have stayed together.
        if (index[Count - 1] - index[0] == Count - 1)
        {
            return Load(table + index[0]);
        }

        return PickAny(table, index);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW PickAny(float* table, uint* index)
    {
        if (Vector<float>.Count == 8)
        {
            return new(Pick8(table, index).AsVector());
        }

        if (Vector<float>.Count == 16)
        {
            return new(Pick8(table, index).ToVector512Unsafe().WithUpper(Pick8(table, index + 8)).AsVector());
        }

        return new(Vector128.Create(table[index[0]], table[index[1]], table[index[2]], table[index[3]]).AsVector());
    }

    /// <summary>table[index] for indices in a register, each below 2³¹.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static FloatW Gather(float* table, UIntW index)
    {
        if (Vector<float>.Count == 8 && Avx2.IsSupported)
        {
            return new(Avx2.GatherVector256(table, index.V.AsVector256().AsInt32(), 4).AsVector());
        }

        if (Vector<float>.Count == 16 && Avx2.IsSupported)
        {
            Vector512<int> i = index.V.AsVector512().AsInt32();
            return new(Vector512.Create(
                Avx2.GatherVector256(table, i.GetLower(), 4),
                Avx2.GatherVector256(table, i.GetUpper(), 4)).AsVector());
        }

        uint* lanes = stackalloc uint[Vector<uint>.Count];
        index.V.Store(lanes);
        return PickAny(table, lanes);
    }

    /// <summary>From <paramref name="a"/> where <paramref name="t"/> is 0 to <paramref name="b"/> where it is 1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static FloatW Mix(FloatW a, FloatW b, FloatW t) => MultiplyAdd(b - a, t, a);

    /// <summary>table[first] and table[first + 1] for indices in a register, each below 2³¹: a load takes both.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Gather(float* table, UIntW first, out FloatW a, out FloatW b)
    {
        if (Vector<float>.Count == 8 && Avx.IsSupported)
        {
            Gather8(table, first.V.AsVector256(), out Vector256<float> x, out Vector256<float> y);
            (a, b) = (new(x.AsVector()), new(y.AsVector()));
        }
        else if (Vector<float>.Count == 16 && Avx.IsSupported)
        {
            Vector512<uint> i = first.V.AsVector512();
            Gather8(table, i.GetLower(), out Vector256<float> lowX, out Vector256<float> lowY);
            Gather8(table, i.GetUpper(), out Vector256<float> x, out Vector256<float> y);
            (a, b) = (new(Vector512.Create(lowX, x).AsVector()), new(Vector512.Create(lowY, y).AsVector()));
        }
        else
        {
            (a, b) = (Gather(table, first), Gather(table + 1, first));
        }
    }

    /// <summary>
    /// table[first], table[first + 1] and table[first + 2] for indices in a register, each below 2³¹: a load takes all three, and one number behind them, which must
    /// be readable. 0.4 of the time of three gathers.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Gather(float* table, UIntW first, out FloatW a, out FloatW b, out FloatW c)
    {
        if (Vector<float>.Count == 8 && Avx.IsSupported)
        {
            Gather8(table, first.V.AsVector256(), out Vector256<float> x, out Vector256<float> y, out Vector256<float> z);
            (a, b, c) = (new(x.AsVector()), new(y.AsVector()), new(z.AsVector()));
        }
        else if (Vector<float>.Count == 16 && Avx.IsSupported)
        {
            Vector512<uint> i = first.V.AsVector512();
            Gather8(table, i.GetLower(), out Vector256<float> lowX, out Vector256<float> lowY, out Vector256<float> lowZ);
            Gather8(table, i.GetUpper(), out Vector256<float> x, out Vector256<float> y, out Vector256<float> z);
            (a, b) = (new(Vector512.Create(lowX, x).AsVector()), new(Vector512.Create(lowY, y).AsVector()));
            c = new(Vector512.Create(lowZ, z).AsVector());
        }
        else
        {
            (a, b, c) = (Gather(table, first), Gather(table + 1, first), Gather(table + 2, first));
        }
    }

    /// <summary>
    /// Stores the lanes whose bit is set, next to one another. Whole registers may be written: what lies up to
    /// <see cref="Count"/> floats behind <paramref name="to"/> must be free to overwrite.
    /// </summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Compress(float* to, uint bits)
    {
        if (Vector<float>.Count == 16 && Avx2.IsSupported)
        {
            Vector512<float> v = V.AsVector512();
            uint low = bits & 0xff;
            Unsafe.WriteUnaligned(to, Avx2.PermuteVar8x32(v.GetLower(), CompressTable.Permutation(low)));
            Unsafe.WriteUnaligned(to + BitOperations.PopCount(low), Avx2.PermuteVar8x32(v.GetUpper(), CompressTable.Permutation(bits >> 8)));
        }
        else if (Vector<float>.Count == 8 && Avx2.IsSupported)
        {
            Unsafe.WriteUnaligned(to, Avx2.PermuteVar8x32(V.AsVector256(), CompressTable.Permutation(bits)));
        }
        else
        {
            for (int lane = 0; lane < Count; lane++)
            {
                if ((bits >> lane & 1) != 0)
                {
                    *to++ = V[lane];
                }
            }
        }
    }

    // Columns 0 and 1 of eight rows. Indices leave the register two at a time.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Gather8(float* table, Vector256<uint> first, out Vector256<float> x, out Vector256<float> y)
    {
        Vector256<ulong> i = first.AsUInt64();
        (ulong i01, ulong i23, ulong i45, ulong i67) = (i[0], i[1], i[2], i[3]);
        Vector256<float> rows0145 = Vector256.Create(Two(table + (uint)i01), Two(table + (i01 >> 32)), Two(table + (uint)i45), Two(table + (i45 >> 32))).AsSingle();
        Vector256<float> rows2367 = Vector256.Create(Two(table + (uint)i23), Two(table + (i23 >> 32)), Two(table + (uint)i67), Two(table + (i67 >> 32))).AsSingle();
        x = Avx.Shuffle(rows0145, rows2367, 0b10_00_10_00);
        y = Avx.Shuffle(rows0145, rows2367, 0b11_01_11_01);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static double Two(float* at) => *(double*)at;

    // Columns 0, 1 and 2 of eight rows: a transposition.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void Gather8(float* table, Vector256<uint> first, out Vector256<float> x, out Vector256<float> y, out Vector256<float> z)
    {
        Vector256<ulong> i = first.AsUInt64();
        (ulong i01, ulong i23, ulong i45, ulong i67) = (i[0], i[1], i[2], i[3]);
        Vector256<float> rows04 = Vector256.Create(Vector128.Load(table + (uint)i01), Vector128.Load(table + (uint)i45));
        Vector256<float> rows15 = Vector256.Create(Vector128.Load(table + (i01 >> 32)), Vector128.Load(table + (i45 >> 32)));
        Vector256<float> rows26 = Vector256.Create(Vector128.Load(table + (uint)i23), Vector128.Load(table + (uint)i67));
        Vector256<float> rows37 = Vector256.Create(Vector128.Load(table + (i23 >> 32)), Vector128.Load(table + (i67 >> 32)));
        Vector256<float> xy0145 = Avx.UnpackLow(rows04, rows15);
        Vector256<float> xy2367 = Avx.UnpackLow(rows26, rows37);
        x = Avx.Shuffle(xy0145, xy2367, 0b01_00_01_00);
        y = Avx.Shuffle(xy0145, xy2367, 0b11_10_11_10);
        z = Avx.Shuffle(Avx.UnpackHigh(rows04, rows15), Avx.UnpackHigh(rows26, rows37), 0b01_00_01_00);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vector256<float> Pick8(float* table, uint* i) => Vector256.Create(
        table[i[0]], table[i[1]], table[i[2]], table[i[3]], table[i[4]], table[i[5]], table[i[6]], table[i[7]]);
}
