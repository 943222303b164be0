using System.Buffers.Binary;
using System.Runtime.InteropServices;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>
/// Reads OpenEXR files of rows or tiles, of the latter the level of full size, with every compression but DWAA and DWAB; of several parts,
/// the first. Channels other than R, G, B (or a lone Y, which is grey; or those of a layer, where nothing stands outside of layers) are
/// skipped; chromaticities are ignored: the primaries are taken to be those of Rec. 709.
/// </summary>
public static class ExrReader
{
    private static readonly string[] s_pictureLayers = ["combined", "beauty", "rgb", "rgba"];

    /// <summary>The four bytes that an OpenEXR file begins with.</summary>
    public static ReadOnlySpan<byte> Signature => ExrFormat.Magic;

    /// <summary>Reads the data window of a picture.</summary>
    /// <param name="file">The whole file.</param>
    /// <returns>The values as linear RGB; half, float and unsigned integers all become floats, grey has three equal channels.</returns>
    /// <exception cref="PictureException">
    /// The file is no OpenEXR, is of another kind than said above, is damaged, or is beyond <see cref="PictureLimits"/>.
    /// </exception>
    public static Picture Read(ReadOnlySpan<byte> file)
    {
        ExrHeader header = ExrHeader.Parse(file);
        int[] targets = Targets(header);
        ExrBlock[] blocks = ExrBlock.Find(file, header);
        Picture picture = PictureLimits.Allocate(header.Width, header.Height);
        ReadRows(file, header, blocks, (values, channel, x, y) =>
        {
            if (targets[channel] >= 0)
            {
                int columns = values.Length / header.Channels[channel].ValueBytes;
                ReadChannel(values, header.Channels[channel], targets[channel], picture.Pixels.AsSpan(3 * ((y * header.Width) + x), 3 * columns));
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
        Require(wanted >= 0, $"it has no channel {name} with a value for every pixel");

        ExrChannel channel = header.Channels[wanted];
        ExrBlock[] blocks = ExrBlock.Find(file, header);
        double[] all = new double[(long)header.Width * header.Height];
        ReadRows(file, header, blocks, (values, number, x, y) =>
        {
            for (int i = 0; number == wanted && i < values.Length / channel.ValueBytes; i++)
            {
                all[((long)y * header.Width) + x + i] = Value(values[(i * channel.ValueBytes)..], channel.Type);
            }
        });
        return all;
    }

    /// <summary>Reads channels of unsigned integers, row by row; rows may come in any order.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="header">Its header.</param>
    /// <param name="names">The channels' names.</param>
    /// <param name="take">Takes a row's number, from the top, and the values of each channel in it, which do not stay.</param>
    /// <exception cref="PictureException">The file is damaged or one of tiles, or a channel is missing.</exception>
    internal static void ReadWords(ReadOnlySpan<byte> file, ExrHeader header, string[] names, Action<int, uint[][]> take)
    {
        Require(!header.IsTiled, "another program has rewritten it, with tiles, from which its integers are not read");

        if (names.FirstOrDefault(n => !header.Channels.Any(c => c is { StepX: 1, StepY: 1, Type: ExrPixelType.Uint } && c.Name == n)) is { } missing)
        {
            throw new PictureException($"it has no channel {missing} with an unsigned integer for every pixel: another program has rewritten it");
        }

        int[] targets = [.. header.Channels.Select(c => Array.IndexOf(names, c.Name))];
        uint[][] row = [.. names.Select(_ => new uint[header.Width])];
        ReadRows(file, header, ExrBlock.Find(file, header), (values, channel, _, y) =>
        {
            if (targets[channel] >= 0)
            {
                MemoryMarshal.Cast<byte, uint>(values).CopyTo(row[targets[channel]]);
            }

            if (channel == targets.Length - 1)
            {
                take(y, row);
            }
        });
    }

    /// <summary>The names of the channels of a file that have a value for every pixel.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">The header is damaged or not of the kind that is read.</exception>
    public static IReadOnlyList<string> ChannelNames(ReadOnlySpan<byte> file) =>
        [.. ExrHeader.Parse(file).Channels.Where(c => c is { StepX: 1, StepY: 1 }).Select(c => c.Name)];

    /// <summary>Reads the channels of a file that are not of its picture and have a value for every pixel.</summary>
    /// <param name="file">The whole file.</param>
    /// <returns>They can be written as they are. They are in memory, 8 bytes a value.</returns>
    /// <exception cref="PictureException">As for <see cref="Read"/>.</exception>
    public static IReadOnlyList<ExrLayerChannel> ReadLayers(ReadOnlySpan<byte> file)
    {
        ExrHeader header = ExrHeader.Parse(file);
        int[] targets = Targets(header);
        ILookup<string, ExrChannel> byName = header.Channels.ToLookup(c => c.Name);
        double[]?[] all = [.. header.Channels.Select((c, i) =>
            targets[i] < 0 && c is { StepX: 1, StepY: 1 } && byName[c.Name].Count() == 1 && ExrChannelRows.CanHold(c.Name) ? new double[(long)header.Width * header.Height] : null)];
        if (Array.TrueForAll(all, a => a is null))
        {
            return [];
        }

        ReadRows(file, header, ExrBlock.Find(file, header), (values, number, x, y) =>
        {
            ExrChannel channel = header.Channels[number];
            for (int i = 0; all[number] is { } own && i < values.Length / channel.ValueBytes; i++)
            {
                own[((long)y * header.Width) + x + i] = Value(values[(i * channel.ValueBytes)..], channel.Type);
            }
        });
        int width = header.Width;
        return [.. header.Channels.Zip(all).Where(c => c.Second is not null).Select(c => new ExrLayerChannel(c.First.Name, c.First.Type, (y, row) => c.Second.AsSpan(y * width, width).CopyTo(row.Span)))];
    }

    /// <summary>Adds channels up to a picture.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="parts">
    /// By the name of a channel, to which channel of the picture it is added, from 0, and what it is multiplied by. Other channels are
    /// skipped.
    /// </param>
    /// <exception cref="PictureException">As for <see cref="Read"/>.</exception>
    public static Picture Sum(ReadOnlySpan<byte> file, IReadOnlyDictionary<string, (int Channel, float Factor)> parts)
    {
        ExrHeader header = ExrHeader.Parse(file);
        (int Channel, float Factor)[] targets =
            [.. header.Channels.Select(c => c is { StepX: 1, StepY: 1 } && parts.TryGetValue(c.Name, out (int, float) part) ? part : (-1, 0))];
        ExrBlock[] blocks = ExrBlock.Find(file, header);
        Picture picture = PictureLimits.Allocate(header.Width, header.Height);
        ReadRows(file, header, blocks, (values, number, x, y) =>
        {
            (int target, float factor) = targets[number];
            ExrChannel channel = header.Channels[number];
            for (int i = 0; target >= 0 && factor != 0 && i < values.Length / channel.ValueBytes; i++)
            {
                picture.Pixels[(3 * ((y * header.Width) + x + i)) + target] += factor * (float)Value(values[(i * channel.ValueBytes)..], channel.Type);
            }
        });
        return picture;
    }

    /// <summary>Reads the string attributes of a file that are not the format's own, in their order.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">The header is damaged or not of the kind that is read.</exception>
    public static IReadOnlyList<KeyValuePair<string, string>> ReadText(ReadOnlySpan<byte> file) => ExrHeader.Parse(file).Texts;

    /// <summary>Reads what a file says of itself.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">The header is damaged or not of the kind that is read.</exception>
    internal static ImageDescription Describe(ReadOnlySpan<byte> file)
    {
        ExrHeader header = ExrHeader.Parse(file);
        string tiles = header.IsTiled ? $", tiles of {header.BlockWidth}×{header.BlockHeight}" : "";
        string parts = header.IsMultiPart ? ", first of several parts" : "";
        return new("OpenEXR", header.Width, header.Height, $"{ExrFormat.NameOf(header.Compression)}{tiles}{parts}", [.. header.Channels.Select(Channel)], header.Texts);

        static ImageChannel Channel(ExrChannel channel) => new(
            channel.Name, channel.Type switch { ExrPixelType.Half => "half", ExrPixelType.Float => "float", _ => ImageChannel.Integer }, 8 * channel.ValueBytes);
    }

    // Where each channel goes: 0, 1, 2 red, green, blue; 3 all three; -1 nowhere.
    private static int[] Targets(ExrHeader header)
    {
        string[] names = [.. header.Channels.Select(channel => channel.Name)];
        string layer = names.Any(name => !name.Contains('.', StringComparison.Ordinal)) ? "" : Layer(names);
        bool grey = !names.Any(name => name == $"{layer}R" || name == $"{layer}G" || name == $"{layer}B");
        string[] wanted = grey ? [$"{layer}Y"] : [$"{layer}R", $"{layer}G", $"{layer}B"];
        if (!wanted.All(names.Contains) || (grey && names.Any(name => name == $"{layer}RY" || name == $"{layer}BY")))
        {
            string list = string.Join(", ", names.Take(8)) + (names.Length > 8 ? ", …" : "");
            throw new PictureException($"it has the channels {list}, and only R, G and B, or Y alone, are read");
        }

        var targets = new int[names.Length];
        for (int i = 0; i < names.Length; i++)
        {
            targets[i] = grey ? 3 : Array.IndexOf(wanted, names[i]);
            ExrChannel channel = header.Channels[i];
            if (wanted.Contains(names[i]) && (channel.StepX != 1 || channel.StepY != 1 || names.Count(name => name == names[i]) > 1))
            {
                throw new PictureException($"its channel {names[i]} is not there once for every pixel");
            }

            targets[i] = wanted.Contains(names[i]) ? targets[i] : -1;
        }

        return targets;
    }

    // Where all channels belong to layers: the only one with colours, or the one that is called as programs call the picture itself.
    private static string Layer(string[] names)
    {
        string[] layers = [.. names.Where(name => name.EndsWith(".R", StringComparison.Ordinal)).Select(name => name[..^1])];
        string[] pictures = [.. layers.Where(layer => s_pictureLayers.Any(word => $".{layer}".EndsWith($".{word}.", StringComparison.OrdinalIgnoreCase)))];
        return layers is [var only] ? only : pictures is [var picture] ? picture : "";
    }

    // The bytes of a channel in a row of a block, the channel's number, the first column, and the row.
    private delegate void RowOfChannel(ReadOnlySpan<byte> values, int channel, int x, int y);

    private static void ReadRows(ReadOnlySpan<byte> file, ExrHeader header, ExrBlock[] blocks, RowOfChannel take)
    {
        foreach (ExrBlock block in blocks)
        {
            ReadOnlySpan<byte> values = Unpacked(file.Slice(block.Offset, block.PackedBytes), header, block);
            for (int y = 0; y < block.Rows; y++)
            {
                for (int c = 0; c < header.Channels.Count; c++)
                {
                    int bytes = block.RowBytes(header, header.Channels[c], y);
                    take(values[..bytes], c, block.FirstColumn, block.FirstRow + y);
                    values = values[bytes..];
                }
            }
        }
    }

    // What would not become smaller is stored as it is.
    private static ReadOnlySpan<byte> Unpacked(ReadOnlySpan<byte> packed, ExrHeader header, ExrBlock block)
    {
        bool isOwn = header.Compression > ExrCompression.Zip && packed.Length != block.Bytes;
        byte[]? restored = !isOwn ? null : header.Compression switch
        {
            ExrFormat.Piz => PizDecoder.Decode(packed, header, block),
            ExrFormat.Pxr24 => Pxr24Decoder.Decode(packed, header, block),
            _ => B44Decoder.Decode(packed, header, block),
        };
        return isOwn ? restored ?? throw new PictureException("one of its blocks of pixels is damaged") : ExrBlockCodec.Decompress(header.Compression, packed, block.Bytes);
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
