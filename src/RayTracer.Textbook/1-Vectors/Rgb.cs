namespace RayTracer.Textbook;

/// <summary>A colour, a radiance, or the share of light that is left: linear red, green and blue.</summary>
/// <param name="R">Red.</param>
/// <param name="G">Green.</param>
/// <param name="B">Blue.</param>
public readonly record struct Rgb(double R, double G, double B)
{
    /// <summary>The same in all channels.</summary>
    /// <param name="all">Red, green and blue.</param>
    public Rgb(double all) : this(all, all, all)
    {
    }

    /// <summary>No light.</summary>
    public static Rgb Black => default;

    /// <summary>1 in all channels.</summary>
    public static Rgb White => new(1);

    /// <summary>True where all channels are 0.</summary>
    public bool IsBlack => R == 0 && G == 0 && B == 0;

    /// <summary>The largest channel.</summary>
    public double Largest => Math.Max(R, Math.Max(G, B));

    /// <summary>The brightness that an eye sees (Rec. 709 weights, ITU-R BT.709-6 item 3.2).</summary>
    public double Luminance => (0.2126 * R) + (0.7152 * G) + (0.0722 * B);

    /// <summary>The numbers of scene files are in single precision.</summary>
    public static implicit operator Rgb(Numerics.Rgb c) => new(c.R, c.G, c.B);

    /// <summary>Channel by channel.</summary>
    public static Rgb operator +(Rgb a, Rgb b) => new(a.R + b.R, a.G + b.G, a.B + b.B);

    /// <summary>Channel by channel.</summary>
    public static Rgb operator -(Rgb a, Rgb b) => new(a.R - b.R, a.G - b.G, a.B - b.B);

    /// <summary>Channel by channel.</summary>
    public static Rgb operator *(Rgb a, Rgb b) => new(a.R * b.R, a.G * b.G, a.B * b.B);

    /// <summary>Brighter or darker.</summary>
    public static Rgb operator *(Rgb a, double s) => new(a.R * s, a.G * s, a.B * s);

    /// <summary>e to the power of each channel times <paramref name="x"/>.</summary>
    public Rgb Exp(double x) => new(Math.Exp(R * x), Math.Exp(G * x), Math.Exp(B * x));
}
