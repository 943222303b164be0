namespace RayTracer.Numerics;

/// <summary>
/// The transfer function of sRGB (IEC 61966-2-1:1999): between linear light and the 8- or 16-bit codes of picture files.
/// Every value is the exact one, correctly rounded to a float or to the nearest code, on every machine.
/// </summary>
public static class SrgbCurve
{
    private static readonly Lazy<SrgbCodes> Codes8 = new(() => new SrgbCodes(255));
    private static readonly Lazy<SrgbCodes> Codes16 = new(() => new SrgbCodes(65535));

    /// <summary>Linear light of a display value; both are in [0, 1].</summary>
    public static double Decode(double encoded)
    {
        if (encoded <= 0.04045)
        {
            return encoded / 12.92;
        }

        double t = (encoded + 0.055) / 1.055;
        double root = PortableMath.FifthRoot(t);
        return t * t * root * root; // t^2.4
    }

    /// <summary>Linear light, 0 to 1, of an 8-bit code.</summary>
    public static float Decode8(byte code) => Codes8.Value.Linear[code];

    /// <summary>Linear light, 0 to 1, of a 16-bit code.</summary>
    public static float Decode16(ushort code) => Codes16.Value.Linear[code];

    /// <summary>The 8-bit code nearest to the display value of linear light; below 0 and NaN give 0, above 1 gives 255.</summary>
    public static byte Encode8(float linear) => (byte)Codes8.Value.Encode(linear);

    /// <summary>The 16-bit code nearest to the display value of linear light; below 0 and NaN give 0, above 1 gives 65535.</summary>
    public static ushort Encode16(float linear) => (ushort)Codes16.Value.Encode(linear);

    internal static SrgbCodes CodesOf(int bitDepth) => bitDepth == 8 ? Codes8.Value : Codes16.Value;
}
