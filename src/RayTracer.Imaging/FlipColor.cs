using RayTracer.Numerics;

namespace RayTracer.Imaging;

/// <summary>
/// The colour spaces of FLIP (Andersson et al. 2020, sections 4.1.1 and 4.1.3): opponent colours to blur in, and uniform ones to compare
/// in.
/// </summary>
internal readonly record struct FlipColor(double X, double Y, double Z)
{
    // Linear RGB of sRGB's primaries and white to XYZ, row by row; white is the sum of each row.
    private static readonly double[] s_toXyz =
    [
        10135552.0 / 24577794, 8788810.0 / 24577794, 4435075.0 / 24577794,
        2613072.0 / 12288897, 8788810.0 / 12288897, 887015.0 / 12288897,
        1425312.0 / 73733382, 8788810.0 / 73733382, 70074185.0 / 73733382,
    ];

    private static readonly double[] s_fromXyz = Inverse(s_toXyz);
    private static readonly FlipColor s_white = Multiply(s_toXyz, new(1, 1, 1));

    /// <summary>Opponent colours, linear in light: luminance (−16 to 100), red against green, blue against yellow.</summary>
    public static FlipColor Opponent(FlipColor linear)
    {
        FlipColor n = Relative(linear);
        return new((116 * n.Y) - 16, 500 * (n.X - n.Y), 200 * (n.Y - n.Z));
    }

    /// <summary>Linear RGB, cut off at 0 and 1, of opponent colours.</summary>
    public static FlipColor Linear(FlipColor opponent)
    {
        double y = (opponent.X + 16) / 116;
        FlipColor rgb = Multiply(s_fromXyz, new(((opponent.Y / 500) + y) * s_white.X, y * s_white.Y, (y - (opponent.Z / 200)) * s_white.Z));
        return new(Math.Clamp(rgb.X, 0, 1), Math.Clamp(rgb.Y, 0, 1), Math.Clamp(rgb.Z, 0, 1));
    }

    /// <summary>L*a*b* of linear RGB, with colours that fade as it gets dark (Hunt's effect).</summary>
    public static FlipColor Uniform(FlipColor linear)
    {
        FlipColor n = Relative(linear);
        (double x, double y, double z) = (Compress(n.X), Compress(n.Y), Compress(n.Z));
        double lightness = (116 * y) - 16;
        return new(lightness, 0.01 * lightness * 500 * (x - y), 0.01 * lightness * 200 * (y - z));
    }

    /// <summary>The HyAB distance of two uniform colours: lightness apart from the rest.</summary>
    public static double Distance(FlipColor a, FlipColor b)
    {
        (double u, double v) = (a.Y - b.Y, a.Z - b.Z);
        return Math.Abs(a.X - b.X) + Math.Sqrt((u * u) + (v * v));
    }

    // CIE 15: the cube root, and a line near black.
    private static double Compress(double t)
    {
        const double Delta = 6.0 / 29;
        return t > Delta * Delta * Delta ? PortableMath.Exp2(PortableMath.Log2(t) / 3) : (t / (3 * Delta * Delta)) + (4.0 / 29);
    }

    private static FlipColor Relative(FlipColor linear)
    {
        FlipColor xyz = Multiply(s_toXyz, linear);
        return new(xyz.X / s_white.X, xyz.Y / s_white.Y, xyz.Z / s_white.Z);
    }

    private static FlipColor Multiply(double[] m, FlipColor c) => new(
        (m[0] * c.X) + (m[1] * c.Y) + (m[2] * c.Z), (m[3] * c.X) + (m[4] * c.Y) + (m[5] * c.Z), (m[6] * c.X) + (m[7] * c.Y) + (m[8] * c.Z));

    // By cofactors.
    private static double[] Inverse(double[] m)
    {
        double Minor(int a, int b, int c, int d) => (m[a] * m[d]) - (m[b] * m[c]);
        double determinant = (m[0] * Minor(4, 5, 7, 8)) - (m[1] * Minor(3, 5, 6, 8)) + (m[2] * Minor(3, 4, 6, 7));
        double[] cofactors =
        [
            Minor(4, 5, 7, 8), -Minor(1, 2, 7, 8), Minor(1, 2, 4, 5),
            -Minor(3, 5, 6, 8), Minor(0, 2, 6, 8), -Minor(0, 2, 3, 5),
            Minor(3, 4, 6, 7), -Minor(0, 1, 6, 7), Minor(0, 1, 3, 4),
        ];
        return [.. cofactors.Select(c => c / determinant)];
    }
}
