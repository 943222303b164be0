using RayTracer.Textures;

namespace RayTracer.Imaging.Tests;

/// <summary>FLIP as its paper writes it (Andersson et al. 2020): whole filters in two dimensions, in double precision.</summary>
internal sealed class PlainFlip(double pixelsPerDegree)
{
    private static readonly double[,] s_toXyz =
    {
        { 0.4123907993, 0.3575843394, 0.1804807884 }, { 0.2126390059, 0.7151686788, 0.0721923154 }, { 0.0193308187, 0.1191947798, 0.9505321522 },
    };

    // The inverse of sRGB's matrix, to ten digits.
    private static readonly double[,] s_toRgb =
    {
        { 3.2409699419, -1.5373831776, -0.4986107603 }, { -0.9692436363, 1.8759675015, 0.0415550574 }, { 0.0556300797, -0.2039769589, 1.0569715142 },
    };

    private static readonly double[] s_white = Times(s_toXyz, [1, 1, 1]);

    /// <summary>The error of each pixel.</summary>
    public double[] Compare(Picture a, Picture b)
    {
        double largest = Math.Pow(Distance(Lab([0, 1, 0]), Lab([0, 0, 1])), 0.7);
        (double[][] colorsA, double[] edgesA, double[] pointsA) = Prepare(a);
        (double[][] colorsB, double[] edgesB, double[] pointsB) = Prepare(b);
        return [.. Enumerable.Range(0, colorsA.Length).Select(i =>
        {
            double power = Math.Pow(Distance(colorsA[i], colorsB[i]), 0.7);
            double color = power < 0.4 * largest ? 0.95 * power / (0.4 * largest) : 0.95 + (0.05 * (power - (0.4 * largest)) / (0.6 * largest));
            double feature = Math.Sqrt(Math.Max(Math.Abs(edgesA[i] - edgesB[i]), Math.Abs(pointsA[i] - pointsB[i])) / Math.Sqrt(2));
            return Math.Pow(color, 1 - feature);
        })];
    }

    private static double[] Times(double[,] m, double[] v) => [.. Enumerable.Range(0, 3).Select(r => (m[r, 0] * v[0]) + (m[r, 1] * v[1]) + (m[r, 2] * v[2]))];

    private static double[] Lab(double[] rgb)
    {
        static double F(double t) => t > Math.Pow(6.0 / 29, 3) ? Math.Cbrt(t) : (t / (3 * Math.Pow(6.0 / 29, 2))) + (4.0 / 29);
        double[] xyz = Times(s_toXyz, rgb);
        double[] f = [.. xyz.Select((v, i) => F(v / s_white[i]))];
        double lightness = (116 * f[1]) - 16;
        return [lightness, lightness / 100 * 500 * (f[0] - f[1]), lightness / 100 * 200 * (f[1] - f[2])];
    }

    private static double Distance(double[] a, double[] b) => Math.Abs(a[0] - b[0]) + Math.Sqrt(Math.Pow(a[1] - b[1], 2) + Math.Pow(a[2] - b[2], 2));

    private static double[] Convolve(double[] plane, int width, Func<int, int, double> kernel, int radius)
    {
        int height = plane.Length / width;
        return [.. Enumerable.Range(0, plane.Length).Select(i =>
        {
            double sum = 0;
            for (int dy = -radius; dy <= radius; dy++)
            {
                for (int dx = -radius; dx <= radius; dx++)
                {
                    sum += kernel(dx, dy) * plane[(Math.Clamp((i / width) + dy, 0, height - 1) * width) + Math.Clamp((i % width) + dx, 0, width - 1)];
                }
            }

            return sum;
        })];
    }

    // Positive weights are divided by their sum, and negative ones by theirs.
    private static Func<int, int, double> Normalized(Func<int, int, double> kernel, int radius)
    {
        double[] all = [.. Enumerable.Range(-radius, (2 * radius) + 1).SelectMany(x => Enumerable.Range(-radius, (2 * radius) + 1).Select(y => kernel(x, y)))];
        double above = all.Where(k => k > 0).Sum();
        double below = -all.Where(k => k < 0).Sum();
        return (x, y) => kernel(x, y) is var k && k > 0 ? k / above : k < 0 ? k / below : 0;
    }

    private (double[][] Colors, double[] Edges, double[] Points) Prepare(Picture picture)
    {
        int count = picture.Width * picture.Height;
        double[][] relative = [.. Enumerable.Range(0, count).Select(i =>
            Times(s_toXyz, [.. picture.Pixels.AsSpan(3 * i, 3).ToArray().Select(v => Math.Clamp((double)v, 0, 1))]).Select((v, k) => v / s_white[k]).ToArray())];
        int radius = (int)Math.Ceiling(3 * Math.Sqrt(0.04 / (2 * Math.PI * Math.PI)) * pixelsPerDegree);
        double Csf(int x, int y, double a1, double b1, double a2, double b2)
        {
            double square = ((x * x) + (y * y)) / (pixelsPerDegree * pixelsPerDegree) * Math.PI * Math.PI;
            return (a1 * Math.Sqrt(Math.PI / b1) * Math.Exp(-square / b1)) + (a2 * Math.Sqrt(Math.PI / b2) * Math.Exp(-square / b2));
        }

        double[] Blur(Func<double[], double> channel, double a1, double b1, double a2, double b2) =>
            Convolve([.. relative.Select(channel)], picture.Width, Normalized((x, y) => Csf(x, y, a1, b1, a2, b2), radius), radius);
        double[] luminance = Blur(n => (116 * n[1]) - 16, 1, 0.0047, 0, 1e-5);
        double[] redGreen = Blur(n => 500 * (n[0] - n[1]), 1, 0.0053, 0, 1e-5);
        double[] blueYellow = Blur(n => 200 * (n[1] - n[2]), 34.1, 0.04, 13.5, 0.025);
        double[][] colors = [.. Enumerable.Range(0, count).Select(i =>
        {
            double y = (luminance[i] + 16) / 116;
            double[] rgb = Times(s_toRgb, [((redGreen[i] / 500) + y) * s_white[0], y * s_white[1], (y - (blueYellow[i] / 200)) * s_white[2]]);
            return Lab([.. rgb.Select(v => Math.Clamp(v, 0, 1))]);
        })];

        double sigma = 0.5 * 0.082 * pixelsPerDegree;
        int reach = (int)Math.Ceiling(3 * sigma);
        double Gauss(int x, int y) => Math.Exp(-((x * x) + (y * y)) / (2 * sigma * sigma));
        double[] grey = [.. relative.Select(n => n[1])];
        double[] Length(Func<int, int, double> kernel)
        {
            double[] x = Convolve(grey, picture.Width, Normalized(kernel, reach), reach);
            double[] y = Convolve(grey, picture.Width, Normalized((dx, dy) => kernel(dy, dx), reach), reach);
            return [.. x.Zip(y, (u, v) => Math.Sqrt((u * u) + (v * v)))];
        }

        return (colors, Length((x, y) => -x * Gauss(x, y)), Length((x, y) => ((x * x / (sigma * sigma)) - 1) * Gauss(x, y)));
    }
}
