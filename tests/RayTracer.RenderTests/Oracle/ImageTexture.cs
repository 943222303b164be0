namespace RayTracer.RenderTests.Oracle;

/// <summary>A picture. Column i of n has its middle at u = (i + ½)/n; rows are counted from the bottom.</summary>
/// <param name="texels">The picture's rows, the top one first.</param>
/// <param name="interpolation">"nearest", "bilinear" or "bicubic".</param>
/// <param name="wrapping">"repeat", "clamp" or "mirror".</param>
/// <param name="scale">Factors on u and v.</param>
/// <param name="offset">Added to u and v after scaling.</param>
internal sealed class ImageTexture(Vec[][] texels, string interpolation, string wrapping, (double U, double V) scale, (double U, double V) offset)
    : Texture
{
    // A sum of texels, each weighted by a kernel of its distance in columns and in rows.
    public override Vec Value(Shape shape, Vec point)
    {
        (double U, double V) uv = shape.Uv(point);
        int width = texels[0].Length;
        int height = texels.Length;
        double x = (((uv.U * scale.U) + offset.U) * width) - 0.5;
        double y = (((uv.V * scale.V) + offset.V) * height) - 0.5;
        Vec sum = default;
        for (int row = (int)Math.Floor(y) - 1; row <= Math.Floor(y) + 2; row++)
        {
            for (int column = (int)Math.Floor(x) - 1; column <= Math.Floor(x) + 2; column++)
            {
                double weight = Kernel(x - column) * Kernel(y - row);
                sum += weight == 0 ? default : weight * texels[height - 1 - Wrap(row, height)][Wrap(column, width)];
            }
        }

        return new(Math.Max(0, sum.X), Math.Max(0, sum.Y), Math.Max(0, sum.Z));
    }

    private double Kernel(double distance)
    {
        double d = Math.Abs(distance);
        return interpolation switch
        {
            "nearest" => distance is >= -0.5 and < 0.5 ? 1 : 0,
            "bilinear" => Math.Max(0, 1 - d),

            // Catmull–Rom.
            "bicubic" => d < 1 ? 1 - (2.5 * d * d) + (1.5 * d * d * d) : d < 2 ? 2 - (4 * d) + (2.5 * d * d) - (0.5 * d * d * d) : 0,
            _ => throw new FormatException(interpolation),
        };
    }

    private int Wrap(int i, int n)
    {
        switch (wrapping)
        {
            case "repeat":
                return ((i % n) + n) % n;
            case "clamp":
                return Math.Clamp(i, 0, n - 1);
            case "mirror":
                int inPair = ((i % (2 * n)) + (2 * n)) % (2 * n);
                return inPair < n ? inPair : (2 * n) - 1 - inPair;
            default:
                throw new FormatException(wrapping);
        }
    }
}
