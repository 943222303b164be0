using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Describes the textures that a glTF file's materials use.</summary>
internal sealed class GltfTextures(GltfDocument document, GltfImages images)
{
    private const int Nearest = 9728;
    private const int NearestMipmapNearest = 9984;
    private const int NearestMipmapLinear = 9986;
    private const int ClampToEdge = 33071;
    private const int MirroredRepeat = 33648;
    private const int Repeat = 10497;

    private readonly Dictionary<(GltfTextureUse Use, GltfChannel Channel), TextureDescription> _described = [];

    /// <summary>A colour times a texture; the colour alone where there is none, or none that can be shown.</summary>
    /// <param name="factor">The colour, linear.</param>
    /// <param name="use">The texture; may be null.</param>
    /// <param name="uvSet">The set of uv that the mesh has; a texture on another one is averaged.</param>
    public TextureDescription Colour(Rgb factor, GltfTextureUse? use, int uvSet) => Times(factor, use, GltfChannel.Color, uvSet);

    /// <summary>A number times a channel of a texture; the number alone where there is none, or none that can be shown.</summary>
    /// <param name="factor">The number.</param>
    /// <param name="use">The texture; may be null.</param>
    /// <param name="channel">The channel.</param>
    /// <param name="uvSet">The set of uv that the mesh has; a texture on another one is averaged.</param>
    public TextureDescription Number(float factor, GltfTextureUse? use, GltfChannel channel, int uvSet) => Times(new(factor, factor, factor), use, channel, uvSet);

    /// <summary>The directions of a normal map; null where there are none that can be shown.</summary>
    public TextureDescription? Normals(GltfTextureUse? use, int uvSet)
    {
        if (use is null || Source(use.Texture) is not { } image)
        {
            return null;
        }

        if (use.UvSet != uvSet)
        {
            document.Notes.Add("a normal map with a different uv set from the base colour is ignored");
            return null;
        }

        return Described(use, image, GltfChannel.All);
    }

    /// <summary>The cut-out of a surface: the opacity, or 1 and 0 as it reaches a threshold or not.</summary>
    /// <param name="factor">Factor on the opacity.</param>
    /// <param name="use">The texture whose alpha it is; may be null.</param>
    /// <param name="threshold">The threshold; null for none.</param>
    /// <param name="uvSet">The set of uv that the mesh has.</param>
    public TextureDescription Opacity(float factor, GltfTextureUse? use, float? threshold, int uvSet)
    {
        TextureDescription opacity = Number(factor, use, GltfChannel.Alpha, uvSet);
        if (threshold is not { } least)
        {
            return opacity;
        }

        if (opacity is SolidTextureDescription { Color.R: var value })
        {
            return Solid(value >= least ? 1 : 0);
        }

        int image = Source(use!.Texture)!.Value;
        Picture alpha = images.Picture(image, GltfChannel.Alpha)!;
        Picture cut = new(alpha.Width, alpha.Height, [.. alpha.Pixels.Select(a => a * factor >= least ? 1f : 0)]);
        return Placed(Image(use.Texture, cut), use);
    }

    private static SolidTextureDescription Solid(float value) => new() { Color = new(value, value, value) };

    private TextureDescription Times(Rgb factor, GltfTextureUse? use, GltfChannel channel, int uvSet)
    {
        TextureDescription solid = new SolidTextureDescription { Color = factor };
        if (use is null || factor.IsBlack || Source(use.Texture) is not { } image || images.Picture(image, channel) is not { } picture)
        {
            return solid;
        }

        if (use.UvSet != uvSet)
        {
            document.Notes.Add("a texture with a different uv set from the base colour is averaged");
            return new SolidTextureDescription { Color = factor * GltfImages.Mean(picture) };
        }

        TextureDescription texture = Described(use, image, channel);
        return factor == Rgb.White ? texture : new ProductTextureDescription { First = texture, Second = solid };
    }

    private TextureDescription Described(GltfTextureUse use, int image, GltfChannel channel) =>
        _described.Remember((use, channel), () => Placed(Image(use.Texture, images.Picture(image, channel)!), use));

    private int? Source(int texture)
    {
        GltfObject described = document.List("textures")[texture];
        int? source = document.Reference(described, "source", "images");
        string[] others = [.. described.Child("extensions")?.Node.Members.Select(m => m.Key) ?? []];
        document.Notes.AddIf(source is null, $"a texture without a PNG or JPEG picture is ignored{(others.Length > 0 ? $": {string.Join(", ", others)} is not read" : "")}");

        return source;
    }

    private ImageTextureDescription Image(int texture, Picture picture)
    {
        GltfObject described = document.List("textures")[texture];
        GltfObject? sampler = document.Reference(described, "sampler", "samplers") is { } index ? document.List("samplers")[index] : null;
        int filter = sampler?.Integer("magFilter") ?? sampler?.Integer("minFilter") ?? 0;
        return new()
        {
            Picture = picture,
            Interpolation = filter is Nearest or NearestMipmapNearest or NearestMipmapLinear ? Interpolation.Nearest : Interpolation.Bilinear,
            Wrapping = Wrap(sampler, "wrapS"),
            VerticalWrapping = Wrap(sampler, "wrapT"),
        };
    }

    private static Wrapping Wrap(GltfObject? sampler, string key) => (sampler?.Integer(key) ?? Repeat) switch
    {
        ClampToEdge => Wrapping.Clamp,
        MirroredRepeat => Wrapping.Mirror,
        Repeat => Wrapping.Repeat,
        _ => throw sampler!.Error(key, "expected 33071 (clamp to edge), 33648 (mirrored repeat) or 10497 (repeat)"),
    };

    // In glTF, s′ = offset + R·(scale·(s, t)), with t downwards; with u = s and v = 1 − t, the same turn is counter-clockwise.
    private static TextureDescription Placed(ImageTextureDescription image, GltfTextureUse use)
    {
        if (use.Scale == Vector2.One && use.Rotation == 0 && use.Offset == Vector2.Zero)
        {
            return image;
        }

        float turns = use.Rotation / (2 * float.Pi);
        LaneMath.SinCosTurn(turns - float.Floor(turns), out float sin, out float cos);
        return new PlacedTextureDescription
        {
            Texture = image,
            Scale = use.Scale,
            Rotate = 360 * turns,
            Offset = new(use.Offset.X + (sin * use.Scale.Y), 1 - use.Offset.Y - (cos * use.Scale.Y)),
        };
    }
}

/// <summary>The use of a texture by a material (glTF 2.0, "textureInfo", and KHR_texture_transform).</summary>
/// <param name="Texture">Which of the file's textures.</param>
/// <param name="UvSet">Which set of uv.</param>
/// <param name="Scale">First, factors on uv.</param>
/// <param name="Rotation">Then, an angle in radians.</param>
/// <param name="Offset">Last, what is added.</param>
internal sealed record GltfTextureUse(int Texture, int UvSet, Vector2 Scale, float Rotation, Vector2 Offset)
{
    /// <summary>Reads a property; null where there is none.</summary>
    public static GltfTextureUse? Of(GltfDocument document, GltfObject? owner, string key)
    {
        if (owner?.Child(key) is not { } info)
        {
            return null;
        }

        GltfObject? transform = info.Extension("KHR_texture_transform");
        return new(
            document.RequiredReference(info, "index", "textures"),
            transform?.Integer("texCoord") ?? info.Integer("texCoord") ?? 0,
            Pair(transform, "scale", Vector2.One),
            transform?.Number("rotation", 0) ?? 0,
            Pair(transform, "offset", Vector2.Zero));
    }

    private static Vector2 Pair(GltfObject? from, string key, Vector2 fallback) =>
        from?.Numbers(key, 2) is { } pair ? new(pair[0], pair[1]) : fallback;
}

/// <summary>The channels of a picture that a texture shows.</summary>
internal enum GltfChannel
{
    /// <summary>Red as a number.</summary>
    Red,

    /// <summary>Green as a number.</summary>
    Green,

    /// <summary>Blue as a number.</summary>
    Blue,

    /// <summary>The opacity.</summary>
    Alpha,

    /// <summary>The colours, decoded from sRGB.</summary>
    Color,

    /// <summary>All three numbers as they are.</summary>
    All,
}
