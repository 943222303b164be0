using System.Buffers.Binary;
using System.Runtime.InteropServices;
using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Scenes;

/// <summary>
/// The tree of a NanoVDB grid of floats: a root, upper nodes of 4,096 voxels along each axis with 32³ entries, lower ones of 128 with 16³, and leaves of 8³ values. The grid that
/// comes of it is dense: all voxels within the box of those that are active.
/// </summary>
internal readonly ref struct NanoVdbTree
{
    private const int GridSize = 672;
    private const int RootHeader = 64;
    private const int RootTile = 32;
    private const int UpperSize = 270400;
    private const int LowerSize = 33856;
    private const int LeafSize = 2144;
    private const int MostTiles = 1 << 16;

    // How many voxels a grid may have, for each of its bytes or however few there are.
    private const long MostEmpty = 1 << 26;
    private const long MostOfByte = 16;

    private readonly ReadOnlySpan<byte> _bytes;
    private readonly Span<float> _values;
    private readonly (long X, long Y, long Z) _first;
    private readonly (long X, long Y, long Z) _size;

    private NanoVdbTree(ReadOnlySpan<byte> bytes, Span<float> values, (long X, long Y, long Z) first, (long X, long Y, long Z) size)
    {
        _bytes = bytes;
        _values = values;
        (_first, _size) = (first, size);
    }

    /// <summary>Reads a grid.</summary>
    public static VolumeGrid Read(ReadOnlySpan<byte> bytes)
    {
        if (!NanoVdbReader.Part(bytes, 0, GridSize)[..7].SequenceEqual("NanoVDB"u8) || BinaryPrimitives.ReadUInt32LittleEndian(bytes[636..]) != 1)
        {
            throw new VolumeException("its grid does not begin as one of floats does");
        }

        long root = Place(bytes, GridSize, BinaryPrimitives.ReadInt64LittleEndian(NanoVdbReader.Part(bytes, GridSize, 64)[24..]));
        ReadOnlySpan<byte> header = NanoVdbReader.Part(bytes, root, RootHeader);
        (long, long, long) Corner(int at, ReadOnlySpan<byte> from) =>
            (BinaryPrimitives.ReadInt32LittleEndian(from[at..]), BinaryPrimitives.ReadInt32LittleEndian(from[(at + 4)..]), BinaryPrimitives.ReadInt32LittleEndian(from[(at + 8)..]));
        (long X, long Y, long Z) first = Corner(0, header);
        (long X, long Y, long Z) last = Corner(12, header);
        (long X, long Y, long Z) size = (last.X - first.X + 1, last.Y - first.Y + 1, last.Z - first.Z + 1);
        if (size.X <= 0 || size.Y <= 0 || size.Z <= 0)
        {
            throw new VolumeException("no voxel of its grid is active");
        }

        // So that a few bytes cannot ask for gigabytes.
        if ((Int128)size.X * size.Y * size.Z > Math.Max(MostEmpty, MostOfByte * (long)bytes.Length))
        {
            throw new VolumeException($"its active voxels span {size.X}×{size.Y}×{size.Z}, too many for so small a file");
        }

        VolumeFile.Check(size, 1);
        float[] values = new float[size.X * size.Y * size.Z];
        Array.Fill(values, BinaryPrimitives.ReadSingleLittleEndian(header[28..]));
        new NanoVdbTree(bytes, values, first, size).Root(root, BinaryPrimitives.ReadUInt32LittleEndian(header[24..]));
        return VolumeFile.Grid(size, 1, values, Map(bytes, first, size));
    }

    private static long Place(ReadOnlySpan<byte> bytes, long from, long offset) =>
        offset >= 0 && offset <= bytes.Length ? from + offset : throw new VolumeException("a part of its tree lies outside of the grid");

    // Voxel i is at i in the file's space; the grid begins half a voxel before.
    private static Transform? Map(ReadOnlySpan<byte> bytes, (long X, long Y, long Z) first, (long X, long Y, long Z) size)
    {
        ReadOnlySpan<double> numbers = MemoryMarshal.Cast<byte, double>(bytes.Slice(296 + 88, 21 * sizeof(double)));
        Transform ToWorld(ReadOnlySpan<double> m) => new(new(m[0], m[1], m[2], m[18]), new(m[3], m[4], m[5], m[19]), new(m[6], m[7], m[8], m[20]));
        Transform place = ToWorld(numbers) * Transform.Translation(new(first.X - 0.5f, first.Y - 0.5f, first.Z - 0.5f)) * Transform.Scaling(new(size.X, size.Y, size.Z));
        return place.IsInvertible ? place : null;
    }

    private void Root(long root, uint tiles)
    {
        if (tiles > MostTiles)
        {
            throw new VolumeException($"its root has {tiles:N0} entries");
        }

        for (long i = 0; i < tiles; i++)
        {
            ReadOnlySpan<byte> tile = NanoVdbReader.Part(_bytes, root + RootHeader + (i * RootTile), RootTile);
            ulong key = BinaryPrimitives.ReadUInt64LittleEndian(tile);
            long child = BinaryPrimitives.ReadInt64LittleEndian(tile[8..]);
            (long, long, long) corner = (Signed(key >> 42), Signed(key >> 21), Signed(key));
            if (child != 0)
            {
                Node(Place(_bytes, root, child), corner, bits: 5, below: 7);
            }
            else
            {
                Fill(corner, 4096, BinaryPrimitives.ReadSingleLittleEndian(tile[20..]));
            }
        }
    }

    // 21 bits of a coordinate over 4,096, of which 20 count.
    private static long Signed(ulong key) => (int)((uint)(key & 0xfffff) << 12);

    // An upper or a lower node: entries are values, or offsets of nodes from this one.
    private void Node(long at, (long X, long Y, long Z) corner, int bits, int below)
    {
        int entries = 1 << (3 * bits);
        ReadOnlySpan<byte> node = NanoVdbReader.Part(_bytes, at, bits == 5 ? UpperSize : LowerSize);
        ReadOnlySpan<byte> children = node.Slice(32 + (entries / 8), entries / 8);
        ReadOnlySpan<byte> table = node[(bits == 5 ? 8256 : 1088)..];
        for (int i = 0; i < entries; i++)
        {
            int mask = (1 << bits) - 1;
            (long X, long Y, long Z) place = (
                corner.X + ((long)(i >> (2 * bits)) << below), corner.Y + ((long)((i >> bits) & mask) << below), corner.Z + ((long)(i & mask) << below));
            if (!Overlaps(place, 1 << below))
            {
                continue;
            }

            if ((children[i >> 3] >> (i & 7) & 1) == 0)
            {
                Fill(place, 1 << below, BinaryPrimitives.ReadSingleLittleEndian(table[(8 * i)..]));
                continue;
            }

            long child = Place(_bytes, at, BinaryPrimitives.ReadInt64LittleEndian(table[(8 * i)..]));
            if (bits == 5)
            {
                Node(child, place, bits: 4, below: 3);
            }
            else
            {
                Leaf(child, place);
            }
        }
    }

    private void Leaf(long at, (long X, long Y, long Z) corner)
    {
        ReadOnlySpan<byte> values = NanoVdbReader.Part(_bytes, at, LeafSize)[96..];
        for (int i = 0; i < 512; i++)
        {
            Fill((corner.X + (i >> 6), corner.Y + ((i >> 3) & 7), corner.Z + (i & 7)), 1, BinaryPrimitives.ReadSingleLittleEndian(values[(4 * i)..]));
        }
    }

    private bool Overlaps((long X, long Y, long Z) corner, long side) =>
        corner.X < _first.X + _size.X && corner.X + side > _first.X && corner.Y < _first.Y + _size.Y && corner.Y + side > _first.Y
            && corner.Z < _first.Z + _size.Z && corner.Z + side > _first.Z;

    // A cube of one value, as far as it lies in the grid.
    private void Fill((long X, long Y, long Z) corner, long side, float value)
    {
        (long x0, long x1) = Within(corner.X - _first.X, side, _size.X);
        (long y0, long y1) = Within(corner.Y - _first.Y, side, _size.Y);
        (long z0, long z1) = Within(corner.Z - _first.Z, side, _size.Z);
        for (long z = z0; z < z1 && x0 < x1; z++)
        {
            for (long y = y0; y < y1; y++)
            {
                _values.Slice((int)((((z * _size.Y) + y) * _size.X) + x0), (int)(x1 - x0)).Fill(value);
            }
        }
    }

    private static (long From, long To) Within(long from, long side, long size) => (long.Max(from, 0), long.Min(from + side, size));
}
