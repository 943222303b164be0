namespace RayTracer.RenderTests.Pairs;

/// <summary>
/// A small scene with a choice of features, and an equal one made otherwise: another sampler and integrator, transforms worked into the
/// numbers in place of an instance, one material of two kinds in place of a texture of numbers, a mix with nothing in place of a mask, slopes
/// by halves, glass without priorities, lamps and fog of other shapes, few lights at a time in place of one chosen of many, and motion that
/// runs backwards by another clock. What two features do to one another is strong in it: the thing is half inside of the fog, lamps are near
/// and large, one of them is seen behind the thing, and a mirror shows all of it again.
/// </summary>
/// <param name="Row">Which level of each of the <see cref="Features"/>.</param>
/// <param name="Samples">Samples for each pixel.</param>
internal sealed record PairScene(IReadOnlyList<int> Row, int Samples = 16)
{
    /// <summary>Lights of a scene with many: more than are asked all together.</summary>
    public const int Many = 9;

    /// <summary>Width and height of the picture, in pixels.</summary>
    public const int Edge = 16;

    private const string Filling = """ "interior": { "extinction": [0.05, 0.3, 0.6], "albedo": [0, 0, 0] } """;

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

    /// <summary>A scene with some features, each named by its level; all others are at their first levels.</summary>
    public static PairScene Of(int samples, params string[] levels) =>
        new([.. Features.Select(f => Math.Max(0, Array.FindIndex(f.Levels, l => levels.Contains(l))))], samples);

    /// <summary>How many groups the lights of the equal scene are rendered in.</summary>
    public int Groups => Is("lights", "many") ? 2 : 1;

    /// <summary>The scene with its features.</summary>
    public string Text => Write(isOtherwise: false, group: 0);

    /// <summary>The equal scene, made otherwise.</summary>
    /// <param name="group">Which of its groups of lights shines.</param>
    public string Otherwise(int group) => Write(isOtherwise: true, group);

    /// <inheritdoc/>
    public override string ToString() => string.Join(", ", Features.Select((f, i) => f.Levels[Row[i]]));

    private bool Is(string feature, string level)
    {
        int i = Features.TakeWhile(f => f.Name != feature).Count();
        int l = Array.IndexOf(Features[i].Levels, level);
        return l >= 0 ? Row[i] == l : throw new ArgumentException($"{feature} is never {level}", nameof(level));
    }

    private string Write(bool isOtherwise, int group)
    {
        string shutter = !Is("motion", "moves") ? "[0, 0]" : isOtherwise ? "[2, 5]" : "[0, 1]";
        string filter = Is("filter", "gaussian") ? """, "filter": { "shape": "gaussian", "radius": 1.2 }""" : "";
        string environment = Is("environment", "constant") && group == 0
            ? """ "environment": { "type": "constant", "radiance": [0.2, 0.25, 0.35] },""" : "";
        return $$"""
            {
              "camera": { "position": [0.4, 1.3, 4.5], "lookAt": [0, 0.75, 0], "up": [0.25, 1, 0], {{Projection()}}{{Lens()}} },
              "render": { "width": {{Edge}}, "height": {{Edge}}, "samplesPerPixel": {{Samples}},
                "integrator": "{{Integrator(isOtherwise)}}", "maxDepth": 6, "rouletteDepth": 30, "sampler": "{{Sampler(isOtherwise)}}", "shutter": {{shutter}}{{filter}},
                "shadingNormals": "{{(Is("shading normals", "literal") ? "literal" : "mended")}}" },
              {{environment}}
              "shapes": [
                { "type": "plane", "point": [0, 0, 0], "normal": [0, 1, 0],
                  "material": { "type": "diffuse", "color": { "type": "checker", "even": [0.3, 0.25, 0.2], "odd": [0.1, 0.15, 0.2] } } },
                { "type": "rectangle", "corner": [0.8, 0.01, -0.9], "edgeU": [0.8, 0, 0.6], "edgeV": [0, 1.5, 0],
                  "material": { "type": "conductor", "metal": "silver" } },
                {{Thing(isOtherwise)}}{{SecondThing(isOtherwise)}}{{Fog(isOtherwise)}}{{string.Concat(Lights(isOtherwise, group))}}
              ]
            }
            """;
    }

    private string Projection() => Is("projection", "orthographic")
        ? """ "projection": "orthographic", "viewSize": 2.5 """
        : """ "fieldOfView": 31 """;

    // The thing is out of focus, so that where a ray leaves the lens matters as much as when.
    private string Lens() => Is("lens", "disk") ? """, "lens": { "apertureRadius": 0.3, "focusDistance": 2.5 }"""
        : Is("lens", "bladed") ? """, "lens": { "shape": "bladed", "blades": 5, "apertureRadius": 0.3, "focusDistance": 2.5 }""" : "";

    private string Integrator(bool isOtherwise) => Is("medium", "fog") || isOtherwise ? "volPath" : "path";

    // What lies between the points of a regular grid is in no picture of it, so that no other sampler has the same.
    private string Sampler(bool isOtherwise) => !isOtherwise || Is("sampler", "regular") ? Features[0].Levels[Row[0]]
        : Is("sampler", "sobol") ? "independent"
        : "sobol";

    // The instance's transforms are worked into the thing in the other scene, and its motion runs backwards.
    private string Thing(bool isOtherwise)
    {
        string place = Is("placing", "stretched instance")
            ? """{ "rotate": 35, "axis": [0, 0, 1] }, { "scale": [1, 0.45, -0.8], "rotate": 30 }, { "translate": [0.2, 0.75, 0.1] }"""
            : """{ "translate": [0.2, 0.75, 0.1] }""";
        const string far = """, "transform": [{ "translate": [-1.1, 0.75, -0.2] }]""";
        string motion = !Is("motion", "moves") ? ""
            : isOtherwise ? $$""", "motion": [{ "time": 2{{far}} }, { "time": 5 }]"""
            : $$""", "motion": [{ "time": 0 }, { "time": 1{{far}} }]""";
        string bare = Shape() + $$""", "material": {{Material(isOtherwise)}}""";
        string inside = IsFilled
            ? $$"""
                , { {{Shape()}}, "material": { "type": "invisible", {{Filling}} },
                    "transform": [{ "scale": [0.998, 0.998, 0.998] }, {{place}}] }
              """
            : "";
        return (Is("placing", "stretched instance"), isOtherwise) switch
        {
            (true, false) => $$"""{ "type": "instance", "transform": [{{place}}]{{motion}}, "of": { {{bare}} } }""",
            (_, true) => $$"""{ "type": "group"{{motion}}, "shapes": [{ {{bare}}, "transform": [{{place}}] }{{inside}}] }""",
            _ => $$"""{ {{bare}}, "transform": [{{place}}]{{motion}} }""",
        };
    }

    // In fog, glass is coloured: by what fills it, and in the other scene by what fills a shape just inside of it.
    private bool IsFilled => Is("material", "glass") && Is("medium", "fog") && Is("normals", "plain") && !Is("thing", "smooth mesh");

    private string Shape()
    {
        const string octahedron = """
             "type": "mesh", "positions": [[0.7, 0, 0], [-0.7, 0, 0], [0, 0.7, 0], [0, -0.7, 0], [0, 0, 0.7], [0, 0, -0.7]],
             "uv": [[0, 0.5], [1, 0.5], [0.5, 1], [0.5, 0], [0.2, 0.3], [0.9, 0.8]],
             "triangles": [[4, 0, 2], [0, 5, 2], [5, 1, 2], [1, 4, 2], [0, 4, 3], [5, 0, 3], [1, 5, 3], [4, 1, 3]]
            """;
        return Is("thing", "box") ? """ "type": "box", "a": [-0.5, -0.5, -0.5], "b": [0.5, 0.5, 0.5] """
            : Is("thing", "flat mesh") ? octahedron
            : octahedron + """, "normals": [[1, 0.2, 0], [-1, 0, 0.2], [0, 1, 0], [0.1, -1, 0], [0, 0, 1], [0, 0.2, -1]]""";
    }

    private string Material(bool isOtherwise) => Embossed(Masked(Bare(isOtherwise), isOtherwise), isOtherwise);

    private string Bare(bool isOtherwise) => Is("material", "matt") ? """{ "type": "diffuse", "color": [0.95, 0.9, 0.8] }"""
        : Is("material", "polished") ? """{ "type": "roughPlastic", "alpha": 0.3, "color": [0.2, 0.4, 0.6] }"""
        : Is("material", "glass") ? $$"""{ "type": "roughDielectric", "alpha": 0.4{{(IsFilled && !isOtherwise ? $", {Filling}" : "")}} }"""
        : isOtherwise ? $$"""{ "type": "mix", "weight": {{Checker("0", "1")}}, "first": {{Metal("0.15")}}, "second": {{Metal("0.6")}} }"""
        : Metal(Checker("0.15", "0.6"));

    private static string Metal(string alpha) => $$"""{ "type": "roughConductor", "metal": "copper", "alpha": {{alpha}} }""";

    private static string Checker(string even, string odd) =>
        $$"""{ "type": "checker", "even": [{{even}}, {{even}}, {{even}}], "odd": [{{odd}}, {{odd}}, {{odd}}], "scale": [2, 2] }""";

    // Where the map says less, its strength is more: slopes are the quotients of its numbers.
    private string Embossed(string inner, bool isOtherwise) => !Is("normals", "normal map") ? inner
        : isOtherwise ? $$"""{ "type": "normalMap", "strength": 2, "map": {{Map("0.65, 0.5, 0.7", "0.5, 0.35, 0.8")}}, "material": {{inner}} }"""
        : $$"""{ "type": "normalMap", "map": {{Map("0.8, 0.5, 0.7", "0.5, 0.2, 0.8")}}, "material": {{inner}} }""";

    private static string Map(string even, string odd) =>
        $$"""{ "type": "checker", "even": [{{even}}], "odd": [{{odd}}], "scale": [3, 3] }""";

    private string Masked(string inner, bool isOtherwise) => !Is("mask", "holes") ? inner
        : isOtherwise ? $$"""{ "type": "mix", "weight": {{Checker("0.3", "1")}}, "first": { "type": "invisible" }, "second": {{inner}} }"""
        : $$"""{ "type": "mask", "opacity": {{Checker("0.3", "1")}}, "material": {{inner}} }""";

    // Fog gives way only to what has a priority: there the water keeps it, and the glass alone has an index relative to the water's.
    private string SecondThing(bool isOtherwise)
    {
        const string outer = """ "type": "sphere", "center": [-0.9, 0.5, 0.6], "radius": 0.45 """;
        const string inner = """ "type": "sphere", "center": [-0.9, 0.45, 0.6], "radius": 0.25 """;
        string priority = Is("medium", "fog") ? ", \"priority\": 1" : "";
        return Is("second thing", "none") ? ""
            : Is("second thing", "translucent sheet") ? """
                , { "type": "rectangle", "corner": [-1.6, 0.3, 0.4], "edgeU": [1.1, 0, 0], "edgeV": [0, 0.9, 0.9],
                    "material": { "type": "translucent", "color": [0.1, 0.1, 0.1], "transmittance": [0.8, 0.8, 0.8] } }
                """
            : Is("second thing", "prism") ? Prism(isOtherwise)
            : isOtherwise ? $$"""
                , { {{outer}}, "material": { "type": "dielectric", "refractiveIndex": 1.333{{priority}} } },
                  { {{inner}}, "material": { "type": "dielectric", "refractiveIndex": 1.2753188 } }
                """
            : $$"""
                , { {{outer}}, "material": { "type": "dielectric", "refractiveIndex": 1.333, "priority": 1 } },
                  { {{inner}}, "material": { "type": "dielectric", "refractiveIndex": 1.7, "priority": 2 } }
                """;
    }

    private static string Prism(bool isOtherwise)
    {
        string glass = isOtherwise
            ? """ "sellmeierB": [1.0396122, 0.231792344, 1.01046945], "sellmeierC": [0.00600069867, 0.0200179144, 103.560653] """
            : """ "glass": "bk7" """;
        return $$"""
            , { "type": "mesh", "material": { "type": "dielectric", {{glass}} }, "transform": [{ "translate": [0, 0.02, 0] }],
                "positions": [[-1.3, 0, 0.3], [-0.5, 0, 0.3], [-0.9, 0.8, 0.3], [-1.3, 0, 0.9], [-0.5, 0, 0.9], [-0.9, 0.8, 0.9]],
                "triangles": [[0, 2, 1], [3, 4, 5], [0, 1, 4], [0, 4, 3], [1, 2, 5], [1, 5, 4], [2, 0, 3], [2, 3, 5]] }
            """;
    }

    // It ends in the middle of the thing, and near the lamps. Panes of nothing before the lamps change only where light crosses boundaries.
    private string Fog(bool isOtherwise)
    {
        const string material = """
             "material": { "type": "invisible", "interior": { "extinction": [1.2, 1, 0.8], "albedo": [0.9, 0.8, 0.7], "anisotropy": 0.4 } }
            """;
        const string nothing = """
             "material": { "type": "invisible", "interior": { "extinction": [1e-6, 1e-6, 1e-6], "albedo": [0, 0, 0] } }
            """;
        return !Is("medium", "fog") ? ""
            : isOtherwise ? $$"""
                , { "type": "mesh", {{material}},
                    "positions": [[-1.5, 0.01, -1], [0.2, 0.01, -1], [0.2, 1.9, -1], [-1.5, 1.9, -1],
                                  [-1.5, 0.01, 1.2], [0.2, 0.01, 1.2], [0.2, 1.9, 1.2], [-1.5, 1.9, 1.2]],
                    "triangles": [[0, 2, 1], [0, 3, 2], [4, 5, 6], [4, 6, 7], [0, 1, 5], [0, 5, 4],
                                  [3, 7, 6], [3, 6, 2], [0, 4, 7], [0, 7, 3], [1, 2, 6], [1, 6, 5]] }
                """
            : $$"""
                , { "type": "box", "a": [-1.5, 0.01, -1], "b": [0.2, 1.9, 1.2], {{material}} },
                  { "type": "box", "a": [-2.5, 2.05, -1.7], "b": [3, 2.1, 3], {{nothing}} },
                  { "type": "box", "a": [-0.8, 0.1, 5.2], "b": [1.4, 2.3, 5.3], {{nothing}} },
                  { "type": "box", "a": [-0.4, 0.35, -1.15], "b": [0.8, 1.55, -1.1], {{nothing}} }
                """;
    }

    // The first light is above the thing, the second behind it, the third before it. Of many, the others hang beside the first. What does not
    // shine is black.
    private IEnumerable<string> Lights(bool isOtherwise, int group)
    {
        int count = Is("lights", "many") ? Many : 3;
        int exponent = Is("exponent", "gathered") ? 3 : 0;
        for (int i = 0; i < count; i++)
        {
            string material = isOtherwise && i % Groups != group
                ? """ "material": { "type": "diffuse", "color": [0, 0, 0] } """
                : $$""" "material": { "type": "luminaire", "multiplier": {{(count > 3 ? 2 + (i % 3) : 4)}}, "exponent": {{exponent}} } """;
            string lamp = i == 0 ? Lamp(-0.5, 2.15, 0.3, 0.6, isOtherwise)
                : i == 1 ? Lamp(0.2, 0.95, -1.35, 0.5, isOtherwise)
                : i == 2 ? Lamp(0.3, 1.2, 5.5, 1, isOtherwise)
                : Lamp(-1.8 + (0.5 * i), 2.3 + (0.1 * (i % 3)), 1.4 - (0.8 * (i % 4)), 0.25, isOtherwise);
            yield return $$""", { {{lamp}}, {{material}} }""";
        }
    }

    // Those above shine downwards, the one behind to the front, the one before it to the back.
    private string Lamp(double x, double y, double z, double half, bool isOtherwise)
    {
        bool isAbove = y > 2;
        int along = z > 3 ? -1 : 1;
        if (Is("lamp", "sphere"))
        {
            string center = Numbers(x, isAbove ? y + half : y, isAbove ? z : z - (along * half));
            return FormattableString.Invariant($" \"type\": \"sphere\", \"center\": {center}, \"radius\": {half}");
        }

        string Corner(int u, int v) => isAbove
            ? Numbers(x + (u * half), y, z + (v * half))
            : Numbers(x + (along * u * half), y + (v * half), z);
        return Is("lamp", "mesh") != isOtherwise
            ? $$"""
                "type": "mesh", "positions": [{{Corner(-1, -1)}}, {{Corner(1, -1)}}, {{Corner(1, 1)}}, {{Corner(-1, 1)}}],
                "triangles": [[0, 1, 2], [0, 2, 3]]
              """
            : $$"""
                "type": "rectangle", "corner": {{Corner(-1, -1)}}, "edgeU": {{Numbers(2 * along * half, 0, 0)}},
                "edgeV": {{(isAbove ? Numbers(0, 0, 2 * half) : Numbers(0, 2 * half, 0))}}
              """;
    }

    private static string Numbers(double x, double y, double z) => FormattableString.Invariant($"[{x}, {y}, {z}]");
}
