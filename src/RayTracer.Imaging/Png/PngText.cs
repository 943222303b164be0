using System.IO.Compression;
using System.Text;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>The text chunks of PNG (W3C PNG specification, section 11.3.3).</summary>
internal static class PngText
{
    /// <summary>Reads a tEXt, zTXt or iTXt chunk.</summary>
    public static KeyValuePair<string, string> Parse(string type, ReadOnlySpan<byte> data)
    {
        string key = Encoding.Latin1.GetString(CutAtNul(ref data, type));
        if (type == "tEXt")
        {
            return new(key, Encoding.Latin1.GetString(Limited(data, key)));
        }

        bool compressed = type == "zTXt";
        int methodAt = compressed ? 0 : 1;
        if (data.Length <= methodAt || data[methodAt] != 0 || data[0] > 1)
        {
            throw new PictureException($"its text '{key}' is compressed in a way that does not exist in PNG");
        }

        if (type == "iTXt")
        {
            compressed = data[0] == 1;
        }

        data = data[(methodAt + 1)..];
        if (type == "zTXt")
        {
            return new(key, Encoding.Latin1.GetString(Inflate(data, key)));
        }

        CutAtNul(ref data, type); // the language
        CutAtNul(ref data, type); // the key in that language
        return new(key, Encoding.UTF8.GetString(compressed ? Inflate(data, key) : Limited(data, key)));
    }

    private static ReadOnlySpan<byte> CutAtNul(ref ReadOnlySpan<byte> data, string type)
    {
        int end = data.IndexOf((byte)0);
        Require(end >= 0, $"one of its {type} chunks does not separate key and text");

        ReadOnlySpan<byte> head = data[..end];
        data = data[(end + 1)..];
        return head;
    }

    private static ReadOnlySpan<byte> Limited(ReadOnlySpan<byte> text, string key)
    {
        Require(text.Length <= PictureLimits.MaxTextBytes, $"its text '{key}' has more than {PictureLimits.MaxTextBytes} bytes");

        return text;
    }

    private static ReadOnlySpan<byte> Inflate(ReadOnlySpan<byte> data, string key)
    {
        using var source = new MemoryStream(data.ToArray());
        using var zlib = new ZLibStream(source, CompressionMode.Decompress);
        using var text = new MemoryStream();
        var part = new byte[4096];
        try
        {
            for (int count = zlib.Read(part); count > 0; count = zlib.Read(part))
            {
                text.Write(part, 0, count);
                Limited(text.GetBuffer().AsSpan(0, (int)text.Length), key);
            }
        }
        catch (Exception e) when (e is InvalidDataException or IOException)
        {
            throw new PictureException($"its compressed text '{key}' is damaged", e);
        }

        return text.ToArray();
    }
}
