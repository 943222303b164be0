using System.Buffers.Binary;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// Everything that is written to an OpenEXR file, channel by channel, in the order of their names, which the format demands.
/// </summary>
internal sealed class ExrChannelRows
{
    private const float LargestHalf = 65504;
    private readonly IImageRows _image;
    private readonly ExrLayerChannel[] _sorted;
    private readonly double[] _values;
    private readonly float[] _rgb;
    private int _rowRead = -1;

    /// <summary>Joins an image and further channels.</summary>
    /// <exception cref="ArgumentException">A name that OpenEXR cannot hold, or that is there twice.</exception>
    public ExrChannelRows(IImageRows image, ExrPixelType type, IEnumerable<ExrLayerChannel> layers)
    {
        _image = image;
        _values = new double[image.Width];
        _rgb = new float[3 * image.Width];
        ExrLayerChannel Own(string name, int offset) => new(name, type, (y, values) => ReadOwn(y, offset, values.Span));
        _sorted = [.. layers.Append(Own("R", 0)).Append(Own("G", 1)).Append(Own("B", 2)).OrderBy(c => c.Name, StringComparer.Ordinal)];
        for (int i = 0; i < _sorted.Length; i++)
        {
            string name = _sorted[i].Name;
            if (!CanHold(name) || (i > 0 && _sorted[i - 1].Name == name))
            {
                throw new ArgumentException($"OpenEXR cannot hold the channel '{name}': a name has 1 to 255 printable ASCII characters, and is there only once.", nameof(layers));
            }
        }
    }

    /// <summary>Returns whether a channel may have a name.</summary>
    public static bool CanHold(string name) => name.Length is > 0 and <= ExrFormat.LongName && name.All(c => c is > ' ' and <= '~');

    /// <summary>The channels, in the order in which rows hold them.</summary>
    public IReadOnlyList<ExrLayerChannel> Channels => _sorted;

    /// <summary>Bytes of a row.</summary>
    public int RowBytes => checked(_sorted.Sum(c => Bytes(c.Type)) * _image.Width);

    /// <summary>Writes a row.</summary>
    public void Write(int y, Span<byte> row)
    {
        foreach (ExrLayerChannel channel in _sorted)
        {
            channel.ReadRow(y, _values);
            int bytes = Bytes(channel.Type);
            foreach (double value in _values)
            {
                Put(row, value, channel.Type);
                row = row[bytes..];
            }
        }
    }

    private static int Bytes(ExrPixelType type) => type == ExrPixelType.Half ? 2 : 4;

    private void ReadOwn(int y, int offset, Span<double> values)
    {
        if (y != _rowRead)
        {
            _image.ReadRow(y, _rgb);
            _rowRead = y;
        }

        for (int x = 0; x < values.Length; x++)
        {
            values[x] = _rgb[(3 * x) + offset];
        }
    }

    private static void Put(Span<byte> at, double value, ExrPixelType type)
    {
        switch (type)
        {
            case ExrPixelType.Float:
                BinaryPrimitives.WriteSingleLittleEndian(at, (float)value);
                break;
            case ExrPixelType.Half:
                float kept = double.IsFinite(value) ? (float)Math.Clamp(value, -LargestHalf, LargestHalf) : (float)value;
                BinaryPrimitives.WriteHalfLittleEndian(at, (Half)kept);
                break;
            default:
                BinaryPrimitives.WriteUInt32LittleEndian(at, (uint)Math.Clamp(value, 0, uint.MaxValue));
                break;
        }
    }
}
