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

    /// <summary>Scenes on which nothing was tuned: they show whether the settings suit others.</summary>
    public static readonly (string Name, string Content)[] Checks =
    [
        ("vanity", $$"""
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": { "type": "marble", "first": [0.7, 0.66, 0.6], "second": [0.3, 0.25, 0.22], "scale": 3, "turbulence": 4 } } },
            { "type": "rectangle", "corner": [-5, 0, -3], "edgeU": [10, 0, 0], "edgeV": [0, 6, 0], "material": { "type": "diffuse", "color": { "type": "checker", "even": [0.55, 0.6, 0.5], "odd": [0.75, 0.72, 0.6], "scale": [24, 14] } } },
            { "type": "rectangle", "corner": [-2.6, 0.1, -0.8], "edgeU": [1.9, 0, -1.3], "edgeV": [0, 2.2, 0], "material": {{Mirror}} },
            { "type": "rectangle", "corner": [0.3, 0, 1.4], "edgeU": [1.7, 0, 0.3], "edgeV": [0, 1.5, 0], "material": { "type": "thinDielectric" } },
            { "type": "sphere", "center": [1.2, 0.6, 0.2], "radius": 0.6, "material": { "type": "diffuse", "color": { "type": "checker", "even": [0.7, 0.2, 0.1], "odd": [0.9, 0.8, 0.5], "scale": [12, 6] } } },
            { "type": "sphere", "center": [-0.6, 0.5, 0.9], "radius": 0.5, "material": { "type": "dielectric" } },
            { "type": "cylinder", "bottom": [-1.7, 0, 1], "top": [-1.7, 0.8, 1], "radius": 0.3, "material": { "type": "roughConductor", "metal": "gold", "alpha": 0.15 } },
            { "type": "sphere", "center": [1.5, 4, 3], "radius": 0.4, "material": { "type": "luminaire", "multiplier": 40 } }
            """),
        ("attic", $$"""
            { "type": "box", "a": [-3, -0.1, -3], "b": [3, 0, 8], "material": { "type": "diffuse", "color": { "type": "wood", "first": [0.5, 0.33, 0.18], "second": [0.34, 0.19, 0.09], "rings": 14, "turbulence": 2 } } },
            { "type": "box", "a": [-3, 0, -3.1], "b": [3, 4, -3], "material": { "type": "diffuse", "color": [0.7, 0.68, 0.62] } },
            { "type": "box", "a": [-3, 4, -3], "b": [3, 4.1, 8], "material": { "type": "diffuse", "color": [0.75, 0.75, 0.72] } },
            { "type": "box", "a": [-3, 0, 8], "b": [3, 4, 8.1], "material": { "type": "diffuse", "color": [0.6, 0.6, 0.6] } },
            { "type": "box", "a": [3, 0, -3], "b": [3.1, 4, 8], "material": { "type": "diffuse", "color": [0.3, 0.45, 0.5] } },
            { "type": "box", "a": [-3.1, 0, -3], "b": [-3, 1.4, 8], "material": { "type": "diffuse", "color": [0.65, 0.5, 0.4] } },
            { "type": "box", "a": [-3.1, 2.6, -3], "b": [-3, 4, 8], "material": { "type": "diffuse", "color": [0.65, 0.5, 0.4] } },
            { "type": "box", "a": [-3.1, 1.4, 1], "b": [-3, 2.6, 8], "material": { "type": "diffuse", "color": [0.65, 0.5, 0.4] } },
            { "type": "box", "a": [-1.6, 0, -1.5], "b": [-0.5, 1.1, -0.6], "material": { "type": "principled", "baseColor": [0.3, 0.12, 0.06], "roughness": 0.4 } },
            { "type": "box", "a": [0.3, 0, -2], "b": [1.9, 0.7, -0.2], "material": { "type": "principled", "baseColor": [0.1, 0.25, 0.2], "roughness": 0.8 } },
            { "type": "sphere", "center": [1, 1.05, -1], "radius": 0.35, "material": { "type": "principled", "baseColor": [0.8, 0.8, 0.75], "roughness": 0.15, "clearcoat": 1 } },
            { "type": "rectangle", "corner": [-5, 0, 1], "edgeU": [0, 0, -5], "edgeV": [0, 4, 0], "material": { "type": "luminaire", "color": [1, 0.9, 0.75], "multiplier": 9 } }
            """),
        ("stall", $$"""
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": { "type": "noise", "first": [0.3, 0.26, 0.2], "second": [0.6, 0.55, 0.45], "scale": 5, "octaves": 4 } } },
            {{Fruit()}},
            { "type": "sphere", "center": [-2, 3, 2], "radius": 0.2, "material": { "type": "luminaire", "color": [1, 0.8, 0.6], "multiplier": 90 } },
            { "type": "sphere", "center": [3, 5, 1], "radius": 0.8, "material": { "type": "luminaire", "color": [0.7, 0.85, 1], "multiplier": 8 } }
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

    // Rows of glossy balls, each of its own colour.
    private static string Fruit() => string.Join(",\n", Enumerable.Range(0, 70).Select(i => string.Create(CultureInfo.InvariantCulture,
        $$"""{ "type": "sphere", "center": [{{(0.44 * (i % 10)) - 2 + (0.2 * (i / 10 % 2)):F2}}, {{0.2 + (0.18 * (i / 10)):F2}}, {{1 - (0.4 * (i / 10)):F2}}], "radius": 0.2, "material": { "type": "principled", "baseColor": [{{0.1 + (0.8 * (i * 7 % 11) / 11.0):F2}}, {{0.1 + (0.7 * (i * 5 % 13) / 13.0):F2}}, {{0.05 + (0.4 * (i * 3 % 7) / 7.0):F2}}], "roughness": {{0.15 + (0.1 * (i % 7)):F2}}, "clearcoat": {{i % 2}} } }""")));
}
