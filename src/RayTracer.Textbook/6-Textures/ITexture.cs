using RayTracer.Textures;

namespace RayTracer.Textbook;

/// <summary>A colour that may vary over a surface.</summary>
public interface ITexture
{
    /// <summary>The colour at a place.</summary>
    /// <param name="u">Along the texture.</param>
    /// <param name="v">Upwards.</param>
    Rgb At(double u, double v);
}

/// <summary>The same colour everywhere.</summary>
/// <param name="color">The colour.</param>
public sealed class Solid(Rgb color) : ITexture
{
    /// <inheritdoc/>
    public Rgb At(double u, double v) => color;
}

/// <summary>A chessboard of two textures, with fields that are 1 wide.</summary>
/// <param name="even">Of the field at the origin.</param>
/// <param name="odd">Of the fields beside it.</param>
/// <param name="scale">Factors on u and v.</param>
/// <param name="offset">Added to them after that.</param>
public sealed class Checker(ITexture even, ITexture odd, (double U, double V) scale, (double U, double V) offset) : ITexture
{
    /// <inheritdoc/>
    public Rgb At(double u, double v)
    {
        double field = Math.Floor((u * scale.U) + offset.U) + Math.Floor((v * scale.V) + offset.V);
        return (field % 2 == 0 ? even : odd).At(u, v);
    }
}

/// <summary>
/// A picture (report, section 6.2.7). The middle of texel i of n lies at (i + ½)/n; the bottom row is at v = 0.
/// </summary>
/// <param name="picture">The picture.</param>
/// <param name="interpolation">What is between texels.</param>
/// <param name="wrapping">What is outside: to the left and right, and above and below.</param>
/// <param name="scale">Factors on u and v.</param>
/// <param name="offset">Added to them after that.</param>
public sealed class ImageMap(
    Picture picture, Interpolation interpolation, (Wrapping U, Wrapping V) wrapping, (double U, double V) scale, (double U, double V) offset) : ITexture
{
    /// <inheritdoc/>
    public Rgb At(double u, double v)
    {
        double x = ((u * scale.U) + offset.U) * picture.Width;
        double y = (1 - ((v * scale.V) + offset.V)) * picture.Height;
        return interpolation switch
        {
            Interpolation.Nearest => Texel(Math.Floor(x), Math.Floor(y)),
            Interpolation.Bilinear => Sum(x - 0.5, y - 0.5, 0, Tent),
            _ => Sum(x - 0.5, y - 0.5, 1, CatmullRom),
        };
    }

    // The texels around, weighted by their distances along and across.
    private Rgb Sum(double x, double y, int more, Func<double, double> weight)
    {
        Rgb sum = default;
        for (double row = Math.Floor(y) - more; row <= Math.Floor(y) + 1 + more; row++)
        {
            for (double column = Math.Floor(x) - more; column <= Math.Floor(x) + 1 + more; column++)
            {
                sum += Texel(column, row) * (weight(Math.Abs(x - column)) * weight(Math.Abs(y - row)));
            }
        }

        return new(Math.Max(sum.R, 0), Math.Max(sum.G, 0), Math.Max(sum.B, 0));
    }

    private static double Tent(double d) => Math.Max(0, 1 - d);

    // Keys, Cubic convolution interpolation for digital image processing (1981), with a = −1/2.
    private static double CatmullRom(double d) => d < 1 ? (((1.5 * d) - 2.5) * d * d) + 1 : d < 2 ? (((((-0.5 * d) + 2.5) * d) - 4) * d) + 2 : 0;

    private Rgb Texel(double column, double row)
    {
        int i = 3 * ((Wrapped(row, picture.Height, wrapping.V) * picture.Width) + Wrapped(column, picture.Width, wrapping.U));
        return new(picture.Pixels[i], picture.Pixels[i + 1], picture.Pixels[i + 2]);
    }

    private static int Wrapped(double i, int n, Wrapping wrapping)
    {
        double inside = wrapping switch
        {
            Wrapping.Repeat => i - (Math.Floor(i / n) * n),
            Wrapping.Mirror => n - 0.5 - Math.Abs(i - (Math.Floor(i / (2.0 * n)) * 2 * n) - n + 0.5),
            _ => i,
        };
        return (int)Math.Clamp(inside, 0, n - 1);
    }
}
