using RayTracer.Rendering;

namespace RayTracer.Testing;

/// <summary>Small scenes whose light is found by chance.</summary>
public static class GuidedScenes
{
    /// <summary>A box with a lamp behind a screen, and things of several materials in it.</summary>
    public const string Screen = """
        {
          "camera": { "position": [0, 1, 3.9], "lookAt": [0, 1, 0], "fieldOfView": 50 },
          "render": { "integrator": "path", "width": 24, "height": 16, "samplesPerPixel": 16 },
          "materials": { "wall": { "type": "diffuse", "color": [0.7, 0.6, 0.5] } },
          "shapes": [
            { "type": "box", "a": [-2, 0, -2], "b": [2, 2, 4], "material": "wall" },
            { "type": "box", "a": [-2, 0, -1.2], "b": [1.2, 2, -1.1], "material": "wall" },
            { "type": "sphere", "center": [-0.8, 0.5, 0], "radius": 0.5, "material": { "type": "plastic", "color": [0.3, 0.5, 0.2] } },
            { "type": "sphere", "center": [0.4, 0.4, 0.6], "radius": 0.4, "material": { "type": "roughConductor", "metal": "gold", "alpha": 0.3 } },
            { "type": "sphere", "center": [1.2, 0.4, 0.8], "radius": 0.35, "material": { "type": "dielectric", "refractiveIndex": 1.5 } },
            { "type": "sphere", "center": [-0.2, 1.4, 0.5], "radius": 0.3, "material": { "type": "translucent", "color": [0.4, 0.4, 0.4], "transmittance": [0.3, 0.5, 0.2] } }
          ],
          "lights": [
            { "type": "rectangle", "corner": [-1.6, 1.99, -1.9], "edgeU": [0.8, 0, 0], "edgeV": [0, 0, 0.5], "material": { "type": "luminaire", "multiplier": 40 } }
          ]
        }
        """;

    /// <summary>Learns, and returns the guided scene.</summary>
    public static Scene Learned(Scene scene, RenderOptions? options = null) => scene.Guided(new GuideLearning(scene, options ?? new()).Learn());
}
