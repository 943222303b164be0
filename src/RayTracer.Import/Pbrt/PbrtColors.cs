using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Spectra;

namespace RayTracer.Import;

/// <summary>
/// Reads colours: RGB, and spectra, of which the colour is computed. Of lights, spectra say the colour alone: pbrt divides them by their luminance, so that
/// they shine with a luminance of 1 until they are scaled.
/// </summary>
internal static class PbrtColors
{
    /// <summary>The colour spaces that are read.</summary>
    public static readonly string[] Spaces = ["srgb", "dci-p3", "rec2020"];

    // Rows of the maps to linear sRGB, of primaries with the white point D65 (SMPTE EG 432-1 and ITU-R BT.2020, section 3).
    private static readonly Dictionary<string, Rgb[]> s_toSrgb = new()
    {
        ["dci-p3"] = [new(1.2249402f, -0.2249402f, 0), new(-0.0420569f, 1.0420569f, 0), new(-0.0196376f, -0.0786361f, 1.0982736f)],
        ["rec2020"] = [new(1.6604910f, -0.5876411f, -0.0728499f), new(-0.1245505f, 1.1328999f, -0.0083494f), new(-0.0181508f, -0.1005789f, 1.1187297f)],
    };

    // A is the light of a black body by the constants of its time, whose temperature is 2856 K by those of today (CIE 15:2004, section 3.1).
    private const float TemperatureOfA = 2856;

    /// <summary>A parameter's colour.</summary>
    /// <param name="thing">The thing that has it.</param>
    /// <param name="name">Its name.</param>
    /// <param name="standard">The colour where none is given, or a wrong one.</param>
    /// <param name="isLight">True where it is of light, and not of what reflects it.</param>
    /// <param name="maximum">The most that a channel may be.</param>
    public static Rgb Read(PbrtThing thing, string name, Rgb standard, bool isLight = false, float maximum = float.PositiveInfinity)
    {
        if (thing.Parameter(name) is not { } parameter || !thing.Is(parameter, "rgb", "spectrum", "blackbody"))
        {
            return standard;
        }

        Rgb? color = parameter.Type switch
        {
            "rgb" => OfNumbers(thing, parameter),
            "blackbody" => BlackBody(thing, parameter, isLight),
            _ => OfSpectrum(thing, parameter, isLight),
        };
        return color is null ? standard : Limited(thing, parameter, color.Value, maximum);
    }

    /// <summary>The name of a spectrum that pbrt knows, where a parameter is one; else null.</summary>
    public static string? NameOf(PbrtThing thing, string name) =>
        thing.Has(name) && thing.Parameter(name) is { Type: "spectrum", Words: [var word] } ? word : null;

    /// <summary>The channels of many colours, none below 0; empty where they are not given.</summary>
    public static IReadOnlyList<float> Many(PbrtThing thing, string name)
    {
        if (thing.Parameter(name) is not { } parameter || !thing.Is(parameter, "rgb"))
        {
            return [];
        }

        if (parameter.Numbers.Count % 3 != 0)
        {
            return thing.Log.Fail<IReadOnlyList<float>>(parameter.Place, $"expected red, green and blue for each colour of {Quotation.Of(name)}, but found {parameter.Numbers.Count} numbers") ?? [];
        }

        return [.. parameter.Numbers.Chunk(3).Select(c => Linear(thing, c[0], c[1], c[2])).SelectMany(c => new[] { c.R, c.G, c.B }).Select(c => float.Max(c, 0))];
    }

    // Colours of wider spaces may lie beyond those of sRGB.
    private static Rgb Limited(PbrtThing thing, PbrtParameter parameter, Rgb color, float maximum)
    {
        Rgb limited = new(float.Clamp(color.R, 0, maximum), float.Clamp(color.G, 0, maximum), float.Clamp(color.B, 0, maximum));
        if (limited != color)
        {
            string range = float.IsInfinity(maximum) ? "at least 0" : $"from 0 to {maximum}";
            thing.Log.Warn(parameter.Place, $"the channels of {Quotation.Of(parameter.Name)} are brought into range, {range}");
        }

        return limited;
    }

    private static Rgb? OfNumbers(PbrtThing thing, PbrtParameter parameter)
    {
        if (parameter.Numbers is not [var r, var g, var b])
        {
            return thing.Log.Fail<Rgb?>(parameter.Place, $"expected red, green and blue for {Quotation.Of(parameter.Name)}, but found {parameter.Numbers.Count} numbers");
        }

        return Linear(thing, r, g, b);
    }

    private static Rgb Linear(PbrtThing thing, float r, float g, float b) =>
        s_toSrgb.TryGetValue(thing.State.ColorSpace, out Rgb[]? rows) ? new(Dot(rows[0], r, g, b), Dot(rows[1], r, g, b), Dot(rows[2], r, g, b)) : new(r, g, b);

    private static float Dot(Rgb row, float r, float g, float b) => (row.R * r) + (row.G * g) + (row.B * b);

    private static Rgb? BlackBody(PbrtThing thing, PbrtParameter parameter, bool isLight)
    {
        if (!isLight)
        {
            return thing.Log.Fail<Rgb?>(parameter.Place, $"{Quotation.Of(parameter.Name)} is not light: no black body has its colour");
        }

        return parameter.Numbers is [>= 1 and <= 1e6f and var temperature] ? Unit(Spectrum.BlackBody(temperature, CieTables.First, CieTables.Last))
            : thing.Log.Fail<Rgb?>(parameter.Place, $"expected one temperature in kelvins, at least 1, for {Quotation.Of(parameter.Name)}");
    }

    private static Rgb? OfSpectrum(PbrtThing thing, PbrtParameter parameter, bool isLight)
    {
        if (parameter.Words is [var word])
        {
            if (isLight && word is "stdillum-A" or "stdillum-D65")
            {
                return word == "stdillum-D65" ? Rgb.White : Unit(Spectrum.BlackBody(TemperatureOfA, CieTables.First, CieTables.Last));
            }

            return PbrtSpectra.IsKnown(word) ? Refused(thing, parameter, word)
                : SpectrumFile.Read(thing.PathOf(word), word, parameter.Place, thing.Log) is { } file ? Color(file, isLight) : null;
        }

        if (parameter.Words.Count > 0 || parameter.Numbers.Count % 2 != 0)
        {
            return thing.Log.Fail<Rgb?>(parameter.Place, $"expected wavelengths in nm, each with its number, or one name, for {Quotation.Of(parameter.Name)}");
        }

        float[] wavelengths = [.. parameter.Numbers.Where((_, i) => i % 2 == 0)];
        bool rises = wavelengths.Zip(wavelengths.Skip(1)).All(p => p.First < p.Second);
        return !rises ? thing.Log.Fail<Rgb?>(parameter.Place, "the wavelengths of a spectrum must rise")
            : Color(new(wavelengths, [.. parameter.Numbers.Where((_, i) => i % 2 == 1)]), isLight);
    }

    private static Rgb? Refused(PbrtThing thing, PbrtParameter parameter, string word)
    {
        thing.Log.Unsupported(parameter.Place, $"the spectrum {Quotation.Of(word)} is not read for {Quotation.Of(parameter.Name)}", "the default is used instead");
        return null;
    }

    private static Rgb Color(Spectrum spectrum, bool isLight) => isLight ? Unit(spectrum) : spectrum.Reflectance();

    private static Rgb Unit(Spectrum spectrum) => spectrum.Light() is var color && color.Luminance > 0 ? color * (1 / color.Luminance) : Rgb.Black;
}

/// <summary>The spectra that have names in pbrt.</summary>
internal static class PbrtSpectra
{
    /// <summary>The glasses of which the index by the wavelength is known here.</summary>
    public static readonly Dictionary<string, Materials.Glass> Glasses = new()
    {
        ["glass-BK7"] = Materials.Glass.Bk7,
        ["glass-LASF9"] = Materials.Glass.Lasf9,
        ["glass-SF10"] = Materials.Glass.Sf10,
        ["glass-F10"] = Materials.Glass.Sf10,
        ["glass-SF11"] = Materials.Glass.Sf11,
        ["glass-F11"] = Materials.Glass.Sf11,
    };

    /// <summary>The metals that are known here, by the part of the name between metal- and -eta or -k.</summary>
    public static readonly Dictionary<string, Materials.Metal> Metals = new()
    {
        ["Ag"] = Materials.Metal.Silver,
        ["Al"] = Materials.Metal.Aluminium,
        ["Au"] = Materials.Metal.Gold,
        ["Cu"] = Materials.Metal.Copper,
    };

    /// <summary>True for the names of pbrt's own spectra, which are no files.</summary>
    public static bool IsKnown(string name) => new[] { "glass-", "metal-", "stdillum-", "illum-", "canon_", "nikon_", "sony_" }.Any(p => name.StartsWith(p, StringComparison.Ordinal));
}
