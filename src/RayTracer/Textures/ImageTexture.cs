using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>The interpolation of colours between texels.</summary>
public enum Interpolation
{
    /// <summary>The nearest texel: blocks are seen from near.</summary>
    Nearest,

    /// <summary>Linear between the four nearest texels.</summary>
    Bilinear,

    /// <summary>Cubic over the sixteen nearest texels (Catmull–Rom): sharper, through every texel.</summary>
    Bicubic,
}

/// <summary>Describes an <see cref="ImageTexture"/>.</summary>
[SceneType("image", "A picture from a file (PNG, JPEG, PFM, OpenEXR, Radiance HDR).")]
public sealed record ImageTextureDescription : TextureDescription
{
    /// <summary>The picture's file.</summary>
    [Parameter("The picture's file.", IsFile = true, Required = true)]
    public string File { get; init; } = "";

    /// <summary>The interpolation of colours between texels.</summary>
    [Parameter("How the colour between texels is found: the nearest one's, linear between four, or cubic between sixteen (Catmull–Rom, cut "
        + "off at zero). The centre of texel i of n is at (i + ½)/n.")]
    public Interpolation Interpolation { get; init; } = Interpolation.Bilinear;

    /// <summary>The continuation outside the picture.</summary>
    [Parameter("What is shown outside the picture, where u or v is below 0 or above 1: the picture repeated, the texels of its edge, or "
        + "the picture and its mirror image in turn.")]
    public Wrapping Wrapping { get; init; } = Wrapping.Repeat;

    /// <summary>The continuation above and below the picture; null where it is <see cref="Wrapping"/> there too.</summary>
    [Parameter("What is shown above and below the picture, where v is below 0 or above 1, if it differs from what is shown to the left and "
        + "right.")]
    public Wrapping? VerticalWrapping { get; init; }

    /// <summary>Factors on u and v.</summary>
    [Parameter("Factors on u and v: 2 shows the picture twice as often, half as large; −1 mirrors it.")]
    public Vector2 Scale { get; init; } = Vector2.One;

    /// <summary>Added to the scaled uv.</summary>
    [Parameter("Added to u and v after scaling.", Unit = "pictures")]
    public Vector2 Offset { get; init; }

    /// <summary>True where the file's numbers are used as they are.</summary>
    [Parameter("Whether the file's numbers are linear and used as they are, instead of being decoded from sRGB. By default they are where "
        + "the texture stands for a number, and are not where it is a colour. Floating-point files are always linear.")]
    public bool? Raw { get; init; }

    /// <summary>True where only the picture's luminance counts.</summary>
    [Parameter("Whether the picture is made grey by its luminance (Rec. 709) first. Where a texture stands for a number, the red channel of a coloured picture counts otherwise.")]
    public bool Luminance { get; init; }

    /// <summary>The picture as a program gives it (decoded, or raw), instead of the file; null where there is none.</summary>
    public Picture? Picture { get; init; }

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder)
    {
        Picture picture = Picture ?? builder.Picture(this, nameof(File), File, Raw ?? builder.ReadsNumbers);
        return new ImageTexture(Luminance ? picture.Grey() : picture, Interpolation, Wrapping, Scale, Offset, VerticalWrapping);
    }
}

/// <summary>
/// A picture on a surface (the report's class of that name, with its three interpolations). Texel centres lie at
/// (i + ½)/n; the picture's bottom row is at v = 0.
/// </summary>
internal sealed unsafe class ImageTexture : Texture
{
    private readonly PinnedBuffer<float> _memory;
    private readonly float* _texels;
    private readonly int _width;
    private readonly int _height;
    private readonly Interpolation _interpolation;
    private readonly Wrapping _wrapping;
    private readonly Wrapping _verticalWrapping;
    private readonly Vector2 _scale;
    private readonly Vector2 _offset;

    /// <summary>Copies the picture's texels.</summary>
    /// <param name="picture">The picture, at most 2³¹/12 texels.</param>
    /// <param name="interpolation">The way in which colours between texels are found.</param>
    /// <param name="wrapping">The continuation of the picture beyond its edges.</param>
    /// <param name="scale">Factors on u and v.</param>
    /// <param name="offset">Added after scaling.</param>
    /// <param name="verticalWrapping">The continuation above and below the picture; null for the same.</param>
    public ImageTexture(Picture picture, Interpolation interpolation, Wrapping wrapping, Vector2 scale, Vector2 offset, Wrapping? verticalWrapping = null)
    {
        _width = picture.Width;
        _height = picture.Height;
        _interpolation = interpolation;
        _wrapping = wrapping;
        _verticalWrapping = verticalWrapping ?? wrapping;
        _scale = scale;
        _offset = offset;
        _memory = new(picture.Pixels.LongLength);
        _texels = _memory.Pointer;
        picture.Pixels.CopyTo(new Span<float>(_texels, picture.Pixels.Length));
    }

    /// <inheritdoc/>
    public override long MemoryBytes => 3L * sizeof(float) * _width * _height;

    /// <inheritdoc/>
    public override float Aspect => (float)_width / _height;

    /// <inheritdoc/>
    public override void Evaluate(in TexturePointW at, out RgbW color)
    {
        // In texels; rows are counted from the top of the picture.
        FloatW x = FloatW.MultiplyAdd(at.U, _scale.X, _offset.X) * _width;
        FloatW y = (1f - FloatW.MultiplyAdd(at.V, _scale.Y, _offset.Y)) * _height;
        switch (_interpolation)
        {
            case Interpolation.Nearest:
                color = Texel(Column(FloatW.Floor(x)), Row(FloatW.Floor(y)));
                break;
            case Interpolation.Bilinear:
                Bilinear(x - 0.5f, y - 0.5f, out color);
                break;
            default:
                Bicubic(x - 0.5f, y - 0.5f, out color);
                break;
        }
    }

    /// <inheritdoc/>
    public override bool HasSlope => _interpolation == Interpolation.Bilinear;

    /// <inheritdoc/>
    public override void Slope(in TexturePointW at, out FloatW alongU, out FloatW alongV)
    {
        // Between texels' centres the picture is bilinear, so this is exact but on the lines between them, where it jumps.
        FloatW x = FloatW.MultiplyAdd(FloatW.MultiplyAdd(at.U, _scale.X, _offset.X), _width, -0.5f);
        FloatW y = FloatW.MultiplyAdd(1f - FloatW.MultiplyAdd(at.V, _scale.Y, _offset.Y), _height, -0.5f);
        FloatW left = FloatW.Floor(x);
        FloatW top = FloatW.Floor(y);
        UIntW column0 = Column(left);
        UIntW column1 = Column(left + 1f);
        UIntW row0 = Row(top);
        UIntW row1 = Row(top + 1f);
        FloatW a = FloatW.Gather(_texels, row0 + column0);
        FloatW b = FloatW.Gather(_texels, row0 + column1);
        FloatW c = FloatW.Gather(_texels, row1 + column0);
        FloatW d = FloatW.Gather(_texels, row1 + column1);
        alongU = FloatW.MultiplyAdd((d - c) - (b - a), y - top, b - a) * (_width * _scale.X);
        alongV = FloatW.MultiplyAdd((d - b) - (c - a), x - left, c - a) * (-_height * _scale.Y);
    }

    private void Bilinear(in FloatW x, in FloatW y, out RgbW color)
    {
        FloatW left = FloatW.Floor(x);
        FloatW top = FloatW.Floor(y);
        FloatW fx = x - left;
        FloatW fy = y - top;
        UIntW column0 = Column(left);
        UIntW column1 = Column(left + 1f);
        UIntW row0 = Row(top);
        UIntW row1 = Row(top + 1f);
        RgbW upper = Texel(column0, row0) * (1f - fx) + Texel(column1, row0) * fx;
        RgbW lower = Texel(column0, row1) * (1f - fx) + Texel(column1, row1) * fx;
        color = upper * (1f - fy) + lower * fy;
    }

    private void Bicubic(in FloatW x, in FloatW y, out RgbW color)
    {
        FloatW left = FloatW.Floor(x);
        FloatW top = FloatW.Floor(y);
        FloatW fx = x - left;
        FloatW fy = y - top;
        UIntW column0 = Column(left - 1f);
        UIntW column1 = Column(left);
        UIntW column2 = Column(left + 1f);
        UIntW column3 = Column(left + 2f);
        FloatW weight0 = CatmullRom(fx + 1f);
        FloatW weight1 = CatmullRom(fx);
        FloatW weight2 = CatmullRom(fx - 1f);
        FloatW weight3 = CatmullRom(fx - 2f);
        RgbW sum = default;
        for (int j = -1; j <= 2; j++)
        {
            UIntW row = Row(top + j);
            RgbW line = Texel(column0, row) * weight0;
            line = RgbW.MultiplyAdd(Texel(column1, row), weight1, line);
            line = RgbW.MultiplyAdd(Texel(column2, row), weight2, line);
            line = RgbW.MultiplyAdd(Texel(column3, row), weight3, line);
            sum = RgbW.MultiplyAdd(line, CatmullRom(fy - j), sum);
        }

        // The kernel's negative lobes may undershoot beside a hard edge; light has no negative colour.
        color = new(FloatW.Max(sum.R, 0f), FloatW.Max(sum.G, 0f), FloatW.Max(sum.B, 0f));
    }

    // Keys, Cubic convolution interpolation for digital image processing (1981), eq. 15, with a = −1/2.
    private static FloatW CatmullRom(FloatW distance)
    {
        FloatW d = FloatW.Abs(distance);
        FloatW inner = FloatW.MultiplyAdd(FloatW.MultiplyAdd(d, 1.5f, -2.5f), d * d, 1f);
        FloatW outer = FloatW.MultiplyAdd(FloatW.MultiplyAdd(FloatW.MultiplyAdd(d, -0.5f, 2.5f), d, -4f), d, 2f);
        return (d < 1f).Select(inner, outer);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private RgbW Texel(UIntW column, UIntW row) => RgbW.Gather(_texels, row + column);

    // Where a column and a row begin, in floats. Indices are whole numbers in floats; the clamp also catches NaN, so no lane can
    // read outside the picture.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private UIntW Column(FloatW i) => FloatW.Max(0f, FloatW.Min(_wrapping.Index(i, _width), _width - 1)).ToIntInRange() * 3u;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private UIntW Row(FloatW i) => FloatW.Max(0f, FloatW.Min(_verticalWrapping.Index(i, _height), _height - 1)).ToIntInRange() * (3u * (uint)_width);
}
