using System.Buffers.Binary;
using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>Takes a .glb file apart (glTF 2.0, section 4.4): a header, a chunk of JSON, and a chunk of bytes that may be missing.</summary>
internal static class GlbContainer
{
    private const uint Magic = 0x46546C67;
    private const uint JsonChunk = 0x4E4F534A;
    private const uint BinaryChunk = 0x004E4942;
    private const int HeaderBytes = 12;
    private const int ChunkHeaderBytes = 8;

    /// <summary>The offset of the JSON chunk's text, in bytes.</summary>
    public const int JsonStart = HeaderBytes + ChunkHeaderBytes;

    /// <summary>True where a file begins as a .glb file does.</summary>
    public static bool IsGlb(ReadOnlySpan<byte> file) => file.Length >= 4 && BinaryPrimitives.ReadUInt32LittleEndian(file) == Magic;

    /// <summary>Finds the chunks.</summary>
    /// <param name="file">The whole file.</param>
    /// <exception cref="ModelException">The file is cut off or is of another version.</exception>
    public static (ReadOnlyMemory<byte> Json, ReadOnlyMemory<byte>? Binary) Split(ReadOnlyMemory<byte> file)
    {
        static ModelException Error(int at, string message) => new($"byte {at}: {message}");

        if (file.Length < JsonStart)
        {
            throw Error(file.Length, $"the file ends within its header of {JsonStart} bytes");
        }

        uint version = Word(file, 4);
        if (version != 2)
        {
            throw Error(4, $"the container's version is {version}: only version 2 is read");
        }

        uint length = Word(file, 8);
        if (length > file.Length)
        {
            throw Error(8, $"the header claims {length} bytes, but the file has {file.Length}: it is cut off");
        }

        ReadOnlyMemory<byte>? json = null;
        ReadOnlyMemory<byte>? binary = null;
        for (int at = HeaderBytes; at + ChunkHeaderBytes <= length;)
        {
            uint size = Word(file, at);
            uint type = Word(file, at + 4);
            if (size > length - at - ChunkHeaderBytes)
            {
                throw Error(at, $"a chunk claims {size} bytes, but only {length - at - ChunkHeaderBytes} are left");
            }

            ReadOnlyMemory<byte> content = file.Slice(at + ChunkHeaderBytes, (int)size);
            if (at == HeaderBytes)
            {
                json = type == JsonChunk ? content : throw Error(at + 4, "the first chunk is not JSON");
            }
            else if (type == BinaryChunk)
            {
                binary ??= content;
            }

            at += ChunkHeaderBytes + (int)size;
        }

        return (json ?? throw Error(HeaderBytes, "there is no JSON chunk"), binary);
    }

    private static uint Word(ReadOnlyMemory<byte> file, int at) => BinaryPrimitives.ReadUInt32LittleEndian(file.Span[at..]);
}
