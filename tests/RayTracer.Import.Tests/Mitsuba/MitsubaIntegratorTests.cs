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

    [Fact]
    public void Light_tracing_is_the_light_integrator()
    {
        RenderDescription render = TestScene.Of("""<integrator type="ptracer"><integer name="max_depth" value="5"/><integer name="samples_per_pass" value="64"/></integrator>""").Render;
        Assert.Equal((Integrator.Light, 5), (render.Integrator, render.MaxDepth));
        Assert.Contains("with \"ptracer\"", TestScene.Complaint("""<integrator type="ptracer"><boolean name="hide_emitters" value="true"/></integrator>"""), StringComparison.Ordinal);
    }

    [Theory]
    [InlineData("path")]
    [InlineData("direct")]
    [InlineData("volpath")]
    public void Emitters_are_hidden_from_the_camera(string integrator)
    {
        Assert.True(TestScene.Of($"<integrator type=\"{integrator}\"><boolean name=\"hide_emitters\" value=\"true\"/></integrator>").Render.HideLights);
        Assert.False(TestScene.Of($"<integrator type=\"{integrator}\"/>").Render.HideLights);
    }
}
