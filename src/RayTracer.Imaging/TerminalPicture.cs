using System.Globalization;
using System.Text;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>The ways in which a terminal can show pictures.</summary>
public enum TerminalGraphics
{
    /// <summary>Upper half blocks, whose two halves have separate 24-bit colours.</summary>
    Blocks,

    /// <summary>Letters of growing darkness, without colours.</summary>
    Letters,

    /// <summary>DEC's sixels, in 252 colours.</summary>
    Sixel,

    /// <summary>Pictures of the terminal kitty, as PNG.</summary>
    Kitty,
}

/// <summary>Pictures as the text that makes a terminal show them.</summary>
public static class TerminalPicture
{
    private const string Escape = "\e";
    private const string Darkness = " .:-=+*#%@";
    private const int KittyChunk = 4096;

    // Levels of red, green and blue of the palette for sixels: eyes distinguish more greens.
    private const int Reds = 6;
    private const int Greens = 7;
    private const int Blues = 6;

    /// <summary>Returns what the variables of an environment say about the terminal.</summary>
    /// <param name="variable">The value of a variable; null where there is none.</param>
    public static TerminalGraphics Of(Func<string, string?> variable)
    {
        string term = variable("TERM") ?? "";
        string program = variable("TERM_PROGRAM") ?? "";
        return !string.IsNullOrEmpty(variable("NO_COLOR")) || term == "dumb" ? TerminalGraphics.Letters
            : term.Contains("kitty", StringComparison.Ordinal) || variable("KITTY_WINDOW_ID") is not null || program is "ghostty" ? TerminalGraphics.Kitty
            : term.Contains("sixel", StringComparison.Ordinal) || term is "mlterm" or "foot" or "foot-extra" ? TerminalGraphics.Sixel
            : TerminalGraphics.Blocks;
    }

    /// <summary>The text.</summary>
    /// <param name="image">Colours as they are to be seen, 0 to 1 in linear light.</param>
    /// <param name="columns">The most columns of the terminal to take; images are made smaller, but not larger.</param>
    /// <param name="graphics">The kind of graphics of the terminal.</param>
    public static string Draw(IImageRows image, int columns, TerminalGraphics graphics) => graphics switch
    {
        TerminalGraphics.Blocks => Blocks(Fit(image, columns, 1)),
        TerminalGraphics.Letters => Letters(Fit(image, columns, 0.5)),
        TerminalGraphics.Sixel => Sixels(Fit(image, 8 * columns, 1)),
        _ => Kitty(Fit(image, 8 * columns, 1)),
    };

    private static Picture Fit(IImageRows image, int columns, double aspect)
    {
        int width = Math.Min(columns, image.Width);
        double height = (double)image.Height * width / image.Width * aspect;
        return ScaledRows.Shrink(image, width, Math.Clamp((int)Math.Round(height), 1, image.Height));
    }

    private static byte Code(Picture picture, int x, int y, int channel) =>
        SrgbCurve.Encode8(picture.Pixels[(3 * ((y * picture.Width) + x)) + channel]);

    private static string Color(Picture picture, int x, int y) =>
        $"{Code(picture, x, y, 0)};{Code(picture, x, y, 1)};{Code(picture, x, y, 2)}";

    private static string Blocks(Picture picture)
    {
        StringBuilder text = new();
        for (int y = 0; y < picture.Height; y += 2)
        {
            for (int x = 0; x < picture.Width; x++)
            {
                string below = y + 1 < picture.Height ? $";48;2;{Color(picture, x, y + 1)}" : "";
                text.Append(CultureInfo.InvariantCulture, $"{Escape}[38;2;{Color(picture, x, y)}{below}m▀");
            }

            text.Append(CultureInfo.InvariantCulture, $"{Escape}[0m\n");
        }

        return text.ToString();
    }

    private static string Letters(Picture picture)
    {
        StringBuilder text = new();
        for (int y = 0; y < picture.Height; y++)
        {
            for (int x = 0; x < picture.Width; x++)
            {
                double luma = ((0.2126 * Code(picture, x, y, 0)) + (0.7152 * Code(picture, x, y, 1)) + (0.0722 * Code(picture, x, y, 2))) / 255;
                text.Append(Darkness[(int)Math.Round(luma * (Darkness.Length - 1))]);
            }

            text.Append('\n');
        }

        return text.ToString();
    }

    // The file in base 64, in pieces that say whether more follow.
    private static string Kitty(Picture picture)
    {
        string data = Convert.ToBase64String(ImageFile.Encode(".png", picture, new()));
        StringBuilder text = new();
        for (int at = 0; at < data.Length; at += KittyChunk)
        {
            bool isLast = at + KittyChunk >= data.Length;
            string head = at == 0 ? "a=T,f=100," : "";
            text.Append(CultureInfo.InvariantCulture, $"{Escape}_G{head}m={(isLast ? 0 : 1)};{data.AsSpan(at, isLast ? data.Length - at : KittyChunk)}{Escape}\\");
        }

        return text.Append('\n').ToString();
    }

    // Rows of six pixels; in each, colour by colour, which of the six have it, run by run.
    private static string Sixels(Picture picture)
    {
        int[] colors = Dithered(picture);
        StringBuilder text = new($"{Escape}P0;1q\"1;1;{picture.Width};{picture.Height}");
        for (int i = 0; i < Reds * Greens * Blues; i++)
        {
            (int r, int g, int b) = (i / (Greens * Blues), i / Blues % Greens, i % Blues);
            text.Append(CultureInfo.InvariantCulture, $"#{i};2;{100 * r / (Reds - 1)};{100 * g / (Greens - 1)};{100 * b / (Blues - 1)}");
        }

        for (int top = 0; top < picture.Height; top += 6)
        {
            int rows = Math.Min(6, picture.Height - top);
            foreach (int color in colors.AsSpan(top * picture.Width, rows * picture.Width).ToArray().Distinct().Order())
            {
                text.Append(CultureInfo.InvariantCulture, $"#{color}");
                AddSixels(text, colors, picture.Width, top, rows, color);
                text.Append('$');
            }

            text.Append('-');
        }

        return text.Append(CultureInfo.InvariantCulture, $"{Escape}\\\n").ToString();
    }

    private static void AddSixels(StringBuilder text, int[] colors, int width, int top, int rows, int color)
    {
        (int last, int run) = (-1, 0);
        for (int x = 0; x <= width; x++)
        {
            int bits = x == width ? -1 : 0;
            for (int row = 0; row < rows && x < width; row++)
            {
                bits |= colors[((top + row) * width) + x] == color ? 1 << row : 0;
            }

            if (bits != last && run > 0)
            {
                char sixel = (char)(63 + last);
                text.Append(run > 3 ? $"!{run}{sixel}" : new string(sixel, run));
                run = 0;
            }

            (last, run) = (bits, run + 1);
        }
    }

    // Nearest colours of the palette; the error is passed to the pixels around (Floyd & Steinberg 1976).
    private static int[] Dithered(Picture picture)
    {
        int[] levels = [Reds, Greens, Blues];
        int[] colors = new int[picture.Width * picture.Height];
        for (int channel = 0; channel < 3; channel++)
        {
            float[] rest = [.. Enumerable.Range(0, colors.Length).Select(i => Code(picture, i % picture.Width, i / picture.Width, channel) * (levels[channel] - 1) / 255f)];
            for (int i = 0; i < colors.Length; i++)
            {
                int level = Math.Clamp((int)Math.Round(rest[i]), 0, levels[channel] - 1);
                float off = rest[i] - level;
                int x = i % picture.Width;
                Spread(rest, i + 1, off * 7 / 16, x + 1 < picture.Width);
                Spread(rest, i + picture.Width - 1, off * 3 / 16, x > 0);
                Spread(rest, i + picture.Width, off * 5 / 16, true);
                Spread(rest, i + picture.Width + 1, off / 16, x + 1 < picture.Width);
                colors[i] = (colors[i] * levels[channel]) + level;
            }
        }

        return colors;
    }

    private static void Spread(float[] rest, int at, float off, bool isInside)
    {
        if (isInside && at < rest.Length)
        {
            rest[at] += off;
        }
    }
}
