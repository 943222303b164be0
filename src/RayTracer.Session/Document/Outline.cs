using System.Globalization;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>The things of a scene, as a tree to choose from.</summary>
/// <param name="Revision">The revision of the text that it is of.</param>
/// <param name="Camera">The camera.</param>
/// <param name="Render">Size, samples and depths.</param>
/// <param name="Background">The colour that is seen where there is nothing.</param>
/// <param name="Environment">The environment, which replaces the background.</param>
/// <param name="Ambient">The ambient light.</param>
/// <param name="Shapes">The shapes.</param>
/// <param name="Lights">The shapes listed as lights.</param>
/// <param name="Materials">The named materials.</param>
/// <param name="Textures">The named textures.</param>
/// <param name="Objects">The named shapes that only instances show.</param>
/// <param name="Idle">The parameters that have no effect as the scene is, by their pointers, with the reasons.</param>
public sealed record Outline(
    int Revision, OutlineNode Camera, OutlineNode Render, OutlineNode Background, OutlineNode Environment, OutlineNode Ambient, IReadOnlyList<OutlineNode> Shapes,
    IReadOnlyList<OutlineNode> Lights, IReadOnlyList<OutlineNode> Materials, IReadOnlyList<OutlineNode> Textures, IReadOnlyList<OutlineNode> Objects,
    IReadOnlyDictionary<string, string> Idle)
{
    /// <summary>The outline of a text.</summary>
    public static Outline Of(int revision, JsonNode root)
    {
        SceneValue scene = SceneValue.Scene(root);
        Dictionary<(TypeFamily, string), int> uses = SceneReferences.All(root).GroupBy(r => (r.Family!, r.Reference!)).ToDictionary(g => g.Key, g => g.Count());
        return new(
            revision,
            Section(scene, "camera", c => $"{c.Number("fieldOfView").ToString(CultureInfo.InvariantCulture)}°"),
            Section(scene, "render", r => string.Create(CultureInfo.InvariantCulture, $"{r.Number("width")} × {r.Number("height")}, {r.Number("samplesPerPixel")} samples")),
            Color(scene, "background"),
            Section(scene, "environment", e => e.Type?.Name ?? "none"),
            Color(scene, "ambient"),
            ListOf(root, scene.Child("shapes")!),
            ListOf(root, scene.Child("lights")!),
            [.. scene.Child("materials")!.Children().Select(m => Definition(root, m, uses))],
            [.. scene.Child("textures")!.Children().Select(t => Definition(root, t, uses))],
            ListOf(root, scene.Child("objects")!),
            IdleFields.Of(root));
    }

    /// <summary>The parameters that say what a material or texture mainly looks like; of one, the first that it has.</summary>
    internal static IReadOnlyList<string> MainKeys { get; } = ["color", "baseColor", "even", "texture", "diffuse", "first", "brick", "front", "material"];

    /// <summary>A colour as #rrggbb, in sRGB.</summary>
    internal static string Hex(Rgb color) =>
        $"#{SrgbCurve.Encode8(color.R):x2}{SrgbCurve.Encode8(color.G):x2}{SrgbCurve.Encode8(color.B):x2}";

    private static OutlineNode Section(SceneValue scene, string key, Func<SceneValue, string> summary)
    {
        SceneValue section = scene.Child(key)!;
        return new(section.Pointer, key, key, summary(section), false, null, []);
    }

    private static OutlineNode Color(SceneValue scene, string key)
    {
        SceneValue value = scene.Child(key)!;
        string? color = ColorOf(value) is { } written ? Hex(written) : value.Node is null ? Hex(default) : null;
        return new(value.Pointer, key, "color", color ?? "", false, color, []);
    }

    private static List<OutlineNode> ListOf(JsonNode root, SceneValue list)
    {
        List<OutlineNode> nodes = [];
        Dictionary<string, int> counts = new(StringComparer.Ordinal);
        foreach (SceneValue shape in list.Children())
        {
            string type = shape.Type?.Name ?? "shape";
            counts[type] = counts.GetValueOrDefault(type) + 1;
            bool isNamed = list.Parameter!.HasNames;
            string name = isNamed ? shape.Key : shape.Node?.Find("name") is { Kind: JsonKind.String, Text.Length: > 0 } given ? given.Text : $"{type} {counts[type]}";
            nodes.Add(Shape(root, shape, name, type));
        }

        return nodes;
    }

    private static OutlineNode Shape(JsonNode root, SceneValue shape, string name, string type)
    {
        SceneValue? material = shape.Child("material");
        SceneValue? made = material?.Resolved(root);
        string summary = shape.Child("of")?.Reference ?? (shape.Child("file")?.Node is { Kind: JsonKind.String, Text.Length: > 0 } file ? file.Text : null)
            ?? material?.Reference ?? made?.Type?.Name ?? "";
        bool isLight = made?.Type?.Name == "luminaire" || shape.Type is { IsLight: true };
        return new(
            shape.Pointer, name, type, summary, isLight, made is null ? null : MainColor(root, made),
            shape.Child("shapes") is { IsList: true } inner ? ListOf(root, inner) : []);
    }

    private static OutlineNode Definition(JsonNode root, SceneValue definition, Dictionary<(TypeFamily, string), int> uses)
    {
        int count = uses.GetValueOrDefault((definition.Family!, definition.Key));
        SceneValue thing = definition.Resolved(root);
        string type = thing.Type?.Name ?? (definition.Family == SceneTypes.Textures ? "solid" : "material");
        string summary = count switch { 0 => "not used", 1 => "used once", _ => string.Create(CultureInfo.InvariantCulture, $"used {count} times") };
        return new(definition.Pointer, definition.Key, type, summary, type == "luminaire", MainColor(root, thing), []);
    }

    // What a thing mainly looks like; null for glass, pictures, and what has no known colour.
    private static string? MainColor(JsonNode root, SceneValue thing, int nesting = 0)
    {
        if (nesting > 16 || thing.Node is null)
        {
            return null;
        }

        if (thing.Type is null)
        {
            return ColorOf(thing) is { } color ? Hex(color) : null;
        }

        if (MainKeys.Select(thing.Child).FirstOrDefault(c => c is not null) is not { } inner)
        {
            return null;
        }

        return inner.Node is not null ? MainColor(root, inner.Resolved(root), nesting + 1)
            : inner.Parameter!.Default switch
            {
                SolidTextureDescription solid => Hex(solid.Color),
                DiffuseMaterialDescription { Color: SolidTextureDescription solid } => Hex(solid.Color),
                _ => null,
            };
    }

    private static Rgb? ColorOf(SceneValue value) => value.Node switch
    {
        { Kind: JsonKind.String } name => CssColors.Find(name.Text) ?? CssColors.FromHex(name.Text),
        { Kind: JsonKind.Array, Items: [{ Number: { } r }, { Number: { } g }, { Number: { } b }] } => new(r, g, b),
        _ => null,
    };
}

/// <summary>A thing in the outline of a scene.</summary>
/// <param name="Pointer">Its pointer in the text.</param>
/// <param name="Name">The name.</param>
/// <param name="Type">Its type in scene files.</param>
/// <param name="Summary">A few words about it.</param>
/// <param name="IsLight">True if it shines.</param>
/// <param name="Color">Its main colour as #rrggbb (sRGB); null where it has none.</param>
/// <param name="Children">The things that it consists of.</param>
public sealed record OutlineNode(string Pointer, string Name, string Type, string Summary, bool IsLight, string? Color, IReadOnlyList<OutlineNode> Children);

/// <summary>The places where a scene's text refers to a material, texture or object by its name.</summary>
internal static class SceneReferences
{
    /// <summary>All references to a definition.</summary>
    public static IEnumerable<SceneValue> To(JsonNode root, TypeFamily family, string name) =>
        All(root).Where(v => v.Family == family && v.Reference == name);

    /// <summary>All references.</summary>
    public static IEnumerable<SceneValue> All(JsonNode root) => SceneValue.Scene(root).WithInner().Where(v => v.Reference is not null);

    /// <summary>The family of what is defined at a pointer, such as <c>/materials/glass</c>; null where it is no definition.</summary>
    public static TypeFamily? DefinedAt(string pointer) => JsonPointer.Parse(pointer) switch
    {
        ["materials", _] => SceneTypes.Materials,
        ["textures", _] => SceneTypes.Textures,
        ["objects", _] => SceneTypes.Shapes,
        _ => null,
    };
}
