using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Imaging;

/// <summary>Linear light as the bytes that a screen takes: exactly those of a PNG of 8 bits a channel.</summary>
internal static class DisplayPixels
{
    /// <summary>Converts pixels.</summary>
    /// <param name="linear">Red, green and blue of each pixel.</param>
    /// <param name="map">The tone map, applied after the exposure.</param>
    /// <param name="factor">The factor on light (<see cref="Factor"/>).</param>
    /// <param name="rgba">Takes red, green, blue and 255 of each pixel.</param>
    public static void Write(ReadOnlySpan<float> linear, ToneMap map, float factor, Span<byte> rgba)
    {
        SrgbCodes codes = SrgbCurve.CodesOf(8);
        for (int i = 0, o = 0; i < linear.Length; i += 3, o += 4)
        {
            Rgb seen = ToneMapping.Apply(map, new Rgb(linear[i], linear[i + 1], linear[i + 2]) * factor);
            rgba[o] = (byte)codes.Encode(seen.R);
            rgba[o + 1] = (byte)codes.Encode(seen.G);
            rgba[o + 2] = (byte)codes.Encode(seen.B);
            rgba[o + 3] = 255;
        }
    }

    /// <summary>The factor by which an exposure multiplies light.</summary>
    /// <param name="exposureStops">The exposure in stops; each doubles the light.</param>
    public static float Factor(float exposureStops) => (float)PortableMath.Exp2(exposureStops);
}
