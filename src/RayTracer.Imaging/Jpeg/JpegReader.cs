using System.Buffers.Binary;
using System.Text;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>
/// Reads JPEG files (ITU-T T.81): baseline, extended of 8 bits and progressive, all with Huffman codes; any sampling factors;
/// grey, YCbCr, RGB, CMYK and YCCK. Colours are taken to be sRGB: ICC profiles are ignored, and so is the orientation that Exif
/// may hold, as glTF 2.0 (section 3.8.3) demands.
/// </summary>
internal static class JpegReader
{
    // Encoders make some ten or twenty; very many, over a large picture of few bytes, would take hours.
    private const int MostScans = 500;

    private const int StartOfImage = 0xD8;
    private const int EndOfImage = 0xD9;
    private const int StartOfScan = 0xDA;
    private const int Comment = 0xFE;

    /// <summary>The bytes that a JPEG file begins with: SOI, and the begin of another marker.</summary>
    public static ReadOnlySpan<byte> Signature => [0xFF, StartOfImage, 0xFF];

    /// <summary>Reads a picture.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="raw">True where the values are data, to be divided by 255, rather than sRGB-encoded colours.</param>
    /// <returns>Linear RGB from 0 to 1, or the raw values from 0 to 1; grey has three equal channels.</returns>
    /// <exception cref="PictureException">
    /// The file is no JPEG, is damaged, of a kind that is not read, or beyond <see cref="PictureLimits"/>.
    /// </exception>
    public static Picture Read(ReadOnlySpan<byte> file, bool raw = false)
    {
        Require(file.StartsWith(Signature), "it does not begin as a JPEG file does");
        var state = new State();
        int position = 2;
        while (NextMarker(file, ref position) is int marker && marker != EndOfImage)
        {
            ReadOnlySpan<byte> data = Segment(file, marker, ref position);
            if (marker == StartOfScan)
            {
                position = ReadScan(state, file, data, position);
            }
            else
            {
                ReadSegment(state, marker, data);
            }
        }

        JpegFrame frame = state.Frame ?? throw new PictureException("it has no frame header: there is no picture in it");
        Require(Array.TrueForAll(frame.Components, c => c.LastBit[0] >= 0), "the file is cut off, or holds only a part of its components");
        Picture picture = PictureLimits.Allocate(frame.Width, frame.Height, filled: true);
        Array.ForEach(frame.Components, c => c.Reconstruct());
        new JpegColours(frame, state.ColourSpace(), state.HasAdobe, raw).Convert(picture);
        return picture;
    }

    /// <summary>
    /// Reads the comments (COM) that a file carries before its image data: <c>key: value</c>, or a text that is called "Comment".
    /// </summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">The file is no JPEG, or is damaged.</exception>
    public static IReadOnlyList<KeyValuePair<string, string>> ReadText(ReadOnlySpan<byte> file)
    {
        Require(file.StartsWith(Signature), "it does not begin as a JPEG file does");
        List<KeyValuePair<string, string>> texts = [];
        int position = 2;
        while (NextMarker(file, ref position) is int marker && marker is not (EndOfImage or StartOfScan))
        {
            ReadOnlySpan<byte> data = Segment(file, marker, ref position);
            if (marker == Comment)
            {
                string text = Encoding.UTF8.GetString(data).TrimEnd('\0');
                int colon = text.IndexOf(": ", StringComparison.Ordinal);
                KeyValuePair<string, string> read = colon > 0 ? new(text[..colon], text[(colon + 2)..]) : new("Comment", text);
                if (texts is [.., var last] && read.Key == last.Key + JpegWriter.Continued)
                {
                    texts[^1] = new(last.Key, last.Value + read.Value);
                }
                else
                {
                    texts.Add(read);
                }
            }
        }

        return texts;
    }

    /// <summary>Reads what a file says of itself.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">As for <see cref="Read"/>.</exception>
    internal static ImageDescription Describe(ReadOnlySpan<byte> file)
    {
        Require(file.StartsWith(Signature), "it does not begin as a JPEG file does");
        State state = new();
        int position = 2;
        while (NextMarker(file, ref position) is int marker && marker is not (EndOfImage or StartOfScan))
        {
            ReadSegment(state, marker, Segment(file, marker, ref position));
        }

        JpegFrame frame = state.Frame ?? throw new PictureException("it has no frame header: there is no picture in it");
        string[] names = state.ColourSpace() switch
        {
            JpegColourSpace.Grey => ["Y"],
            JpegColourSpace.Rgb => ["R", "G", "B"],
            JpegColourSpace.YCbCr => ["Y", "Cb", "Cr"],
            JpegColourSpace.Ycck => ["Y", "Cb", "Cr", "K"],
            _ => ["C", "M", "Y", "K"],
        };
        string compression = $"{(frame.IsProgressive ? "progressive" : "baseline")} DCT{(names.Length == 3 ? $", chroma {Chroma(frame.Components)}" : "")}";
        return new("JPEG", frame.Width, frame.Height, compression, ImageChannel.Of(ImageChannel.Integer, 8, names), ReadText(file));
    }

    private static string Chroma(JpegComponent[] components) =>
        (components[0].Horizontal / (double)components[1].Horizontal, components[0].Vertical / (double)components[1].Vertical) switch
        {
            (1, 1) => "4:4:4",
            (2, 1) => "4:2:2",
            (2, 2) => "4:2:0",
            (4, 1) => "4:1:1",
            (1, 2) => "4:4:0",
            _ => $"of {string.Join(", ", components.Select(c => $"{c.Horizontal}×{c.Vertical}"))}",
        };

    // What stands before a scan and holds for it.
    private sealed class State
    {
        public JpegFrame? Frame { get; set; }

        public float[]?[] Quantization { get; } = new float[]?[4];

        public JpegHuffmanTable?[] Huffman { get; } = new JpegHuffmanTable?[8];

        public int RestartInterval { get; set; }

        public int Scans { get; set; }

        public bool HasJfif { get; set; }

        public bool HasAdobe { get; set; }

        public int AdobeTransform { get; set; }

        // JFIF is always YCbCr; then Adobe's marker decides; then names of components (as libjpeg decides).
        public JpegColourSpace ColourSpace()
        {
            JpegComponent[] components = Frame!.Components;
            if (components.Length == 1)
            {
                return JpegColourSpace.Grey;
            }

            if (components.Length == 4)
            {
                return HasAdobe && AdobeTransform == 2 ? JpegColourSpace.Ycck : JpegColourSpace.Cmyk;
            }

            bool isNamedRgb = components[0].Id == 'R' && components[1].Id == 'G' && components[2].Id == 'B';
            bool isRgb = !HasJfif && (HasAdobe ? AdobeTransform == 0 : isNamedRgb);
            return isRgb ? JpegColourSpace.Rgb : JpegColourSpace.YCbCr;
        }
    }

    // The second byte of the next marker, past which the position goes; null at the end of the file, which may lack its own marker.
    private static int? NextMarker(ReadOnlySpan<byte> file, ref int position)
    {
        for (; position + 1 < file.Length; position++)
        {
            if (file[position] == 0xFF && file[position + 1] is not (0 or 0xFF))
            {
                position += 2;
                return file[position - 1];
            }
        }

        return null;
    }

    private static ReadOnlySpan<byte> Segment(ReadOnlySpan<byte> file, int marker, ref int position)
    {
        bool isAlone = marker is 0x01 or (>= 0xD0 and <= 0xD8);
        if (isAlone)
        {
            return [];
        }

        Require(file.Length - position >= 2, $"the file is cut off in a marker at byte {position}");
        int length = BinaryPrimitives.ReadUInt16BigEndian(file[position..]);
        Require(length >= 2 && length <= file.Length - position, $"the file is cut off or damaged: a segment of {length} bytes begins at byte {position}, and {file.Length - position} are left");
        ReadOnlySpan<byte> data = file.Slice(position + 2, length - 2);
        position += length;
        return data;
    }

    private static void ReadSegment(State state, int marker, ReadOnlySpan<byte> data)
    {
        switch (marker)
        {
            case 0xC0 or 0xC1 or 0xC2:
                Require(state.Frame is null, "it has two frame headers");
                state.Frame = JpegFrame.Parse(marker, data);
                break;
            case 0xC4:
                ReadHuffmanTables(state, data);
                break;
            case 0xC3:
                throw new PictureException("it is compressed losslessly (JPEG process 14), which is not read");
            case (>= 0xC9 and <= 0xCB) or 0xCC:
                throw new PictureException("it is arithmetically coded, which is not read: only JPEG files with Huffman codes are");
            case (>= 0xC5 and <= 0xC7) or (>= 0xCD and <= 0xCF) or 0xDE:
                throw new PictureException("it is hierarchical, which is not read: only baseline and progressive JPEG files are");
            case 0xDB:
                ReadQuantizationTables(state, data);
                break;
            case 0xDD:
                Require(data.Length == 2, "its restart interval has the wrong length");
                state.RestartInterval = BinaryPrimitives.ReadUInt16BigEndian(data);
                break;
            case 0xE0:
                state.HasJfif |= data.StartsWith("JFIF\0"u8);
                break;
            case 0xEE when data.Length >= 12 && data.StartsWith("Adobe"u8):
                state.HasAdobe = true;
                state.AdobeTransform = data[11];
                break;
        }
    }

    private static int ReadScan(State state, ReadOnlySpan<byte> file, ReadOnlySpan<byte> data, int position)
    {
        JpegFrame frame = state.Frame ?? throw new PictureException("it has a scan before its frame header");
        Require(++state.Scans <= MostScans, $"it has more than {MostScans} scans");

        // Each block has a bit at least: so few bytes cannot be so large a picture.
        Require(frame.Blocks / frame.Components.Length / 8 <= file.Length, $"{file.Length} bytes cannot hold its {frame.Width}×{frame.Height} pixels");
        var scan = new JpegScan(frame, data, state.Huffman, state.RestartInterval);
        foreach (JpegComponent component in frame.Components)
        {
            component.LatchQuantization(state.Quantization);
        }

        return scan.Read(file, position);
    }

    private static void ReadQuantizationTables(State state, ReadOnlySpan<byte> data)
    {
        while (!data.IsEmpty)
        {
            bool isWide = data[0] >> 4 != 0;
            int table = data[0] & 15;
            int bytes = isWide ? 128 : 64;
            Require(data[0] >> 4 <= 1 && table < 4 && data.Length > bytes, "one of its quantization tables is damaged");
            var steps = new float[JpegComponent.BlockSize];
            for (int i = 0; i < steps.Length; i++)
            {
                steps[JpegScan.PlaceOf(i)] = isWide ? BinaryPrimitives.ReadUInt16BigEndian(data[(1 + (2 * i))..]) : data[1 + i];
            }

            state.Quantization[table] = steps;
            data = data[(1 + bytes)..];
        }
    }

    private static void ReadHuffmanTables(State state, ReadOnlySpan<byte> data)
    {
        while (!data.IsEmpty)
        {
            Require(data.Length > JpegHuffmanTable.LongestCode, "one of its Huffman tables is damaged");
            ReadOnlySpan<byte> counts = data.Slice(1, JpegHuffmanTable.LongestCode);
            int symbols = 0;
            foreach (byte count in counts)
            {
                symbols += count;
            }

            (int kind, int table) = (data[0] >> 4, data[0] & 15);
            int length = 1 + JpegHuffmanTable.LongestCode + symbols;
            Require(kind <= 1 && table < 4 && symbols <= 256 && data.Length >= length, "one of its Huffman tables is damaged");
            state.Huffman[(4 * kind) + table] = new JpegHuffmanTable(counts, data[(1 + JpegHuffmanTable.LongestCode)..length]);
            data = data[length..];
        }
    }
}
