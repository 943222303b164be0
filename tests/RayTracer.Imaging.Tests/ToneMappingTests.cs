using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

public class ToneMappingTests
{
    [Theory]
    [InlineData(ToneMap.Soft)]
    [InlineData(ToneMap.Reinhard)]
    [InlineData(ToneMap.Aces)]
    [InlineData(ToneMap.Agx)]
    public void Grey_stays_grey_and_rises_towards_white(ToneMap map)
    {
        float previous = -1;
        for (int stops = -12; stops <= 12; stops++)
        {
            float light = MathF.Pow(2, stops);
            Rgb mapped = ToneMapping.Apply(map, new Rgb(light, light, light));
            Assert.InRange(mapped.R, previous, 1.03f);
            Assert.Equal(mapped.R, mapped.G, 2e-3f);
            Assert.Equal(mapped.R, mapped.B, 2e-3f);
            previous = mapped.R;
        }

        Assert.InRange(previous, 0.9f, 1.03f);
    }

    [Theory]
    [InlineData(ToneMap.Soft)]
    [InlineData(ToneMap.Reinhard)]
    [InlineData(ToneMap.Aces)]
    [InlineData(ToneMap.Agx)]
    public void Extreme_light_gives_finite_numbers(ToneMap map)
    {
        float[] extremes = [0, -1, float.MaxValue, float.PositiveInfinity, float.NegativeInfinity, float.Epsilon];
        foreach (float r in extremes)
        {
            foreach (float g in extremes)
            {
                Rgb mapped = ToneMapping.Apply(map, new Rgb(r, g, 0.5f));
                Assert.True(float.IsFinite(mapped.R) && float.IsFinite(mapped.G) && float.IsFinite(mapped.B));
            }
        }
    }

    [Theory]
    [InlineData(4, 2, 0)]
    [InlineData(0.3, 8, 1)]
    [InlineData(40, 30, 50)]
    public void The_soft_curve_keeps_hues_that_clamping_changes(float r, float g, float b)
    {
        Rgb shown = ToneMapping.Apply(ToneMap.Soft, new Rgb(r, g, b));
        Assert.All([shown.R, shown.G, shown.B], v => Assert.InRange(v, 0, 1));
        Assert.Equal((double)(g - b) / (r - b), (shown.G - shown.B) / (shown.R - shown.B), 1e-3);
    }

    [Fact]
    public void The_soft_curve_shows_the_colours_of_things_as_they_are_and_goes_on_without_a_kink()
    {
        Rgb colour = new(0.7f, 0.1f, 0.4f);
        Assert.Equal(colour, ToneMapping.Apply(ToneMap.Soft, colour));
        Assert.Equal(0.701f, ToneMapping.Apply(ToneMap.Soft, new Rgb(0.701f, 0.701f, 0.701f)).R, 1e-5f);
    }

    [Fact]
    public void Reinhard_scales_by_luminance()
    {
        Rgb mapped = ToneMapping.Apply(ToneMap.Reinhard, new Rgb(0, 1 / 0.7152f, 0));
        Assert.Equal(0.5f / 0.7152f, mapped.G, 1e-6f);
        Assert.Equal(0, mapped.R);
    }

    // Expected values: the published formulas, evaluated with another program in double precision.
    [Theory]
    [InlineData(ToneMap.Aces, 0.18f, 0.18f, 0.18f, 0.1055912, 0.1055912, 0.1055902)]
    [InlineData(ToneMap.Aces, 2f, 0.5f, 0.1f, 0.9014993, 0.4186894, 0.1050008)]
    [InlineData(ToneMap.Agx, 0.18f, 0.18f, 0.18f, 0.2144674, 0.2145327, 0.2145367)]
    [InlineData(ToneMap.Agx, 2f, 0.5f, 0.1f, 0.8072893, 0.4496241, 0.2106905)]
    public void Film_curves_give_the_published_values(ToneMap map, float r, float g, float b, double red, double green, double blue)
    {
        Rgb mapped = ToneMapping.Apply(map, new Rgb(r, g, b));
        Assert.Equal(red, mapped.R, 1e-5);
        Assert.Equal(green, mapped.G, 1e-5);
        Assert.Equal(blue, mapped.B, 1e-5);
    }

    [Fact]
    public void Exposure_multiplies_by_an_exact_power_of_two()
    {
        Picture picture = TestPictures.Noise(5, 2);
        var row = new float[15];
        new ToneMappedRows(picture, ToneMap.Clamp, -3).ReadRow(1, row);
        Assert.Equal(picture.Pixels.Skip(15).Select(value => value / 8), row);
    }

    [Fact]
    public void Exposure_of_half_a_stop_is_the_root_of_two()
    {
        var row = new float[3];
        new ToneMappedRows(new Picture(1, 1, [1, 2, 0]), ToneMap.Clamp, 0.5f).ReadRow(0, row);
        Assert.Equal([MathF.Sqrt(2), 2 * MathF.Sqrt(2), 0], row);
    }

    [Theory]
    [InlineData(float.NaN)]
    [InlineData(101)]
    public void Exposure_out_of_range_is_refused(float stops) =>
        Assert.Throws<ArgumentOutOfRangeException>(() => new ToneMappedRows(new Picture(1, 1), ToneMap.Clamp, stops));
}
