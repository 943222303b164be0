using RayTracer.Rendering;

namespace RayTracer.RenderTests.Transport.LightPaths;

/// <summary>
/// How many edges paths have, however they are made: the camera sees a wall that is lit only by way of another one, which it does not see. So with two edges
/// there is no light at all, and with three there is.
/// Covers `CameraSubpaths`, `LightSubpaths`, `Connections` and `PhotonMerge`.
/// </summary>
public class PathLengthTests
{
    // What the spot, or the lamp, does not shine at is behind it.
    private const string Spot = """{ "type": "spot", "position": [1, 1, 0], "direction": [1, 0, 0], "intensity": [9, 9, 9], "cutoffAngle": 20, "beamWidth": 15 }""";
    private const string Lamp = """{ "type": "rectangle", "corner": [1, 0.8, 0.2], "edgeU": [0, 0, -0.4], "edgeV": [0, 0.4, 0], "material": { "type": "luminaire", "multiplier": 9 } }""";
    private const string Pane = """{ "type": "rectangle", "corner": [-1, 0, 2], "edgeU": [1.9, 0, 0], "edgeV": [0, 2, 0], "material": { "type": "thinDielectric", "refractiveIndex": 1 } }""";

    [Theory]
    [InlineData("path", Spot)]
    [InlineData("path", Lamp)]
    [InlineData("volPath", Lamp)]
    [InlineData("light", Spot)]
    [InlineData("light", Lamp)]
    [InlineData("bidirectional", Spot)]
    [InlineData("bidirectional", Lamp)]
    [InlineData("photons", Spot)]
    [InlineData("photons", Lamp)]
    [InlineData("vcm", Spot)]
    [InlineData("vcm", Lamp)]
    public void Paths_have_as_many_edges_as_they_may_and_not_one_more(string integrator, string light)
    {
        Assert.Equal(0, Brightest(integrator, light, maxDepth: 2));
        Assert.True(Brightest(integrator, light, maxDepth: 3) > 0.01);
        if (integrator != "light")
        {
            // Through a pane, the camera's path is an edge longer: where it ends, it may be merged with paths from the lights.
            Assert.Equal(0, Brightest(integrator, $"{Pane}, {light}", maxDepth: 3));
            Assert.True(Brightest(integrator, $"{Pane}, {light}", maxDepth: 4) > 0.01);
        }
    }

    private static float Brightest(string integrator, string shapes, int maxDepth)
    {
        Film film = new RTracer(TestScenes.Build($$"""
            {
              "camera": { "position": [0, 1, 3], "lookAt": [0, 1, -1], "fieldOfView": 18 },
              "render": { "integrator": "{{integrator}}", "width": 16, "height": 16, "samplesPerPixel": 16, "maxDepth": {{maxDepth}}, "mergeRadius": 0.2 },
              "shapes": [
                { "type": "rectangle", "corner": [-1, 0, -1], "edgeU": [1.9, 0, 0], "edgeV": [0, 2, 0], "material": { "type": "diffuse", "color": [0.9, 0.9, 0.9] } },
                { "type": "rectangle", "corner": [2, 0, 0.8], "edgeU": [0, 0, -1.6], "edgeV": [0, 2, 0], "material": { "type": "diffuse", "color": [0.9, 0.9, 0.9] } },
                {{shapes}}
              ]
            }
            """)).Render().Film;
        float[] row = new float[3 * film.Width];
        float brightest = 0;
        for (int y = 0; y < film.Height; y++)
        {
            film.ReadRow(y, row);
            brightest = Math.Max(brightest, row.Max(float.Abs));
        }

        return brightest;
    }
}
