using System.Buffers.Binary;
using System.Text;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>Walks over the chunks of a PNG file and checks each.</summary>
internal ref struct PngChunks
{
    private ReadOnlySpan<byte> _rest;

    public PngChunks(ReadOnlySpan<byte> file)
    {
        Require(file.StartsWith(PngReader.Signature), "it does not begin as a PNG file does");

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

        Require(_rest.Length >= 12, "the file is cut off: its IEND chunk is missing");

        uint length = BinaryPrimitives.ReadUInt32BigEndian(_rest);
        ReadOnlySpan<byte> type = _rest.Slice(4, 4);
        Type = Encoding.Latin1.GetString(type);
        Require(Type.All(char.IsAsciiLetter), "a chunk's type does not consist of four letters: the file is damaged");

        if (length > _rest.Length - 12)
        {
            throw new PictureException($"the file is cut off: its {Type} chunk claims {length} bytes, and {_rest.Length - 12} are left");
        }

        Data = _rest.Slice(8, (int)length);
        uint check = BinaryPrimitives.ReadUInt32BigEndian(_rest[(8 + (int)length)..]);
        Require(check == Crc32.Of(type, Data), $"the checksum of its {Type} chunk is wrong: the file is damaged");

        _rest = _rest[(12 + (int)length)..];
        return true;
    }
}
