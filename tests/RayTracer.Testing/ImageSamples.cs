using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>Independent images of one expectation: renders of a scene with different seeds.</summary>
/// <param name="width">Width in pixels.</param>
/// <param name="height">Height in pixels.</param>
public sealed class ImageSamples(int width, int height)
{
    private readonly List<float[]> _images = [];

    /// <summary>Width in pixels.</summary>
    public int Width => width;

    /// <summary>Height in pixels.</summary>
    public int Height => height;

    /// <summary>Number of images.</summary>
    public int Count => _images.Count;

    /// <summary>A number of an image.</summary>
    /// <param name="image">Which image, from 0.</param>
    /// <param name="index">Which number: three a pixel, rows from top to bottom.</param>
    public float Value(int image, int index) => _images[image][index];

    /// <summary>Takes a copy of an image.</summary>
    /// <exception cref="ArgumentException">It has another size.</exception>
    public void Add(IImageRows image)
    {
        if (image.Width != width || image.Height != height)
        {
            throw new ArgumentException($"An image of {image.Width}×{image.Height} pixels is none of {width}×{height}.", nameof(image));
        }

        float[] pixels = new float[3 * width * height];
        for (int y = 0; y < height; y++)
        {
            image.ReadRow(y, pixels.AsSpan(3 * width * y, 3 * width));
        }

        _images.Add(pixels);
    }

    /// <summary>An image.</summary>
    /// <param name="image">Which image, from 0.</param>
    public Picture Image(int image) => new(width, height, _images[image]);

    /// <summary>The mean of all images.</summary>
    public Picture Mean()
    {
        float[] mean = new float[3 * width * height];
        for (int i = 0; i < mean.Length; i++)
        {
            double sum = 0;
            foreach (float[] image in _images)
            {
                sum += image[i];
            }

            mean[i] = (float)(sum / Count);
        }

        return new(width, height, mean);
    }

    /// <summary>Mean over the images, and variance of that mean as estimated from their spread, of a block's mean.</summary>
    /// <param name="block">The pixels.</param>
    /// <param name="channel">0 red, 1 green, 2 blue.</param>
    public BlockEstimate Estimate(Block block, int channel)
    {
        double sum = 0;
        double squares = 0;
        double first = 0;
        for (int i = 0; i < Count; i++)
        {
            // Deviations from the first image: no cancellation where the images hardly differ.
            double value = MeanOf(_images[i], block, channel);
            first = i == 0 ? value : first;
            sum += value - first;
            squares += (value - first) * (value - first);
        }

        double variance = Math.Max(0, squares - (sum * sum / Count)) / (Count - 1);
        return new(first + (sum / Count), variance / Count, Count - 1);
    }

    private double MeanOf(float[] image, Block block, int channel)
    {
        double sum = 0;
        for (int y = block.Y; y < block.Y + block.Height; y++)
        {
            for (int x = block.X; x < block.X + block.Width; x++)
            {
                sum += image[(3 * ((y * width) + x)) + channel];
            }
        }

        return sum / (block.Width * block.Height);
    }
}

/// <summary>A rectangle of pixels.</summary>
/// <param name="X">Left column.</param>
/// <param name="Y">Top row.</param>
/// <param name="Width">Number of columns.</param>
/// <param name="Height">Number of rows.</param>
public readonly record struct Block(int X, int Y, int Width, int Height)
{
    /// <summary>Cuts an image into blocks of at most <paramref name="edge"/> pixels on a side.</summary>
    public static IEnumerable<Block> Cut(int width, int height, int edge)
    {
        for (int y = 0; y < height; y += edge)
        {
            for (int x = 0; x < width; x += edge)
            {
                yield return new(x, y, Math.Min(edge, width - x), Math.Min(edge, height - y));
            }
        }
    }
}

/// <summary>A mean with the variance of that mean.</summary>
/// <param name="Mean">The mean.</param>
/// <param name="Variance">Estimated variance of the mean.</param>
/// <param name="Freedom">Degrees of freedom of the estimate.</param>
public readonly record struct BlockEstimate(double Mean, double Variance, double Freedom);
