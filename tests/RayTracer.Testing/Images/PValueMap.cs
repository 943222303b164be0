using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>Welch's p-values of all blocks of 4×4 pixels, as pictures: where two sets of images disagree.</summary>
internal sealed class PValueMap
{
    /// <summary>−log₁₀ p, and the sRGB colour that stands for it; between them, colours are interpolated.</summary>
    public static readonly (double MinusLog, byte R, byte G, byte B)[] Scale =
        [(0, 20, 20, 45), (2, 40, 90, 170), (4, 40, 150, 70), (6, 240, 200, 20), (9, 220, 40, 40), (12, 255, 255, 255)];

    // Smaller p-values underflow.
    private const double Largest = 300;

    private readonly int _width;
    private readonly int _height;
    private readonly List<(Block Block, double[] P)> _blocks = [];

    public PValueMap(int width, int height, Func<Block, int, BlockEstimate> image, Func<Block, int, BlockEstimate> reference)
    {
        _width = width;
        _height = height;
        foreach (Block block in Block.Cut(width, height, BlockTest.Edges.Min()))
        {
            _blocks.Add((block, [.. Enumerable.Range(0, 3).Select(c => BlockTest.Welch(image(block, c), reference(block, c)))]));
        }
    }

    /// <summary>−log₁₀ p of each channel, at most 300, in the pixels of each block.</summary>
    public Picture Numbers() => Paint(p => [.. p.Select(x => (float)MinusLog(x))]);

    /// <summary>The smallest p-value of the three channels, times 3, in the colours of <see cref="Scale"/>.</summary>
    public Picture Colours() => Paint(p => Colour(MinusLog(PValues.Smallest(p))));

    private static double MinusLog(double p) => double.IsNaN(p) ? Largest : Math.Clamp(-Math.Log10(p), 0, Largest);

    private static float[] Colour(double minusLog)
    {
        int i = 1;
        while (i < Scale.Length - 1 && minusLog > Scale[i].MinusLog)
        {
            i++;
        }

        (double s0, byte r0, byte g0, byte b0) = Scale[i - 1];
        (double s1, byte r1, byte g1, byte b1) = Scale[i];
        double t = Math.Clamp((minusLog - s0) / (s1 - s0), 0, 1);
        return [Mix(r0, r1), Mix(g0, g1), Mix(b0, b1)];

        float Mix(byte a, byte b) => (float)SrgbCurve.Decode((a + (t * (b - a))) / 255);
    }

    private Picture Paint(Func<double[], float[]> paint)
    {
        Picture picture = new(_width, _height);
        foreach ((Block block, double[] p) in _blocks)
        {
            float[] colour = paint(p);
            for (int y = block.Y; y < block.Y + block.Height; y++)
            {
                for (int x = block.X; x < block.X + block.Width; x++)
                {
                    colour.CopyTo(picture.Pixels, 3 * ((y * _width) + x));
                }
            }
        }

        return picture;
    }
}
