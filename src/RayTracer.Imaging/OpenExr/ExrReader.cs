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
        foreach (ExrBlock block in blocks)
        {
            ReadOnlySpan<byte> packed = file.Slice(block.Offset, block.PackedBytes);
            ReadOnlySpan<byte> values = ExrBlockCodec.Decompress(header.Compression, packed, block.Bytes);
            for (int y = block.FirstRow; y < block.FirstRow + block.Rows; y++)
            {
                values = ReadRow(values, header, targets, y, picture.Pixels.AsSpan(3 * y * header.Width, 3 * header.Width));
            }
        }

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

    // Returns what is left of the block after the row.
    private static ReadOnlySpan<byte> ReadRow(ReadOnlySpan<byte> values, ExrHeader header, int[] targets, int y, Span<float> row)
    {
        for (int c = 0; c < targets.Length; c++)
        {
            ExrChannel channel = header.Channels[c];
            int bytes = (int)channel.RowBytes(header.Top + y, header.Left, header.Left + header.Width - 1);
            if (targets[c] >= 0)
            {
                ReadChannel(values[..bytes], channel, targets[c], row);
            }

            values = values[bytes..];
        }

        return values;
    }

    private static void ReadChannel(ReadOnlySpan<byte> values, ExrChannel channel, int target, Span<float> row)
    {
        for (int i = 0; i < row.Length; i += 3)
        {
            float value = channel.Type switch
            {
                ExrPixelType.Half => (float)BinaryPrimitives.ReadHalfLittleEndian(values),
                ExrPixelType.Float => BinaryPrimitives.ReadSingleLittleEndian(values),
                _ => BinaryPrimitives.ReadUInt32LittleEndian(values),
            };
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
}
