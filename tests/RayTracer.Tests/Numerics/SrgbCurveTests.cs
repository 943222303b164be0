using FsCheck;
using FsCheck.Fluent;
using RayTracer.Numerics;

namespace RayTracer.Tests.Numerics;

public class SrgbCurveTests
{
    [Fact]
    public void Every_8_bit_code_survives_decoding_and_encoding()
    {
        for (int code = 0; code <= 255; code++)
        {
            Assert.Equal(code, SrgbCurve.Encode8(SrgbCurve.Decode8((byte)code)));
        }
    }

    [Fact]
    public void Every_16_bit_code_survives_decoding_and_encoding()
    {
        for (int code = 0; code <= 65535; code++)
        {
            Assert.Equal(code, SrgbCurve.Encode16(SrgbCurve.Decode16((ushort)code)));
        }
    }

    [Fact]
    public void Decode_is_the_power_of_the_standard()
    {
        for (int i = 0; i <= 1000; i++)
        {
            double encoded = i / 1000.0;
            double expected = encoded <= 0.04045 ? encoded / 12.92 : Math.Pow((encoded + 0.055) / 1.055, 2.4);
            Assert.Equal(expected, SrgbCurve.Decode(encoded), 1e-15);
        }

        Assert.Equal(1, SrgbCurve.Decode(1));
    }

    [Fact]
    public void Encode_gives_the_nearest_code_of_any_light()
    {
        Prop.ForAll(ArbMap.Default.ArbFor<uint>(), bits =>
        {
            // All exponents from 2^-24 to 1 alike.
            float linear = BitConverter.UInt32BitsToSingle(0x33800000 + (bits * 2654435761u % 0x0C000000));
            double encoded = linear <= 0.0031308 ? linear * 12.92 : (1.055 * Math.Pow(linear, 1 / 2.4)) - 0.055;
            return Math.Abs((encoded * 65535) - SrgbCurve.Encode16(linear)) <= 0.51
                && Math.Abs((encoded * 255) - SrgbCurve.Encode8(linear)) <= 0.501;
        }).QuickCheckThrowOnFailure();
    }

    [Theory]
    [InlineData(float.NaN, 0)]
    [InlineData(float.NegativeInfinity, 0)]
    [InlineData(-1f, 0)]
    [InlineData(float.NegativeZero, 0)]
    [InlineData(float.Epsilon, 0)]
    [InlineData(0.99999994f, 255)]
    [InlineData(1f, 255)]
    [InlineData(1e30f, 255)]
    [InlineData(float.PositiveInfinity, 255)]
    public void Encode_is_defined_when_light_is_out_of_range(float linear, int expected)
    {
        Assert.Equal(expected, SrgbCurve.Encode8(linear));
        Assert.Equal(expected * 257, SrgbCurve.Encode16(linear));
    }

    [Fact]
    public void Encode_switches_code_exactly_between_two_codes()
    {
        for (int code = 0; code < 255; code++)
        {
            double middle = SrgbCurve.Decode((code + 0.5) / 255);
            float below = (float)middle;
            below = below < middle ? below : float.BitDecrement(below);
            Assert.Equal(code, SrgbCurve.Encode8(below));
            Assert.Equal(code + 1, SrgbCurve.Encode8(float.BitIncrement(below)));
        }
    }
}
