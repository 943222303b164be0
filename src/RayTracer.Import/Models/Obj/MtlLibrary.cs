using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>The materials that an OBJ file uses, from the MTL files that it names.</summary>
internal sealed class MtlLibrary(string folder)
{
    // Beyond these a file is none of materials.
    private const int MostFaults = 20;

    // A matt colour that is not understood is seen.
    private static readonly Rgb s_magenta = new(1, 0, 1);

    // Statements that change nothing here without loss: ambient light is the scene's, sharpness belongs to reflection maps that are ready-made.
    private static readonly string[] s_ignored = ["Ka", "map_Ka", "sharpness", "map_aat"];

    private static readonly Dictionary<string, Action<MtlMaterial, float>> s_numbers = new()
    {
        ["Ns"] = (m, number) => m.Exponent = number,
        ["Ni"] = (m, number) => m.RefractiveIndex = number,
        ["Tr"] = (m, number) => m.Transparency = number,
        ["illum"] = (m, number) => m.Illumination = number is >= 0 and <= 10 ? (int)number : null,
        ["Pr"] = (m, number) => m.Roughness = number,
        ["Pm"] = (m, number) => m.Metallic = number,
        ["Ps"] = (m, number) => m.Sheen = number,
        ["Pc"] = (m, number) => m.Clearcoat = number,
        ["Pcr"] = (m, number) => m.ClearcoatRoughness = number,
        ["aniso"] = (m, number) => m.Anisotropic = number,
    };

    private static readonly Dictionary<string, Action<MtlMaterial, Rgb>> s_colors = new()
    {
        ["Kd"] = (m, color) => m.Diffuse = color,
        ["Ks"] = (m, color) => m.Specular = color,
        ["Ke"] = (m, color) => m.Emission = color,
    };

    private static readonly HashSet<string> s_maps = new(["map_Kd", "map_Ke", "map_d", "map_Pr", "map_Pm", "map_Ps", "norm", "bump", "map_Bump"], StringComparer.OrdinalIgnoreCase);

    private readonly Dictionary<string, MtlMaterial> _known = new(StringComparer.Ordinal);
    private readonly HashSet<string> _files = new(StringComparer.Ordinal);
    private int _faults;
    private readonly List<string> _used = [];
    private readonly Dictionary<string, int> _places = new(StringComparer.Ordinal);
    private readonly SortedSet<string> _notes = new(StringComparer.Ordinal);
    private readonly SortedSet<string> _leftOut = new(StringComparer.Ordinal);

    /// <summary>The number of a material that faces are made of; it may become known later.</summary>
    public int Use(string name)
    {
        if (!_places.TryGetValue(name, out int place))
        {
            place = _used.Count;
            _used.Add(name);
            _places.Add(name, place);
        }

        return place;
    }

    /// <summary>Reads material files.</summary>
    /// <param name="names">One name, which may have spaces; or several.</param>
    /// <exception cref="ModelException">Something is wrong with one.</exception>
    public void Read(string names)
    {
        string[] each = Find(names) is not null ? [names] : names.Split((char[])[' ', '\t'], StringSplitOptions.RemoveEmptyEntries);
        foreach (string name in each.Where(_files.Add))
        {
            if (Find(name) is not { } path)
            {
                Require(isThere: false, $"the material file {Quotation.Of(name)} does not exist");
                continue;
            }

            try
            {
                Parse(ModelBytes.Read(path), Path.GetFileName(path));
            }
            catch (Exception e) when (e is ModelException or IOException or UnauthorizedAccessException)
            {
                throw new ModelException($"{Path.GetFileName(path)}: {e.Message}", e);
            }
        }
    }

    /// <summary>The materials by their numbers.</summary>
    /// <param name="notes">Receives, once each, what is missing, left out or approximated.</param>
    public IReadOnlyList<MaterialDescription> Materials(List<string> notes)
    {
        string[] missing = [.. _used.Where(name => !_known.ContainsKey(name))];
        string more = missing.Length > 1 ? $" and {missing.Length - 1} more" : "";
        Require(missing.Length == 0, $"no material file describes {Quotation.Of(missing.FirstOrDefault(""))}{more}: grey is used instead");

        MaterialDescription[] all = [.. _used.Select(name => _known.TryGetValue(name, out MtlMaterial? known) ? known.ToDescription(_notes) : ShapeDescription.DefaultMaterial)];
        notes.AddRange(_notes);
        if (_leftOut.Count > 0)
        {
            notes.Add($"these material statements are ignored: {string.Join(", ", _leftOut.Take(20))}");
        }

        return all;
    }

    /// <summary>Reads the content of a material file.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="name">Its name in notes.</param>
    /// <exception cref="ModelException">Too much is wrong with it, or what is missing is an error.</exception>
    internal void Parse(ReadOnlySpan<byte> file, string name = "the material file")
    {
        var text = new ModelText(file, hasContinuations: true) { AcceptsOddNumbers = true };
        MtlMaterial? material = null;
        for (; !text.IsAtEnd; text.SkipLine())
        {
            int begin = text.Position;
            ReadOnlySpan<byte> word = text.Word();
            string keyword = ModelText.Decode(word[..Math.Min(word.Length, 40)]);
            if (keyword.Length == 0)
            {
                continue;
            }

            if (keyword == "newmtl")
            {
                material = new MtlMaterial();
                _known[text.RestOfLine()] = material;
                continue;
            }

            try
            {
                ReadStatement(keyword, ref text, material ?? throw text.ErrorAt(begin, "a statement comes before the first newmtl"));
            }
            catch (ModelException e) when (!StandIn.IsError && ++_faults <= MostFaults)
            {
                _notes.Add($"{name}: {e.Message}: the statement is ignored");
                if (keyword == "Kd" && material is not null)
                {
                    material.Diffuse = s_magenta;
                }
            }
        }
    }

    // What is missing is noted, or an error.
    private void Require(bool isThere, string note)
    {
        if (!isThere && StandIn.IsError)
        {
            throw new ModelException(note);
        }

        _ = isThere || _notes.Add(note);
    }

    private void ReadStatement(string keyword, ref ModelText text, MtlMaterial material)
    {
        if (s_numbers.TryGetValue(keyword, out Action<MtlMaterial, float>? setNumber))
        {
            setNumber(material, text.Number());
        }
        else if (s_colors.TryGetValue(keyword, out Action<MtlMaterial, Rgb>? setColor))
        {
            if (Color(keyword, ref text) is { } color)
            {
                setColor(material, color);
            }
        }
        else if (keyword == "d")
        {
            material.Opacity = text.TryNumber() ?? (text.Word().SequenceEqual("-halo"u8) ? 1 : throw text.Expected("a number", []));
        }
        else if (keyword == "Tf")
        {
            _ = (Color(keyword, ref text) ?? Rgb.White) == Rgb.White || _leftOut.Add(keyword);
        }
        else if (s_maps.Contains(keyword))
        {
            bool isColor = keyword is "map_Kd" or "map_Ke";
            ImageTextureDescription picture = Picture(ref text, material, isColor ? StandIn.Words : "its number is used instead");
            if (picture.Picture is null || isColor)
            {
                material.Pictures[keyword] = picture;
            }
        }
        else if (!s_ignored.Contains(keyword))
        {
            _leftOut.Add(Quotation.Short(Quotation.Of(keyword)[1..^1]));
        }
    }

    // One number is grey; files of spectra, and CIE XYZ, are not read.
    private Rgb? Color(string keyword, ref ModelText text)
    {
        int begin = text.Position;
        ReadOnlySpan<byte> word = text.Word();
        if (word.SequenceEqual("spectral"u8) || word.SequenceEqual("xyz"u8))
        {
            _leftOut.Add($"{keyword} {ModelText.Decode(word)}");
            return null;
        }

        text.Position = begin;
        float red = text.Number();
        return text.IsAtLineEnd() ? new Rgb(red, red, red) : new Rgb(red, text.Number(), text.Number());
    }

    private ImageTextureDescription Picture(ref ModelText text, MtlMaterial material, string instead)
    {
        ImageTextureDescription texture = new();
        while (true)
        {
            int begin = text.Position;
            ReadOnlySpan<byte> option = text.Word();
            if (option.IsEmpty || option[0] != '-')
            {
                text.Position = begin;
                break;
            }

            if (option.SequenceEqual("-bm"u8))
            {
                material.BumpScale = text.Number();
                continue;
            }

            texture = ReadOption(ModelText.Decode(option), ref text, texture);
        }

        string name = text.RestOfLine();
        string? path = Find(name);
        if (path is null || ImageFormat.OfName(path) is null)
        {
            string fault = path is null ? "is not there" : $"has no readable format ({ImageFormat.Endings()})";
            Require(isThere: false, $"the picture {Quotation.Of(name)} {fault}: {instead}");
            return texture with { Picture = StandIn.Checks };
        }

        return texture with { File = path };
    }

    private static ImageTextureDescription ReadOption(string option, ref ModelText text, ImageTextureDescription texture)
    {
        switch (option)
        {
            case "-s":
                return texture with { Scale = Pair(ref text, 1) };
            case "-o":
                return texture with { Offset = Pair(ref text, 0) };
            case "-clamp":
                return texture with { Wrapping = text.Word().SequenceEqual("on"u8) ? Wrapping.Clamp : Wrapping.Repeat };
        }

        _ = option switch { "-t" => Pair(ref text, 0).X, "-mm" => text.Number() + text.Number(), _ => text.Word().Length };
        return texture;
    }

    // u, and perhaps v, and perhaps w.
    private static System.Numerics.Vector2 Pair(ref ModelText text, float otherwise)
    {
        float u = text.Number();
        float v = text.TryNumber() ?? otherwise;
        text.TryNumber();
        return new(u, v);
    }

    // Authors work on other systems: with backslashes, with other folders, without regard to case.
    private string? Find(string name)
    {
        string relative = name.Replace('\\', '/').Trim('"');
        if (relative.Length == 0 || relative.Contains('\0', StringComparison.Ordinal))
        {
            return null;
        }

        string bare = relative[(relative.LastIndexOf('/') + 1)..];
        string? path = new[] { relative, bare }.Where(n => n.Length > 0).Select(n => Path.GetFullPath(Path.Combine(folder, n))).FirstOrDefault(File.Exists);
        return path ?? SimilarTo(bare);
    }

    private string? SimilarTo(string name)
    {
        try
        {
            return Directory.EnumerateFiles(folder).Where(f => Path.GetFileName(f).Equals(name, StringComparison.OrdinalIgnoreCase)).Order(StringComparer.Ordinal).FirstOrDefault();
        }
        catch (Exception e) when (e is IOException or UnauthorizedAccessException or ArgumentException)
        {
            return null;
        }
    }
}
