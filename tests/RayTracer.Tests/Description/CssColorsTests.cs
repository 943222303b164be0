using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Tests.Description;

public class CssColorsTests
{
    [Fact]
    public void All_148_names_have_the_colors_that_the_framework_knows_too()
    {
        Assert.Equal(148, CssColors.Names.Count);
        foreach (string name in CssColors.Names.Where(n => !n.Contains("grey", StringComparison.Ordinal)))
        {
            System.Drawing.Color expected = System.Drawing.Color.FromName(name);
            Assert.True(expected.IsKnownColor, name);
            Assert.Equal(CssColors.FromHex($"#{expected.R:x2}{expected.G:x2}{expected.B:x2}"), CssColors.Find(name));
        }
    }

    [Fact]
    public void Both_spellings_of_grey_are_the_same()
    {
        string[] greys = [.. CssColors.Names.Where(n => n.Contains("grey", StringComparison.Ordinal))];
        Assert.Equal(7, greys.Length);
        Assert.All(greys, n => Assert.Equal(CssColors.Find(n.Replace("grey", "gray", StringComparison.Ordinal)), CssColors.Find(n)));
    }

    [Fact]
    public void Every_code_is_decoded_by_the_sRGB_curve_rounded_to_a_float()
    {
        for (int code = 0; code < 256; code++)
        {
            double display = code / 255.0;
            double expected = display <= 0.04045 ? display / 12.92 : Math.Pow((display + 0.055) / 1.055, 2.4);
            Assert.Equal((float)expected, CssColors.FromHex($"#{code:X2}0000")!.Value.R);
        }
    }

    [Fact]
    public void Three_digits_are_doubled() => Assert.Equal(CssColors.FromHex("#aabbcc"), CssColors.FromHex("#aBc"));

    [Theory]
    [InlineData("#")]
    [InlineData("#12345")]
    [InlineData("#1234567")]
    [InlineData("#12345g")]
    [InlineData("123456")]
    public void Other_forms_are_no_colors(string text) => Assert.Null(CssColors.FromHex(text));

    [Fact]
    public void Programs_write_colours_and_textures_as_scene_files_do()
    {
        SceneDescription scene = new() { Background = "skyblue" };
        DiffuseMaterialDescription[] materials = [new() { Color = "red" }, new() { Color = "#f00" }, new() { Color = new Rgb(1, 0, 0) }];
        Assert.Equal(CssColors.FromHex("#87ceeb"), scene.Background);
        Assert.All(materials, m => Assert.Equal(new(1, 0, 0), Assert.IsType<SolidTextureDescription>(m.Color).Color));
    }

    [Theory]
    [InlineData("rde", "unknown colour \"rde\" (did you mean \"red\"?)")]
    [InlineData("#12345", "\"#12345\" is not a colour: expected # and three or six hexadecimal digits")]
    public void A_text_that_is_no_colour_is_refused(string text, string message) =>
        Assert.Equal(message, Assert.Throws<FormatException>(() => (TextureDescription)text).Message);

    [Fact]
    public void White_is_one_and_black_is_zero()
    {
        Assert.Equal(Rgb.White, CssColors.Find("white"));
        Assert.Equal(Rgb.Black, CssColors.Find("black"));
        Assert.Null(CssColors.Find("White"));
    }
}
