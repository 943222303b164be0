using System.Text;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

public sealed class TerminalPictureTests
{
    [Theory]
    [InlineData("TERM=xterm-256color", TerminalGraphics.Blocks)]
    [InlineData("", TerminalGraphics.Blocks)]
    [InlineData("TERM=dumb", TerminalGraphics.Letters)]
    [InlineData("TERM=xterm-kitty", TerminalGraphics.Kitty)]
    [InlineData("TERM=xterm-kitty NO_COLOR=1", TerminalGraphics.Letters)]
    [InlineData("TERM=xterm KITTY_WINDOW_ID=3", TerminalGraphics.Kitty)]
    [InlineData("TERM=foot", TerminalGraphics.Sixel)]
    [InlineData("TERM=xterm-sixel", TerminalGraphics.Sixel)]
    public void Variables_say_what_a_terminal_can_show(string variables, TerminalGraphics expected)
    {
        Dictionary<string, string> values = variables.Split(' ', StringSplitOptions.RemoveEmptyEntries).Select(v => v.Split('=')).ToDictionary(v => v[0], v => v[1]);
        Assert.Equal(expected, TerminalPicture.Of(name => values.GetValueOrDefault(name)));
    }

    [Fact]
    public void Sixels_are_the_colours_of_the_picture()
    {
        // Colours of the palette itself: nothing is left to spread.
        Picture picture = new(5, 8);
        for (int i = 0; i < 40; i++)
        {
            (picture.Pixels[3 * i], picture.Pixels[(3 * i) + 1], picture.Pixels[(3 * i) + 2]) = (i % 2, i / 5 % 2, i % 3 / 2);
        }

        Assert.Equal(picture.Pixels.Select(v => (int)v), Sixels(TerminalPicture.Draw(picture, 80, TerminalGraphics.Sixel), 5, 8));
    }

    [Fact]
    public void Dithered_greys_keep_their_mean()
    {
        Picture picture = new(64, 60, [.. Enumerable.Repeat((float)SrgbCurve.Decode(0.37), 3 * 64 * 60)]);
        string text = TerminalPicture.Draw(picture, 80, TerminalGraphics.Sixel);
        Assert.Equal(0.37, Sixels(text, 64, 60, percent: true).Average() / 100, 0.01);
    }

    [Fact]
    public void Kitty_gets_a_png_in_pieces()
    {
        Picture noise = TestPictures.Noise(60, 50);
        string[] pieces = TerminalPicture.Draw(noise, 80, TerminalGraphics.Kitty).TrimEnd('\n').Split("\e\\", StringSplitOptions.RemoveEmptyEntries);
        Assert.StartsWith("\e_Ga=T,f=100,m=1;", pieces[0], StringComparison.Ordinal);
        Assert.All(pieces, (piece, i) => Assert.Contains(i < pieces.Length - 1 ? "m=1;" : "m=0;", piece, StringComparison.Ordinal));
        Assert.All(pieces, piece => Assert.True(piece.Length <= 4096 + 20));
        byte[] png = Convert.FromBase64String(string.Concat(pieces.Select(p => p[(p.IndexOf(';', StringComparison.Ordinal) + 1)..])));
        Assert.Equal((60, 50), (ImageFile.Decode(png).Width, ImageFile.Decode(png).Height));
    }

    [Fact]
    public void Pictures_that_are_too_wide_are_made_smaller_in_linear_light()
    {
        Picture stripes = new(8, 4, [.. Enumerable.Range(0, 96).Select(i => (float)(i / 3 % 2))]);
        Picture small = ScaledRows.Shrink(stripes, 4, 2);
        Assert.All(small.Pixels, p => Assert.Equal(0.5f, p));
        Assert.Contains("38;2;188;188;188", TerminalPicture.Draw(stripes, 4, TerminalGraphics.Blocks), StringComparison.Ordinal);
    }

    // A small reader of sixels: whole levels of red, green and blue (0 or 1 of 100 percent), or percents.
    private static int[] Sixels(string text, int width, int height, bool percent = false)
    {
        int[] pixels = new int[3 * width * height];
        Dictionary<int, int[]> palette = [];
        (int x, int top, int color) = (0, 0, 0);
        int at = text.IndexOf('q', StringComparison.Ordinal) + 1;
        List<int> Numbers()
        {
            StringBuilder digits = new();
            for (; at < text.Length && (char.IsAsciiDigit(text[at]) || text[at] == ';'); at++)
            {
                digits.Append(text[at]);
            }

            return [.. digits.ToString().Split(';').Select(int.Parse)];
        }

        while (text[at] != '\e')
        {
            char c = text[at++];
            switch (c)
            {
                case '"':
                    Assert.Equal([1, 1, width, height], Numbers());
                    break;
                case '#':
                    List<int> numbers = Numbers();
                    color = numbers[0];
                    if (numbers.Count > 1)
                    {
                        palette[color] = [.. numbers[2..].Select(n => percent ? n : n / 100)];
                    }

                    break;
                case '$':
                    x = 0;
                    break;
                case '-':
                    (x, top) = (0, top + 6);
                    break;
                default:
                    int count = c == '!' ? Numbers()[0] : 1;
                    int bits = (c == '!' ? text[at++] : c) - 63;
                    for (; count > 0; count--, x++)
                    {
                        for (int row = 0; row < 6; row++)
                        {
                            if ((bits >> row & 1) != 0)
                            {
                                palette[color].CopyTo(pixels, 3 * (((top + row) * width) + x));
                            }
                        }
                    }

                    break;
            }
        }

        return pixels;
    }
}
