using System.Runtime.CompilerServices;

namespace RayTracer.Numerics;

/// <summary>A colour in each lane: linear red, green and blue (Rec. 709 primaries).</summary>
public readonly struct RgbW
{
    /// <summary>The channels.</summary>
    public readonly FloatW R, G, B;

    /// <summary>From channels.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public RgbW(FloatW r, FloatW g, FloatW b)
    {
        R = r;
        G = g;
        B = b;
    }

    /// <summary>The same colour in every lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static implicit operator RgbW(Rgb c) => new(c.R, c.G, c.B);

    /// <summary>The three numbers from table[first] on, for indices in a register; the one behind them must be readable.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static unsafe RgbW Gather(float* table, UIntW first)
    {
        FloatW.Gather(table, first, out FloatW r, out FloatW g, out FloatW b);
        return new(r, g, b);
    }

    /// <summary>From <paramref name="a"/> where <paramref name="t"/> is 0 to <paramref name="b"/> where it is 1.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static RgbW Mix(in RgbW a, in RgbW b, FloatW t) => new(FloatW.Mix(a.R, b.R, t), FloatW.Mix(a.G, b.G, t), FloatW.Mix(a.B, b.B, t));

    /// <summary>Relative luminances, with the bits of <see cref="Rgb.Luminance"/>.</summary>
    public FloatW Luminance
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        get => FloatW.MultiplyAdd(B, 0.0722f, FloatW.MultiplyAdd(G, 0.7152f, R * 0.2126f));
    }

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static RgbW operator +(RgbW a, RgbW b) => new(a.R + b.R, a.G + b.G, a.B + b.B);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static RgbW operator *(RgbW a, RgbW b) => new(a.R * b.R, a.G * b.G, a.B * b.B);

    /// <summary>Lane by lane.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static RgbW operator *(RgbW a, FloatW s) => new(a.R * s, a.G * s, a.B * s);

    /// <summary>a·b + c, each channel with one rounding.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static RgbW MultiplyAdd(RgbW a, RgbW b, RgbW c) => new(
        FloatW.MultiplyAdd(a.R, b.R, c.R), FloatW.MultiplyAdd(a.G, b.G, c.G), FloatW.MultiplyAdd(a.B, b.B, c.B));

    /// <summary>a·s + c, each channel with one rounding.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static RgbW MultiplyAdd(RgbW a, FloatW s, RgbW c) => new(
        FloatW.MultiplyAdd(a.R, s, c.R), FloatW.MultiplyAdd(a.G, s, c.G), FloatW.MultiplyAdd(a.B, s, c.B));
}
