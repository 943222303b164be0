using System.Buffers.Binary;
using System.IO.Compression;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>
/// Reads PNG files (W3C PNG specification, third edition): every colour type, bit depth and interlacing. Transparency is
/// ignored (the colour under it is what counts) unless it is asked for, and so are gAMA, cHRM and iCCP: colours are taken to be sRGB.
/// </summary>
internal static class PngReader
{
    /// <summary>The eight bytes that a PNG file begins with.</summary>
    public static ReadOnlySpan<byte> Signature => [0x89, (byte)'P', (byte)'N', (byte)'G', 0x0D, 0x0A, 0x1A, 0x0A];

    /// <summary>Reads a picture.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="raw">True where the values are data, to be divided by the largest code, rather than sRGB-encoded colours.</param>
    /// <returns>Linear RGB from 0 to 1, or the raw values from 0 to 1; grey has three equal channels.</returns>
    /// <exception cref="PictureException">The file is no PNG, is damaged, or is beyond <see cref="PictureLimits"/>.</exception>
    public static Picture Read(ReadOnlySpan<byte> file, bool raw = false) => Read(file, raw, ofAlpha: false);

    /// <summary>Reads how opaque a picture's pixels are.</summary>
    /// <param name="file">The whole file.</param>
    /// <returns>0 for transparent to 1 for opaque, in all three channels; null where the file has no channel for that.</returns>
    /// <exception cref="PictureException">As for <see cref="Read(ReadOnlySpan{byte}, bool)"/>.</exception>
    public static Picture? ReadAlpha(ReadOnlySpan<byte> file)
    {
        var chunks = new PngChunks(file);
        chunks.Next();
        bool has = chunks.Type == "IHDR" && PngHeader.Parse(chunks.Data).ColourType is PngColourType.GreyAlpha or PngColourType.RgbAlpha;
        return has ? Read(file, raw: true, ofAlpha: true) : null;
    }

    private static Picture Read(ReadOnlySpan<byte> file, bool raw, bool ofAlpha)
    {
        var chunks = new PngChunks(file);
        chunks.Next();
        Require(chunks.Type == "IHDR", $"its first chunk is {chunks.Type} instead of IHDR");

        PngHeader header = PngHeader.Parse(chunks.Data);
        using var compressed = new MemoryStream();
        byte[]? palette = ReadChunks(ref chunks, header, compressed);
        CheckPlausible(header, compressed.Length);
        compressed.Position = 0;
        try
        {
            using var zlib = new ZLibStream(compressed, CompressionMode.Decompress);
            return Decode(zlib, header, new PngPixels(header, palette, raw, ofAlpha));
        }
        catch (Exception e) when (e is InvalidDataException or IOException)
        {
            throw new PictureException("its compressed image data is damaged", e);
        }
    }

    /// <summary>Reads the texts that a file carries (tEXt, zTXt and iTXt chunks), in their order.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">The file is no PNG or is damaged, or a text is beyond <see cref="PictureLimits"/>.</exception>
    public static IReadOnlyList<KeyValuePair<string, string>> ReadText(ReadOnlySpan<byte> file)
    {
        var texts = new List<KeyValuePair<string, string>>();
        var chunks = new PngChunks(file);
        long characters = 0;
        while (chunks.Next())
        {
            if (chunks.Type is "tEXt" or "zTXt" or "iTXt")
            {
                texts.Add(PngText.Parse(chunks.Type, chunks.Data));
                characters += texts[^1].Value.Length;
                Require(characters <= PictureLimits.MaxTextBytes, $"its texts have more than {PictureLimits.MaxTextBytes} characters together");
            }
        }

        return texts;
    }

    /// <summary>Reads what a file says of itself.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="PictureException">As for <see cref="ReadText"/>.</exception>
    internal static ImageDescription Describe(ReadOnlySpan<byte> file)
    {
        PngHeader? header = null;
        int frames = 1;
        PngChunks chunks = new(file);
        while (chunks.Next())
        {
            header ??= chunks.Type == "IHDR" ? PngHeader.Parse(chunks.Data) : throw new PictureException($"its first chunk is {chunks.Type} instead of IHDR");
            frames = chunks.Type == "acTL" && chunks.Data.Length == 8 ? BinaryPrimitives.ReadInt32BigEndian(chunks.Data) : frames;
        }

        (string type, string[] names) = header!.Value.ColourType switch
        {
            PngColourType.Grey => (ImageChannel.Integer, ["Y"]),
            PngColourType.GreyAlpha => (ImageChannel.Integer, ["Y", "A"]),
            PngColourType.Palette => ("index of a palette", new[] { "RGB" }),
            PngColourType.Rgb => (ImageChannel.Integer, ["R", "G", "B"]),
            _ => (ImageChannel.Integer, ["R", "G", "B", "A"]),
        };
        return new("PNG", header.Value.Width, header.Value.Height, header.Value.Interlaced ? "Deflate, interlaced" : "Deflate", ImageChannel.Of(type, header.Value.BitDepth, names), ReadText(file))
        {
            Frames = Math.Max(frames, 1),
        };
    }

    // Reads all chunks after IHDR; returns the palette, if any.
    private static byte[]? ReadChunks(ref PngChunks chunks, PngHeader header, MemoryStream compressed)
    {
        byte[]? palette = null;
        string before = "IHDR";
        bool hasData = false;
        while (chunks.Next())
        {
            bool critical = char.IsAsciiLetterUpper(chunks.Type[0]);
            switch (chunks.Type)
            {
                case "PLTE":
                    Require(palette is null && !hasData, "its PLTE chunk is repeated or comes after the image data");
                    palette = ReadPalette(chunks.Data, header);
                    break;
                case "tRNS":
                    Require(!hasData, "its tRNS chunk comes after the image data");
                    CheckTransparency(chunks.Data, header, palette);
                    break;
                case "IDAT":
                    Require(!hasData || before == "IDAT", "other chunks stand between its IDAT chunks");
                    Require(palette is not null || header.ColourType != PngColourType.Palette, "it has no PLTE chunk before its image data");
                    hasData = true;
                    compressed.Write(chunks.Data);
                    break;
                case "IEND":
                    break;
                default:
                    Require(!critical, $"its chunk {chunks.Type} must be understood to show the picture, and is not a chunk of PNG at this place");
                    break;
            }

            before = chunks.Type;
        }

        Require(hasData, "it has no image data (no IDAT chunk)");
        return palette;
    }

    private static byte[] ReadPalette(ReadOnlySpan<byte> data, PngHeader header)
    {
        Require(header.ColourType is not (PngColourType.Grey or PngColourType.GreyAlpha), "a grey picture cannot have a palette");
        int largest = header.ColourType == PngColourType.Palette ? 1 << header.BitDepth : 256;
        Require(data.Length % 3 == 0 && data.Length >= 3 && data.Length <= 3 * largest, $"its palette has {data.Length} bytes instead of 3 for each of 1 to {largest} colours");
        return data.ToArray();
    }

    private static void CheckTransparency(ReadOnlySpan<byte> data, PngHeader header, byte[]? palette)
    {
        bool valid = header.ColourType switch
        {
            PngColourType.Grey => data.Length == 2,
            PngColourType.Rgb => data.Length == 6,
            PngColourType.Palette => palette is not null && data.Length <= palette.Length / 3,
            _ => false,
        };
        Require(valid, "its tRNS chunk does not fit its colour type or palette");
    }

    private static void CheckPlausible(PngHeader header, long compressedBytes)
    {
        long needed = 0;
        foreach (PngPass pass in PngPass.Of(header))
        {
            needed += (long)pass.Height * (1 + header.RowBytes(pass.Width));
        }

        Require(needed <= compressedBytes * PictureLimits.MaxDeflateRatio, $"{compressedBytes} bytes of compressed data cannot hold its {header.Width}×{header.Height} pixels");
    }

    private static Picture Decode(ZLibStream zlib, PngHeader header, PngPixels pixels)
    {
        // The first row is unpacked before the picture is made, so that data that is no deflate stream costs nothing.
        Picture? picture = null;
        foreach (PngPass pass in PngPass.Of(header))
        {
            var row = new byte[1 + header.RowBytes(pass.Width)];
            var above = new byte[row.Length];
            for (int y = 0; y < pass.Height; y++)
            {
                Require(zlib.ReadAtLeast(row, row.Length, throwOnEndOfStream: false) == row.Length, "its image data ends before its last row");
                Require(row[0] < PngFilter.Count, "it uses a row filter that does not exist in PNG");
                PngFilter.Undo(row[0], row.AsSpan(1), above.AsSpan(1), header.PixelBytes);
                picture ??= PictureLimits.Allocate(header.Width, header.Height);
                pixels.Expand(row.AsSpan(1), pass, y, picture);
                (row, above) = (above, row);
            }
        }

        zlib.ReadByte(); // reaches the checksum at the end, which is verified there
        return picture!;
    }
}
