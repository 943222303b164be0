using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Makes textures. Our uv are theirs; pictures, whose first row they have at v = 0, are turned over.</summary>
internal sealed class MitsubaTextures(ImportReading reading)
{
    private static readonly Dictionary<string, Interpolation> s_filters = new() { ["nearest"] = Interpolation.Nearest, ["bilinear"] = Interpolation.Bilinear };

    private static readonly Dictionary<string, Wrapping> s_wrappings =
        new() { ["repeat"] = Wrapping.Repeat, ["mirror"] = Wrapping.Mirror, ["clamp"] = Wrapping.Clamp };

    private readonly Dictionary<MitsubaObject, TextureDescription> _made = [];
    private readonly Dictionary<TextureDescription, string> _attributes = new(ReferenceEqualityComparer.Instance);
    private readonly Dictionary<TextureDescription, TextureDescription> _numbers = new(ReferenceEqualityComparer.Instance);

    /// <summary>The textures that have names.</summary>
    public Dictionary<string, TextureDescription> Named { get; } = new(StringComparer.Ordinal);

    /// <summary>A colour that may vary over a surface.</summary>
    /// <param name="thing">The thing that has it.</param>
    /// <param name="name">Its name there.</param>
    /// <param name="standard">The value where none is given.</param>
    /// <param name="isLight">True where it is of light, and not of what reflects it.</param>
    public TextureDescription Read(MitsubaObject thing, string name, Rgb standard, bool isLight = false) =>
        thing.Child("texture", name) is { } texture ? Read(texture) : MaterialTextures.Solid(MitsubaColors.Read(thing, name, standard, isLight, isLight ? float.PositiveInfinity : 1));

    /// <summary>A number that may vary over a surface.</summary>
    /// <param name="thing">The thing that has it.</param>
    /// <param name="name">Its name there.</param>
    /// <param name="standard">The value where none is given.</param>
    /// <param name="maximum">The most that is allowed.</param>
    public TextureDescription Read(MitsubaObject thing, string name, float standard, float maximum = 1) =>
        thing.Child("texture", name) is { } texture
            ? Number(texture)
            : MaterialTextures.Solid(MitsubaColors.Read(thing, name, new Rgb(standard, standard, standard), maximum: maximum));

    /// <summary>The texture that a thing is.</summary>
    public TextureDescription Read(MitsubaObject texture)
    {
        if (!_made.TryGetValue(texture, out TextureDescription? made))
        {
            made = reading.At(texture.Place, Make(texture));
            texture.Finish();
            _made.Add(texture, made);
            if (texture.Id.Length > 0)
            {
                Named[texture.Id] = made;
            }
        }

        return made;
    }

    /// <summary>The texture that a thing is, where a number is asked of it.</summary>
    public TextureDescription Number(MitsubaObject texture) => AsNumber(Read(texture), texture.Place);

    // There, coloured pictures have their luminance, and Mitsuba's checkerboard has its two textures in each other's place.
    private TextureDescription AsNumber(TextureDescription texture, SourcePlace place)
    {
        if (!_numbers.TryGetValue(texture, out TextureDescription? number))
        {
            number = texture switch
            {
                CheckerTextureDescription checker => checker with { Even = AsNumber(checker.Odd, place), Odd = AsNumber(checker.Even, place) },
                PlacedTextureDescription placed when AsNumber(placed.Texture, place) is var inner && inner != placed.Texture => placed with { Texture = inner },
                ImageTextureDescription image => image with { Luminance = true },
                _ => texture,
            };
            _numbers.Add(texture, number == texture ? texture : reading.At(place, number));
        }

        return number;
    }

    private TextureDescription Make(MitsubaObject texture) => texture.Type switch
    {
        "bitmap" => Bitmap(texture),
        "checkerboard" => Checkerboard(texture),
        "mesh_attribute" => Attribute(texture),
        "rawconstant" => Constant(texture),
        _ => Unknown(texture),
    };

    private static TextureDescription Unknown(MitsubaObject texture)
    {
        texture.UnknownType("textures", "bitmap", "checkerboard", "mesh_attribute", "rawconstant");
        return MaterialTextures.Solid(texture.Log.IsLenient ? new Rgb(1, 0, 1) : new Rgb(0.5f, 0.5f, 0.5f));
    }

    // Numbers that are no colours, whatever they are used for.
    private static TextureDescription Constant(MitsubaObject texture)
    {
        if (texture.Property("value") is not { } value)
        {
            texture.Log.Error(texture.Place, $"{texture.Describe()} needs a \"value\"");
            return MaterialTextures.Solid(Rgb.Black);
        }

        if (value.Name is "float" or "integer")
        {
            float number = texture.Float("value", 0);
            return MaterialTextures.Solid(new Rgb(number, number, number));
        }

        Vector3 numbers = texture.Vector("value") ?? Vector3.Zero;
        return MaterialTextures.Solid(new Rgb(numbers.X, numbers.Y, numbers.Z));
    }

    private TextureDescription Bitmap(MitsubaObject texture)
    {
        texture.Ignore("format", "accel");
        UvMap uv = UvMap.Read(texture);
        if (texture.FileName() is not { } file)
        {
            texture.Ignore("filter_type", "wrap_mode", "raw");
            return MaterialTextures.Solid(new Rgb(0.5f, 0.5f, 0.5f));
        }

        ImageTextureDescription image = new()
        {
            File = file,
            Interpolation = texture.Choice("filter_type", Interpolation.Bilinear, s_filters),
            Wrapping = texture.Choice("wrap_mode", Wrapping.Repeat, s_wrappings),
            Raw = texture.Boolean("raw", false),
        };
        Vector2 scale = uv.IsStraight ? uv.Scale : Vector2.One;
        Vector2 offset = uv.IsStraight ? uv.Offset : Vector2.Zero;
        image = reading.At(texture.Place, image with { Scale = new(scale.X, -scale.Y), Offset = new(offset.X, 1 - offset.Y) });
        return uv.IsStraight ? image : uv.Place(image);
    }

    /// <summary>The attributes of meshes that a material shows; the colours of corners come first.</summary>
    public string[] AttributesOf(MaterialDescription material) =>
        [.. MaterialTextures.Colors(material).Select(_attributes.GetValueOrDefault).OfType<string>().Distinct().OrderBy(name => name == "vertex_color" ? 0 : 1)];

    /// <summary>A material that shows an attribute as the second colours of its mesh.</summary>
    public MaterialDescription WithSecond(MaterialDescription material, string attribute) => MaterialTextures.Map(material, t => WithSecond(t, attribute));

    private TextureDescription WithSecond(TextureDescription texture, string attribute) => texture switch
    {
        VertexColorTextureDescription colors when _attributes.GetValueOrDefault(colors) == attribute => colors with { Second = true },
        ProductTextureDescription product => product with { First = WithSecond(product.First, attribute), Second = WithSecond(product.Second, attribute) },
        CheckerTextureDescription checker => checker with { Even = WithSecond(checker.Even, attribute), Odd = WithSecond(checker.Odd, attribute) },
        PlacedTextureDescription placed => placed with { Texture = WithSecond(placed.Texture, attribute) },
        _ => texture,
    };

    private TextureDescription Attribute(MitsubaObject texture)
    {
        string? name = texture.Text("name");
        if (name is null || !(name.StartsWith("vertex_", StringComparison.Ordinal) || name.StartsWith("face_", StringComparison.Ordinal)))
        {
            reading.Log.Error(name is null ? texture.Place : texture.PlaceOf("name"), "the name of a mesh's attribute begins with vertex_ or face_, as in \"vertex_color\"");
        }

        float scale = texture.Float("scale", 1);
        VertexColorTextureDescription colors = new();
        _attributes.Add(colors, name ?? "vertex_color");
        return scale == 1 ? colors : new ProductTextureDescription { First = colors, Second = MaterialTextures.Solid(new Rgb(scale, scale, scale)) };
    }

    // Fields of half a unit.
    private TextureDescription Checkerboard(MitsubaObject texture)
    {
        UvMap uv = UvMap.Read(texture);
        CheckerTextureDescription checker = new()
        {
            Even = Read(texture, "color0", new Rgb(0.4f, 0.4f, 0.4f)),
            Odd = Read(texture, "color1", new Rgb(0.2f, 0.2f, 0.2f)),
            Scale = 2 * (uv.IsStraight ? uv.Scale : Vector2.One),
            Offset = 2 * (uv.IsStraight ? uv.Offset : Vector2.Zero),
        };
        return uv.IsStraight ? checker : uv.Place(checker);
    }
}

/// <summary>An affine map of uv: what a texture's <c>to_uv</c> does before the texture is looked up.</summary>
/// <param name="First">The row that gives u: factors on u and v, and what is added.</param>
/// <param name="Second">The row that gives v.</param>
internal sealed record UvMap(Vector3 First, Vector3 Second)
{
    /// <summary>True where nothing is turned.</summary>
    public bool IsStraight => First.Y == 0 && Second.X == 0;

    /// <summary>Factors on u and v of a map that turns nothing.</summary>
    public Vector2 Scale => new(First.X, Second.Y);

    /// <summary>The offset.</summary>
    public Vector2 Offset => new(First.Z, Second.Z);

    /// <summary>A texture's map.</summary>
    public static UvMap Read(MitsubaObject texture)
    {
        Transform map = texture.Transform("to_uv");
        return new(new((float)map.X.A, (float)map.X.B, (float)map.X.D), new((float)map.Y.A, (float)map.Y.B, (float)map.Y.D));
    }

    /// <summary>A texture that is looked up at mapped uv.</summary>
    public TextureDescription Place(TextureDescription texture) =>
        new PlacedTextureDescription { Texture = texture, Matrix = [First.X, First.Y, First.Z, Second.X, Second.Y, Second.Z] };
}
