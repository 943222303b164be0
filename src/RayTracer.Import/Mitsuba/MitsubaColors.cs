using System.Globalization;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Scenes;
using RayTracer.Spectra;

namespace RayTracer.Import;

/// <summary>Reads colours: RGB, one number for all channels, and spectra, of which the colour is computed.</summary>
internal static class MitsubaColors
{
    private const int MostSamples = 100_000;

    // A spectral radiance of 1 at all wavelengths, which is a little red beside daylight.
    private static readonly Rgb s_equalEnergy = new Spectrum([CieTables.First, CieTables.Last], [1, 1]).Light();

    /// <summary>A property's colour.</summary>
    /// <param name="thing">The object that has the property.</param>
    /// <param name="name">The property.</param>
    /// <param name="standard">The colour where none is given, or a wrong one.</param>
    /// <param name="isLight">True where it is of light, and not of what reflects it.</param>
    /// <param name="maximum">The most that a channel may be.</param>
    public static Rgb Read(MitsubaObject thing, string name, Rgb standard, bool isLight = false, float maximum = float.PositiveInfinity)
    {
        if (thing.Child("spectrum", name) is { } plugin)
        {
            return Limited(Plugin(plugin, standard, isLight), maximum, name, plugin.Place, thing.Log);
        }

        if (thing.Property(name) is not { } property || Read(property, isLight, thing) is not { } color)
        {
            return standard;
        }

        if (property.Name == "spectrum")
        {
            return Limited(color, maximum, name, property.PlaceOf("value"), thing.Log);
        }

        float worst = float.Min(color.R, float.Min(color.G, color.B)) is < 0 and var least ? least : float.Max(color.R, float.Max(color.G, color.B));
        return thing.IsWithin(property, name, worst, 0, maximum) ? color : standard;
    }

    // The colour of a spectrum may lie beyond those of three primaries.
    private static Rgb Limited(Rgb color, float maximum, string name, SourcePlace place, ImportLog log)
    {
        Rgb limited = new(float.Clamp(color.R, 0, maximum), float.Clamp(color.G, 0, maximum), float.Clamp(color.B, 0, maximum));
        if (limited != color)
        {
            string range = float.IsInfinity(maximum) ? "at least 0" : $"from 0 to {maximum}";
            log.Warn(place, $"the spectrum of {Quotation.Of(name)} is a colour beyond the three primaries: its channels are brought into range, {range}");
        }

        return limited;
    }

    /// <summary>The colour of an element; null, after an error, where it is none.</summary>
    public static Rgb? Read(MitsubaElement property, bool isLight, MitsubaObject thing) => property.Name switch
    {
        "rgb" => Rgb(property, thing.Log),
        "float" or "integer" => MitsubaNumbers.Float(property, "value", thing.Log) is { } grey ? new(grey, grey, grey) : null,
        "spectrum" => Spectrum(property, isLight, thing),
        _ => thing.Log.Fail<Rgb?>(
            property.Place,
            $"expected a colour (<rgb>, <spectrum> or <float>) for {Quotation.Of(property.Attribute("name") ?? "")}, but found <{property.Name}>"),
    };

    /// <summary>The colour of a spectrum that is a separate object.</summary>
    public static Rgb Plugin(MitsubaObject plugin, Rgb standard, bool isLight)
    {
        Rgb? color = plugin.Type switch
        {
            "uniform" => (isLight ? s_equalEnergy : Numerics.Rgb.White) * plugin.Float("value", 1),
            "d65" => Read(plugin, "color", Numerics.Rgb.White) * plugin.Float("scale", 1),
            "rgb" => Read(plugin, "value", standard),
            "srgb" => Read(plugin, "color", standard),
            "blackbody" => Color(BlackBody(plugin), isLight),
            "regular" or "irregular" => Sampled(plugin) is { } sampled ? Color(sampled, isLight) : standard,
            _ => null,
        };
        if (color is null)
        {
            plugin.UnknownType("spectra", "uniform", "d65", "rgb", "srgb", "regular", "irregular", "blackbody");
            return standard;
        }

        plugin.Finish();
        return color.Value;
    }

    private static Spectrum BlackBody(MitsubaObject plugin) => Scenes.Spectrum.BlackBody(
        plugin.Float("temperature", 5000, 1), plugin.Float("wavelength_min", CieTables.First), plugin.Float("wavelength_max", CieTables.Last));

    private static Rgb? Rgb(MitsubaElement property, ImportLog log)
    {
        if (property.Attribute("value") is ['#', ..] hex)
        {
            if (CssColors.FromHex(hex) is not null && hex.Length == 7)
            {
                int number = int.Parse(hex.AsSpan(1), NumberStyles.HexNumber, CultureInfo.InvariantCulture);
                return new((number >> 16) / 255f, ((number >> 8) & 255) / 255f, (number & 255) / 255f);
            }

            return log.Fail<Rgb?>(property.PlaceOf("value"), $"{Quotation.Of(hex)} is not a colour: expected # and six hexadecimal digits");
        }

        return MitsubaNumbers.Floats(property, "value", log, 1, 3) is not { } v ? null
            : v.Length == 1 ? new(v[0], v[0], v[0]) : new(v[0], v[1], v[2]);
    }

    // One number, or wavelengths and numbers: 400:0.1, 500:0.2; or a file of them.
    private static Rgb? Spectrum(MitsubaElement property, bool isLight, MitsubaObject thing)
    {
        ImportLog log = thing.Log;
        if (property.Attributes.ContainsKey("filename"))
        {
            string name = property.Attribute("filename")!;
            return SpectrumFile.Read(thing.PathOf(name), name, property.PlaceOf("filename"), log) is { } file ? Color(file, isLight) : null;
        }

        string[] words = MitsubaNumbers.Words(property.Attribute("value") ?? "");
        if (words.Length == 1 && !words[0].Contains(':', StringComparison.Ordinal))
        {
            return MitsubaNumbers.Float(words[0], property.PlaceOf("value"), log) is not { } value ? null
                : isLight ? s_equalEnergy * value : new(value, value, value);
        }

        string[][] pairs = [.. words.Select(w => w.Split(':'))];
        if (pairs.Length == 0 || pairs.Any(p => p.Length != 2))
        {
            return log.Fail<Rgb?>(property.PlaceOf("value"), "expected one number, or wavelengths in nm with their numbers, as in 400:0.1, 700:0.5");
        }

        return Sampled([.. pairs.Select(p => p[0])], [.. pairs.Select(p => p[1])], property.PlaceOf("value"), log) is { } sampled ? Color(sampled, isLight) : null;
    }

    /// <summary>A spectrum of words; null, after an error, where they are none.</summary>
    public static Spectrum? Sampled(string[] wavelengths, string[] values, SourcePlace place, ImportLog log)
    {
        if (wavelengths.Length != values.Length || wavelengths.Length is 0 or > MostSamples)
        {
            return log.Fail<Spectrum>(place, $"expected as many wavelengths as numbers, at most {MostSamples}, but found {wavelengths.Length} and {values.Length}");
        }

        float?[] at = [.. wavelengths.Select(w => MitsubaNumbers.Float(w, place, log))];
        float?[] numbers = [.. values.Select(v => MitsubaNumbers.Float(v, place, log))];
        if (at.Contains(null) || numbers.Contains(null))
        {
            return null;
        }

        return at.Zip(at.Skip(1)).Any(p => !(p.First < p.Second)) ? log.Fail<Spectrum>(place, "the wavelengths of a spectrum must rise")
            : new([.. at.Select(v => v!.Value)], [.. numbers.Select(v => v!.Value)]);
    }

    private static Spectrum? Sampled(MitsubaObject plugin)
    {
        string[] values = MitsubaNumbers.Words(plugin.Text("values") ?? "");
        if (plugin.Type == "irregular")
        {
            return Sampled(MitsubaNumbers.Words(plugin.Text("wavelengths") ?? ""), values, plugin.PlaceOf("values"), plugin.Log);
        }

        (float first, float last) = (plugin.Float("wavelength_min", CieTables.First), plugin.Float("wavelength_max", CieTables.Last));
        float step = (last - first) / int.Max(values.Length - 1, 1);
        string[] wavelengths = [.. values.Select((_, i) => (first + (i * step)).ToString(CultureInfo.InvariantCulture))];
        return Sampled(wavelengths, values, plugin.PlaceOf("values"), plugin.Log);
    }

    private static Rgb Color(Spectrum spectrum, bool isLight) => isLight ? spectrum.Light() : spectrum.Reflectance();
}
