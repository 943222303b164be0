using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>An image made smaller: each pixel is the mean, in linear light, of those that lie in its rectangle.</summary>
internal static class ScaledRows
{
    /// <summary>Makes it.</summary>
    /// <param name="image">Linear RGB.</param>
    /// <param name="width">Columns, at least 1 and at most as many as the image has.</param>
    /// <param name="height">Rows, likewise.</param>
    public static Picture Shrink(IImageRows image, int width, int height)
    {
        Picture small = new(width, height);
        double[] sums = new double[3 * width];
        float[] row = new float[3 * image.Width];
        for (int y = 0; y < height; y++)
        {
            Array.Clear(sums);
            (int top, int bottom) = Range(y, height, image.Height);
            for (int line = top; line < bottom; line++)
            {
                image.ReadRow(line, row);
                for (int x = 0; x < width; x++)
                {
                    (int left, int right) = Range(x, width, image.Width);
                    for (int i = 3 * left; i < 3 * right; i++)
                    {
                        sums[(3 * x) + (i % 3)] += row[i] / (double)(right - left);
                    }
                }
            }

            for (int i = 0; i < sums.Length; i++)
            {
                small.Pixels[(3 * width * y) + i] = (float)(sums[i] / (bottom - top));
            }
        }

        return small;
    }

    private static (int First, int End) Range(int index, int count, int all) =>
        ((int)((long)index * all / count), (int)((long)(index + 1) * all / count));
}
