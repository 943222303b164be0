using System.Globalization;
using System.Text.Json;

namespace RayTracer.RenderTests.Oracle;

/// <summary>Reads the scene files that docs/scene-format.md describes, as far as the oracle's scenes use it.</summary>
internal sealed class SceneFile
{
    private readonly string _folder;
    private readonly JsonElement _root;

    private SceneFile(string folder, JsonElement root)
    {
        _folder = folder;
        _root = root;
    }

    /// <summary>Reads a scene.</summary>
    /// <param name="path">The file.</param>
    /// <param name="size">Width and height in pixels; null for the file's.</param>
    public static Scene Read(string path, (int Width, int Height)? size = null)
    {
        JsonDocumentOptions options = new() { CommentHandling = JsonCommentHandling.Skip, AllowTrailingCommas = true };
        using JsonDocument document = JsonDocument.Parse(File.ReadAllText(path), options);
        return new SceneFile(Path.GetDirectoryName(path)!, document.RootElement).Scene(size);
    }

    private static JsonElement? Get(JsonElement? element, string key) =>
        element is { } e && e.TryGetProperty(key, out JsonElement value) ? value : null;

    private static double Number(JsonElement? element, string key, double otherwise) => Get(element, key)?.GetDouble() ?? otherwise;

    private static string Word(JsonElement? element, string key, string otherwise) => Get(element, key)?.GetString() ?? otherwise;

    private static (double U, double V) Pair(JsonElement? element, string key, double u, double v) =>
        Get(element, key) is { } pair ? (pair[0].GetDouble(), pair[1].GetDouble()) : (u, v);

    private static Vec Vector(JsonElement? element, string key, Vec otherwise) =>
        Get(element, key) is { } v ? new(v[0].GetDouble(), v[1].GetDouble(), v[2].GetDouble()) : otherwise;

    private static Vec Color(JsonElement? element, string key) => Get(element, key) is { } color ? Color(color) : default;

    private static Vec Color(JsonElement color)
    {
        if (color.ValueKind == JsonValueKind.Array)
        {
            return new(color[0].GetDouble(), color[1].GetDouble(), color[2].GetDouble());
        }

        string code = color.GetString() switch { "skyblue" => "#87ceeb", "lightgrey" => "#d3d3d3", var other => other! };
        double Channel(int i) => PngFile.Linear(byte.Parse(code.AsSpan((2 * i) + 1, 2), NumberStyles.HexNumber, CultureInfo.InvariantCulture), raw: false);
        return new(Channel(0), Channel(1), Channel(2));
    }

    private Scene Scene((int Width, int Height)? size)
    {
        JsonElement? render = Get(_root, "render");
        Shape[] shapes = [.. Elements("shapes").Concat(Elements("lights")).Select(Shape)];
        return new()
        {
            Camera = Camera(),
            Width = size?.Width ?? (int)Number(render, "width", 600),
            Height = size?.Height ?? (int)Number(render, "height", 600),
            MaxDiffuseDepth = (int)Number(render, "maxDiffuseDepth", 4),
            MaxSpecularDepth = (int)Number(render, "maxSpecularDepth", 4),
            Background = Color(_root, "background"),
            Ambient = Color(_root, "ambient"),
            Shapes = shapes,
            Lights = [.. shapes.Where(s => s.Material is LuminaireMaterial)],
        };
    }

    private IEnumerable<JsonElement> Elements(string key) => Get(_root, key)?.EnumerateArray() ?? Enumerable.Empty<JsonElement>();

    private Camera Camera()
    {
        JsonElement? camera = Get(_root, "camera");
        JsonElement? lens = Get(camera, "lens");
        return new()
        {
            Position = Vector(camera, "position", new(0, 1, 5)),
            LookAt = Vector(camera, "lookAt", default),
            Up = Vector(camera, "up", new(0, 1, 0)),
            FieldOfView = Number(camera, "fieldOfView", 40),
            Axis = Word(camera, "fieldOfViewAxis", "vertical"),
            LensShape = Word(lens, "shape", "disk"),
            ApertureRadius = Number(lens, "apertureRadius", 0),
            FocusDistance = Number(lens, "focusDistance", 0),
            Jitter = Vector(lens, "jitter", new(0.05, 0.05, 0.05)),
        };
    }

    private Shape Shape(JsonElement shape)
    {
        Material material = Material(Get(shape, "material"), 0.5);
        switch (Word(shape, "type", ""))
        {
            case "sphere":
                return new Sphere(material, Vector(shape, "center", default), Number(shape, "radius", 1));
            case "plane":
                (double, double)? size = Get(shape, "size") is null ? null : Pair(shape, "size", 0, 0);
                return new Plane(material, Vector(shape, "point", default), Vector(shape, "normal", default), size);
            case "triangle":
                Vec[] corners = [.. new[] { "a", "b", "c" }.Select(corner => Vector(shape, corner, default))];
                return new Triangle(material, corners[0], corners[1], corners[2], [Pair(shape, "uvA", 0, 0), Pair(shape, "uvB", 1, 0), Pair(shape, "uvC", 0, 1)]);
            case "disk":
                return new Disk(material, Vector(shape, "center", default), Vector(shape, "normal", default), Number(shape, "radius", 1));
            case "rectangle":
                return new Parallelogram(material, Vector(shape, "corner", default), Vector(shape, "edgeU", default), Vector(shape, "edgeV", default));
            case "box":
                return new Box(material, Vector(shape, "a", default), Vector(shape, "b", default));
            case "cylinder" or "cone":
                double radius = Number(shape, "radius", 1);
                double topRadius = Word(shape, "type", "") == "cone" ? Number(shape, "topRadius", 0) : radius;
                return new Cone(material, Vector(shape, "bottom", default), Vector(shape, "top", default), radius, topRadius);
            case "torus":
                return new Torus(material, Vector(shape, "center", default), Vector(shape, "axis", new(0, 1, 0)), Number(shape, "radius", 1), Number(shape, "tubeRadius", 0.25));
            default:
                throw new FormatException($"shape {shape}");
        }
    }

    /// <param name="given">A material, its name, or null for a diffuse one.</param>
    /// <param name="otherwise">Grey of the diffuse material where none is given.</param>
    private Material Material(JsonElement? given, double otherwise)
    {
        if (given is not { } material)
        {
            return new DiffuseMaterial(new SolidTexture(otherwise * Vec.One));
        }

        if (material.ValueKind == JsonValueKind.String)
        {
            return Material(_root.GetProperty("materials").GetProperty(material.GetString()!), otherwise);
        }

        Texture Texture(double grey) => this.Texture(Get(material, "color"), grey);
        return Word(material, "type", "") switch
        {
            "diffuse" => new DiffuseMaterial(Texture(0.5)),
            "phongMetal" => new PhongMetalMaterial(Texture(0.9), Number(material, "exponent", 10000)),
            "dielectric" => new DielectricMaterial(
                Number(material, "refractiveIndex", 1.5), Color(material, "extinction"), Word(material, "fresnel", "exact") == "schlick"),
            "diffuseSpecular" => new DiffuseSpecularMaterial(
                Material(Get(material, "diffuse"), 0.5),
                Get(material, "specular") is { } coat ? Material(coat, 0) : new PhongMetalMaterial(new SolidTexture(Vec.One), 10000),
                Number(material, "r0", 0.04)),
            "luminaire" => new LuminaireMaterial(
                Texture(1), Number(material, "multiplier", 1), Number(material, "exponent", 0), Material(Get(material, "material"), 0)),
            _ => throw new FormatException($"material {material}"),
        };
    }

    private Texture Texture(JsonElement? given, double grey)
    {
        if (given is not { } texture)
        {
            return new SolidTexture(grey * Vec.One);
        }

        if (texture.ValueKind == JsonValueKind.String && Get(Get(_root, "textures"), texture.GetString()!) is { } named)
        {
            return Texture(named, grey);
        }

        return texture.ValueKind != JsonValueKind.Object ? new SolidTexture(Color(texture)) : Word(texture, "type", "") switch
        {
            "solid" => new SolidTexture(Color(texture.GetProperty("color"))),
            "checker" => new CheckerTexture(
                Texture(Get(texture, "even"), 0.8), Texture(Get(texture, "odd"), 0.2), Pair(texture, "scale", 1, 1), Pair(texture, "offset", 0, 0)),
            "image" => new ImageTexture(
                PngFile.Read(Path.Combine(_folder, Word(texture, "file", "")), Get(texture, "raw")?.GetBoolean() ?? false),
                Word(texture, "interpolation", "bilinear"), Word(texture, "wrapping", "repeat"), Pair(texture, "scale", 1, 1), Pair(texture, "offset", 0, 0)),
            _ => throw new FormatException($"texture {texture}"),
        };
    }
}
