using System.Globalization;
using RayTracer.Numerics;

namespace RayTracer.Desktop.ViewModels;

/// <summary>Numbers as people read them; as the Studio's pages write them.</summary>
internal static class Figures
{
    /// <summary>A number with at most so many significant digits.</summary>
    public static string Short(double value, int digits = 6) => double.IsFinite(value)
        ? value.ToString($"G{digits}", CultureInfo.InvariantCulture).Replace('-', '−')
        : double.IsNaN(value) ? "–" : value > 0 ? "∞" : "−∞";

    /// <summary>Returns a number as a person typed it: a decimal comma or a real minus sign is fine; null where it is none.</summary>
    public static double? Parse(string? text) =>
        double.TryParse((text ?? "").Trim().Replace('−', '-').Replace(',', '.'), NumberStyles.Float, CultureInfo.InvariantCulture, out double value) && double.IsFinite(value) ? value : null;

    /// <summary>A large number with a prefix, ready for its unit: "31.4 M".</summary>
    public static string WithPrefix(double value)
    {
        (double factor, string prefix) = Math.Abs(value) switch { >= 1e9 => (1e9, "G"), >= 1e6 => (1e6, "M"), >= 1e3 => (1e3, "k"), _ => (1, "") };
        return $"{Short(value / factor, 3)} {prefix}";
    }

    /// <summary>Seconds as a person says them: 4.2 s, 3:07, 1:02:05.</summary>
    public static string Duration(double seconds)
    {
        TimeSpan whole = TimeSpan.FromSeconds(Math.Round(seconds));
        return seconds < 10 ? $"{seconds.ToString("F1", CultureInfo.InvariantCulture)} s"
            : seconds < 59.5 ? $"{whole.Seconds} s"
            : whole.TotalHours < 1 ? $"{whole.Minutes}:{whole.Seconds:00}"
            : $"{(int)whole.TotalHours}:{whole.Minutes:00}:{whole.Seconds:00}";
    }

    /// <summary>A radiance or weight: one number where the channels agree.</summary>
    public static string Color(Rgb color, int digits = 3) => Color([color.R, color.G, color.B], digits);

    /// <summary>A radiance or weight: one number where the channels agree.</summary>
    public static string Color(IReadOnlyList<double> color, int digits = 3)
    {
        string[] shown = [.. color.Select(c => Short(c, digits))];
        return shown.Distinct().Count() == 1 ? shown[0] : string.Join(' ', shown);
    }

    /// <summary>"samplesPerPixel" as people read it: "samples per pixel".</summary>
    public static string Spaced(string key) => string.Concat(key.Select((c, i) => char.IsUpper(c) && i > 0 && !char.IsUpper(key[i - 1]) ? $" {char.ToLowerInvariant(c)}" : $"{c}"));
}
