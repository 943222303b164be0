using System.Buffers.Binary;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// Reads OpenEXR files of one part stored as rows, uncompressed or compressed with RLE, ZIPS or ZIP. Channels other than R, G, B
/// (or a lone Y, which is grey) are skipped; chromaticities are ignored: the primaries are taken to be those of Rec. 709.
/// </summary>
public static class ExrReader
{
    /// <summary>The four bytes that an OpenEXR file begins with.</summary>
    public static ReadOnlySpan<byte> Signature => ExrFormat.Magic;

    /// <summary>Reads the data window of a picture.</summary>
    /// <param name="file">The whole file.</param>
    /// <returns>The values as linear RGB; half, float and unsigned integers all become floats, grey has three equal channels.</returns>
    /// <exception cref="PictureException">The file is no OpenEXR, is of another kind than said above, is damaged, or is beyond <see cref="PictureLimits"/>.</exception>
    public static Picture Read(ReadOnlySpan<byte> file)
    {
        ExrHeader header = ExrHeader.Parse(file);
        int[] targets = Targets(header);
        ExrBlock[] blocks = ExrBlock.Find(file, header);
        Picture picture = PictureLimits.Allocate(header.Width, header.Height);
        ReadRows(file, header, blocks, (values, channel, y) =>
        {
            if (targets[channel] >= 0)
            {
                ReadChannel(values, header.Channels[channel], targets[channel], picture.Pixels.AsSpan(3 * y * header.Width, 3 * header.Width));
            }
        });
        return picture;
    }

    /// <summary>Reads one channel of a file by its name, such as <c>depth.Z</c>.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="name">The channel's name.</param>
    /// <returns>Its values, rows from top to bottom; every type's are exact.</returns>
    /// <exception cref="PictureException">As for <see cref="Read"/>, or there is no such channel with a value for every pixel.</exception>
    public static double[] ReadChannel(ReadOnlySpan<byte> file, string name)
    {
        ExrHeader header = ExrHeader.Parse(file);
        int wanted = header.Channels.ToList().FindIndex(c => c.Name == name && c is { StepX: 1, StepY: 1 });
        if (wanted < 0)
        {
            throw new PictureException($"it has no channel {name} with a value for every pixel");
        }

        ExrChannel channel = header.Channels[wanted];
        ExrBlock[] blocks = ExrBlock.Find(file, header);
        double[] all = new double[(long)header.Width * header.Height];
        ReadRows(file, header, blocks, (values, number, y) =>
        {
            for (int x = 0; number == wanted && x < header.Width; x++)
            {
                all[((long)y * header.Width) + x] = Value(values[(x * channel.ValueBytes)..], channel.Type);
            }
        });
        return all;
    }

    /// <summary>The names of the channels of a file that have a value for every pixel.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">The header is damaged or not of the kind that is read.</exception>
    public static IReadOnlyList<string> ChannelNames(ReadOnlySpan<byte> file) =>
        [.. ExrHeader.Parse(file).Channels.Where(c => c is { StepX: 1, StepY: 1 }).Select(c => c.Name)];

    /// <summary>Adds channels up to a picture.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="parts">By the name of a channel, to which channel of the picture it is added, from 0, and what it is multiplied by. Other channels are skipped.</param>
    /// <exception cref="PictureException">As for <see cref="Read"/>.</exception>
    public static Picture Sum(ReadOnlySpan<byte> file, IReadOnlyDictionary<string, (int Channel, float Factor)> parts)
    {
        ExrHeader header = ExrHeader.Parse(file);
        (int Channel, float Factor)[] targets =
            [.. header.Channels.Select(c => c is { StepX: 1, StepY: 1 } && parts.TryGetValue(c.Name, out (int, float) part) ? part : (-1, 0))];
        ExrBlock[] blocks = ExrBlock.Find(file, header);
        Picture picture = PictureLimits.Allocate(header.Width, header.Height);
        ReadRows(file, header, blocks, (values, number, y) =>
        {
            (int target, float factor) = targets[number];
            ExrChannel channel = header.Channels[number];
            for (int x = 0; target >= 0 && factor != 0 && x < header.Width; x++)
            {
                picture.Pixels[(3 * ((y * header.Width) + x)) + target] += factor * (float)Value(values[(x * channel.ValueBytes)..], channel.Type);
            }
        });
        return picture;
    }

    /// <summary>Reads the string attributes of a file that are not the format's own, in their order.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">The header is damaged or not of the kind that is read.</exception>
    public static IReadOnlyList<KeyValuePair<string, string>> ReadText(ReadOnlySpan<byte> file) => ExrHeader.Parse(file).Texts;

    // Where each channel goes: 0, 1, 2 red, green, blue; 3 all three; -1 nowhere.
    private static int[] Targets(ExrHeader header)
    {
        string[] names = [.. header.Channels.Select(channel => channel.Name)];
        bool grey = !names.Any(name => name is "R" or "G" or "B");
        string[] wanted = grey ? ["Y"] : ["R", "G", "B"];
        if (!wanted.All(names.Contains) || (grey && names.Any(name => name is "RY" or "BY")))
        {
            string list = string.Join(", ", names.Take(8)) + (names.Length > 8 ? ", …" : "");
            throw new PictureException($"it has the channels {list}, and only R, G and B, or Y alone, are read");
        }

        var targets = new int[names.Length];
        for (int i = 0; i < names.Length; i++)
        {
            targets[i] = grey && names[i] == "Y" ? 3 : Array.IndexOf(wanted, names[i]);
            ExrChannel channel = header.Channels[i];
            if (wanted.Contains(names[i]) && (channel.StepX != 1 || channel.StepY != 1 || names.Count(name => name == names[i]) > 1))
            {
                throw new PictureException($"its channel {names[i]} is not there once for every pixel");
            }

            targets[i] = wanted.Contains(names[i]) ? targets[i] : -1;
        }

        return targets;
    }

    // The bytes of a channel in a row, the channel's number, and the row.
    private delegate void RowOfChannel(ReadOnlySpan<byte> values, int channel, int y);

    private static void ReadRows(ReadOnlySpan<byte> file, ExrHeader header, ExrBlock[] blocks, RowOfChannel take)
    {
        foreach (ExrBlock block in blocks)
        {
            ReadOnlySpan<byte> packed = file.Slice(block.Offset, block.PackedBytes);
            ReadOnlySpan<byte> values = header.Compression == ExrFormat.Piz && packed.Length != block.Bytes
                ? PizDecoder.Decode(packed, header, block) ?? throw new PictureException("one of its blocks of pixels is damaged")
                : ExrBlockCodec.Decompress(header.Compression, packed, block.Bytes);
            for (int y = block.FirstRow; y < block.FirstRow + block.Rows; y++)
            {
                for (int c = 0; c < header.Channels.Count; c++)
                {
                    int bytes = (int)header.Channels[c].RowBytes(header.Top + y, header.Left, header.Left + header.Width - 1);
                    take(values[..bytes], c, y);
                    values = values[bytes..];
                }
            }
        }
    }

    private static void ReadChannel(ReadOnlySpan<byte> values, ExrChannel channel, int target, Span<float> row)
    {
        for (int i = 0; i < row.Length; i += 3)
        {
            float value = (float)Value(values, channel.Type);
            values = values[channel.ValueBytes..];
            if (target < 3)
            {
                row[i + target] = value;
            }
            else
            {
                row.Slice(i, 3).Fill(value);
            }
        }
    }

    private static double Value(ReadOnlySpan<byte> at, ExrPixelType type) => type switch
    {
        ExrPixelType.Half => (double)BinaryPrimitives.ReadHalfLittleEndian(at),
        ExrPixelType.Float => BinaryPrimitives.ReadSingleLittleEndian(at),
        _ => BinaryPrimitives.ReadUInt32LittleEndian(at),
    };
}
