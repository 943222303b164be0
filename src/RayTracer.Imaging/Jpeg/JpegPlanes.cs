using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Turns an image into the quantized coefficients of luminance and two differences of colour.</summary>
/// <remarks>
/// All arithmetic is of floats, with the operations in a fixed order and none fused, so that files have the same bytes on every machine.
/// </remarks>
internal sealed class JpegPlanes
{
    private const int Side = JpegComponent.Side;

    private readonly IImageRows _image;
    private readonly SrgbCodes _codes = SrgbCurve.CodesOf(8);
    private readonly int _factor;
    private readonly float[] _linear;
    private readonly int _stride;

    // The rows of one row of units, three planes.
    private readonly float[][] _rows;

    /// <summary>Computes the coefficients.</summary>
    /// <param name="image">Linear RGB.</param>
    /// <param name="chroma">True where differences of colour are kept for every pixel.</param>
    /// <param name="steps">The steps of each component, row by row.</param>
    public JpegPlanes(IImageRows image, JpegChroma chroma, byte[][] steps)
    {
        _image = image;
        _factor = chroma == JpegChroma.Half ? 2 : 1;
        _linear = new float[3 * image.Width];
        UnitsAcross = JpegFrame.Divide(image.Width, Side * _factor);
        UnitsDown = JpegFrame.Divide(image.Height, Side * _factor);
        _stride = UnitsAcross * Side * _factor;
        _rows = [.. Enumerable.Range(0, 3).Select(_ => new float[_stride * Side * _factor])];
        Components = [new(1, _factor, _factor, 0), new(2, 1, 1, 1), new(3, 1, 1, 1)];
        Array.ForEach(Components, c => c.SetSize(image.Width, image.Height, UnitsAcross, UnitsDown));
        float[][] factors = [.. steps.Select(s => s.Select(step => 0.25f / step).ToArray())];
        for (int unit = 0; unit < UnitsDown; unit++)
        {
            ReadUnitRow(unit);
            Transform(unit, factors);
        }
    }

    /// <summary>Units (MCUs) side by side.</summary>
    public int UnitsAcross { get; }

    /// <summary>Units one above the other.</summary>
    public int UnitsDown { get; }

    /// <summary>Luminance, and the differences of blue and of red, with coefficients in the order of scans.</summary>
    public JpegComponent[] Components { get; }

    // Behind the image's edges, its last row and column go on.
    private void ReadUnitRow(int unit)
    {
        int rows = Side * _factor;
        for (int y = 0; y < rows; y++)
        {
            int from = (unit * rows) + y;
            int at = y * _stride;
            if (from >= _image.Height)
            {
                Array.ForEach(_rows, plane => plane.AsSpan(at - _stride, _stride).CopyTo(plane.AsSpan(at)));
                continue;
            }

            _image.ReadRow(from, _linear);
            for (int x = 0; x < _image.Width; x++)
            {
                SetPixel(at + x, _codes.Encode(_linear[3 * x]), _codes.Encode(_linear[(3 * x) + 1]), _codes.Encode(_linear[(3 * x) + 2]));
            }

            Array.ForEach(_rows, plane => plane.AsSpan(at + _image.Width, _stride - _image.Width).Fill(plane[at + _image.Width - 1]));
        }
    }

    // ITU-T T.871 (JFIF), section 7; around zero.
    private void SetPixel(int at, float r, float g, float b)
    {
        float luminance = (0.299f * r) + (0.587f * g) + (0.114f * b);
        _rows[0][at] = luminance - 128;
        _rows[1][at] = (b - luminance) * (1 / 1.772f);
        _rows[2][at] = (r - luminance) * (1 / 1.402f);
    }

    private void Transform(int unit, float[][] factors)
    {
        Span<float> values = stackalloc float[JpegComponent.BlockSize];
        for (int c = 0; c < Components.Length; c++)
        {
            JpegComponent component = Components[c];
            int shrink = _factor / component.Vertical;
            for (int y = 0; y < component.Vertical; y++)
            {
                short[] blocks = component.BlockRow((unit * component.Vertical) + y);
                for (int block = 0; block < component.Stride / Side; block++)
                {
                    Take(_rows[c], (y * Side * _stride) + (block * Side * shrink), shrink, values);
                    JpegTransform.Forward(values, factors[component.Quantization], blocks.AsSpan(block * JpegComponent.BlockSize, JpegComponent.BlockSize));
                }
            }
        }
    }

    private void Take(float[] plane, int at, int shrink, Span<float> values)
    {
        for (int y = 0; y < Side; y++)
        {
            ReadOnlySpan<float> row = plane.AsSpan(at + (y * shrink * _stride));
            Span<float> taken = values.Slice(y * Side, Side);
            if (shrink == 1)
            {
                row[..Side].CopyTo(taken);
                continue;
            }

            for (int x = 0; x < Side; x++)
            {
                taken[x] = (row[2 * x] + row[(2 * x) + 1] + row[_stride + (2 * x)] + row[_stride + (2 * x) + 1]) * 0.25f;
            }
        }
    }
}
