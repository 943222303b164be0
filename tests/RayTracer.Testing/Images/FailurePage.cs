using System.Globalization;
using System.Net;
using System.Text;

namespace RayTracer.Testing;

/// <summary>The page that says what is what in a failure's folder.</summary>
internal static class FailurePage
{
    // Small images are enlarged to about this width, in pixels.
    private const int ShownWidth = 480;

    public static string Html(ImageFailure failure, string replay, IReadOnlyList<(string File, string What)> pictures)
    {
        StringBuilder page = new();
        page.Append(CultureInfo.InvariantCulture, $"""
            <!DOCTYPE html>
            <html lang="en"><head><meta charset="utf-8"><title>{Text(failure.Name)}</title>
            <style>body {"{"} font: 15px sans-serif; margin: 2em; {"}"} img {"{"} width: {Width(failure.Image.Width)}px; image-rendering: pixelated; {"}"} figure {"{"} display: inline-block; vertical-align: top; margin: 0 1em 1em 0; max-width: {Width(failure.Image.Width)}px; {"}"}</style></head><body>
            <h1>{Text(failure.Name)}</h1>
            <p>{Text(failure.Finding)}</p>
            <p>Worst pixel: {failure.X},{failure.Y} (column, row, from the top left): image {Value(failure.Image)}, reference {Value(failure.Reference)}.</p>

            """);
        if (replay.Length > 0)
        {
            page.Append(CultureInfo.InvariantCulture, $"<pre>{Text(replay)}</pre>\n");
        }

        foreach ((string file, string what) in pictures.Where(p => p.File.EndsWith(".png", StringComparison.Ordinal)))
        {
            string legend = file == "pvalues.png" ? Legend() : "";
            page.Append(CultureInfo.InvariantCulture, $"<figure><img src=\"{file}\" alt=\"{Text(what)}\"><figcaption>{Text(what)}{legend}</figcaption></figure>\n");
        }

        IEnumerable<string> rest = pictures.Where(p => !p.File.EndsWith(".png", StringComparison.Ordinal)).Select(p => $"<a href=\"{p.File}\">{p.File}</a>: {Text(p.What)}");
        page.Append(CultureInfo.InvariantCulture, $"<p>The same as numbers: {string.Join("; ", rest)}.</p>\n</body></html>\n");
        return page.ToString();

        string Value(RayTracer.Textures.Picture? picture)
        {
            int i = 3 * ((failure.Y * failure.Image.Width) + failure.X);
            return picture is not null && i + 2 < picture.Pixels.Length
                ? string.Join(' ', picture.Pixels.Skip(i).Take(3).Select(v => v.ToString(CultureInfo.InvariantCulture)))
                : "(none)";
        }
    }

    private static int Width(int pixels) => pixels * Math.Max(1, ShownWidth / pixels);

    // A strip of the colours, each with its p-value below.
    private static string Legend()
    {
        double end = PValueMap.Scale[^1].MinusLog;
        string colours = string.Join(", ", PValueMap.Scale.Select(s => string.Create(CultureInfo.InvariantCulture, $"rgb({s.R} {s.G} {s.B}) {100 * s.MinusLog / end:F1}%")));
        string numbers = string.Join("", PValueMap.Scale.Select(s => string.Create(CultureInfo.InvariantCulture, $"<span style=\"position:absolute;left:{92 * s.MinusLog / end:F1}%\">10<sup>−{s.MinusLog}</sup></span>")));
        return $"<div style=\"height:14px;margin-top:6px;background:linear-gradient(to right, {colours})\"></div><div style=\"position:relative;height:2em\">{numbers}</div>";
    }

    private static string Text(string text) => WebUtility.HtmlEncode(text);
}
