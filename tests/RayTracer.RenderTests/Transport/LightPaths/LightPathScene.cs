namespace RayTracer.RenderTests.Transport.LightPaths;

/// <summary>
/// A small scene that every integrator which starts paths at the camera, at the lights, or at both can sample well, so that few samples tell
/// whether it does so rightly. Each has several kinds of lights, materials, cameras and limits of paths.
/// </summary>
/// <param name="Name">What is in it.</param>
/// <param name="Samples">Samples for each pixel, every day: more where light is found by chance.</param>
/// <param name="IsMatt">True where the camera sees nothing that is specular, nor anything through a mask, so that light tracing finds all light.</param>
/// <param name="Text">The scene, as its file has it, without an integrator.</param>
/// <param name="Reference">The integrator with which it is right.</param>
internal sealed record LightPathScene(string Name, int Samples, bool IsMatt, string Text, string Reference = "path")
{
    private const string Matt = """{ "type": "diffuse", "color": [0.7, 0.6, 0.5] }""";
    private const string Floor = """{ "type": "rectangle", "corner": [-2, 0, 2], "edgeU": [4, 0, 0], "edgeV": [0, 0, -4], "material": { "type": "diffuse", "color": [0.5, 0.6, 0.7] } }""";
    private const string Wall = """{ "type": "rectangle", "corner": [-2, 0, -2], "edgeU": [4, 0, 0], "edgeV": [0, 3, 0], "material": { "type": "diffuse", "color": { "type": "checker", "even": [0.8, 0.7, 0.3], "odd": [0.3, 0.4, 0.8], "scale": [3, 2] } } }""";
    private const string Ceiling = """{ "type": "rectangle", "corner": [-0.8, 2.6, -0.8], "edgeU": [1.6, 0, 0], "edgeV": [0, 0, 1.6], "material": { "type": "luminaire", "color": [1, 0.9, 0.7], "multiplier": 4 } }""";
    private const string Pinhole = """ "position": [0, 1.2, 5], "lookAt": [0, 0.9, 0], "fieldOfView": 36 """;
    private const string Octahedron = """
         "positions": [[0.7, 0, 0], [-0.7, 0, 0], [0, 0.7, 0], [0, -0.7, 0], [0, 0, 0.7], [0, 0, -0.7]],
         "uv": [[0, 0.5], [1, 0.5], [0.5, 1], [0.5, 0], [0.2, 0.3], [0.9, 0.8]],
         "triangles": [[4, 0, 2], [0, 5, 2], [5, 1, 2], [1, 4, 2], [0, 4, 3], [5, 0, 3], [1, 5, 3], [4, 1, 3]]
        """;

    /// <summary>All scenes.</summary>
    public static IReadOnlyList<LightPathScene> All { get; } =
    [
        new("a room with a ball of glass", 4, IsMatt: false, Write(Pinhole, """ "rouletteDepth": 3 """, "",
            Floor, Wall, Side(-2), Side(2), Ceiling,
            """{ "type": "sphere", "center": [-0.7, 0.6, 0.3], "radius": 0.6, "material": { "type": "dielectric", "extinction": [0.1, 0.4, 0.2] } }""",
            """{ "type": "box", "a": [0.3, 0, -0.8], "b": [1.3, 1.1, 0.2], "material": { "type": "roughConductor", "metal": "copper", "alpha": 0.5 } }""")),

        new("a ball that shines, seen through a lens", 2, IsMatt: true, Write(Pinhole + """, "lens": { "apertureRadius": 0.15, "focusDistance": 4 } """,
            """ "maxDepth": 3, "filter": { "shape": "gaussian", "radius": 1.3 } """, "",
            """{ "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.5, 0.6, 0.7] } }""",
            """{ "type": "sphere", "center": [-0.8, 0.5, 0], "radius": 0.5, "material": { "type": "roughPlastic", "alpha": 0.3, "color": [0.2, 0.6, 0.3] } }""",
            """{ "type": "cylinder", "bottom": [0.9, 0, -0.4], "top": [0.9, 1.1, -0.4], "radius": 0.4, "material": { "type": "diffuse", "color": { "type": "checker", "scale": [6, 3] } } }""",
            """{ "type": "sphere", "center": [0.3, 2.2, 0.6], "radius": 0.45, "material": { "type": "luminaire", "multiplier": 9, "exponent": 0.7, "material": { "type": "diffuse", "color": [0.4, 0.1, 0.1] } } }""")),

        new("a mesh that shines, moves, and is stretched", 2, IsMatt: true, Write(Pinhole, """ "maxDepth": 5, "shutter": [0, 1] """, "",
            Floor, Wall,
            $$"""
            { "type": "instance", "transform": [{ "scale": [1.3, -0.5, 0.8], "rotate": 30, "axis": [0, 0, 1], "translate": [-0.3, 2, 0.2] }],
              "motion": [{ "time": 0 }, { "time": 1, "transform": [{ "translate": [0.9, -0.2, 0.3] }] }],
              "of": { "type": "mesh", {{Octahedron}}, "material": { "type": "luminaire", "color": [1, 0.8, 0.5], "multiplier": 4 } } }
            """,
            $$"""
            { "type": "mesh", {{Octahedron}}, "shading": "smooth", "material": {{Matt}}, "transform": [{ "translate": [-0.6, 0.75, 0.2] }],
              "motion": [{ "time": 0 }, { "time": 1, "transform": [{ "rotate": 40, "axis": [0, 1, 0] }] }] }
            """)),

        new("lights without extent before a background, without perspective", 2, IsMatt: true, Write(
            """ "position": [0.4, 1.6, 5], "lookAt": [0, 0.7, 0], "projection": "orthographic", "viewSize": 3 """, """ "maxDepth": 4 """, """ "background": [0.2, 0.3, 0.4], """,
            Floor, Wall,
            """{ "type": "sphere", "center": [-0.7, 0.6, 0], "radius": 0.6, "material": { "type": "roughConductor", "metal": "gold", "alpha": 0.4 } }""",
            $$"""{ "type": "cone", "bottom": [0.9, 0, 0], "top": [0.9, 1.3, 0], "radius": 0.5, "material": {{Matt}} }""",
            """{ "type": "point", "position": [-1.5, 1.8, 1.2], "intensity": [3, 2, 1] }""",
            """{ "type": "spot", "position": [0.3, 2.6, 1], "direction": [0.1, -1, -0.3], "intensity": [9, 9, 12], "cutoffAngle": 35, "beamWidth": 20 }""",
            """{ "type": "directional", "direction": [-0.6, -1, -0.5], "irradiance": [0.6, 0.7, 0.9] }""")),

        new("an even sky and negative lobes of the filter", 2, IsMatt: true, Write(Pinhole, """ "maxDepth": 6, "filter": { "shape": "mitchell" } """,
            """ "environment": { "type": "constant", "radiance": [0.8, 0.9, 1.1] }, """,
            Floor,
            """{ "type": "sphere", "center": [-0.6, 0.8, 0], "radius": 0.8, "material": { "type": "principled", "baseColor": [0.8, 0.3, 0.2], "roughness": 0.5, "metallic": 0.4 } }""",
            """{ "type": "sphere", "center": [0.9, 0.5, 0.6], "radius": 0.5, "material": { "type": "translucent", "color": [0.3, 0.3, 0.2], "transmittance": [0.5, 0.6, 0.4] } }""",
            """{ "type": "sphere", "center": [0.6, 2, -0.4], "radius": 0.5, "material": { "type": "luminaire", "multiplier": 8 } }""")),

        new("sky and sun above a plane without end", 2, IsMatt: false, Write(Pinhole, """ "maxDepth": 5 """,
            """ "environment": { "type": "sky", "sunElevation": 35, "sunAzimuth": 120, "sunSize": 25 }, """,
            """{ "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": [0.5, 0.5, 0.4] } }""",
            """{ "type": "sphere", "center": [-0.7, 0.7, 0], "radius": 0.7, "material": { "type": "plastic", "color": [0.2, 0.4, 0.7] } }""",
            """{ "type": "rectangle", "corner": [0.2, 0, -0.4], "edgeU": [1.2, 0, 0.5], "edgeV": [0, 1.6, 0], "material": { "type": "translucent", "color": [0.2, 0.4, 0.2], "transmittance": [0.3, 0.5, 0.2] } }""")),

        new("frosted glass", 6, IsMatt: true, Write(Pinhole, """ "maxDepth": 8 """, "",
            Floor, Wall, Ceiling,
            """{ "type": "sphere", "center": [-0.6, 0.8, 0.3], "radius": 0.7, "material": { "type": "roughDielectric", "alpha": 0.4 } }""",
            $$"""{ "type": "mesh", {{Octahedron}}, "transform": [{ "scale": [0.9, 1.1, 0.9], "translate": [0.9, 0.8, 0.2] }], "material": { "type": "roughDielectric", "alpha": 0.5, "refractiveIndex": 1.7 } }""")),

        new("normal maps and coats, all around", 2, IsMatt: true, Write("""
             "position": [0, 0.9, 0.9], "lookAt": [0, 0.9, 0], "projection": "spherical"
            """, """ "maxDepth": 5 """, "",
            """{ "type": "box", "a": [-2, 0, -2], "b": [2, 3, 2], "material": { "type": "diffuse", "color": [0.4, 0.4, 0.5] } }""",
            $$"""
            { "type": "mesh", {{Octahedron}}, "shading": "smooth", "transform": [{ "translate": [-0.7, 0.8, -0.4] }],
              "material": { "type": "normalMap", "map": { "type": "checker", "even": [0.7, 0.5, 0.85], "odd": [0.45, 0.35, 0.9], "scale": [3, 3] },
                "material": { "type": "principled", "baseColor": [0.7, 0.6, 0.2], "roughness": 0.6, "clearcoat": 1, "clearcoatRoughness": 0.6 } } }
            """,
            """{ "type": "sphere", "center": [0.9, 0.6, -0.3], "radius": 0.6, "material": { "type": "diffuseSpecular", "diffuse": { "type": "diffuse", "color": [0.2, 0.5, 0.9] }, "specular": { "type": "phongMetal", "exponent": 12 }, "r0": 0.2 } }""",
            """{ "type": "disk", "center": [0.8, 2.9, 0.5], "normal": [0, -1, 0], "radius": 0.6, "material": { "type": "luminaire", "multiplier": 6 } }""",
            """{ "type": "triangle", "a": [-1.9, 0.5, 0.5], "b": [-1.9, 0.5, -0.8], "c": [-1.9, 1.7, 0.1], "material": { "type": "luminaire", "color": [0.5, 0.8, 1], "multiplier": 5 } }""")),

        new("prisms", 6, IsMatt: false, Write(Pinhole, """ "maxDepth": 7 """, "",
            Floor, Wall, Ceiling,
            $$"""{ "type": "mesh", {{Octahedron}}, "transform": [{ "rotate": 20, "translate": [-0.8, 0.8, 0.2] }], "material": { "type": "dielectric", "glass": "sf11" } }""",
            """{ "type": "sphere", "center": [0.8, 0.7, 0], "radius": 0.6, "material": { "type": "roughDielectric", "alpha": 0.3, "glass": "diamond" } }""")),

        new("many lights", 2, IsMatt: true, Write(Pinhole, """ "maxDepth": 4 """,
            """ "environment": { "type": "constant", "radiance": [0.1, 0.12, 0.2] }, """,
            [
                Floor, Wall, Ceiling,
                $$"""{ "type": "sphere", "center": [-0.4, 0.6, 0], "radius": 0.6, "material": {{Matt}} }""",
                """{ "type": "rectangle", "corner": [0.5, 0, -0.3], "edgeU": [0.9, 0, 0.6], "edgeV": [0, 1.2, 0], "material": { "type": "translucent", "color": [0.3, 0.3, 0.3], "transmittance": [0.6, 0.5, 0.4] } }""",
                """{ "type": "point", "position": [1, 1.5, 1], "intensity": [0.8, 0.6, 0.4] }""",
                """{ "type": "directional", "direction": [0.3, -1, -0.2], "irradiance": [0.3, 0.2, 0.2] }""",
                .. Enumerable.Range(0, 7).Select(i => $$"""{ "type": "sphere", "center": [{{-1.5 + (0.5 * i)}}, {{1.3 + (0.3 * (i % 3))}}, {{-1.2 + (0.35 * (i % 4))}}], "radius": {{0.08 + (0.03 * (i % 3))}}, "material": { "type": "luminaire", "multiplier": {{4 + i}} } }"""),
            ])),

        new("two edges, from a camera that moves", 2, IsMatt: true, Write(Pinhole + """, "motion": [{ "time": 0 }, { "time": 1, "transform": [{ "translate": [0.3, 0.1, 0] }] }] """,
            """ "maxDepth": 2, "shutter": [0, 1], "shadingNormals": "literal" """, "",
            Floor, Wall, Ceiling,
            $$"""
            { "type": "mesh", {{Octahedron}}, "shading": "smooth", "transform": [{ "translate": [0, 0.8, 0.4] }],
              "material": { "type": "bumpMap", "map": { "type": "checker", "even": 0, "odd": 1, "scale": [4, 4] }, "scale": 0.02, "material": {{Matt}} } }
            """,
            """{ "type": "rectangle", "corner": [-1.9, 0.4, 1], "edgeU": [0.5, 0, -1.5], "edgeV": [0, 1.2, 0], "material": { "type": "luminaire", "color": { "type": "checker", "even": [6, 2, 1], "odd": [1, 2, 6], "scale": [2, 2] } } }""")),

        new("light by detours", 6, IsMatt: false, Write(Pinhole, """ "rouletteDepth": 2 """, "",
            Floor, Wall, Side(-2), Side(2),
            """{ "type": "rectangle", "corner": [-2, 3, -2], "edgeU": [4, 0, 0], "edgeV": [0, 0, 4], "material": { "type": "diffuse", "color": [0.8, 0.8, 0.8] } }""",
            """{ "type": "rectangle", "corner": [-1.2, 2, -1.2], "edgeU": [0, 0, 1.8], "edgeV": [2.4, 0, 0], "material": { "type": "luminaire", "multiplier": 6 } }""",
            """{ "type": "sphere", "center": [0.5, 0.6, 0.3], "radius": 0.6, "material": { "type": "mask", "opacity": { "type": "checker", "even": [0.3, 0.3, 0.3], "odd": [1, 1, 1], "scale": [4, 4] }, "material": { "type": "diffuse", "color": [0.8, 0.4, 0.3] } } }""",
            $$"""{ "type": "box", "a": [-1.3, 0, -0.5], "b": [-0.5, 1.1, 0.2], "material": { "type": "mix", "weight": 0.4, "first": {{Matt}}, "second": { "type": "roughConductor", "metal": "silver", "alpha": 0.3 } } }""")),

        // Light tracing is far too noisy here: what scatters just before the camera is bright without limit.
        new("fog around all, with a spot and a lamp", 3, IsMatt: false, Write(Pinhole, """ "maxDepth": 6 """, "",
            Floor, Wall, Ceiling,
            Fog("""{ "type": "box", "a": [-3, -1, -3], "b": [3, 4, 6],""", "[0.2, 0.25, 0.35]", "[0.9, 0.8, 0.7]", 0.6f),
            """{ "type": "sphere", "center": [-0.6, 0.6, 0.2], "radius": 0.5, "material": { "type": "roughConductor", "metal": "gold", "alpha": 0.4 } }""",
            """{ "type": "spot", "position": [0.3, 2.6, 1], "direction": [0.1, -1, -0.3], "intensity": [9, 9, 12], "cutoffAngle": 35, "beamWidth": 20 }"""), "volPath"),

        new("a lamp within a cloud, seen from outside", 3, IsMatt: true, Write(Pinhole, """ "maxDepth": 8 """, "",
            Floor, Wall,
            Fog("""{ "type": "sphere", "center": [0, 1.2, 0], "radius": 1,""", "[0.6, 1, 1.6]", "[0.9, 0.8, 0.6]", 0),
            """{ "type": "sphere", "center": [0.1, 1.3, 0], "radius": 0.25, "material": { "type": "luminaire", "multiplier": 15 } }"""), "volPath"),

        new("a cloud within a cloud, and a lamp across its boundary", 3, IsMatt: true, Write(Pinhole, """ "maxDepth": 8 """, "",
            Floor, Wall, Ceiling,
            Fog("""{ "type": "box", "a": [-1.5, 0.01, -1], "b": [1.5, 1, 1],""", "[0.5, 0.3, 0.2]", "[0.8, 0.8, 0.8]", -0.4f),
            $$"""{ "type": "instance", "transform": [{ "scale": [0.3, 0.3, 0.4], "translate": [0.2, 0.5, 0.2] }], "of": {{Fog("""{ "type": "sphere", "center": [0, 0, 0],""", "[2, 2.5, 1.5]", "[0.9, 0.95, 0.5]", 0.6f)}} }""",
            """{ "type": "rectangle", "corner": [-1.2, 0.5, 0.2], "edgeU": [0, 1.1, 0], "edgeV": [0, 0, 0.7], "material": { "type": "luminaire", "multiplier": 8 } }""",
            """{ "type": "point", "position": [0.9, 0.5, 0.5], "intensity": [1, 0.8, 0.5] }"""), "volPath"),

        new("milk in frosted glass beneath a sky", 3, IsMatt: true, Write(Pinhole, """ "maxDepth": 10 """,
            """ "environment": { "type": "constant", "radiance": [0.2, 0.25, 0.3] }, """,
            Floor, Wall, Ceiling,
            """{ "type": "sphere", "center": [-0.7, 0.8, 0.2], "radius": 0.6, "material": { "type": "roughDielectric", "alpha": 0.4, "interior": { "extinction": [1, 2, 3], "albedo": [0.9, 0.9, 0.95], "anisotropy": 0.3 } } }""",
            """{ "type": "sphere", "center": [0.8, 0.8, 0.2], "radius": 0.6, "material": { "type": "roughDielectric", "alpha": 0.4, "interior": { "extinction": [0.3, 0.8, 1.5] } } }"""), "volPath"),

        new("many lamps in a cloud that moves and around it", 3, IsMatt: true, Write(Pinhole, """ "maxDepth": 5, "shutter": [0, 1] """, "",
            [
                Floor, Wall,
                Fog("""{ "type": "sphere", "center": [0, 1.2, 0], "radius": 1, "motion": [{ "time": 0 }, { "time": 1, "transform": [{ "translate": [0.2, 0, 0] }] }],""", "[0.8, 0.6, 0.5]", "[0.9, 0.9, 0.9]", 0.3f),
                .. Enumerable.Range(0, 10).Select(i => $$"""{ "type": "sphere", "center": [{{-1.5 + (0.34 * i)}}, {{1.2 + (0.7 * ((i % 3) - 1))}}, {{-0.5 + (0.35 * (i % 4))}}], "radius": {{0.05 + (0.03 * (i % 3))}}, "material": { "type": "luminaire", "multiplier": {{9 + i}} } }"""),
            ]), "volPath"),

        new("things that overlap, by priorities", 4, IsMatt: false, Write(Pinhole, """ "maxDepth": 10 """, "",
            Floor, Wall, Ceiling,
            """{ "type": "box", "a": [-1.2, 0.05, -0.6], "b": [0.2, 1.3, 0.6], "material": { "type": "roughDielectric", "alpha": 0.3, "glass": "bk7", "priority": 2 } }""",
            """{ "type": "sphere", "center": [0.4, 0.8, 0.2], "radius": 0.7, "material": { "type": "roughDielectric", "alpha": 0.4, "refractiveIndex": 1.33, "priority": 1 } }""",
            """{ "type": "box", "a": [-0.3, 0.7, -0.3], "b": [0.8, 1.6, 0.3], "material": { "type": "dielectric", "refractiveIndex": 1.31, "priority": 3, "extinction": [0.3, 0.9, 0.2] } }""")),

        new("a lamp within things that overlap", 3, IsMatt: false, Write(Pinhole, """ "maxDepth": 10 """, "",
            Floor, Wall,
            """{ "type": "sphere", "center": [-0.3, 1, 0.2], "radius": 0.8, "material": { "type": "roughDielectric", "alpha": 0.3, "refractiveIndex": 1.5, "priority": 2 } }""",
            """{ "type": "sphere", "center": [0.4, 1.1, 0.2], "radius": 0.8, "material": { "type": "dielectric", "refractiveIndex": 1.15, "priority": 1, "extinction": [0.1, 0.4, 0.9] } }""",
            """{ "type": "sphere", "center": [0.1, 1, 0.2], "radius": 0.35, "material": { "type": "luminaire", "multiplier": 12 } }""")),

        new("a lamp in milk that overlaps with others", 4, IsMatt: true, Write(Pinhole, """ "maxDepth": 10 """, "",
            Floor, Wall, Ceiling,
            """{ "type": "box", "a": [-1.2, 0.05, -0.6], "b": [0.2, 1.3, 0.6], "material": { "type": "roughDielectric", "alpha": 0.3, "refractiveIndex": 1.5, "priority": 2, "interior": { "extinction": [1, 1.4, 2], "albedo": [0.9, 0.8, 0.9] } } }""",
            """{ "type": "sphere", "center": [0.4, 0.8, 0.2], "radius": 0.7, "material": { "type": "roughDielectric", "alpha": 0.4, "refractiveIndex": 1.33, "priority": 1 } }""",
            Fog("""{ "type": "sphere", "center": [1.1, 1.9, 0.3], "radius": 0.5,""", "[0.7, 0.7, 0.7]", "[0.9, 0.9, 0.9]", 0.5f),
            """{ "type": "sphere", "center": [0.1, 0.8, 0.3], "radius": 0.3, "material": { "type": "luminaire", "multiplier": 15 } }"""), "volPath"),
    ];

    /// <inheritdoc/>
    public override string ToString() => Name;

    private static string Side(int x) =>
        $$"""{ "type": "rectangle", "corner": [{{x}}, 0, {{-x}}], "edgeU": [0, 0, {{2 * x}}], "edgeV": [0, 3, 0], "material": { "type": "diffuse", "color": [{{(x < 0 ? "0.8, 0.3, 0.3" : "0.3, 0.8, 0.3")}}] } }""";

    private static string Fog(string shape, string extinction, string albedo, float anisotropy) => FormattableString.Invariant(
        $$"""{{shape}} "material": { "type": "invisible", "interior": { "extinction": {{extinction}}, "albedo": {{albedo}}, "anisotropy": {{anisotropy}} } } }""");

    private static string Write(string camera, string render, string environment, params string[] shapes) => $$"""
        {
          "camera": { {{camera}} },
          "render": { "width": 24, "height": 24, "samplesPerPixel": 1, {{render}} },
          {{environment}}
          "shapes": [ {{string.Join(",\n", shapes)}} ]
        }
        """;
}
