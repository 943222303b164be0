using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

public class AutoExposureTests
{
    [Theory]
    [InlineData(0.25f, 0)]
    [InlineData(1, -2)]
    [InlineData(500, -10.97f)]
    [InlineData(0.003f, 6.38f)]
    public void The_middle_brightness_becomes_a_middle_grey(float light, float stops) =>
        Assert.Equal(stops, Exposure.Auto.StopsFor(Even(light, light, light)));

    [Fact]
    public void Pixels_without_light_do_not_count() => Assert.Equal(-2, Exposure.Auto.StopsFor(Even(0, 1, 0, 1, 1, -1)));

    [Fact]
    public void A_dark_and_a_bright_pixel_are_halfway_between_in_stops() => Assert.Equal(-1, Exposure.Auto.StopsFor(Even(0.125f, 2)));

    [Fact]
    public void The_mean_of_the_faintest_and_the_strongest_light_is_that_of_their_logarithms() =>
        Assert.Equal(1.32f, Exposure.Auto.StopsFor(Even([.. Enumerable.Repeat(1e-40f, 5000), .. Enumerable.Repeat(1e38f, 5000)])));

    [Fact]
    public void A_black_picture_stays_as_it_is() => Assert.Equal(0, Exposure.Auto.StopsFor(Even(0, 0, 0)));

    // A pixel in four may be as bright as it likes.
    [Theory]
    [InlineData(0, 0.5f, 1f, 1f, 90f)]
    [InlineData(-3, 0f, 1f, 2f, 8f, 90f)]
    [InlineData(-0.5f, 0.1f, 0.2f, 1.41421f, 2f)]
    [InlineData(-100, float.MaxValue, float.MaxValue)]
    [InlineData(0, 0f, 0f)]
    public void A_limited_one_darkens_what_would_be_a_white_sheet(float stops, params float[] light) =>
        Assert.Equal(stops, Exposure.Limited.StopsFor(Even(light)));

    [Fact]
    public void Stops_that_are_given_do_not_depend_on_the_picture() => Assert.Equal(1.5f, new Exposure(1.5f).StopsFor(Even(7, 0.1f)));

    private static Picture Even(params float[] greys) => new(greys.Length, 1, [.. greys.SelectMany(v => new[] { v, v, v })]);
}
