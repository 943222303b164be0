using System.Globalization;
using Avalonia.Media;
using Avalonia.Media.TextFormatting;
using Avalonia.Platform;

namespace RayTracer.Desktop.Tests;

/// <summary>The stand-in's only font, and its characters one after another.</summary>
internal sealed class Fonts : IFontManagerImpl, ITextShaperImpl
{
    private static readonly Face Only = new();

    public string GetDefaultFontFamilyName() => Only.FamilyName;

    public string[] GetInstalledFontFamilyNames(bool checkForUpdates = false) => [Only.FamilyName];

    public bool TryMatchCharacter(int codepoint, FontStyle fontStyle, FontWeight fontWeight, FontStretch fontStretch, CultureInfo? culture, out Typeface typeface)
    {
        typeface = new(Only.FamilyName);
        return true;
    }

    public bool TryCreateGlyphTypeface(string familyName, FontStyle style, FontWeight weight, FontStretch stretch, out IGlyphTypeface glyphTypeface)
    {
        glyphTypeface = Only;
        return true;
    }

    public bool TryCreateGlyphTypeface(Stream stream, out IGlyphTypeface glyphTypeface)
    {
        glyphTypeface = Only;
        return true;
    }

    public ShapedBuffer ShapeText(ReadOnlyMemory<char> text, TextShaperOptions options)
    {
        ShapedBuffer buffer = new(text, text.Length, options.Typeface, options.FontRenderingEmSize, options.BidiLevel);
        for (int i = 0; i < text.Length; i++)
        {
            buffer[i] = new GlyphInfo(text.Span[i], i, options.FontRenderingEmSize / 2);
        }

        return buffer;
    }
}
