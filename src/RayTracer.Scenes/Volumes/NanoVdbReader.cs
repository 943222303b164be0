using System.Buffers.Binary;
using System.IO.Compression;
using System.Text;
using RayTracer.Description;
using RayTracer.Media;

namespace RayTracer.Scenes;

/// <summary>
/// Reads grids of floats from NanoVDB's files (Museth 2021): segments, each with a header, what is known of its grids, and the grids themselves, as they are or as ZIP.
/// </summary>
internal static class NanoVdbReader
{
    private const ulong FileMagic = 0x304244566f6e614e;
    private const ulong NewFileMagic = 0x324244566f6e614e;
    private const int SegmentHeader = 16;
    private const int MetaData = 176;
    private const int MostGrids = 1000;
    private static readonly string[] s_codecs = ["none", "ZIP", "Blosc"];

    // The numbers of kinds of values; 1 is what is read.
    private static readonly string[] s_types =
        ["nothing", "float", "double", "int16", "int32", "int64", "vec3f", "vec3d", "mask", "half", "uint32", "boolean", "rgba8", "fp4", "fp8", "fp16", "fpN", "vec4f", "vec4d", "index"];

    /// <summary>Reads a grid.</summary>
    /// <param name="bytes">The file.</param>
    /// <param name="name">Its name; empty for the first of floats.</param>
    public static VolumeGrid Read(ReadOnlySpan<byte> bytes, string name)
    {
        List<string> others = [];
        if (Find(bytes, name, others, out int codec, out long size) is { } place)
        {
            return NanoVdbTree.Read(Unpacked(bytes[place], codec, size));
        }

        string has = others.Count == 0 ? "it has none" : $"it has {string.Join(", ", others.Take(10))}";
        throw new VolumeException(name.Length == 0 ? $"it has no grid of floats: {has}" : $"it has no grid of floats called {Quotation.Of(name)}: {has}");
    }

    /// <summary>True where a file has a grid of floats of a name.</summary>
    public static bool Has(ReadOnlySpan<byte> bytes, string name) => Find(bytes, name, [], out _, out _) is not null;

    private static Range? Find(ReadOnlySpan<byte> bytes, string name, List<string> others, out int codec, out long size)
    {
        (codec, size) = (0, 0);
        int at = 0;
        while (at < bytes.Length && others.Count < MostGrids)
        {
            (codec, int count) = Segment(Part(bytes, at, SegmentHeader));
            at += SegmentHeader;
            (long Stored, long Size, uint Type, string Name)[] grids = new (long, long, uint, string)[count];
            for (int i = 0; i < count; i++)
            {
                grids[i] = Grid(bytes, ref at);
            }

            foreach ((long stored, long unpacked, uint type, string own) in grids)
            {
                _ = Part(bytes, at, stored);
                if ((name.Length == 0 || name == own) && type == 1)
                {
                    size = unpacked;
                    return at..(at + (int)stored);
                }

                others.Add($"{Quotation.Of(own)} ({(type < s_types.Length ? s_types[type] : $"kind {type}")})");
                at += (int)stored;
            }
        }

        return null;
    }

    private static (int Codec, int Count) Segment(ReadOnlySpan<byte> header)
    {
        ulong magic = BinaryPrimitives.ReadUInt64LittleEndian(header);
        if (magic is not (FileMagic or NewFileMagic))
        {
            throw new VolumeException("it is not one of NanoVDB's files: a part of it does not begin with NanoVDB0 or NanoVDB2");
        }

        int codec = BinaryPrimitives.ReadUInt16LittleEndian(header[14..]);
        int count = BinaryPrimitives.ReadUInt16LittleEndian(header[12..]);
        if (codec > 1)
        {
            string called = codec < s_codecs.Length ? s_codecs[codec] : $"codec {codec}";
            throw new VolumeException($"it is compressed with {called}, which is not read: write it uncompressed, or with ZIP (nanovdb_convert --zip)");
        }

        return count is > 0 and <= MostGrids ? (codec, count) : throw new VolumeException($"a part of it says that it has {count} grids");
    }

    private static (long Stored, long Size, uint Type, string Name) Grid(ReadOnlySpan<byte> bytes, ref int at)
    {
        ReadOnlySpan<byte> meta = Part(bytes, at, MetaData);
        long size = BinaryPrimitives.ReadInt64LittleEndian(meta);
        long stored = BinaryPrimitives.ReadInt64LittleEndian(meta[8..]);
        uint type = BinaryPrimitives.ReadUInt32LittleEndian(meta[32..]);
        long length = BinaryPrimitives.ReadUInt32LittleEndian(meta[136..]);
        string name = Encoding.UTF8.GetString(Part(bytes, (long)at + MetaData, length)).TrimEnd('\0');
        at += MetaData + (int)length;
        return (stored, size, type, name);
    }

    private static ReadOnlySpan<byte> Unpacked(ReadOnlySpan<byte> data, int codec, long size)
    {
        if (codec == 0)
        {
            return data;
        }

        // ZIP cannot make more than about a thousand bytes of one.
        long packed = BinaryPrimitives.ReadInt64LittleEndian(Part(data, 0, sizeof(long)));
        ReadOnlySpan<byte> zip = Part(data, sizeof(long), packed);
        if (size < 0 || size > Array.MaxLength || size / 1032 > zip.Length)
        {
            throw new VolumeException($"a grid of {size:N0} bytes cannot come from {zip.Length:N0}");
        }

        if (SceneBudget.Open?.TakeWork("a grid", size, size) is { } tooMuch)
        {
            throw new VolumeException(tooMuch);
        }

        byte[] unpacked = new byte[size];
        try
        {
            using ZLibStream stream = new(new MemoryStream(zip.ToArray()), CompressionMode.Decompress);
            stream.ReadExactly(unpacked);
        }
        catch (Exception e) when (e is InvalidDataException or EndOfStreamException)
        {
            throw new VolumeException("its ZIP data are damaged, or too short", e);
        }

        return unpacked;
    }

    /// <summary>A part of a file.</summary>
    /// <exception cref="VolumeException">It does not lie within the file.</exception>
    internal static ReadOnlySpan<byte> Part(ReadOnlySpan<byte> bytes, long at, long length) =>
        at >= 0 && length >= 0 && at <= bytes.Length && length <= bytes.Length - at
            ? bytes.Slice((int)at, (int)length)
            : throw new VolumeException("it ends too early, or names a place outside of itself");
}
