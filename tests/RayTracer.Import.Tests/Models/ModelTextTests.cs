using System.Globalization;
using System.Text;
using RayTracer.Import;
using RayTracer.Scenes;

namespace RayTracer.Import.Tests;

[Trait("Category", "Thorough")]
public class ModelTextTests
{
    // The fast way must give the very bits that the runtime's parser gives, which rounds correctly (IEEE 754).
    [Fact]
    public void Numbers_of_all_lengths_and_sizes_are_rounded_correctly()
    {
        var random = new Random(754 + TestSettings.Seed);
        for (int i = 0; i < TestSettings.Scale(200_000, 1_000_000); i++)
        {
            string text = (i % 5) switch
            {
                0 => Any(random).ToString("R", CultureInfo.InvariantCulture),
                1 => ((double)Any(random)).ToString("R", CultureInfo.InvariantCulture),
                2 => $"{(i % 2 == 0 ? "-" : "+")}{random.Next(100)}.{random.Next(1_000_000):D6}",
                3 => Middle(random).ToString("R", CultureInfo.InvariantCulture),
                _ => $"{random.NextInt64(1L << 56)}{(i % 3 == 0 ? "." : "")}e{random.Next(-60, 40)}",
            };
            Assert.True(ModelText.TryNumber(Encoding.ASCII.GetBytes(text), out float value), text);
            float expected = float.Parse(text, CultureInfo.InvariantCulture);
            Assert.True(BitConverter.SingleToInt32Bits(expected) == BitConverter.SingleToInt32Bits(value), $"{text}: {value:R} instead of {expected:R}");
        }
    }

    [Theory]
    [InlineData("1.", 1)]
    [InlineData(".5", 0.5)]
    [InlineData("-0", -0.0)]
    [InlineData("+2.e1", 20)]
    [InlineData("1E+2", 100)]
    [InlineData("0e99", 0)]
    [InlineData("1e99", double.PositiveInfinity)]
    [InlineData("nan", double.NaN)]
    [InlineData("-nan(ind)", double.NaN)]
    [InlineData("1.#QNAN0", double.NaN)]
    public void Every_spelling_of_numbers_is_read(string text, double expected)
    {
        Assert.True(ModelText.TryNumber(Encoding.ASCII.GetBytes(text), out float value));
        Assert.Equal((float)expected, value);
        Assert.Equal(double.IsNegative(expected) && !double.IsNaN(expected), float.IsNegative(value) && !float.IsNaN(value));
    }

    [Theory]
    [InlineData("")]
    [InlineData("-")]
    [InlineData(".")]
    [InlineData("e5")]
    [InlineData("1e")]
    [InlineData("1e+")]
    [InlineData("1,5")]
    [InlineData("1.2.3")]
    [InlineData("0x10")]
    [InlineData("--1")]
    [InlineData("1 2")]
    public void What_is_no_number_is_refused(string text) => Assert.False(ModelText.TryNumber(Encoding.ASCII.GetBytes(text), out _));

    private static float Any(Random random)
    {
        float value = BitConverter.Int32BitsToSingle(random.Next() ^ (random.Next(2) << 31));
        return float.IsFinite(value) ? value : 0;
    }

    // The middle between two floats, where one rounding after the other can go wrong; sometimes a double beside it.
    private static double Middle(Random random)
    {
        float low = random.NextSingle() * random.Next(1, 1 << 20);
        double middle = ((double)low + float.BitIncrement(low)) / 2;
        return random.Next(3) switch { 0 => middle, 1 => double.BitIncrement(middle), _ => double.BitDecrement(middle) };
    }
}
