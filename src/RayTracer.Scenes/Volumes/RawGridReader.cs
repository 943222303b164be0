using System.Buffers.Binary;
using RayTracer.Description;
using RayTracer.Media;

namespace RayTracer.Scenes;

/// <summary>Reads files of nothing but numbers.</summary>
internal static class RawGridReader
{
    /// <summary>Reads a grid.</summary>
    public static VolumeGrid Read(ReadOnlySpan<byte> bytes, GridDescription description)
    {
        IReadOnlyList<int> size = description.Size;
        if (size.Count is not (3 or 4))
        {
            throw new VolumeException(
                size.Count == 0 ? "a file of nothing but numbers needs \"size\", its points along x, y and z (files that say it themselves end in .vol or .nvdb)"
                    : $"\"size\" has 3 numbers, or 4 with the channels, not {size.Count}");
        }

        int channels = size.Count == 4 ? size[3] : 1;
        VolumeFile.Check((size[0], size[1], size[2]), channels);
        long count = (long)size[0] * size[1] * size[2] * channels;
        int each = description.Numbers switch { GridNumbers.Float32 => 4, GridNumbers.UInt8 => 1, _ => 2 };
        if (bytes.Length != count * each)
        {
            throw new VolumeException(
                $"{string.Join('×', size)} numbers of {each} {(each == 1 ? "byte" : "bytes")} are {count * each:N0} bytes, but the file has {bytes.Length:N0}");
        }

        float[] values = new float[count];
        for (int i = 0; i < values.Length; i++)
        {
            ReadOnlySpan<byte> at = bytes[(i * each)..];
            values[i] = description.Numbers switch
            {
                GridNumbers.Float32 => BinaryPrimitives.ReadSingleLittleEndian(at),
                GridNumbers.Float16 => (float)BinaryPrimitives.ReadHalfLittleEndian(at),
                GridNumbers.UInt16 => BinaryPrimitives.ReadUInt16LittleEndian(at) / 65535f,
                _ => at[0] / 255f,
            };
        }

        return VolumeFile.Grid((size[0], size[1], size[2]), channels, values);
    }
}
