namespace RayTracer.RenderTests.Pairs;

/// <summary>
/// A small scene with a choice of features, and an equal one made otherwise: another sampler and integrator, transforms worked into the numbers in place of an instance, one material of two
/// kinds in place of a texture of numbers, a mix with nothing in place of a mask, slopes by halves, glass without priorities, lamps and fog of other shapes,
/// few lights at a time in place of one chosen of many, and instants in place of motion.
/// </summary>
/// <param name="Row">Which level of each of the <see cref="Features"/>.</param>
internal sealed record PairScene(IReadOnlyList<int> Row)
{
    /// <summary>Lights of a scene with many: more than are asked all together.</summary>
    public const int Many = 12;

    private const string Slopes = """{ "type": "checker", "even": [EVEN], "odd": [ODD], "scale": [3, 3] }""";

    /// <summary>The features and their levels.</summary>
    public static IReadOnlyList<(string Name, string[] Levels)> Features { get; } =
    [
        ("sampler", ["sobol", "jittered", "regular", "independent"]),
        ("projection", ["perspective", "orthographic"]),
        ("lens", ["pinhole", "disk", "bladed"]),
        ("filter", ["box", "gaussian"]),
        ("motion", ["still", "moves"]),
        ("placing", ["plain", "stretched instance"]),
        ("thing", ["flat mesh", "smooth mesh", "box"]),
        ("material", ["matt", "polished", "roughness by a texture", "glass"]),
        ("mask", ["whole", "holes"]),
        ("normals", ["plain", "normal map"]),
        ("shading normals", ["mended", "literal"]),
        ("lamp", ["rectangle", "mesh", "sphere"]),
        ("exponent", ["even", "gathered"]),
        ("lights", ["few", "many"]),
        ("environment", ["dark", "constant"]),
        ("medium", ["empty", "fog"]),
        ("second thing", ["none", "glass in water", "prism", "translucent sheet"]),
    ];

    /// <summary>How many groups the lights of the equal scene are rendered in.</summary>
    public int Groups => Is("lights", "many") ? 3 : 1;

    /// <summary>How many instants are rendered of the equal scene.</summary>
    public int Instants => Is("motion", "moves") ? 4 : 1;

    /// <summary>The scene with its features.</summary>
    public string Text => Write(isOtherwise: false, group: 0, time: 0);

    /// <summary>The equal scene, made otherwise.</summary>
    /// <param name="group">Which of its groups of lights shines.</param>
    /// <param name="time">The instant that it shows, where something moves.</param>
    public string Otherwise(int group, double time) => Write(isOtherwise: true, group, time);

    /// <inheritdoc/>
    public override string ToString() => string.Join(", ", Features.Select((f, i) => f.Levels[Row[i]]));

    private bool Is(string feature, string level)
    {
        int i = Features.TakeWhile(f => f.Name != feature).Count();
        int l = Array.IndexOf(Features[i].Levels, level);
        return l >= 0 ? Row[i] == l : throw new ArgumentException($"{feature} is never {level}", nameof(level));
    }

    private string Write(bool isOtherwise, int group, double time)
    {
        string shutter = Instants > 1 && !isOtherwise ? "[0, 1]" : "[0, 0]";
        string filter = Is("filter", "gaussian") ? """, "filter": { "shape": "gaussian", "radius": 1.2 }""" : "";
        string environment = Is("environment", "constant") && group == 0 ? """ "environment": { "type": "constant", "radiance": [0.2, 0.25, 0.35] },""" : "";
        return $$"""
            {
              "camera": { "position": [0.4, 1.3, 4.5], "lookAt": [0, 0.5, 0], {{Projection()}}{{Lens()}} },
              "render": { "width": 8, "height": 8, "samplesPerPixel": {{(isOtherwise && Instants > 1 ? 16 : 36)}}, "integrator": "{{Integrator(isOtherwise)}}", "maxDepth": 6, "rouletteDepth": 30,
                "sampler": "{{Sampler(isOtherwise)}}", "shadingNormals": "{{(Is("shading normals", "literal") ? "literal" : "mended")}}", "shutter": {{shutter}}{{filter}} },
              {{environment}}
              "shapes": [
                { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0], "material": { "type": "diffuse", "color": { "type": "checker", "even": [0.3, 0.25, 0.2], "odd": [0.1, 0.15, 0.2] } } },
                {{Thing(isOtherwise, time)}}{{SecondThing(isOtherwise)}}{{Fog(isOtherwise)}}{{string.Concat(Lights(isOtherwise, group))}}
              ]
            }
            """;
    }

    private string Projection() => Is("projection", "orthographic") ? """ "projection": "orthographic", "viewSize": 3 """ : """ "fieldOfView": 38 """;

    private string Lens() => Is("lens", "disk") ? """, "lens": { "apertureRadius": 0.15, "focusDistance": 4 }"""
        : Is("lens", "bladed") ? """, "lens": { "shape": "bladed", "blades": 5, "apertureRadius": 0.2, "focusDistance": 5 }""" : "";

    private string Integrator(bool isOtherwise) => Is("medium", "fog") || isOtherwise ? "volPath" : "path";

    private string Sampler(bool isOtherwise) => !isOtherwise ? Features[0].Levels[Row[0]] : Is("sampler", "independent") ? "sobol" : "independent";

    // The instance's transforms are worked into the thing in the other scene, where nothing moves: it stands where it is at the time.
    private string Thing(bool isOtherwise, double time)
    {
        string place = Is("placing", "stretched instance")
            ? """ "transform": [{ "scale": [0.9, 0.5, -0.6] }, { "translate": [0.2, 0.65, 0.1] }]"""
            : """ "transform": [{ "translate": [0.2, 0.75, 0.1] }]""";
        string motion = Instants == 1 ? ""
            : isOtherwise ? FormattableString.Invariant($", \"transform\": [{{ \"translate\": [{-1.1 * time}, {0.4 * time}, {0.2 * time}] }}]")
            : """, "motion": [{ "time": 0 }, { "time": 1, "transform": [{ "translate": [-1.1, 0.4, 0.2] }] }]""";
        string bare = Shape() + $$""", "material": {{Material(isOtherwise)}}""";
        return (Is("placing", "stretched instance"), isOtherwise) switch
        {
            (true, false) => $$"""{ "type": "instance",{{place}}{{motion}}, "of": { {{bare}} } }""",
            (_, true) => $$"""{ "type": "group"{{motion}}, "shapes": [{ {{bare}},{{place}} }] }""",
            _ => $$"""{ {{bare}},{{place}}{{motion}} }""",
        };
    }

    private string Shape()
    {
        const string octahedron = """ "type": "mesh", "positions": [[0.7, 0, 0], [-0.7, 0, 0], [0, 0.7, 0], [0, -0.7, 0], [0, 0, 0.7], [0, 0, -0.7]], "uv": [[0, 0.5], [1, 0.5], [0.5, 1], [0.5, 0], [0.2, 0.3], [0.9, 0.8]], "triangles": [[4, 0, 2], [0, 5, 2], [5, 1, 2], [1, 4, 2], [0, 4, 3], [5, 0, 3], [1, 5, 3], [4, 1, 3]] """;
        return Is("thing", "box") ? """ "type": "box", "a": [-0.5, -0.5, -0.5], "b": [0.5, 0.5, 0.5] """
            : Is("thing", "flat mesh") ? octahedron
            : octahedron + """, "normals": [[1, 0.2, 0], [-1, 0, 0.2], [0, 1, 0], [0.1, -1, 0], [0, 0, 1], [0, 0.2, -1]]""";
    }

    private string Material(bool isOtherwise) => Embossed(Masked(Is("material", "matt") ? """{ "type": "diffuse", "color": [0.95, 0.9, 0.8] }"""
        : Is("material", "polished") ? """{ "type": "roughPlastic", "alpha": 0.3, "color": [0.2, 0.4, 0.6] }"""
        : Is("material", "glass") ? """{ "type": "roughDielectric", "alpha": 0.4 }"""
        : isOtherwise ? $$"""{ "type": "mix", "weight": {{Checker("0", "1")}}, "first": {{Metal("0.15")}}, "second": {{Metal("0.6")}} }"""
        : Metal(Checker("0.15", "0.6")), isOtherwise), isOtherwise);

    private static string Metal(string alpha) => $$"""{ "type": "roughConductor", "metal": "copper", "alpha": {{alpha}} }""";

    private static string Checker(string even, string odd) =>
        $$"""{ "type": "checker", "even": [{{even}}, {{even}}, {{even}}], "odd": [{{odd}}, {{odd}}, {{odd}}], "scale": [2, 2] }""";

    // Where the map says less, its strength is more: slopes are the quotients of its numbers.
    private string Embossed(string inner, bool isOtherwise) => !Is("normals", "normal map") ? inner
        : isOtherwise ? $$"""{ "type": "normalMap", "strength": 2, "map": {{Map("0.55, 0.5, 0.75", "0.5, 0.4, 0.9")}}, "material": {{inner}} }"""
        : $$"""{ "type": "normalMap", "map": {{Map("0.6, 0.5, 0.75", "0.5, 0.3, 0.9")}}, "material": {{inner}} }""";

    private static string Map(string even, string odd) => Slopes.Replace("EVEN", even, StringComparison.Ordinal).Replace("ODD", odd, StringComparison.Ordinal);

    private string Masked(string inner, bool isOtherwise) => !Is("mask", "holes") ? inner
        : isOtherwise ? $$"""{ "type": "mix", "weight": {{Checker("0.3", "1")}}, "first": { "type": "invisible" }, "second": {{inner}} }"""
        : $$"""{ "type": "mask", "opacity": {{Checker("0.3", "1")}}, "material": {{inner}} }""";

    // Fog gives way only to what has a priority: there the water keeps it, and the glass alone has an index relative to the water's.
    private string SecondThing(bool isOtherwise)
    {
        const string outer = """ "type": "sphere", "center": [-0.9, 0.5, 0.6], "radius": 0.45 """;
        const string inner = """ "type": "sphere", "center": [-0.9, 0.45, 0.6], "radius": 0.25 """;
        return Is("second thing", "none") ? ""
            : Is("second thing", "translucent sheet") ? """, { "type": "rectangle", "corner": [-1.6, 0.3, 0.4], "edgeU": [1.1, 0, 0], "edgeV": [0, 0.9, 0.9], "material": { "type": "translucent", "color": [0.1, 0.1, 0.1], "transmittance": [0.8, 0.8, 0.8] } }"""
            : Is("second thing", "prism") ? $$""", { "type": "mesh", "positions": [[-1.3, 0, 0.3], [-0.5, 0, 0.3], [-0.9, 0.8, 0.3], [-1.3, 0, 0.9], [-0.5, 0, 0.9], [-0.9, 0.8, 0.9]], "triangles": [[0, 2, 1], [3, 4, 5], [0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]], "transform": [{ "translate": [0, 0.02, 0] }], "material": { "type": "dielectric", {{(isOtherwise ? """ "sellmeierB": [1.0396122, 0.231792344, 1.01046945], "sellmeierC": [0.00600069867, 0.0200179144, 103.560653] """ : """ "glass": "bk7" """)}} } }"""
            : isOtherwise ? $$""", { {{outer}}, "material": { "type": "dielectric", "refractiveIndex": 1.333{{(Is("medium", "fog") ? ", \"priority\": 1" : "")}} } }, { {{inner}}, "material": { "type": "dielectric", "refractiveIndex": 1.2753188 } }"""
            : $$""", { {{outer}}, "material": { "type": "dielectric", "refractiveIndex": 1.333, "priority": 1 } }, { {{inner}}, "material": { "type": "dielectric", "refractiveIndex": 1.7, "priority": 2 } }""";
    }

    private string Fog(bool isOtherwise)
    {
        const string material = """ "material": { "type": "invisible", "interior": { "extinction": [0.5, 0.4, 0.3], "albedo": [0.9, 0.8, 0.7], "anisotropy": 0.4 } } """;
        return !Is("medium", "fog") ? ""
            : isOtherwise ? $$""", { "type": "mesh", "positions": [[-1.5, 0.01, -1], [1.5, 0.01, -1], [1.5, 1.6, -1], [-1.5, 1.6, -1], [-1.5, 0.01, 1.2], [1.5, 0.01, 1.2], [1.5, 1.6, 1.2], [-1.5, 1.6, 1.2]], "triangles": [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4], [3, 7, 6], [3, 6, 2], [0, 4, 7], [0, 7, 3], [1, 2, 6], [1, 6, 5]], {{material}} }"""
            : $$""", { "type": "box", "a": [-1.5, 0.01, -1], "b": [1.5, 1.6, 1.2], {{material}} }""";
    }

    // The first light is the lamp; of many, the others stand around it. What does not shine is black.
    private IEnumerable<string> Lights(bool isOtherwise, int group)
    {
        int count = Is("lights", "many") ? Many : 2;
        for (int i = 0; i < count; i++)
        {
            string material = isOtherwise && i % Groups != group
                ? """ "material": { "type": "diffuse", "color": [0, 0, 0] } """
                : $$""" "material": { "type": "luminaire", "multiplier": {{(count > 2 ? 4 + i : 9)}}, "exponent": {{(Is("exponent", "gathered") ? 3 : 0)}} } """;
            yield return FormattableString.Invariant($", {{ {Lamp(i == 0, -1.4 + (0.26 * i), 2.1 + (0.1 * (i % 3)), 0.9 - (0.3 * (i % 4)), isOtherwise)}, {material} }}");
        }
    }

    // All shine downwards; the first is large.
    private string Lamp(bool isLarge, double x, double y, double z, bool isOtherwise)
    {
        double half = isLarge ? 0.5 : 0.12;
        if (Is("lamp", "sphere"))
        {
            return FormattableString.Invariant($"\"type\": \"sphere\", \"center\": [{x}, {y}, {z}], \"radius\": {half}");
        }

        return Is("lamp", "mesh") != isOtherwise
            ? FormattableString.Invariant($"\"type\": \"mesh\", \"positions\": [[{x - half}, {y}, {z - half}], [{x + half}, {y}, {z - half}], [{x + half}, {y}, {z + half}], [{x - half}, {y}, {z + half}]], \"triangles\": [[0, 1, 2], [0, 2, 3]]")
            : FormattableString.Invariant($"\"type\": \"rectangle\", \"corner\": [{x - half}, {y}, {z - half}], \"edgeU\": [{2 * half}, 0, 0], \"edgeV\": [0, 0, {2 * half}]");
    }
}
