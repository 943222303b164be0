using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// The difference that somebody sees who flips between two images: LDR-FLIP (Andersson et al. 2020), with its published parameters. For
/// each pixel a number from 0 (alike) to 1: a difference of colours, blurred as the eye blurs them, raised where edges and points differ.
/// </summary>
public sealed class FlipError : IImageRows
{
    /// <summary>
    /// Pixels a degree of the field of view for a display 0.7 m wide with 3840 columns, seen from 0.7 m: 0.7 · 3840/0.7 · π/180.
    /// </summary>
    public const double StandardPixelsPerDegree = 3840 * double.Pi / 180;

    private const double ColorExponent = 0.7;
    private const double FeatureExponent = 0.5;
    private const double Knee = 0.4;
    private const double ErrorAtKnee = 0.95;
    private static readonly double s_largest = Power(FlipColor.Distance(FlipColor.Uniform(new(0, 1, 0)), FlipColor.Uniform(new(0, 0, 1))), ColorExponent);
    private readonly float[] _errors;

    private FlipError(int width, int height, float[] errors)
    {
        (Width, Height, _errors) = (width, height, errors);
        double sum = 0;
        foreach (float error in errors)
        {
            sum += error;
        }

        Mean = sum / errors.Length;
    }

    /// <inheritdoc/>
    public int Width { get; }

    /// <inheritdoc/>
    public int Height { get; }

    /// <summary>The mean error of all pixels.</summary>
    public double Mean { get; }

    /// <summary>The error of a pixel, 0 to 1.</summary>
    /// <param name="x">Column, from the left.</param>
    /// <param name="y">Row, from the top.</param>
    public float this[int x, int y] => _errors[(y * Width) + x];

    /// <summary>Compares two images of one size; it does not matter which is the reference.</summary>
    /// <param name="image">Linear RGB, of which what a display shows counts: 0 to 1. What is no number counts as 0.</param>
    /// <param name="reference">The same of the reference.</param>
    /// <param name="pixelsPerDegree">The number of pixels per degree of the field of view, 1 to 1000.</param>
    /// <exception cref="PictureException">The images differ in size.</exception>
    public static FlipError Compare(IImageRows image, IImageRows reference, double pixelsPerDegree = StandardPixelsPerDegree)
    {
        ImageComparison.CheckSameSize(image, reference);
        FlipFilters filters = new(pixelsPerDegree);
        FlipImage a = new(image, filters);
        FlipImage b = new(reference, filters);
        var errors = new float[image.Width * image.Height];
        Parallel.For(0, image.Height, y =>
        {
            for (int i = y * image.Width; i < (y + 1) * image.Width; i++)
            {
                double color = Error(FlipColor.Distance(a.Color(i), b.Color(i)));
                double feature = Math.Max(Math.Abs(a.Edges[i] - b.Edges[i]), Math.Abs(a.Points[i] - b.Points[i]));
                errors[i] = (float)Power(color, 1 - Power(Math.Min(feature / Math.Sqrt(2), 1), FeatureExponent));
            }
        });
        return new(image.Width, image.Height, errors);
    }

    /// <summary>Reads a row as a heat map in linear RGB (<see cref="HeatMap"/>, from 0 to 1).</summary>
    /// <param name="y">The row, 0 is the top.</param>
    /// <param name="rgb">Gets 3·Width floats.</param>
    public void ReadRow(int y, Span<float> rgb)
    {
        for (int x = 0; x < Width; x++)
        {
            Rgb shown = HeatMap.Color(this[x, y]);
            rgb[3 * x] = (float)SrgbCurve.Decode(shown.R);
            rgb[(3 * x) + 1] = (float)SrgbCurve.Decode(shown.G);
            rgb[(3 * x) + 2] = (float)SrgbCurve.Decode(shown.B);
        }
    }

    // A distance of colours as an error: up to the knee it takes nearly all of the range, for people hardly see which of two large
    // differences is larger.
    private static double Error(double distance)
    {
        double power = Power(distance, ColorExponent);
        double knee = Knee * s_largest;
        double error = power < knee ? power * ErrorAtKnee / knee : ErrorAtKnee + ((power - knee) / (s_largest - knee) * (1 - ErrorAtKnee));
        return Math.Clamp(error, 0, 1);
    }

    private static double Power(double x, double exponent) =>
        x > 1e-300 ? PortableMath.Exp2(exponent * PortableMath.Log2(x)) : exponent == 0 ? 1 : 0;
}
