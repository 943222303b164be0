using System.Globalization;
using System.Text.RegularExpressions;
using RayTracer.Testing;

namespace RayTracer.Benchmarks.Standing;

/// <summary>
/// The scenes on which builds are compared before a release. Each file names integrator, sampler, depth and samples itself, since another build
/// may have other defaults; a render takes three to fifteen seconds of processor time, so that the start of the program does not decide.
/// </summary>
internal static partial class StandingScenes
{
    // "jittered" needs a square number of samples.
    private const string Report =
        """ "integrator": "report", "sampler": "jittered", "maxDiffuseDepth": 4, "maxSpecularDepth": 4, "width": 600, "height": 600, "samplesPerPixel": 256 """;

    private const string FourLamps = """
        {
          "camera": { "position": [0, 2, 6], "lookAt": [0, 0.8, 0], "fieldOfView": 40 },
          "render": {},
          "materials": { "lamp": { "type": "luminaire", "multiplier": 14 } },
          "shapes": [
            { "type": "sphere", "center": [0, 1, 0], "radius": 1, "material": { "type": "diffuse", "color": [0.8, 0.3, 0.2] } },
            { "type": "rectangle", "corner": [-40, 0, 40], "edgeU": [80, 0, 0], "edgeV": [0, 0, -80], "material": { "type": "diffuse", "color": [0.6, 0.6, 0.6] } }
          ],
          "lights": [
            { "type": "sphere", "center": [-2, 3.5, -2], "radius": 0.2, "material": "lamp" },
            { "type": "sphere", "center": [-2, 3.5, 2], "radius": 0.2, "material": "lamp" },
            { "type": "sphere", "center": [2, 3.5, -2], "radius": 0.2, "material": "lamp" },
            { "type": "sphere", "center": [2, 3.5, 2], "radius": 0.2, "material": "lamp" }
          ]
        }
        """;

    private const string MillionTriangles = """
        {
          "camera": { "position": [0, 1.2, 3.2], "lookAt": [0, 0, 0], "fieldOfView": 45 },
          "render": {},
          "background": [0.5, 0.6, 0.7],
          "shapes": [{ "type": "mesh", "file": "million.ply", "material": { "type": "diffuse", "color": [0.7, 0.6, 0.5] } }],
          "lights": [{ "type": "directional", "direction": [-0.5, -1, -0.3], "irradiance": [2, 2, 2] }]
        }
        """;

    // For each scene its name, what "render" holds, and its text, or the file below scenes/ that has the rest.
    private static readonly (string Name, string Render, string Content)[] s_all =
    [
        ("report1", Report, "report/scene1.json"),
        ("report2", Report, "report/scene2.json"),
        ("report3", Report, "report/scene3.json"),
        ("cornell", Paths(512, 512, 256, 8), "cornell.json"),
        ("four-lamps", Paths(600, 600, 256, 6), FourLamps),
        ("shader-balls", Paths(400, 225, 64, 12), "gallery/shader-balls.json"),
        ("fog", Paths(300, 200, 256, 64, "volPath"), "media/01-milk-and-fog.json"),
        ("glass", Paths(480, 270, 256, 16), "materials/04-frosted-glass.json"),
        ("ten-thousand-lamps", Paths(320, 180, 32, 5), TenThousandLamps()),
        ("thousand-instances", Paths(320, 180, 16, 5), ThousandInstances()),
        ("million-triangles", Paths(1024, 1024, 64, 3), MillionTriangles),
    ];

    /// <summary>Writes the scenes into a folder, with the files that they need.</summary>
    public static void Write(string folder)
    {
        Directory.CreateDirectory(folder);
        BumpyBall.Write(Path.Combine(folder, "boulder.ply"), 250, 201);
        BumpyBall.Write(Path.Combine(folder, "million.ply"), 1000, 501);
        foreach ((string name, string render, string content) in s_all)
        {
            string text = content.EndsWith(".json", StringComparison.Ordinal) ? Shipped(content, folder) : content;
            string scene = RenderSection().Replace(text, $$""" "render": {{{render}}}""".TrimStart());
            File.WriteAllText(Path.Combine(folder, $"{name}.json"), scene.ReplaceLineEndings("\n"));
        }
    }

    private static string Paths(int width, int height, int samples, int depth, string integrator = "path") =>
        $""" "integrator": "{integrator}", "sampler": "sobol", "maxDepth": {depth}, "width": {width}, "height": {height}, "samplesPerPixel": {samples} """;

    // A scene of the repository, beside which the files that it names are copied.
    private static string Shipped(string scene, string folder)
    {
        string path = ProjectFolder.PathOf("scenes", scene);
        return NamedFile().Replace(File.ReadAllText(path), match =>
        {
            string source = Path.Combine(Path.GetDirectoryName(path)!, match.Value);
            string name = Path.GetFileName(source);
            File.Copy(source, Path.Combine(folder, name), overwrite: true);
            return name;
        });
    }

    // Small lamps of five colours, which hang above some balls.
    private static string TenThousandLamps() => $$"""
        {
          "camera": { "position": [0, 2.4, 11], "lookAt": [0, 0.2, 0], "fieldOfView": 20 },
          "render": {},
          "materials": {
            "lamp 0": { "type": "luminaire", "color": [1, 0.55, 0.2], "multiplier": 12 },
            "lamp 1": { "type": "luminaire", "color": [1, 0.8, 0.5], "multiplier": 12 },
            "lamp 2": { "type": "luminaire", "color": [1, 0.3, 0.3], "multiplier": 12 },
            "lamp 3": { "type": "luminaire", "color": [0.4, 0.6, 1], "multiplier": 12 },
            "lamp 4": { "type": "luminaire", "color": [0.5, 1, 0.6], "multiplier": 12 }
          },
          "shapes": [
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.6, 0.6, 0.6] } },
            { "type": "sphere", "center": [-3.4, 1.2, 0], "radius": 1.2, "material": { "type": "diffuse", "color": [0.7, 0.7, 0.7] } },
            { "type": "sphere", "center": [0, 1.5, -1.5], "radius": 1.5, "material": { "type": "diffuse", "color": [0.7, 0.4, 0.3] } },
            { "type": "sphere", "center": [3.2, 1, 0.5], "radius": 1, "material": { "type": "diffuse", "color": [0.3, 0.5, 0.7] } },
            { "type": "box", "a": [-1.6, 0, 2], "b": [1, 0.5, 3.4], "material": { "type": "diffuse", "color": [0.5, 0.6, 0.4] } }
          ],
          "lights": [
        {{Lines(10000, i => $$"""{ "type": "sphere", "center": [{{Any(i, 0, -8, 8):F3}}, {{Any(i, 1, 2.6, 4.4):F3}}, {{Any(i, 2, -9, 5):F3}}], "radius": 0.015, "material": "lamp {{i % 5}}" }""")}}
          ]
        }
        """;

    // A field of boulders that are all the same mesh.
    private static string ThousandInstances() => $$"""
        {
          "camera": { "position": [0, 3, 13], "lookAt": [0, 0.6, 0], "fieldOfView": 32 },
          "render": {},
          "environment": { "type": "sky", "sunElevation": 30, "sunAzimuth": 290 },
          "objects": { "boulder": { "type": "mesh", "file": "boulder.ply", "material": { "type": "diffuse", "color": [0.6, 0.55, 0.5] } } },
          "shapes": [
            { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.35, 0.38, 0.3] } },
        {{Lines(1000, i => $$"""{ "type": "instance", "of": "boulder", "transform": { "scale": {{Any(i, 3, 0.1, 0.6):F3}}, "rotate": {{i * 7 % 360}}, "axis": [1, 2, 3], "translate": [{{Any(i, 0, -12, 12):F3}}, {{Any(i, 1, 0, 0.5):F3}}, {{Any(i, 2, -20, 9):F3}}] } }""")}}
          ]
        }
        """;

    private static string Lines(int count, Func<int, FormattableString> line) =>
        string.Join(",\n", Enumerable.Range(0, count).Select(i => "    " + line(i).ToString(CultureInfo.InvariantCulture)));

    // A number between two others, which only its place in the list and the coordinate decide: a hash.
    private static double Any(int i, uint coordinate, double low, double high)
    {
        uint hash = ((uint)i * 0x9E3779B1) ^ (coordinate * 0xC2B2AE3D);
        hash = (hash ^ (hash >> 15)) * 0x2C1B3C6D;
        hash = (hash ^ (hash >> 12)) * 0x297A2D39;
        return low + ((high - low) * (hash ^ (hash >> 15)) / uint.MaxValue);
    }

    [GeneratedRegex("\"render\": \\{[^}]*\\}", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex RenderSection();

    [GeneratedRegex("(?<=\"file\": \")[^\"]+", RegexOptions.CultureInvariant, 1000)]
    private static partial Regex NamedFile();
}
