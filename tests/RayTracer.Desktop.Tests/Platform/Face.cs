using Avalonia.Media;

namespace RayTracer.Desktop.Tests;

/// <summary>A font in which every character is half as wide as the font is high.</summary>
internal sealed class Face : IGlyphTypeface
{
    private const int Em = 10;
    private const int Advance = 5;

    public string FamilyName => "Stand-in";

    public FontWeight Weight => FontWeight.Normal;

    public FontStyle Style => FontStyle.Normal;

    public FontStretch Stretch => FontStretch.Normal;

    public int GlyphCount => ushort.MaxValue;

    public FontMetrics Metrics => new() { DesignEmHeight = Em, Ascent = -8, Descent = 2, UnderlinePosition = 1, UnderlineThickness = 1, StrikethroughPosition = 4, StrikethroughThickness = 1, IsFixedPitch = true };

    public FontSimulations FontSimulations => FontSimulations.None;

    public bool TryGetGlyphMetrics(ushort glyph, out GlyphMetrics metrics)
    {
        metrics = new() { Width = Advance, Height = Em };
        return true;
    }

    public ushort GetGlyph(uint codepoint) => (ushort)codepoint;

    public bool TryGetGlyph(uint codepoint, out ushort glyph)
    {
        glyph = (ushort)codepoint;
        return true;
    }

    public ushort[] GetGlyphs(ReadOnlySpan<uint> codepoints) => [.. codepoints.ToArray().Select(GetGlyph)];

    public int GetGlyphAdvance(ushort glyph) => Advance;

    public int[] GetGlyphAdvances(ReadOnlySpan<ushort> glyphs) => [.. Enumerable.Repeat(Advance, glyphs.Length)];

    public bool TryGetTable(uint tag, out byte[] table)
    {
        table = [];
        return false;
    }

    public void Dispose()
    {
    }
}
