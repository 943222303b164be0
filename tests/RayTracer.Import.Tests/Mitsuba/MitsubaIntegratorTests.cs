using RayTracer.Description;

namespace RayTracer.Import.Tests;

public class MitsubaIntegratorTests
{
    [Theory]
    [InlineData("path", false)]
    [InlineData("direct", false)]
    [InlineData("volpath", true)]
    [InlineData("volpathmis", true)]
    public void What_passes_straight_through_is_no_bounce_where_Mitsuba_shows_media(string integrator, bool isStraight) =>
        Assert.Equal(isStraight, TestScene.Of($"<integrator type=\"{integrator}\"/>").Render.StraightThrough);
}
