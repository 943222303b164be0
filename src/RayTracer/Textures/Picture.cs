namespace RayTracer.Textures;

/// <summary>An image that can be read row by row, such as a film or a picture: what image writers take.</summary>
public interface IImageRows
{
    /// <summary>Width in pixels.</summary>
    int Width { get; }

    /// <summary>Height in pixels.</summary>
    int Height { get; }

    /// <summary>Writes row <paramref name="y"/> (0 is the top) as linear RGB, three floats a pixel, to <paramref name="rgb"/>.</summary>
    void ReadRow(int y, Span<float> rgb);
}

/// <summary>
/// Image storage (the report's class of that name): linear RGB (Rec. 709 primaries), three floats a pixel, rows from top to bottom.
/// </summary>
public sealed class Picture : IImageRows
{
    /// <summary>Takes over an array of pixels.</summary>
    /// <param name="width">Width in pixels, at least 1.</param>
    /// <param name="height">Height in pixels, at least 1.</param>
    /// <param name="pixels">3·width·height floats: linear red, green and blue of each pixel, rows from top to bottom.</param>
    /// <exception cref="ArgumentException">A size below 1, or an array of another length.</exception>
    public Picture(int width, int height, float[] pixels)
    {
        ArgumentOutOfRangeException.ThrowIfLessThan(width, 1);
        ArgumentOutOfRangeException.ThrowIfLessThan(height, 1);
        if (pixels.LongLength != 3L * width * height)
        {
            throw new ArgumentException($"A picture of {width}×{height} pixels needs {3L * width * height} floats, not {pixels.LongLength}.", nameof(pixels));
        }

        Width = width;
        Height = height;
        Pixels = pixels;
    }

    /// <summary>Makes a black picture.</summary>
    /// <param name="width">Width in pixels, at least 1.</param>
    /// <param name="height">Height in pixels, at least 1.</param>
    public Picture(int width, int height)
        : this(width, height, new float[checked(3L * width * height)])
    {
    }

    /// <summary>Width in pixels.</summary>
    public int Width { get; }

    /// <summary>Height in pixels.</summary>
    public int Height { get; }

    /// <summary>3·Width·Height floats: linear red, green and blue of each pixel, rows from top to bottom.</summary>
    public float[] Pixels { get; }

    /// <summary>The picture with the luminance of its pixels; those that are grey stay as they are.</summary>
    internal Picture Grey()
    {
        Picture grey = new(Width, Height);
        for (int i = 0; i < Pixels.Length; i += 3)
        {
            (float r, float g, float b) = (Pixels[i], Pixels[i + 1], Pixels[i + 2]);
            grey.Pixels.AsSpan(i, 3).Fill(r == g && g == b ? r : new Numerics.Rgb(r, g, b).Luminance);
        }

        return grey;
    }

    /// <inheritdoc/>
    public void ReadRow(int y, Span<float> rgb) => Pixels.AsSpan(3 * y * Width, 3 * Width).CopyTo(rgb);
}

/// <summary>A picture file that cannot be read; the message says what is wrong, for the user.</summary>
public sealed class PictureException : Exception
{
    /// <summary>Says what is wrong.</summary>
    public PictureException(string message) : base(message)
    {
    }

    /// <summary>Says what is wrong, and what caused it.</summary>
    public PictureException(string message, Exception innerException) : base(message, innerException)
    {
    }

    /// <summary>An unnamed fault.</summary>
    public PictureException()
    {
    }

    /// <summary>True where there is no such file.</summary>
    public bool IsMissing { get; init; }
}
