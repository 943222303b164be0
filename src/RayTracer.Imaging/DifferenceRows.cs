using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>The absolute difference of two images, channel by channel, as an image; each row is computed when it is read.</summary>
public sealed class DifferenceRows : IImageRows
{
    private readonly IImageRows _image;
    private readonly IImageRows _reference;
    private readonly float _scale;
    private readonly float[] _referenceRow;

    /// <summary>Sets the two images.</summary>
    /// <param name="image">Linear RGB.</param>
    /// <param name="reference">Linear RGB, of the same size.</param>
    /// <param name="scale">
    /// The factor of differences, so that they are seen. Where a value is NaN or infinite in either image, the result is 1.
    /// </param>
    /// <exception cref="PictureException">The images differ in size.</exception>
    public DifferenceRows(IImageRows image, IImageRows reference, float scale = 1)
    {
        ImageComparison.CheckSameSize(image, reference);
        _image = image;
        _reference = reference;
        _scale = scale;
        _referenceRow = new float[3 * image.Width];
    }

    /// <inheritdoc/>
    public int Width => _image.Width;

    /// <inheritdoc/>
    public int Height => _image.Height;

    /// <summary>Reads a row of the difference; not from several threads at once.</summary>
    /// <param name="y">The row, 0 is the top.</param>
    /// <param name="rgb">Gets 3·Width floats.</param>
    public void ReadRow(int y, Span<float> rgb)
    {
        _image.ReadRow(y, rgb);
        _reference.ReadRow(y, _referenceRow);
        for (int i = 0; i < _referenceRow.Length; i++)
        {
            bool finite = float.IsFinite(rgb[i]) && float.IsFinite(_referenceRow[i]);
            rgb[i] = finite ? Math.Abs(rgb[i] - _referenceRow[i]) * _scale : 1;
        }
    }
}
