using System.Buffers.Binary;
using System.Text;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>Reads the parts of an OpenEXR header one after another.</summary>
internal ref struct ExrBytes(ReadOnlySpan<byte> all)
{
    private readonly ReadOnlySpan<byte> _all = all;

    public int Position { get; private set; }

    public readonly int Left => _all.Length - Position;

    public ReadOnlySpan<byte> Bytes(int count)
    {
        Require(count <= Left, "the file is cut off within its header");

        Position += count;
        return _all.Slice(Position - count, count);
    }

    public int Int() => BinaryPrimitives.ReadInt32LittleEndian(Bytes(4));

    /// <summary>A text that NUL ends, of at most 255 bytes.</summary>
    public string Name()
    {
        ReadOnlySpan<byte> rest = _all[Position..];
        int length = rest[..Math.Min(rest.Length, ExrFormat.LongName + 1)].IndexOf((byte)0);
        Require(length >= 0, "its header is cut off, or holds a name of more than 255 bytes");

        Position += length + 1;
        return Printable(rest[..length]);
    }

    /// <summary>A text, with question marks for control characters, which have no place in messages.</summary>
    public static string Printable(ReadOnlySpan<byte> bytes)
    {
        string text = Encoding.UTF8.GetString(bytes);
        return text.Any(char.IsControl) ? string.Concat(text.Select(c => char.IsControl(c) ? '?' : c)) : text;
    }
}
