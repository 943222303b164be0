namespace RayTracer.Numerics;

/// <summary>A colour or radiance: linear red, green and blue (Rec. 709 primaries, as in sRGB without its curve).</summary>
/// <param name="R">Red.</param>
/// <param name="G">Green.</param>
/// <param name="B">Blue.</param>
public readonly record struct Rgb(float R, float G, float B)
{
    /// <summary>No light.</summary>
    public static Rgb Black => default;

    /// <summary>1 in each channel.</summary>
    public static Rgb White => new(1, 1, 1);

    /// <summary>True where every channel is zero.</summary>
    public bool IsBlack => R == 0 && G == 0 && B == 0;

    /// <summary>Relative luminance Y (Rec. 709 weights, ITU-R BT.709-6 item 3.2).</summary>
    public float Luminance => float.FusedMultiplyAdd(0.0722f, B, float.FusedMultiplyAdd(0.7152f, G, 0.2126f * R));

    /// <summary>The colour of a text: programs write <c>Background = "skyblue"</c> or <c>"#87ceeb"</c>, as scene files do.</summary>
    /// <param name="color">A name of CSS, or # and three or six hexadecimal digits.</param>
    /// <exception cref="FormatException">It is neither.</exception>
    // Not of a string, to which null is converted: `isLit ? color : null` would be one.
    public static implicit operator Rgb(ReadOnlySpan<char> color) => Description.CssColors.Parse(color.ToString());

    /// <summary>Channel by channel.</summary>
    public static Rgb operator +(Rgb a, Rgb b) => new(a.R + b.R, a.G + b.G, a.B + b.B);

    /// <summary>Channel by channel.</summary>
    public static Rgb operator *(Rgb a, Rgb b) => new(a.R * b.R, a.G * b.G, a.B * b.B);

    /// <summary>Every channel scaled.</summary>
    public static Rgb operator *(Rgb a, float s) => new(a.R * s, a.G * s, a.B * s);
}
