using System.Buffers.Binary;
using System.Text;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// Writes OpenEXR files: one part, rows from top to bottom, channels B, G and R, Rec. 709 primaries (the format's default), and further
/// layers beside them.
/// </summary>
internal static class ExrWriter
{
    /// <summary>Writes an image, a block of at most 16 rows at a time: no more is in memory.</summary>
    /// <param name="output">The stream to write to; it must be able to seek, for the table of blocks before the pixels.</param>
    /// <param name="image">Linear RGB.</param>
    /// <param name="type">
    /// Half or float. Floats are kept bit for bit; for halves, finite values are rounded to the nearest and cut off at ±65504.
    /// </param>
    /// <param name="compression">Compression, without loss.</param>
    /// <param name="metadata">
    /// Text to keep with the image as string attributes: keys of 1 to 255 bytes without NUL, each once, that are not attributes of the
    /// format itself.
    /// </param>
    /// <param name="layers">Channels to write beside the image's own, each in its own type.</param>
    /// <exception cref="ArgumentException">
    /// A stream that cannot seek, the type <see cref="ExrPixelType.Uint"/> for the image, or metadata or names of channels that OpenEXR
    /// cannot hold.
    /// </exception>
    public static void Write(
        Stream output,
        IImageRows image,
        ExrPixelType type = ExrPixelType.Half,
        ExrCompression compression = ExrCompression.Zip,
        IEnumerable<KeyValuePair<string, string>>? metadata = null,
        IEnumerable<ExrLayerChannel>? layers = null)
    {
        if (!output.CanSeek)
        {
            throw new ArgumentException("OpenEXR is written only to a stream that can seek.", nameof(output));
        }

        if (type is not (ExrPixelType.Half or ExrPixelType.Float) || !Enum.IsDefined(compression))
        {
            throw new ArgumentException($"OpenEXR is written as half or float with one of four compressions, not as {type} with {compression}.", nameof(type));
        }

        ExrChannelRows channels = new(image, type, layers ?? []);
        long start = output.Position;
        output.Write(Header(image, channels, compression, metadata ?? []));
        long tableAt = output.Position;
        int rows = ExrFormat.RowsOfBlock(compression);
        var table = new byte[8 * ((image.Height + rows - 1) / rows)];
        output.Write(table);
        for (int block = 0; block < table.Length / 8; block++)
        {
            BinaryPrimitives.WriteInt64LittleEndian(table.AsSpan(8 * block), output.Position - start);
            WriteBlock(output, channels, compression, block * rows, Math.Min(rows, image.Height - (block * rows)));
        }

        long end = output.Position;
        output.Position = tableAt;
        output.Write(table);
        output.Position = end;
    }

    private static void WriteBlock(Stream output, ExrChannelRows channels, ExrCompression compression, int firstRow, int rows)
    {
        var block = new byte[checked(channels.RowBytes * rows)];
        for (int row = 0; row < rows; row++)
        {
            channels.Write(firstRow + row, block.AsSpan(channels.RowBytes * row, channels.RowBytes));
        }

        ReadOnlySpan<byte> packed = ExrBlockCodec.Compress(compression, block);
        Span<byte> head = stackalloc byte[8];
        BinaryPrimitives.WriteInt32LittleEndian(head, firstRow);
        BinaryPrimitives.WriteInt32LittleEndian(head[4..], packed.Length);
        output.Write(head);
        output.Write(packed);
    }

    private static byte[] Header(IImageRows image, ExrChannelRows channels, ExrCompression compression, IEnumerable<KeyValuePair<string, string>> metadata)
    {
        using var bytes = new MemoryStream();
        using var writer = new BinaryWriter(bytes); // little-endian, as OpenEXR is
        KeyValuePair<string, string>[] texts = [.. metadata];
        bool longNames = texts.Any(text => Encoding.UTF8.GetByteCount(text.Key) > ExrFormat.ShortName) || channels.Channels.Any(c => c.Name.Length > ExrFormat.ShortName);
        writer.Write(ExrFormat.Magic);
        writer.Write(ExrFormat.Version | (longNames ? ExrFormat.LongNamesFlag : 0));
        Attribute(writer, "channels", "chlist", [.. channels.Channels.SelectMany(c => Channel(c.Name, c.Type)), 0]);
        Attribute(writer, "compression", "compression", [(byte)compression]);
        Attribute(writer, "dataWindow", "box2i", Words(0, 0, image.Width - 1, image.Height - 1));
        Attribute(writer, "displayWindow", "box2i", Words(0, 0, image.Width - 1, image.Height - 1));
        Attribute(writer, "lineOrder", "lineOrder", [0]);
        Attribute(writer, "pixelAspectRatio", "float", Words(BitConverter.SingleToInt32Bits(1)));
        Attribute(writer, "screenWindowCenter", "v2f", Words(0, 0));
        Attribute(writer, "screenWindowWidth", "float", Words(BitConverter.SingleToInt32Bits(1)));
        var names = new HashSet<string>(ExrFormat.Attributes, StringComparer.Ordinal);
        foreach ((string key, string value) in texts)
        {
            bool valid = key.Length > 0 && !key.Contains('\0') && Encoding.UTF8.GetByteCount(key) <= ExrFormat.LongName && names.Add(key);
            if (!valid)
            {
                throw new ArgumentException($"OpenEXR cannot hold the text '{key}': a key has 1 to 255 bytes, is there only once, and is no attribute of the format.", nameof(metadata));
            }

            Attribute(writer, key, "string", Encoding.UTF8.GetBytes(value));
        }

        writer.Write((byte)0);
        return bytes.ToArray();
    }

    private static void Attribute(BinaryWriter writer, string name, string type, byte[] value)
    {
        writer.Write([.. Encoding.UTF8.GetBytes(name), 0, .. Encoding.ASCII.GetBytes(type), 0]);
        writer.Write(value.Length);
        writer.Write(value);
    }

    // Name, type, four bytes unused here (perceptually linear, reserved), and no subsampling.
    private static byte[] Channel(string name, ExrPixelType type) => [.. Encoding.ASCII.GetBytes(name), 0, .. Words((int)type, 0, 1, 1)];

    private static byte[] Words(params ReadOnlySpan<int> values)
    {
        var bytes = new byte[4 * values.Length];
        for (int i = 0; i < values.Length; i++)
        {
            BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(4 * i), values[i]);
        }

        return bytes;
    }
}
