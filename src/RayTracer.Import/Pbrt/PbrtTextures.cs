using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Makes textures. Their uv are ours: (0, 0) is the lower left corner of a picture.</summary>
internal sealed class PbrtTextures(ImportReading reading, PbrtWorld world)
{
    private const string Number = "float";

    private static readonly string[] s_types = ["constant", "scale", "mix", "bilerp", "imagemap", "checkerboard", "dots", "fbm", "wrinkled", "windy", "marble"];

    private static readonly Dictionary<string, Interpolation> s_filters = new()
    {
        ["point"] = Interpolation.Nearest,
        ["bilinear"] = Interpolation.Bilinear,
        ["trilinear"] = Interpolation.Bilinear,
        ["ewa"] = Interpolation.Bilinear,
        ["EWA"] = Interpolation.Bilinear,
    };

    private static readonly Dictionary<string, Wrapping> s_wrappings = new() { ["repeat"] = Wrapping.Repeat, ["clamp"] = Wrapping.Clamp };

    private static readonly Dictionary<string, PerlinPattern> s_noises =
        new() { ["fbm"] = PerlinPattern.Fbm, ["wrinkled"] = PerlinPattern.Wrinkled, ["windy"] = PerlinPattern.Windy, ["marble"] = PerlinPattern.Marble };

    private readonly Dictionary<PbrtThing, TextureDescription> _made = [];
    private readonly HashSet<PbrtThing> _open = [];

    /// <summary>The textures that have names.</summary>
    public Dictionary<string, TextureDescription> Named { get; } = new(StringComparer.Ordinal);

    /// <summary>Reads all of the scene's textures, so that mistakes in those that nothing shows are found too.</summary>
    public void ReadAll()
    {
        foreach (((string of, string name), PbrtThing thing) in world.Textures)
        {
            Named[world.Textures.ContainsKey((of == Number ? "spectrum" : Number, name)) ? $"{name} ({of})" : name] = Read(thing, of);
        }
    }

    /// <summary>A colour that may vary over a surface.</summary>
    /// <param name="thing">The thing that has it.</param>
    /// <param name="name">Its name there.</param>
    /// <param name="standard">The value where none is given.</param>
    /// <param name="maximum">The most that a channel may be.</param>
    public TextureDescription Color(PbrtThing thing, string name, Rgb standard, float maximum = 1) =>
        Varying(thing, name, "spectrum") ?? MaterialTextures.Solid(PbrtColors.Read(thing, name, standard, maximum: maximum));

    /// <summary>A number that may vary over a surface; null where none is given.</summary>
    public TextureDescription? Float(PbrtThing thing, string name) =>
        !thing.Has(name) ? Ask(thing, name) : Varying(thing, name, Number) ?? MaterialTextures.Solid(thing.Float(name, 0));

    private static TextureDescription? Ask(PbrtThing thing, string name)
    {
        thing.Ignore(name);
        return null;
    }

    // The texture that a parameter names; null where it names none.
    private TextureDescription? Varying(PbrtThing thing, string name, string of)
    {
        if (!thing.Has(name) || thing.Parameter(name) is not { Type: "texture" } parameter)
        {
            return null;
        }

        string texture = parameter.Words[0];
        if (world.Textures.TryGetValue((of, texture), out PbrtThing? found))
        {
            return Read(found, of);
        }

        string[] known = [.. world.Textures.Keys.Where(k => k.Of == of).Select(k => k.Name)];
        reading.Log.Unknown(parameter.Place, $"there is no texture {Quotation.Of(texture)} of {of}", texture, known);
        return MaterialTextures.Solid(0.5f);
    }

    private TextureDescription Read(PbrtThing texture, string of)
    {
        if (_made.TryGetValue(texture, out TextureDescription? made))
        {
            return made;
        }

        if (!_open.Add(texture) || _open.Count > 64)
        {
            reading.Log.Error(texture.Place, "the texture consists of itself, or of more than 64 others one within the other");
            return MaterialTextures.Solid(0.5f);
        }

        made = reading.At(texture.Place, Make(texture, of));
        texture.Finish();
        _made.Add(texture, made);
        _open.Remove(texture);
        return made;
    }

    private TextureDescription Make(PbrtThing texture, string of)
    {
        if (!s_types.Contains(texture.Type))
        {
            texture.UnknownType(s_types);
            return MaterialTextures.Solid(new Rgb(1, 0, 1));
        }

        return texture.Type switch
        {
            "constant" => Part(texture, "value", of, 1),
            "scale" => new ProductTextureDescription { First = Part(texture, "tex", of, 1), Second = Part(texture, "scale", Number, 1) },
            "mix" => new MixTextureDescription { First = Part(texture, "tex1", of, 0), Second = Part(texture, "tex2", of, 1), Weight = Part(texture, "amount", Number, 0.5f) },
            "bilerp" => Bilerp(texture, of),
            "imagemap" => Picture(texture),
            "dots" => Dots(texture, of),
            var noise when s_noises.TryGetValue(noise, out PerlinPattern pattern) => Noise(texture, pattern, of),
            _ => Checkerboard(texture, of),
        };
    }

    private TextureDescription Part(PbrtThing texture, string name, string of, float standard) =>
        of == Number ? Float(texture, name) ?? MaterialTextures.Solid(standard) : Color(texture, name, new Rgb(standard, standard, standard));

    private TextureDescription Bilerp(PbrtThing texture, string of)
    {
        (Vector2 scale, Vector2 offset) = Mapping(texture);
        GradientTextureDescription AlongU(string first, string second) => new() { First = Part(texture, first, of, 0), Second = Part(texture, second, of, 1) };
        MixTextureDescription both = new()
        {
            First = AlongU("v00", "v10") is var low && texture.Has("v10") ? low : low with { Second = MaterialTextures.Solid(0) },
            Second = AlongU("v01", "v11") is var high && texture.Has("v01") ? high : high with { First = MaterialTextures.Solid(1) },
            Weight = new PlacedTextureDescription { Texture = new GradientTextureDescription(), Matrix = [0, 1, 0, 1, 0, 0] },
        };
        return new PlacedTextureDescription { Texture = both, Scale = scale, Offset = offset };
    }

    private TextureDescription Checkerboard(PbrtThing texture, string of)
    {
        if (texture.Integer("dimension", 2) != 2)
        {
            reading.Log.Unsupported(texture.PlaceOf("dimension"), "a checkerboard in space is not supported", "it is on the surface");
        }

        (Vector2 scale, Vector2 offset) = Mapping(texture);
        return new CheckerTextureDescription { Even = Part(texture, "tex1", of, 1), Odd = Part(texture, "tex2", of, 0), Scale = scale, Offset = offset };
    }

    private DotsTextureDescription Dots(PbrtThing texture, string of)
    {
        (Vector2 scale, Vector2 offset) = Mapping(texture);
        return new() { Inside = Part(texture, "inside", of, 1), Outside = Part(texture, "outside", of, 0), Scale = scale, Offset = offset };
    }

    // In the space of the texture itself, which instances move through.
    private PerlinTextureDescription Noise(PbrtThing texture, PerlinPattern pattern, string of)
    {
        bool isMarble = pattern == PerlinPattern.Marble;
        if (isMarble == (of == Number))
        {
            reading.Log.Error(texture.Place, $"a texture {Quotation.Of(texture.Type)} is of {(isMarble ? "spectrum" : Number)}, not of {of}");
        }

        float scale = isMarble ? texture.Float("scale", 1, 1e-6f) : 1;
        PerlinTextureDescription noise = new()
        {
            Pattern = pattern,
            Space = TextureSpace.World,
            Transform = MatrixSteps.Of(texture.State.Place * Transform.Scaling(new(1 / scale, 1 / scale, 1 / scale))),
        };
        return pattern == PerlinPattern.Windy ? noise : noise with
        {
            Octaves = int.Min(texture.Integer("octaves", 8, 1), 16),
            Roughness = texture.Float("roughness", 0.5f, 0, 1),
            Variation = isMarble ? texture.Float("variation", 0.2f, 0) : noise.Variation,
        };
    }

    private TextureDescription Picture(PbrtThing texture)
    {
        // Ours need no hints against aliasing.
        texture.Ignore("maxanisotropy");
        (Vector2 scale, Vector2 offset) = Mapping(texture);
        string encoding = texture.Text("encoding") ?? "sRGB";
        if (encoding is not ("sRGB" or "linear"))
        {
            reading.Log.Unsupported(texture.PlaceOf("encoding"), $"pictures are encoded as sRGB or linear here, not as {Quotation.Of(encoding)}", "sRGB is assumed");
        }

        if (texture.Boolean("invert", false))
        {
            reading.Log.Unsupported(texture.PlaceOf("invert"), "pictures that are inverted are not supported", "it is as it is");
        }

        ImageTextureDescription image = new()
        {
            File = texture.FileName() ?? "",
            Interpolation = texture.Choice("filter", Interpolation.Bilinear, s_filters),
            Wrapping = texture.Choice("wrap", Wrapping.Repeat, s_wrappings),
            Raw = encoding == "linear",
            Scale = scale,
            Offset = offset,
        };
        float factor = texture.Float("scale", 1, 0);
        return image.File.Length == 0 ? MaterialTextures.Solid(0.5f)
            : factor == 1 ? image : new ProductTextureDescription { First = reading.At(texture.Place, image), Second = MaterialTextures.Solid(factor) };
    }

    private (Vector2 Scale, Vector2 Offset) Mapping(PbrtThing texture)
    {
        if (texture.Text("mapping") is { } mapping and not "uv")
        {
            reading.Log.Unsupported(texture.PlaceOf("mapping"), $"textures lie on surfaces by their uv here, not by a {Quotation.Of(mapping)} mapping", "the uv are used");
            texture.Ignore("v1", "v2");
        }

        return (new(texture.Float("uscale", 1), texture.Float("vscale", 1)), new(texture.Float("udelta", 0), texture.Float("vdelta", 0)));
    }
}
