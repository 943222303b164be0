using RayTracer.Numerics;

namespace RayTracer.Tests.Numerics;

public unsafe class LaneMathTests
{
    // Strides through the bit patterns of all floats; a prime, so that low and high bits vary together.
    private const uint Stride = 4099;

    private static readonly float[] Special =
    [
        0f, float.NegativeZero, 1f, -1f, 0.5f, -0.5f, 2f, -3f, float.Epsilon, -float.Epsilon, 1e-40f, 1.17549435e-38f,
        1.00000012f, 0.99999994f, 1e30f, float.MaxValue, float.MinValue, float.PositiveInfinity, float.NegativeInfinity,
        float.NaN,
    ];

    private delegate FloatW Unary(FloatW x);

    private delegate FloatW Binary(FloatW x, FloatW y);

    [Fact]
    public void SinCos_is_precise_for_every_float()
    {
        AssertEverywhere(Sin, Math.Sin, 1.6);
        AssertEverywhere(Cos, Math.Cos, 1.6);
    }

    [Fact]
    public void SinCos_is_precise_where_the_reduced_angle_is_tiny()
    {
        for (int k = -200_000; k <= 200_000; k++)
        {
            float x = (float)(k * (Math.PI / 2));
            LaneMath.SinCos(x, out float sin, out float cos);
            AssertClose(Math.Sin(x), sin, 1.6, x);
            AssertClose(Math.Cos(x), cos, 1.6, x);
        }
    }

    [Fact]
    public void SinCos_keeps_the_sign_of_zero()
    {
        LaneMath.SinCos(float.NegativeZero, out float sin, out float cos);
        AssertSameBits(float.NegativeZero, sin);
        AssertSameBits(1f, cos);
    }

    [Fact]
    public void SinCos_reduces_only_the_large_lanes_slowly()
    {
        FloatW x = FloatW.Iota * 1e6f + 1f;
        LaneMath.SinCos(x, out FloatW sin, out FloatW cos);
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            AssertClose(Math.Sin(x[lane]), sin[lane], 1.6, x[lane]);
            AssertClose(Math.Cos(x[lane]), cos[lane], 1.6, x[lane]);
        }
    }

    [Fact]
    public void SinCosTurn_has_a_small_absolute_error_and_stays_in_range()
    {
        for (uint i = 0; i <= 1 << 24; i += 31)
        {
            float u = i / 16777216f;
            LaneMath.SinCosTurn(u, out float sin, out float cos);
            Assert.Equal(Math.Sin(2 * Math.PI * u), sin, 1.4e-7);
            Assert.Equal(Math.Cos(2 * Math.PI * u), cos, 1.4e-7);
            Assert.InRange(sin, -1f, 1f);
            Assert.InRange(cos, -1f, 1f);
        }
    }

    [Theory]
    [InlineData(0f, 0f, 1f)]
    [InlineData(0.25f, 1f, 0f)]
    [InlineData(0.5f, 0f, -1f)]
    [InlineData(0.75f, -1f, 0f)]
    [InlineData(1f, 0f, 1f)]
    [InlineData(-0.25f, -1f, 0f)]
    [InlineData(1000.25f, 1f, 0f)]
    public void SinCosTurn_is_exact_at_quarter_turns(float u, float expectedSin, float expectedCos)
    {
        LaneMath.SinCosTurn(u, out float sin, out float cos);
        Assert.Equal(expectedSin, sin);
        Assert.Equal(expectedCos, cos);
    }

    [Fact]
    public void SinCosTurn_is_relatively_precise_near_zero()
    {
        LaneMath.SinCosTurn(1e-30f, out float sin, out float cos);
        AssertClose(2 * Math.PI * 1e-30f, sin, 2, 1e-30f);
        Assert.Equal(1f, cos);
    }

    [Fact]
    public void Tan_is_precise_for_every_float() =>
        AssertEverywhere(x => LaneMath.Tan(x[0]), Math.Tan, 3.3, Stride * 8, scalarOnly: true);

    [Fact]
    public void Exp_is_precise_for_every_float() => AssertEverywhere(x => LaneMath.Exp(x), Math.Exp, 1.1);

    [Fact]
    public void Exp_is_precise_where_results_become_subnormal_zero_or_infinite()
    {
        for (float x = -104.5f; x < -87f; x += 0.0003f)
        {
            AssertClose(Math.Exp(x), LaneMath.Exp(x), 1.1, x);
        }

        AssertClose(Math.Exp(88.722839f), LaneMath.Exp(88.722839f), 1.1, 88.722839f);
        Assert.Equal(float.PositiveInfinity, LaneMath.Exp(88.722847f));
    }

    [Fact]
    public void Log_is_precise_for_every_float() => AssertEverywhere(x => LaneMath.Log(x), Math.Log, 1);

    [Fact]
    public void Log_is_precise_around_one()
    {
        for (uint bits = 0x3f700000; bits < 0x3f900000; bits += 13)
        {
            float x = BitConverter.UInt32BitsToSingle(bits);
            AssertClose(Math.Log(x), LaneMath.Log(x), 1, x);
        }
    }

    [Fact]
    public void Acos_is_precise_for_every_float() => AssertEverywhere(x => LaneMath.Acos(x), Math.Acos, 2.4);

    [Fact]
    public void Atan2_is_precise_for_any_two_floats()
    {
        AssertAtRandom(Atan2, Math.Atan2, 1.6, r => (AnyFloat(r), AnyFloat(r)));
        AssertAtRandom(Atan2, Math.Atan2, 1.6, r => (2 * r.NextSingle() - 1, 2 * r.NextSingle() - 1));
    }

    [Fact]
    public void Atan2_follows_ISO_C_for_special_values()
    {
        foreach (float y in Special)
        {
            foreach (float x in Special)
            {
                float atan = LaneMath.Atan2(y, x);
                AssertClose(Math.Atan2(y, x), atan, 1.6, y);
                Assert.True(float.IsNaN(atan) || float.IsNegative(atan) == float.IsNegative(y), $"{y} {x}");
            }
        }
    }

    [Fact]
    public void Pow_is_precise_for_any_result()
    {
        AssertAtRandom(Pow, Math.Pow, 0.75, r => (MathF.Abs(AnyFloat(r)), AnyFloat(r)));
        AssertAtRandom(Pow, Math.Pow, 0.75, r => PowArguments(r, MathF.Abs(AnyFloat(r))));
        AssertAtRandom(Pow, Math.Pow, 0.75, r => PowArguments(r, 0.5f + 1.5f * r.NextSingle()));
        AssertAtRandom(Pow, Math.Pow, 0.75, r => PowArguments(r, 1f + 1e-4f * (r.NextSingle() - 0.5f)));
    }

    [Fact]
    public void Pow_follows_ISO_C_for_special_values_that_are_not_negative()
    {
        foreach (float x in Special)
        {
            foreach (float y in Special)
            {
                double expected = x < 0 && y != 0 ? double.NaN : Math.Pow(x == 0 ? 0 : x, y);
                AssertClose(expected, LaneMath.Pow(x, y), 0.75, x);
            }
        }
    }

    [Fact]
    public void Scalar_functions_have_the_bits_of_every_lane()
    {
        foreach (float x in Special)
        {
            foreach (float other in Special)
            {
                for (int lane = 0; lane < FloatW.Count; lane++)
                {
                    FloatW mixed = MaskW.First(lane).Select(other, MaskW.First(lane + 1).Select(x, other));
                    LaneMath.SinCos(x, out float sin, out float cos);
                    AssertSameBits(sin, Sin(mixed)[lane]);
                    AssertSameBits(cos, Cos(mixed)[lane]);
                    LaneMath.SinCosTurn(x, out sin, out cos);
                    LaneMath.SinCosTurn(mixed, out FloatW sines, out FloatW cosines);
                    AssertSameBits(sin, sines[lane]);
                    AssertSameBits(cos, cosines[lane]);
                    AssertSameBits(LaneMath.Exp(x), LaneMath.Exp(mixed)[lane]);
                    AssertSameBits(LaneMath.Log(x), LaneMath.Log(mixed)[lane]);
                    AssertSameBits(LaneMath.Acos(x), LaneMath.Acos(mixed)[lane]);
                    AssertSameBits(LaneMath.Pow(x, other), LaneMath.Pow(mixed, other)[lane]);
                    AssertSameBits(LaneMath.Atan2(x, other), LaneMath.Atan2(mixed, other)[lane]);
                }
            }
        }
    }

    private static FloatW Sin(FloatW x)
    {
        LaneMath.SinCos(x, out FloatW sin, out _);
        return sin;
    }

    private static FloatW Cos(FloatW x)
    {
        LaneMath.SinCos(x, out _, out FloatW cos);
        return cos;
    }

    private static FloatW Atan2(FloatW y, FloatW x) => LaneMath.Atan2(y, x);

    private static FloatW Pow(FloatW x, FloatW y) => LaneMath.Pow(x, y);

    private static float AnyFloat(Random random) => BitConverter.UInt32BitsToSingle((uint)random.NextInt64(1L << 32));

    // An exponent for which the power is anything from 0 to infinity.
    private static (float X, float Y) PowArguments(Random random, float x) =>
        (x, (float)((random.NextDouble() * 290 - 155) / Math.Log2(x)));

    private static void AssertEverywhere(
        Unary function, Func<double, double> expected, double ulps, uint stride = Stride, bool scalarOnly = false)
    {
        int lanes = scalarOnly ? 1 : FloatW.Count;
        float* x = stackalloc float[FloatW.Count];
        for (ulong bits = 0; bits < 1ul << 32; bits += stride * (ulong)lanes)
        {
            for (int lane = 0; lane < lanes; lane++)
            {
                x[lane] = BitConverter.UInt32BitsToSingle((uint)(bits + (ulong)lane * stride));
            }

            FloatW wide = function(FloatW.Load(x));
            for (int lane = 0; lane < lanes; lane++)
            {
                AssertClose(expected(x[lane]), wide[lane], ulps, x[lane]);
            }
        }

        foreach (float special in Special)
        {
            AssertClose(expected(special), function(special)[FloatW.Count - 1], ulps, special);
        }
    }

    private static void AssertAtRandom(
        Binary function, Func<double, double, double> expected, double ulps, Func<Random, (float A, float B)> arguments)
    {
        var random = new Random(7);
        float* a = stackalloc float[FloatW.Count];
        float* b = stackalloc float[FloatW.Count];
        for (int i = 0; i < 30_000; i++)
        {
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                (a[lane], b[lane]) = arguments(random);
            }

            FloatW wide = function(FloatW.Load(a), FloatW.Load(b));
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                AssertClose(expected(a[lane], b[lane]), wide[lane], ulps, a[lane]);
            }
        }
    }

    // One ulp is the spacing of floats at the exact result.
    private static void AssertClose(double expected, float actual, double ulps, float argument)
    {
        float rounded = (float)expected;
        bool close = float.IsNaN(rounded)
            ? float.IsNaN(actual)
            : float.IsInfinity(rounded) || float.IsInfinity(actual)
                ? actual == rounded
                : Math.Abs(actual - expected) <= ulps * Spacing(expected);
        if (!close)
        {
            Assert.Fail($"At {argument:R}: expected {expected:R}, got {actual:R}.");
        }
    }

    private static double Spacing(double x) => Math.ScaleB(1, x == 0 ? -149 : Math.Max(Math.ILogB(x) - 23, -149));

    private static void AssertSameBits(float expected, float actual) =>
        Assert.Equal(BitConverter.SingleToUInt32Bits(expected), BitConverter.SingleToUInt32Bits(actual));
}
