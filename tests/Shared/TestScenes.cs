using RayTracer.Rendering;
using RayTracer.Scenes;

namespace RayTracer.Testing;

/// <summary>Small scenes for tests, written as scene files are.</summary>
public static class TestScenes
{
    /// <summary>All materials, shapes and textures at once, at 48×32 pixels and 16 samples.</summary>
    public const string Everything = """
        {
          "camera": { "position": [0, 1.6, 5], "lookAt": [0, 0.7, 0], "fieldOfView": 45, "lens": { "apertureRadius": 0.05, "focusDistance": 5 } },
          "render": { "integrator": "report", "width": 48, "height": 32, "samplesPerPixel": 16, "sampler": "SAMPLER" },
          "background": "skyblue",
          "ambient": [0.02, 0.02, 0.05],
          "materials": {
            "mirror": { "type": "phongMetal", "color": [0.9, 0.8, 0.7], "exponent": 1000 },
            "glass": { "type": "dielectric", "refractiveIndex": 1.5, "extinction": [0.5, 0.1, 0.3] },
            "board": { "type": "diffuse", "color": { "type": "checker", "scale": [2, 2] } }
          },
          "shapes": [
            { "type": "sphere", "center": [-1.2, 0.6, 0], "radius": 0.6, "material": "glass" },
            { "type": "sphere", "center": [0.2, 0.6, -0.6], "radius": 0.6, "material": "mirror" },
            { "type": "sphere", "center": [1.4, 0.5, 0.4], "radius": 0.5, "material": { "type": "diffuseSpecular", "diffuse": { "type": "diffuse", "color": "seagreen" }, "specular": "mirror" } },
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": "board" },
            { "type": "plane", "point": [0, 1, -2], "normal": [0, 0, 1], "size": [3, 2], "material": "board" },
            { "type": "triangle", "a": [-2, 0, -1], "b": [-1, 0, -1.5], "c": [-1.5, 1.5, -1.2], "material": { "type": "diffuse", "color": "tomato" } }
          ],
          "lights": [
            { "type": "sphere", "center": [1, 3, 2], "radius": 0.3, "material": { "type": "luminaire", "multiplier": 12, "exponent": 1, "material": "mirror" } },
            { "type": "plane", "point": [-2, 3, 1], "normal": [1, -1, 0], "size": [1, 1], "material": { "type": "luminaire", "color": { "type": "checker", "scale": [4, 4] }, "multiplier": 6 } }
          ]
        }
        """;

    /// <summary>Builds a scene from text; fails with its diagnostics.</summary>
    public static Scene Build(string json)
    {
        SceneReadResult read = SceneReader.ReadText(json, "test.json");
        SceneLoadResult result = SceneLoader.Build(read, ".");
        return result.Scene ?? throw new InvalidOperationException(Diagnostic.Format(result.Diagnostics));
    }

    /// <summary>The scene of everything, with a sampler.</summary>
    public static Scene BuildEverything(string sampler = "sobol") => Build(Everything.Replace("SAMPLER", sampler, StringComparison.Ordinal));
}
