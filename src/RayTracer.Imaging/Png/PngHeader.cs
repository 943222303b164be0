using System.Buffers.Binary;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>The IHDR chunk.</summary>
internal readonly record struct PngHeader(int Width, int Height, int BitDepth, PngColourType ColourType, bool Interlaced)
{
    /// <summary>Samples of one pixel.</summary>
    public int Samples => ColourType switch
    {
        PngColourType.Rgb => 3,
        PngColourType.GreyAlpha => 2,
        PngColourType.RgbAlpha => 4,
        _ => 1,
    };

    /// <summary>Bytes from one pixel to the next for the filters, at least 1.</summary>
    public int PixelBytes => Math.Max(1, Samples * BitDepth / 8);

    /// <summary>Bytes of a row of so many pixels, without its filter type.</summary>
    public int RowBytes(int width) => (int)((((long)width * Samples * BitDepth) + 7) / 8);

    public static PngHeader Parse(ReadOnlySpan<byte> data)
    {
        Require(data.Length == 13, $"its IHDR chunk has {data.Length} bytes instead of 13");

        uint width = BinaryPrimitives.ReadUInt32BigEndian(data);
        uint height = BinaryPrimitives.ReadUInt32BigEndian(data[4..]);
        PictureLimits.CheckSize(width, height);
        var type = (PngColourType)data[9];
        int depth = data[8];
        bool valid = type switch
        {
            PngColourType.Grey => depth is 1 or 2 or 4 or 8 or 16,
            PngColourType.Palette => depth is 1 or 2 or 4 or 8,
            PngColourType.Rgb or PngColourType.GreyAlpha or PngColourType.RgbAlpha => depth is 8 or 16,
            _ => false,
        };
        Require(valid, $"colour type {data[9]} with {depth} bits does not exist in PNG");

        if (data[10] != 0 || data[11] != 0 || data[12] > 1)
        {
            throw new PictureException($"compression {data[10]}, filter method {data[11]} and interlacing {data[12]} are not those of PNG (0, 0, and 0 or 1)");
        }

        return new PngHeader((int)width, (int)height, depth, type, data[12] == 1);
    }
}

/// <summary>The kinds of PNG pixels, with the specification's numbers.</summary>
internal enum PngColourType
{
    Grey = 0,
    Rgb = 2,
    Palette = 3,
    GreyAlpha = 4,
    RgbAlpha = 6,
}
