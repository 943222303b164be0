namespace RayTracer.Imaging;

/// <summary>
/// Steps of coefficients (ITU-T T.81, annex K.1) for a quality from 1 to 100, scaled as libjpeg scales them, so that a number means what it
/// means elsewhere.
/// </summary>
internal static class JpegQuantization
{
    private static readonly byte[] s_luminance =
    [
        16, 11, 10, 16, 24, 40, 51, 61, 12, 12, 14, 19, 26, 58, 60, 55, 14, 13, 16, 24, 40, 57, 69, 56, 14, 17, 22, 29, 51, 87, 80, 62,
        18, 22, 37, 56, 68, 109, 103, 77, 24, 35, 55, 64, 81, 104, 113, 92, 49, 64, 78, 87, 103, 121, 120, 101, 72, 92, 95, 98, 112, 100, 103, 99,
    ];

    private static readonly byte[] s_chrominance =
    [
        17, 18, 24, 47, 99, 99, 99, 99, 18, 21, 26, 66, 99, 99, 99, 99, 24, 26, 56, 99, 99, 99, 99, 99, 47, 66, 99, 99, 99, 99, 99, 99,
        99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99, 99,
    ];

    /// <summary>The steps, row by row, from 1 to 255.</summary>
    /// <param name="quality">1 to 100.</param>
    /// <param name="isLuminance">Whether of luminance, not of differences of colour.</param>
    public static byte[] Steps(int quality, bool isLuminance)
    {
        int percent = quality < 50 ? 5000 / quality : 200 - (2 * quality);
        return [.. (isLuminance ? s_luminance : s_chrominance).Select(step => (byte)Math.Clamp(((step * percent) + 50) / 100, 1, 255))];
    }
}
