using System.Buffers.Binary;
using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Scenes;

/// <summary>
/// Reads Mitsuba's .vol, version 3: "VOL", the version as a byte, the kind of numbers (1: floats), the size, the channels, a box, and the numbers.
/// </summary>
internal static class VolReader
{
    private const int Header = 48;

    /// <summary>Reads a grid.</summary>
    public static VolumeGrid Read(ReadOnlySpan<byte> bytes)
    {
        if (bytes.Length < Header || !bytes[..3].SequenceEqual("VOL"u8))
        {
            throw new VolumeException("it is not one of Mitsuba's .vol files: it does not begin with VOL and a header");
        }

        if (bytes[3] != 3)
        {
            throw new VolumeException($"it is of version {bytes[3]} of the format, but only 3 is read");
        }

        ReadOnlySpan<byte> header = bytes;
        int Integer(int number, ReadOnlySpan<byte> from) => BinaryPrimitives.ReadInt32LittleEndian(from[(4 + (4 * number))..]);
        if (Integer(0, header) != 1)
        {
            throw new VolumeException($"its numbers are of kind {Integer(0, header)}, but only floats (1) are read");
        }

        (long X, long Y, long Z) size = (Integer(1, header), Integer(2, header), Integer(3, header));
        int channels = Integer(4, header);
        if (VolumeGrid.SizeComplaint(size.X, size.Y, size.Z, channels) is { } complaint)
        {
            throw new VolumeException(complaint);
        }

        long count = size.X * size.Y * size.Z * channels;
        if (bytes.Length - Header < count * sizeof(float))
        {
            throw new VolumeException($"{size.X}×{size.Y}×{size.Z} points with {channels} channels need {count * sizeof(float):N0} bytes, but {bytes.Length - Header:N0} follow the header");
        }

        VolumeFile.Check(size, channels);
        float[] values = new float[count];
        bytes.Slice(Header, (int)(count * sizeof(float))).CopyTo(MemoryMarshal.AsBytes(values.AsSpan()));
        return VolumeFile.Grid(size, channels, values, Box(bytes));
    }

    // A box that cannot be computed with counts as none.
    private static Transform? Box(ReadOnlySpan<byte> bytes)
    {
        Span<float> b = stackalloc float[6];
        for (int i = 0; i < b.Length; i++)
        {
            b[i] = BinaryPrimitives.ReadSingleLittleEndian(bytes[(24 + (4 * i))..]);
        }

        Vector3 corner = new(b[0], b[1], b[2]);
        Transform place = Transform.Translation(corner) * Transform.Scaling(new Vector3(b[3], b[4], b[5]) - corner);
        return place.IsInvertible ? place : null;
    }
}
