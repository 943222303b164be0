using System.Buffers.Binary;
using System.Text;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Walks over the chunks of a PNG file and checks each.</summary>
internal ref struct PngChunks
{
    private ReadOnlySpan<byte> _rest;

    public PngChunks(ReadOnlySpan<byte> file)
    {
        if (!file.StartsWith(PngReader.Signature))
        {
            throw new PictureException("it does not begin as a PNG file does");
        }

        _rest = file[PngReader.Signature.Length..];
        Type = "";
        Data = default;
    }

    /// <summary>The current chunk's four letters.</summary>
    public string Type { get; private set; }

    /// <summary>The current chunk's data.</summary>
    public ReadOnlySpan<byte> Data { get; private set; }

    /// <summary>Goes on to the next chunk; false after IEND.</summary>
    public bool Next()
    {
        if (Type == "IEND")
        {
            return false;
        }

        if (_rest.Length < 12)
        {
            throw new PictureException("the file is cut off: its IEND chunk is missing");
        }

        uint length = BinaryPrimitives.ReadUInt32BigEndian(_rest);
        ReadOnlySpan<byte> type = _rest.Slice(4, 4);
        Type = Encoding.Latin1.GetString(type);
        if (!Type.All(char.IsAsciiLetter))
        {
            throw new PictureException("a chunk's type does not consist of four letters: the file is damaged");
        }

        if (length > _rest.Length - 12)
        {
            throw new PictureException($"the file is cut off: its {Type} chunk claims {length} bytes, and {_rest.Length - 12} are left");
        }

        Data = _rest.Slice(8, (int)length);
        uint check = BinaryPrimitives.ReadUInt32BigEndian(_rest[(8 + (int)length)..]);
        if (check != Crc32.Of(type, Data))
        {
            throw new PictureException($"the checksum of its {Type} chunk is wrong: the file is damaged");
        }

        _rest = _rest[(12 + (int)length)..];
        return true;
    }
}
