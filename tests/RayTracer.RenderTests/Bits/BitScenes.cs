using RayTracer.Description;
using RayTracer.Rendering;

namespace RayTracer.RenderTests.Bits;

/// <summary>The scenes whose bits are known: the report's, the primer's, that of all shapes and the test scene of everything, all small.</summary>
internal static class BitScenes
{
    /// <summary>Meshes and instances in trees of some depth.</summary>
    public const string Hills = "hills";

    /// <summary>Glass that disperses light and weakens shadows.</summary>
    public const string DispersingShadows = "dispersing-shadows";

    /// <summary>Boundaries of clouds inside of other materials, between the lamp and what it lights.</summary>
    public const string WrappedBoundaries = "wrapped-boundaries";

    /// <summary>Large triangles of meshes, shaded with literal normals and transmitting light, before lamps that are meshes.</summary>
    public const string MeshLamps = "mesh-lamps";

    /// <summary>A lamp that is a mesh, just behind a pane of nothing.</summary>
    public const string LampBehindPane = "lamp-behind-pane";

    /// <summary>Panes, masks and a cloud that are no bounce.</summary>
    public const string StraightThrough = "straight-through";

    /// <summary>Media that scatter by other phase functions or shine, by path, and thin sheets.</summary>
    public const string Phases = "phases";

    private const string Everything = "everything-";
    private const string Split = "split/";
    private const string LightPath = "light-paths-";

    // The same in fog, with a lamp in milk that overlaps with the ball.
    private const string InFog = "-in-fog";
    private const string Fog = """
        { "type": "box", "a": [-3, -1, -3], "b": [3, 3, 3], "material": { "type": "invisible", "interior": { "extinction": [0.1, 0.15, 0.2], "albedo": [0.9, 0.8, 0.7], "anisotropy": 0.6 } } },
        { "type": "sphere", "center": [-0.1, 0.5, 0.4], "radius": 0.4, "material": { "type": "roughDielectric", "alpha": 0.3, "refractiveIndex": 1.3, "priority": 1, "interior": { "extinction": [2, 3, 4], "albedo": [0.9, 0.9, 0.8] } } },
        { "type": "sphere", "center": [-0.1, 0.5, 0.4], "radius": 0.2, "material": { "type": "luminaire", "multiplier": 9 } },
        """;

    // A ring and a mesh, placed and moving, glass and its caustic, a lamp that shines on them and one behind them.
    private const string Caustic = """
        {
          "camera": { "position": [0.2, 1.4, 4], "lookAt": [0, 0.5, 0], "fieldOfView": 34, "lens": { "apertureRadius": 0.05 } },
          "render": { SIZE, "integrator": "INTEGRATOR", "shutter": [0, 1], "filter": { "shape": "gaussian" } },
          "shapes": [
            { "type": "rectangle", "corner": [-2, 0, 2], "edgeU": [4, 0, 0], "edgeV": [0, 0, -4], "material": { "type": "diffuse", "color": [0.5, 0.6, 0.7] } },
            { "type": "sphere", "center": [-0.5, 0.5, 0.3], "radius": 0.45, "material": { "type": "dielectric", "glass": "sf11" } },
            {
              "type": "instance", "transform": [{ "scale": [0.8, -0.6, 0.7], "rotate": 40, "axis": [0, 0, 1], "translate": [0.7, 0.6, 0.1] }],
              "motion": [{ "time": 0 }, { "time": 1, "transform": [{ "translate": [0.2, 0.1, -0.3] }] }],
              "of": {
                "type": "mesh", "shading": "smooth", "positions": [[-0.6, -0.5, 0.4], [0.6, -0.5, 0.4], [0, -0.5, -0.7], [0, 0.7, 0]],
                "triangles": [[0, 2, 1], [0, 1, 3], [1, 2, 3], [2, 0, 3]], "material": { "type": "roughPlastic", "alpha": 0.3, "color": [0.7, 0.3, 0.2] }
              }
            },
            { "type": "sphere", "center": [-1, 2, 0.8], "radius": 0.25, "material": { "type": "luminaire", "multiplier": 20 } },
            { "type": "point", "position": [0.9, 1.4, -0.8], "intensity": [0.5, 0.8, 1.2] }
          ]
        }
        """;

    // Rays to the lamp meet glass from both sides, before and after paths have a wavelength.
    private const string Prisms = """
        {
          "camera": { "position": [0, 1.5, 5], "lookAt": [0, 0.5, 0], "fieldOfView": 40 },
          "render": { "width": 32, "height": 24, "samplesPerPixel": 4, "integrator": "report", "maxDiffuseDepth": 2, "maxSpecularDepth": 6, "weakenedShadows": true },
          "background": [0.1, 0.2, 0.3],
          "shapes": [
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.7, 0.7, 0.7] } },
            { "type": "sphere", "center": [-1, 0.8, 0], "radius": 0.6, "material": { "type": "dielectric", "glass": "diamond", "extinction": [0.2, 0.9, 2] } },
            { "type": "cone", "bottom": [0.9, 0.1, 0], "top": [0.9, 1.4, 0], "radius": 0.6, "material": { "type": "dielectric", "glass": "sf11" } },
            { "type": "sphere", "center": [0, 4, 0], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 20 } }
          ]
        }
        """;

    private const string Clouds = """
        {
          "camera": { "position": [0, 1.5, 6], "lookAt": [0, 1, 0], "fieldOfView": 40 },
          "render": { "width": 32, "height": 24, "samplesPerPixel": 4, "integrator": "volPath", "maxDepth": 8 },
          "materials": { "cloud": { "type": "invisible", "interior": { "extinction": [2, 1, 0.5], "albedo": [0.9, 0.9, 0.9] } } },
          "shapes": [
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.7, 0.7, 0.7] } },
            { "type": "sphere", "center": [-1.5, 1.2, 0], "radius": 0.7, "material": { "type": "mask", "opacity": 0.5, "material": "cloud" } },
            { "type": "sphere", "center": [0, 1.2, 0], "radius": 0.7, "material": { "type": "bumpMap", "map": { "type": "marble" }, "material": "cloud" } },
            { "type": "sphere", "center": [1.5, 1.2, 0], "radius": 0.7, "material": { "type": "mix", "first": "cloud", "second": "cloud" } },
            { "type": "sphere", "center": [0, 4, 0], "radius": 0.3, "material": { "type": "luminaire", "multiplier": 20 } }
          ]
        }
        """;

    private const string Walls = """
        {
          "camera": { "position": [0, 3, 12], "lookAt": [0, 0, 0], "fieldOfView": 60 },
          "render": { "width": 32, "height": 24, "samplesPerPixel": 4, "integrator": "path", "maxDepth": 4, "shadingNormals": "literal" },
          "shapes": [
            {
              "type": "mesh", "positions": [[-10, -10, 0], [10, -10, 0], [10, 10, 0], [-10, 10, 0]], "triangles": [[0, 1, 2], [0, 2, 3]], "shading": "smooth",
              "material": { "type": "mix", "first": { "type": "diffuse", "color": [0.8, 0.8, 0.8] }, "second": { "type": "translucent", "transmittance": [0.3, 0.5, 0.2] } }
            },
            {
              "type": "mesh", "positions": [[-2, 1, 2], [0, 1, 2], [0, 3, 2], [-2, 3, 2]], "triangles": [[0, 2, 1], [0, 3, 2]],
              "material": { "type": "luminaire", "multiplier": 30 }
            },
            {
              "type": "mesh", "positions": [[0, -3, -2], [2, -3, -2], [2, -1, -2], [0, -1, -2]], "triangles": [[0, 1, 2], [0, 2, 3]],
              "material": { "type": "luminaire", "color": [1, 0.5, 0.2], "multiplier": 30 }
            }
          ]
        }
        """;

    private const string Pane = """
        {
          "camera": { "position": [0, 1.3, 5], "lookAt": [0, 0.8, 0], "fieldOfView": 40 },
          "render": { "width": 32, "height": 24, "samplesPerPixel": 4, "integrator": "volPath", "maxDepth": 4 },
          "shapes": [
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.7, 0.7, 0.7] } },
            { "type": "sphere", "center": [0, 0.6, 0], "radius": 0.6, "material": { "type": "diffuse", "color": [0.7, 0.5, 0.3] } },
            {
              "type": "box", "a": [-9, 2.05, -9], "b": [9, 2.1, 9],
              "material": { "type": "invisible", "interior": { "extinction": [1e-6, 1e-6, 1e-6], "albedo": [0, 0, 0] } }
            },
            {
              "type": "mesh", "positions": [[-1, 2.15, -1], [1, 2.15, -1], [1, 2.15, 1], [-1, 2.15, 1]], "triangles": [[0, 1, 2], [0, 2, 3]],
              "material": { "type": "luminaire", "multiplier": 4 }
            }
          ]
        }
        """;

    private const string Panes = """
        {
          "camera": { "position": [0, 1.6, 5], "lookAt": [0, 0.8, 0], "fieldOfView": 40 },
          "render": { "width": 32, "height": 24, "samplesPerPixel": 4, "integrator": "volPath", "maxDepth": 3, "straightThrough": true },
          "background": [0.1, 0.15, 0.2],
          "shapes": [
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "roughConductor", "metal": "gold", "alpha": 0.3 } },
            { "type": "sphere", "center": [-0.8, 0.6, 0], "radius": 0.6, "material": { "type": "mask", "opacity": 0.5, "material": { "type": "diffuse", "color": 0.7 } } },
            { "type": "sphere", "center": [0.8, 0.6, 0], "radius": 0.6, "material": { "type": "invisible", "interior": { "extinction": [1, 2, 3], "albedo": 0.9 } } },
            { "type": "rectangle", "corner": [-1.5, 1.4, 1], "edgeU": [3, 0, 0], "edgeV": [0, 0.3, -2], "material": { "type": "thinDielectric", "specularTransmittance": [0.9, 0.6, 0.3] } },
            { "type": "sphere", "center": [0, 3, 0], "radius": 0.4, "material": { "type": "luminaire", "multiplier": 20 } },
            { "type": "point", "position": [1, 2.5, 1], "intensity": 3 }
          ]
        }
        """;

    private const string Haze = """
        {
          "camera": { "position": [0, 1.2, 5], "lookAt": [0, 0.8, 0], "fieldOfView": 40 },
          "render": { "width": 32, "height": 24, "samplesPerPixel": 4, "integrator": "path" },
          "background": [0.1, 0.15, 0.2],
          "shapes": [
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": 0.6 } },
            { "type": "box", "a": [-2, 0.1, -1.5], "b": [2, 2.2, 1.5], "material": { "type": "invisible", "interior": { "extinction": [0.2, 0.3, 0.5], "albedo": 0.9, "emission": [0.01, 0.02, 0],
              "phase": { "shape": "mix", "weight": 0.9, "weightGrid": { "size": [3, 1, 1], "values": [0, 0.5, 1], "box": [[-2, 0, -1], [2, 2, 1]] },
                "first": { "shape": "rayleigh" }, "second": { "shape": "table", "values": [2, 0.5, 0, 1, 8] } } } } },
            { "type": "sphere", "center": [-0.8, 0.8, 0], "radius": 0.5, "material": { "type": "invisible", "interior": { "extinction": [3, 2, 1], "albedo": 0.8, "noise": { "box": [[-1.5, 0, -1], [0, 1.5, 1]] },
              "phase": { "shape": "mix", "first": { "anisotropy": 0.7 }, "second": { "shape": "rayleigh" } } } } },
            { "type": "rectangle", "corner": [0.2, 0.2, 0.6], "edgeU": [1, 0, -0.6], "edgeV": [0, 1.2, 0], "material": { "type": "thinPrincipled", "baseColor": [0.8, 0.5, 0.3], "roughness": 0.6, "anisotropic": 0.5,
              "transmission": 0.5, "diffuseTransmission": 0.6, "specularTint": 0.5, "sheen": 0.4, "flatness": 0.5 } },
            { "type": "sphere", "center": [0, 3, 0.5], "radius": 0.4, "material": { "type": "luminaire", "multiplier": 20 } }
          ]
        }
        """;

    /// <summary>Names of all scenes.</summary>
    public static IReadOnlyList<string> All { get; } =
        [.. Report, .. Samplers, .. Splitting, "shapes", "cornell", Hills, DispersingShadows, WrappedBoundaries, MeshLamps, LampBehindPane, StraightThrough, Phases, .. Folders.SelectMany(In)];

    /// <summary>Names of scenes that are guided.</summary>
    public static string[] Guided => ["guided/screen"];

    /// <summary>Names of scenes whose auxiliary images are looked at.</summary>
    public static string[] Auxiliary => ["aov/everything-sobol", "aov/meshes/01-cube", "aov/meshes/02-smooth", "aov/meshes/04-motion-blur"];

    /// <summary>All that is compared between settings of the runtime.</summary>
    public static IEnumerable<string> Pictures => [.. All, .. LightPaths, .. Guided, .. Auxiliary, .. Denoised];

    /// <summary>Names of scenes whose denoised pictures are looked at.</summary>
    public static string[] Denoised => ["denoised/everything-sobol"];

    /// <summary>Names of the report's scenes.</summary>
    public static string[] Report => ["report/scene1", "report/scene2", "report/scene3"];

    /// <summary>The scene of everything, with each sampler.</summary>
    public static string[] Samplers => [.. new[] { "independent", "jittered", "regular", "sobol" }.Select(s => Everything + s)];

    /// <summary>Scenes of so many samples that some share their camera's rays: by both kinds of samplers, and by both integrators.</summary>
    public static string[] Splitting => [Split + "cornell", Split + "report/scene2", Split + "materials/10-principled"];

    /// <summary>Scenes of media that vary.</summary>
    public static string[] Varying => ["media/03-cloud", "media/04-smoke", "media/05-noise", "media/06-fire", "media/07-fibres"];

    /// <summary>Names of the scenes of meshes, instances and motion.</summary>
    public static IReadOnlyList<string> Meshes => In("meshes");

    /// <summary>Names of the scenes of lights.</summary>
    public static IReadOnlyList<string> Lights => In("lights");

    // All folders of scenes but those of the report, which are larger, those of which tiles are rendered, and those that are wrong.
    private static IEnumerable<string> Folders =>
        Directory.GetDirectories(ProjectFolder.PathOf("scenes")).Select(f => Path.GetFileName(f)).Where(f => f is not ("broken" or "gallery" or "report")).Order(StringComparer.Ordinal);

    /// <summary>One scene, by each of the integrators whose paths start at the lights, too.</summary>
    public static string[] LightPaths => [.. new[] { "light", "bidirectional", "photons", "vcm" }.SelectMany(i => new[] { LightPath + i, LightPath + i + InFog })];

    /// <summary>Names of the scenes in a folder.</summary>
    public static string[] In(string folder) =>
        [.. Directory.GetFiles(ProjectFolder.PathOf("scenes", folder), "*.json").Select(f => $"{folder}/{Path.GetFileNameWithoutExtension(f)}").Order(StringComparer.Ordinal)];

    /// <summary>Loads a scene, at 64×64 pixels and 4 samples (the primer's at 32×24).</summary>
    public static Scene Load(string name) => name.StartsWith(Everything, StringComparison.Ordinal)
        ? TestScenes.BuildEverything(name[Everything.Length..])
        : name.StartsWith(LightPath, StringComparison.Ordinal) ? LoadCaustic(name)
        : Guided.Contains(name) ? GuidedScenes.Learned(TestScenes.Build(GuidedScenes.Screen), new() { Threads = 2 })
        : name == Hills ? HillScene.Build()
        : name == DispersingShadows ? TestScenes.Build(Prisms)
        : name == WrappedBoundaries ? TestScenes.Build(Clouds)
        : name == MeshLamps ? TestScenes.Build(Walls)
        : name == LampBehindPane ? TestScenes.Build(Pane)
        : name == StraightThrough ? TestScenes.Build(Panes)
        : name == Phases ? TestScenes.Build(Haze)
        : name.StartsWith(Split, StringComparison.Ordinal)
            ? SceneRuns.Load(ProjectFolder.PathOf("scenes", name[Split.Length..] + ".json"), d => d with { Render = Small(d, 24, 24).Render with { SamplesPerPixel = 64 } })
        : SceneRuns.Load(ProjectFolder.PathOf("scenes", name + ".json"), name.StartsWith("report", StringComparison.Ordinal) ? d => Small(d, 64, 64) : d => Small(d, 32, 24));

    /// <summary>Loads a scene of <see cref="LightPaths"/>.</summary>
    /// <param name="name">Its name.</param>
    /// <param name="size">Its size and samples, as a scene file has them.</param>
    public static Scene LoadCaustic(string name, string size = """ "width": 22, "height": 18, "samplesPerPixel": 4 """)
    {
        bool isInFog = name.EndsWith(InFog, StringComparison.Ordinal);
        string integrator = name[LightPath.Length..].Replace(InFog, "", StringComparison.Ordinal);
        string text = Caustic.Replace("INTEGRATOR", integrator, StringComparison.Ordinal).Replace("SIZE", size, StringComparison.Ordinal);
        text = isInFog ? text.Replace("\"shapes\": [", "\"shapes\": [" + Fog, StringComparison.Ordinal).Replace("\"glass\": \"sf11\"", "\"glass\": \"sf11\", \"priority\": 2", StringComparison.Ordinal) : text;
        return TestScenes.Build(text);
    }

    private static SceneDescription Small(SceneDescription d, int width, int height) =>
        d with { Render = d.Render with { Width = width, Height = height, SamplesPerPixel = 4 } };
}
