using RayTracer.Rendering;

namespace RayTracer.Tests.Rendering;

/// <summary>
/// Several points of lights where paths first meet the scene (<see cref="Scene.PointsOfFirst"/>) bring the light that one point brings. The same scene has one
/// where there is a medium, however far away.
/// </summary>
public class PointsOfFirstTests
{
    private const string Lamp = """{ "type": "rectangle", "corner": [-1, 2, -1], "edgeU": [2, 0, 0], "edgeV": [0, 0, 2], "material": { "type": "luminaire", "multiplier": 4 } }""";

    private static readonly string s_many = string.Join(',', Enumerable.Range(0, 12).Select(i =>
        $$"""{ "type": "sphere", "center": [{{(i % 4) - 1.5}}, {{1 + (0.3 * (i % 3))}}, {{(i / 4) - 1}}], "radius": {{0.05 + (0.02 * i)}}, "material": { "type": "luminaire", "multiplier": {{1 + i}} } }"""));

    // Points; lights; the environment. A lamp without extent has one point; of many lights there are four choices.
    public static TheoryData<int, string, string> Lights() => new()
    {
        { 2, Lamp, "null" },
        { 2, Lamp + """, { "type": "point", "position": [1, 1, 1], "intensity": [3, 3, 3] }""", "null" },
        { 1, """{ "type": "point", "position": [1, 1, 1], "intensity": [3, 3, 3] }""", "null" },
        { 2, "", """{ "type": "sky", "sunElevation": 40 }""" },
        { 4, s_many, "null" },
        { 4, s_many, """{ "type": "sky", "sunElevation": 40 }""" },
    };

    [Theory]
    [MemberData(nameof(Lights))]
    public void They_bring_the_light_of_one(int points, string lights, string environment)
    {
        Scene several = Build(points, lights, environment, "path", "");
        Scene one = Build(1, lights, environment, "volPath", """{ "type": "sphere", "center": [0, -900, 0], "radius": 1, "material": { "type": "invisible", "interior": { "extinction": [1, 1, 1] } } },""");
        (double expected, double actual) = (Mean(one), Mean(several));
        Assert.Equal(1, actual / expected, 0.004);
    }

    private static Scene Build(int points, string lights, string environment, string integrator, string more)
    {
        Scene scene = TestScenes.Build($$"""
            {
              "camera": { "position": [0, 1.5, 4], "lookAt": [0, 0.4, 0], "fieldOfView": 40 },
              "render": { "integrator": "{{integrator}}", "maxDepth": 3, "width": 24, "height": 24, "samplesPerPixel": 256, "splitting": 1 },
              {{(environment == "null" ? "" : $"\"environment\": {environment},")}}
              "shapes": [
                {{more}}
                { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "roughConductor", "alpha": 0.3 } },
                { "type": "sphere", "center": [0, 0.5, 0], "radius": 0.5, "material": { "type": "diffuse", "color": [0.8, 0.6, 0.4] } }
              ],
              "lights": [{{lights}}]
            }
            """);
        Assert.Equal(points, scene.PointsOfFirst);
        return scene;
    }

    private static double Mean(Scene scene)
    {
        Film film = new RTracer(scene).Render().Film;
        double sum = 0;
        for (int y = 0; y < film.Height; y++)
        {
            for (int x = 0; x < film.Width; x++)
            {
                // Of bright reflections of small lamps only so much that they do not decide.
                sum += Math.Min(film.Mean(x, y).Luminance, 3);
            }
        }

        return sum;
    }
}
