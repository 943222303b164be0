using System.Globalization;
using System.Numerics;
using RayTracer.Description;
using RayTracer.Rendering;
using RayTracer.Scenes;
using RayTracer.Testing;

namespace RayTracer.Benchmarks.Denoising;

/// <summary>Scenes that are hard for a denoiser, each for another reason.</summary>
internal static class DenoiserScenes
{
    private const string Lamp = """{ "type": "rectangle", "corner": [-2, 5, 0], "edgeU": [4, 0, 0], "edgeV": [0, 0, 2], "material": { "type": "luminaire", "multiplier": 8 } }""";
    private const string Tiles = """{ "type": "diffuse", "color": { "type": "checker", "even": [0.75, 0.7, 0.6], "odd": [0.2, 0.25, 0.3], "scale": [4, 4] } }""";
    private const string Mirror = """{ "type": "phongMetal", "color": [0.9, 0.9, 0.92], "exponent": 1000000 }""";

    /// <summary>The scenes: a name, and a file below scenes/ or the shapes of a picture.</summary>
    public static readonly (string Name, string Content)[] All =
    [
        ("report", "report/scene1.json"),
        ("room", "cornell.json"),
        ("fireflies", $$"""
            { "type": "sphere", "center": [0, 1, 0], "radius": 1, "material": { "type": "dielectric" } },
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.6, 0.6, 0.6] } },
            { "type": "sphere", "center": [2, 4, 1], "radius": 0.05, "material": { "type": "luminaire", "multiplier": 900 } },
            { "type": "sphere", "center": [-3, 5, 3], "radius": 1, "material": { "type": "luminaire", "multiplier": 4 } }
            """),
        ("caustics", $$"""
            { "type": "sphere", "center": [-1, 0.9, 0], "radius": 0.9, "material": { "type": "dielectric" } },
            { "type": "cylinder", "bottom": [1.1, 0, 0], "top": [1.1, 0.7, 0], "radius": 0.8, "material": {{Mirror}} },
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.6, 0.55, 0.5] } }, {{Lamp}}
            """),
        ("fog", "media/01-milk-and-fog.json"),
        ("textures", $$"""
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": {{Tiles}} },
            { "type": "rectangle", "corner": [-5, 0, -2], "edgeU": [10, 0, 0], "edgeV": [0, 5, 0],
              "material": { "type": "diffuse", "color": { "type": "checker", "even": [0.8, 0.3, 0.2], "odd": [0.7, 0.6, 0.5], "scale": [60, 30] } } },
            { "type": "sphere", "center": [0, 1, 0], "radius": 1, "material": { "type": "diffuse", "color": { "type": "checker", "even": [0.8, 0.8, 0.8], "odd": [0.1, 0.1, 0.1], "scale": [30, 15] } } }, {{Lamp}}
            """),
        ("mirrors", $$"""
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": {{Tiles}} },
            { "type": "rectangle", "corner": [-4, 0, -2], "edgeU": [8, 0, 0], "edgeV": [0, 4, 0], "material": {{Mirror}} },
            { "type": "sphere", "center": [-1.2, 0.9, 0], "radius": 0.9, "material": {{Mirror}} },
            { "type": "sphere", "center": [1, 0.7, 0.5], "radius": 0.7, "material": { "type": "diffuse", "color": [0.8, 0.2, 0.1] } }, {{Lamp}}
            """),
        ("glass", "materials/04-frosted-glass.json"),
        ("foliage", $$"""{ "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.3, 0.25, 0.2] } }, {{Leaves()}}, {{Lamp}}"""),
        ("studio", "lights/02-studio.json"),
        ("metals", "materials/02-rough-metals.json"),
        ("motion", "meshes/04-motion-blur.json"),
        ("polish", $$"""
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": {{Tiles}} },
            { "type": "box", "a": [-2, 0, -1], "b": [2, 1.6, 0], "material": { "type": "principled", "roughness": 0.3, "clearcoat": 0.6,
              "baseColor": { "type": "wood", "first": [0.16, 0.08, 0.04], "second": [0.08, 0.035, 0.018], "rings": 18, "turbulence": 2 } } }, {{Lamp}}
            """),
    ];

    /// <summary>Builds a scene.</summary>
    public static Scene Build((string Name, string Content) scene, int width, int height, int samples, long seed)
    {
        SceneDescription Change(SceneDescription d) => d with { Render = d.Render with { Width = width, Height = height, SamplesPerPixel = samples, Seed = seed } };
        SceneLoadResult result = scene.Content.EndsWith(".json", StringComparison.Ordinal)
            ? SceneLoader.Load(Path.Combine(ProjectFolder.PathOf("scenes"), scene.Content), Change)
            : SceneLoader.LoadText(Text(scene.Content), scene.Name, ".", Change);
        return result.Scene ?? throw new InvalidOperationException(Diagnostic.Format(result.Diagnostics));
    }

    private static string Text(string shapes) => $$"""
        { "camera": { "position": [0, 2.2, 6], "lookAt": [0, 0.9, 0], "fieldOfView": 36 }, "background": [0.2, 0.25, 0.3],
          "render": { "integrator": "path", "maxDepth": 12 }, "shapes": [{{shapes}}] }
        """;

    private static string Leaves()
    {
        uint state = 1;
        float Next() => ((state = (state * 1664525u) + 1013904223u) >> 8) / 16777216f;
        return string.Join(",\n", Enumerable.Range(0, 900).Select(_ =>
        {
            Vector3 at = new((4 * Next()) - 2, 2.2f * Next(), (2 * Next()) - 1);
            string Corner() => string.Create(CultureInfo.InvariantCulture,
                $"[{at.X + (0.3f * Next()):F3}, {at.Y + (0.3f * Next()):F3}, {at.Z + (0.3f * Next()):F3}]");
            return string.Create(CultureInfo.InvariantCulture,
                $$"""{ "type": "triangle", "a": {{Corner()}}, "b": {{Corner()}}, "c": {{Corner()}}, "material": { "type": "diffuse", "color": [{{0.1f + (0.3f * Next()):F2}}, {{0.3f + (0.3f * Next()):F2}}, 0.1] } }""");
        }));
    }
}
