using Avalonia;
using Avalonia.Data.Converters;
using Avalonia.Media;
using Avalonia.Media.Imaging;
using RayTracer.Desktop.ViewModels;

namespace RayTracer.Desktop.Controls;

/// <summary>Makes what Avalonia shows of what view models have.</summary>
internal static class Converters
{
    /// <summary>Lines as SVG writes them.</summary>
    public static IValueConverter Geometry { get; } =
        new FuncValueConverter<string?, Geometry?>(path => string.IsNullOrEmpty(path) ? null : Avalonia.Media.Geometry.Parse(path));

    /// <summary>A colour as #rrggbb.</summary>
    public static IValueConverter Brush { get; } =
        new FuncValueConverter<string?, IBrush?>(hex => string.IsNullOrEmpty(hex) ? null : SolidColorBrush.Parse(hex));

    /// <summary>A PNG file.</summary>
    public static IValueConverter Bitmap { get; } =
        new FuncValueConverter<byte[]?, IImage?>(png => png is null ? null : new Bitmap(new MemoryStream(png)));

    /// <summary>Points of a line.</summary>
    public static IValueConverter Points { get; } =
        new FuncValueConverter<IReadOnlyList<Spot>?, IList<Point>>(spots => [.. (spots ?? []).Select(s => new Point(s.X, s.Y))]);

    /// <summary>The indentation of a line.</summary>
    public static IValueConverter Indent { get; } = new FuncValueConverter<double, Thickness>(indent => new(indent, 0, 0, 0));

}
