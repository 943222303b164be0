using System.Numerics;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Tests.Lights;

/// <summary>Lights without extent, against their formulas, wherever the scene graph puts them.</summary>
public class PunctualLightTests
{
    private const string Spot = """ { "type": "spot", "position": [1, 2, 3], "direction": [0, -2, 0], "intensity": [6, 3, 1], "cutoffAngle": 40, "beamWidth": 10 } """;

    private static readonly Vector3[] s_points = [new(1, 0, 3), new(1.2f, 0.3f, 3.1f), new(2, 0.5f, 2.5f), new(1, 1, 3.84f), new(4, 0, 3), new(1, 5, 3), new(-3, -7, 4)];

    [Fact]
    public void A_point_light_brings_its_intensity_over_the_square_of_the_distance() => Check(
        """{ "type": "point", "position": [1, 2, 3], "intensity": [6, 3, 1] }""",
        from => 1 / (new Vector3D(1, 2, 3) - from).Squared,
        from => (new Vector3D(1, 2, 3) - from).Unit);

    // As measured in Mitsuba 3: in proportion to the angle.
    [Fact]
    public void A_spot_light_falls_with_the_angle_from_beam_to_edge() => Check(Spot, from => SpotStrength(new(1, 2, 3), new(0, -1, 0), from, 40, 10), from => (new Vector3D(1, 2, 3) - from).Unit);

    [Fact]
    public void Without_a_beam_width_it_is_three_quarters_of_the_cutoff_angle() => Check(
        Spot.Replace(", \"beamWidth\": 10", "", StringComparison.Ordinal),
        from => SpotStrength(new(1, 2, 3), new(0, -1, 0), from, 40, 30),
        from => (new Vector3D(1, 2, 3) - from).Unit);

    [Fact]
    public void A_beam_as_wide_as_the_cone_has_a_sharp_edge() => Check(
        Spot.Replace("\"beamWidth\": 10", "\"beamWidth\": 40", StringComparison.Ordinal),
        from => Angle(from) < 40 ? 1 / (new Vector3D(1, 2, 3) - from).Squared : 0,
        from => (new Vector3D(1, 2, 3) - from).Unit);

    // KHR_lights_punctual, "Inner and outer cone angles".
    [Fact]
    public void A_smooth_spot_light_falls_as_glTFs_does() => Check(
        Spot.Replace("\"beamWidth\": 10", "\"beamWidth\": 10, \"falloff\": \"smooth\"", StringComparison.Ordinal),
        from =>
        {
            double part = (Math.Cos(Angle(from) * Math.PI / 180) - Math.Cos(40 * Math.PI / 180)) / (Math.Cos(10 * Math.PI / 180) - Math.Cos(40 * Math.PI / 180));
            return Math.Pow(Math.Clamp(part, 0, 1), 2) / (new Vector3D(1, 2, 3) - from).Squared;
        },
        from => (new Vector3D(1, 2, 3) - from).Unit);

    // Red to the lower left and upper right, as somebody sees it who stands behind the light and has −z above.
    [Theory]
    [InlineData("", 1, 0)]
    [InlineData(""", "evenOnWalls": false""", 3, 0)]
    [InlineData(""", "transform": [{ "scale": [-1, 1, 1], "translate": [2, 0, 0] }]""", 1, 1)]
    public void A_projector_throws_its_picture(string more, int power, int mirrored)
    {
        const string picture = """{ "type": "checker", "scale": [2, 2], "even": [1, 0, 0], "odd": [0, 1, 0] }""";
        LightSource light = Only($$"""{ "type": "group", "shapes": [{ "type": "projector", "position": [1, 2, 3], "direction": [0, -2, 0], "up": [0, 1, -3], "fieldOfView": 90, "aspect": 2, "intensity": [6, 3, 1], "picture": {{picture}}{{(power == 3 ? more : "")}} }]{{(power == 1 ? more : "")}} }""");
        foreach ((float x, float z) in new[] { (0.3f, 0.2f), (-0.3f, 0.2f), (-0.9f, -0.4f), (0.9f, 0.4f), (1.1f, 0), (0.3f, 0.6f), (0.3f, -0.6f) })
        {
            bool isSeen = float.Abs(x) <= 1 && float.Abs(z) <= 0.5f;
            bool isRed = x < 0 == z > 0 == (mirrored == 0);
            light.Sample(new Vector3(1 + (2 * x), 0, 3 + (2 * z)), 0f, 0f, 0f, out ShapeSampleW sample, out RgbW radiance);
            double cosine = 1 / Math.Sqrt(1 + (x * x) + (z * z));

            // On a wall at distance 2, E = I/4 · cos⁴, and I = 1/cos³ makes it even but for the cosine of the wall.
            double expected = power == 1 ? 1 / (4 * cosine) : cosine * cosine / 4;
            Assert.Equal(isSeen && isRed ? 6 * expected : 0, radiance.R[0], 1e-5);
            Assert.Equal(isSeen && !isRed ? 3 * expected : 0, radiance.G[0], 1e-5);
            Assert.Equal(isSeen, sample.InversePdf[0] > 0);
        }
    }

    [Fact]
    public void A_picture_colours_the_light_of_a_spot()
    {
        string spot = Spot.Replace(" }", """, "pictureUp": [0, 0, -1], "picture": { "type": "checker", "scale": [2, 1], "even": [1, 0, 0], "odd": [0, 1, 0] } }""", StringComparison.Ordinal);
        LightSource light = Only(spot);
        foreach (float x in new[] { -0.5f, 0.5f, -1.2f, 1.2f })
        {
            Vector3 from = new(1 + x, 0, 3.2f);
            light.Sample(from, 0f, 0f, 0f, out _, out RgbW radiance);
            double strength = SpotStrength(new(1, 2, 3), new(0, -1, 0), from, 40, 10);
            Assert.Equal(x < 0 ? 6 * strength : 0, radiance.R[0], 1e-5);
            Assert.Equal(x < 0 ? 0 : 3 * strength, radiance.G[0], 1e-5);
        }
    }

    [Fact]
    public void A_narrow_beam_is_not_rounded_to_steps()
    {
        LightSource light = Only("""{ "type": "spot", "direction": [0, 0, -1], "cutoffAngle": 0.05, "beamWidth": 0 }""");
        for (int i = 1; i < 100; i++)
        {
            double angle = 0.05 * Math.PI / 180 * i / 100;
            light.Sample(new Vector3((float)Math.Tan(angle), 0, -1), 0f, 0f, 0f, out _, out RgbW radiance);
            Assert.Equal(1 - (i / 100.0), radiance.R[0], 1e-4);
        }
    }

    [Fact]
    public void A_directional_light_brings_its_irradiance_from_where_it_comes()
    {
        LightSource light = Only("""{ "type": "directional", "direction": [3, -4, 0], "irradiance": [6, 3, 1] }""");
        light.Sample(new Vector3(5, 6, 7), 0f, 0f, 0f, out ShapeSampleW sample, out RgbW radiance);
        Assert.True((Vector3D.Of(sample.Direction, 0) - new Vector3D(-0.6, 0.8, 0)).Length < 1e-6);
        Assert.Equal((6, 3, 1), (radiance.R[0], radiance.G[0], radiance.B[0]));
        Assert.Equal((float.PositiveInfinity, 1, 1), (sample.Distance[0], sample.Cosine[0], sample.InversePdf[0]));
    }

    [Theory]
    [InlineData("""{ "type": "group", "shapes": [SPOT], "transform": [STEPS] }""", false)]
    [InlineData("""{ "type": "instance", "of": SPOT, "transform": [STEPS] }""", false)]
    [InlineData("""{ "type": "instance", "of": { "type": "group", "shapes": [SPOT, { "type": "sphere", "center": [9, 9, 9] }] }, "transform": [STEPS] }""", false)]
    [InlineData("""{ "type": "group", "shapes": [{ "type": "instance", "of": SPOT, "transform": [STEPS] }] }""", false)]
    [InlineData("""{ "type": "group", "shapes": [SPOT], "motion": [{ "time": 0, "transform": [STEPS] }, { "time": 1, "transform": [STEPS, { "translate": [0, 4, 0] }] }] }""", true)]
    public void Groups_instances_and_motions_place_lights(string shape, bool moves)
    {
        const string steps = """{ "scale": [2, 2, 2], "rotate": 90, "axis": [1, 0, 0], "translate": [0, 0, 1] }""";
        Scene scene = Build(shape.Replace("SPOT", Spot, StringComparison.Ordinal).Replace("STEPS", steps, StringComparison.Ordinal));
        Assert.Equal(moves, scene.IsTimed);
        LightSource light = Assert.Single(scene.Lights);
        foreach (float time in new[] { 0, 0.25f, 1 })
        {
            // (1, 2, 3) doubled is (2, 4, 6), turned (2, −6, 4), and then a step along z; down becomes −z.
            Vector3D place = new(2, -6 + (moves ? 4 * time : 0), 5);
            foreach (Vector3 offset in new Vector3[] { new(0, 0, -2), new(0.5f, 0.1f, -1), new(1, 0.2f, -1.5f), new(0, 0, 1) })
            {
                Vector3 from = new Vector3((float)place.X, (float)place.Y, (float)place.Z) + offset;
                light.Sample(from, 0f, 0f, time, out ShapeSampleW sample, out RgbW radiance);
                double expected = 6 * SpotStrength(place, new(0, 0, -1), from, 40, 10);
                Assert.Equal(expected, radiance.R[0], 1e-5);
                Assert.True((Vector3D.Of(sample.Direction, 0) - (place - from).Unit).Length < 1e-5);
            }
        }
    }

    [Fact]
    public void An_object_shown_twice_lights_twice() => Assert.Equal(2, Build("""
        { "type": "instance", "of": "lamp" }, { "type": "instance", "of": "lamp", "transform": [{ "translate": [1, 0, 0] }] }
        """, """ "objects": { "lamp": { "type": "point" } }, """).Lights.Count);

    [Fact]
    public void At_its_own_place_a_light_brings_nothing()
    {
        foreach (string type in new[] { "point", "spot", "projector" })
        {
            Only($$"""{ "type": "{{type}}", "position": [1, 2, 3] }""").Sample(new Vector3(1, 2, 3), 0f, 0f, 0f, out ShapeSampleW sample, out RgbW radiance);
            Assert.Equal((0, 0), (sample.InversePdf[0], radiance.R[0]));
        }
    }

    [Theory]
    [InlineData("point")]
    [InlineData("spot")]
    [InlineData("projector")]
    [InlineData("directional")]
    public void No_ray_meets_it_by_chance(string type)
    {
        LightSource light = Only($$"""{ "type": "{{type}}" }""");
        light.Pdf(default, out FloatW pdf);
        Assert.True(light.IsDelta);
        Assert.Equal(0, pdf[0]);
    }

    private static double Angle(Vector3 from) => Math.Acos(-((new Vector3D(1, 2, 3) - from).Unit.Y * -1)) * 180 / Math.PI;

    private static double SpotStrength(Vector3D place, Vector3D axis, Vector3D from, double cutoff, double beam)
    {
        Vector3D to = place - from;
        double angle = Math.Acos(Math.Clamp(-to.Unit.Dot(axis), -1, 1)) * 180 / Math.PI;
        return Math.Clamp((cutoff - angle) / (cutoff - beam), 0, 1) / to.Squared;
    }

    private static void Check(string json, Func<Vector3, double> strength, Func<Vector3, Vector3D> direction)
    {
        LightSource light = Only(json);
        foreach (Vector3 from in s_points)
        {
            light.Sample(from, 0f, 0f, 0f, out ShapeSampleW sample, out RgbW radiance);
            double expected = strength(from);
            Assert.Equal(6 * expected, radiance.R[0], 2e-5 * (1 + expected));
            Assert.Equal(3 * expected, radiance.G[0], 2e-5 * (1 + expected));
            Assert.Equal(expected, radiance.B[0], 2e-5 * (1 + expected));
            Assert.Equal(expected > 0, sample.InversePdf[0] > 0);
            Assert.True((Vector3D.Of(sample.Direction, 0) - direction(from)).Length < 1e-6);
            Assert.Equal((new Vector3D(1, 2, 3) - from).Length, sample.Distance[0], 1e-5);
        }
    }

    private static LightSource Only(string light) => Assert.Single(Build(light).Lights);

    private static Scene Build(string lights, string more = "") => TestScenes.Build($$"""{ {{more}} "shapes": [], "lights": [{{lights}}] }""");
}
