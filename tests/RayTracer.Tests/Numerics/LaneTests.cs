using System.Numerics;
using System.Reflection;
using RayTracer.Numerics;

namespace RayTracer.Tests.Numerics;

public unsafe class LaneTests
{
    private const BindingFlags Own = BindingFlags.Instance | BindingFlags.Static | BindingFlags.Public | BindingFlags.NonPublic | BindingFlags.DeclaredOnly;

    // Code that is compiled ahead knows the size of Vector<T> in no Nullable<T>: a program that is given away as a single file breaks its stack there.
    [Fact]
    public void No_member_of_the_core_has_lanes_that_may_be_null()
    {
        foreach (Type type in typeof(FloatW).Assembly.GetTypes())
        {
            IEnumerable<Type> inFields = type.GetFields(Own).Select(field => field.FieldType);
            IEnumerable<Type> inMethods = type.GetMethods(Own).SelectMany(method => method.GetParameters().Select(p => p.ParameterType).Append(method.ReturnType));
            Assert.DoesNotContain(inFields.Concat(inMethods), used => Nullable.GetUnderlyingType(used) is { } value && HasLanes(value));
        }
    }

    [Theory]
    [InlineData(1f, 2f)]
    [InlineData(2f, 1f)]
    [InlineData(0f, float.NegativeZero)]
    [InlineData(float.NegativeZero, 0f)]
    [InlineData(float.NaN, 1f)]
    [InlineData(1f, float.NaN)]
    [InlineData(float.NegativeInfinity, float.PositiveInfinity)]
    public void Min_and_Max_are_exactly_the_conditional_expression(float a, float b)
    {
        AssertSameBits(a < b ? a : b, FloatW.Min(a, b)[0]);
        AssertSameBits(a > b ? a : b, FloatW.Max(a, b)[FloatW.Count - 1]);
    }

    [Theory]
    [InlineData(float.NaN, 0)]
    [InlineData(1e30f, int.MaxValue)]
    [InlineData(-1e30f, int.MinValue)]
    [InlineData(float.PositiveInfinity, int.MaxValue)]
    [InlineData(-1.9f, -1)]
    [InlineData(2.9f, 2)]
    public void ToInt_is_defined_for_every_float(float value, int expected) =>
        Assert.Equal(expected, (int)((FloatW)value).ToInt()[0]);

    [Fact]
    public void ReverseBits_reverses_every_bit_pattern()
    {
        var random = new Random(1);
        for (int i = 0; i < 1000; i++)
        {
            uint x = (uint)random.NextInt64(1L << 32);
            uint expected = 0;
            for (int bit = 0; bit < 32; bit++)
            {
                expected |= (x >> bit & 1) << (31 - bit);
            }

            UIntW reversed = ((UIntW)x).ReverseBits();
            Assert.Equal(expected, reversed[0]);
            Assert.Equal(expected, reversed[FloatW.Count - 1]);
        }
    }

    [Fact]
    public void Compress_keeps_exactly_the_chosen_lanes_in_order()
    {
        float* to = stackalloc float[2 * FloatW.Count];
        for (uint bits = 0; bits < 1u << FloatW.Count; bits++)
        {
            FloatW.Iota.Compress(to, bits);
            int k = 0;
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                if ((bits >> lane & 1) != 0)
                {
                    Assert.Equal(lane, to[k++]);
                }
            }
        }
    }

    [Fact]
    public void Gather_and_Pick_read_the_indexed_entries()
    {
        float* table = stackalloc float[64];
        uint* index = stackalloc uint[FloatW.Count];
        for (int i = 0; i < 64; i++)
        {
            table[i] = i * 3;
        }

        for (int i = 0; i < FloatW.Count; i++)
        {
            index[i] = (uint)((i * 7 + 5) % 64);
        }

        FloatW gathered = FloatW.Gather(table, UIntW.Load(index));
        FloatW picked = FloatW.Pick(table, index);
        for (int i = 0; i < FloatW.Count; i++)
        {
            Assert.Equal(index[i] * 3, gathered[i]);
            Assert.Equal(index[i] * 3, picked[i]);
        }
    }

    [Fact]
    public void Entries_that_lie_side_by_side_are_gathered_together()
    {
        float* table = stackalloc float[64 + 3];
        for (int i = 0; i < 64 + 3; i++)
        {
            table[i] = i * 3;
        }

        for (uint turn = 0; turn < 64; turn++)
        {
            UIntW first = (UIntW.Iota * 7u + turn) & 63u;
            FloatW.Gather(table, first, out FloatW a, out FloatW b);
            Vec3W three = Vec3W.Gather(table, first);
            RgbW color = RgbW.Gather(table, first);
            UIntW.Gather((uint*)table, first, out UIntW p, out UIntW q);
            UIntW.Gather((uint*)table, first, out UIntW x, out UIntW y, out UIntW z);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                float* at = table + first[lane];
                Assert.Equal((at[0], at[1]), (a[lane], b[lane]));
                Assert.Equal((at[0], at[1], at[2]), (three.X[lane], three.Y[lane], three.Z[lane]));
                Assert.Equal((at[0], at[1], at[2]), (color.R[lane], color.G[lane], color.B[lane]));
                Assert.Equal((at[0], at[1]), (p.AsFloat()[lane], q.AsFloat()[lane]));
                Assert.Equal((at[0], at[1], at[2]), (x.AsFloat()[lane], y.AsFloat()[lane], z.AsFloat()[lane]));
            }
        }
    }

    [Fact]
    public void Masks_select_and_count_lanes()
    {
        for (int n = 0; n <= FloatW.Count; n++)
        {
            MaskW first = MaskW.First(n);
            Assert.Equal((1u << n) - 1, first.Bits);
            Assert.Equal(n > 0, first.Any);
            FloatW chosen = first.Select(FloatW.Iota, -1f);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                Assert.Equal(lane < n ? lane : -1, chosen[lane]);
            }
        }
    }

    [Theory]
    [InlineData(0u, 0f)]
    [InlineData(uint.MaxValue, 1 - 1f / 16777216)]
    [InlineData(0x80000000u, 0.5f)]
    public void ToUnit_lies_below_one(uint bits, float expected) => Assert.Equal(expected, ((UIntW)bits).ToUnit()[0]);

    private static bool HasLanes(Type type) => type.IsValueType && !type.IsPrimitive && !type.IsEnum
        && ((type.IsGenericType && type.GetGenericTypeDefinition() == typeof(Vector<>))
            || type.GetFields(BindingFlags.Instance | BindingFlags.Public | BindingFlags.NonPublic).Any(field => field.FieldType != type && HasLanes(field.FieldType)));

    private static void AssertSameBits(float expected, float actual) =>
        Assert.Equal(BitConverter.SingleToUInt32Bits(expected), BitConverter.SingleToUInt32Bits(actual));
}
