using RayTracer.Textures;

namespace RayTracer.Session;

/// <summary>A picture of linear light, whose memory can be used again for another one.</summary>
public sealed class LinearPicture : IImageRows
{
    private float[] _rgb = [];

    /// <inheritdoc/>
    public int Width { get; private set; }

    /// <inheritdoc/>
    public int Height { get; private set; }

    /// <summary>A row, which may be written to.</summary>
    /// <param name="y">Its number, from the top.</param>
    public Span<float> Row(int y) => _rgb.AsSpan(3 * Width * y, 3 * Width);

    /// <summary>Gives it another size; what it shows is undefined then.</summary>
    public void Resize(int width, int height)
    {
        (Width, Height) = (width, height);
        int needed = checked(3 * width * height);
        if (_rgb.Length < needed || _rgb.Length / 4 > needed)
        {
            _rgb = new float[needed];
        }
    }

    /// <summary>Takes over an image.</summary>
    public void CopyFrom(IImageRows image)
    {
        Resize(image.Width, image.Height);
        for (int y = 0; y < Height; y++)
        {
            image.ReadRow(y, Row(y));
        }
    }

    /// <inheritdoc/>
    public void ReadRow(int y, Span<float> rgb) => Row(y).CopyTo(rgb);
}
