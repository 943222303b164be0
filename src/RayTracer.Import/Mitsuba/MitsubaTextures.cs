using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Makes textures. Our uv are theirs; pictures, whose first row they have at v = 0, are turned over.</summary>
internal sealed class MitsubaTextures(MitsubaReading reading)
{
    private static readonly Dictionary<string, Interpolation> s_filters = new() { ["nearest"] = Interpolation.Nearest, ["bilinear"] = Interpolation.Bilinear };

    private static readonly Dictionary<string, Wrapping> s_wrappings = new()
    {
        ["repeat"] = Wrapping.Repeat,
        ["mirror"] = Wrapping.Mirror,
        ["clamp"] = Wrapping.Clamp,
    };

    private readonly Dictionary<MitsubaObject, TextureDescription> _made = [];

    /// <summary>The textures that have names.</summary>
    public Dictionary<string, TextureDescription> Named { get; } = new(StringComparer.Ordinal);

    /// <summary>A colour that may vary over a surface.</summary>
    /// <param name="thing">What has it.</param>
    /// <param name="name">Its name there.</param>
    /// <param name="standard">What it is where it is not given.</param>
    /// <param name="isLight">Whether it is of light, and not of what reflects it.</param>
    public TextureDescription Read(MitsubaObject thing, string name, Rgb standard, bool isLight = false) =>
        thing.Child("texture", name) is { } texture ? Read(texture) : Solid(MitsubaColors.Read(thing, name, standard, isLight, isLight ? float.PositiveInfinity : 1));

    /// <summary>A number that may vary over a surface.</summary>
    /// <param name="thing">What has it.</param>
    /// <param name="name">Its name there.</param>
    /// <param name="standard">What it is where it is not given.</param>
    /// <param name="maximum">The most that is allowed.</param>
    public TextureDescription Read(MitsubaObject thing, string name, float standard, float maximum = 1) =>
        thing.Child("texture", name) is { } texture ? Read(texture) : Solid(MitsubaColors.Read(thing, name, new Rgb(standard, standard, standard), maximum: maximum));

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

    /// <summary>The same colour everywhere.</summary>
    public static TextureDescription Solid(Rgb color) => new SolidTextureDescription { Color = color };

    private TextureDescription Make(MitsubaObject texture)
    {
        switch (texture.Type)
        {
            case "bitmap":
                return Bitmap(texture);
            case "checkerboard":
                return Checkerboard(texture);
            case "mesh_attribute":
                return Attribute(texture);
            default:
                reading.Log.Unknown(texture.TypePlace, $"textures of type {Quotation.Of(texture.Type)} are not supported", texture.Type, ["bitmap", "checkerboard", "mesh_attribute"]);
                return Solid(new(0.5f, 0.5f, 0.5f));
        }
    }

    private TextureDescription Bitmap(MitsubaObject texture)
    {
        texture.Ignore("format", "accel");
        UvMap uv = UvMap.Read(texture);
        if (texture.FileName() is not { } file)
        {
            texture.Ignore("filter_type", "wrap_mode", "raw");
            return Solid(new(0.5f, 0.5f, 0.5f));
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

    // Of the attributes of meshes besides uv, only the colours of their corners are supported.
    private TextureDescription Attribute(MitsubaObject texture)
    {
        if (texture.Text("name") != "vertex_color")
        {
            reading.Log.Error(texture.Has("name") ? texture.PlaceOf("name") : texture.Place, "of the attributes of meshes, only \"vertex_color\" is supported");
        }

        float scale = texture.Float("scale", 1);
        TextureDescription colors = new VertexColorTextureDescription();
        return scale == 1 ? colors : new ProductTextureDescription { First = colors, Second = Solid(new(scale, scale, scale)) };
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
