using System.Buffers.Binary;
using System.IO.Compression;
using System.Runtime.InteropServices;
using System.Text;

namespace RayTracer.Testing;

/// <summary>A file of NanoVDB with one grid: one upper node, one lower one, and leaves.</summary>
internal static class TestNanoVdb
{
    private const int Root = 672 + 64;
    private const int Upper = Root + 64 + 32;
    private const int Lower = Upper + 270400;
    private const int Leaf = Lower + 33856;
    private const int LeafSize = 2144;

    /// <summary>The bytes of a file.</summary>
    /// <param name="first">The first active voxel, in the first 128 along each axis, or in those before 0.</param>
    /// <param name="last">The last active voxel, in the same lower node.</param>
    /// <param name="value">The values of voxels.</param>
    /// <param name="codec">0 for none, 1 for ZIP, 2 for Blosc.</param>
    /// <param name="type">The kind of values: 1 for floats.</param>
    /// <param name="name">The grid's name.</param>
    /// <returns>A file; several one after the other are a file of as many grids.</returns>
    public static byte[] File((int X, int Y, int Z) first, (int X, int Y, int Z) last, Func<int, int, int, float> value, int codec = 0, uint type = 1, string name = "density")
    {
        byte[] grid = Grid(first, last, value, type);
        byte[] stored = codec == 0 ? grid : Packed(grid);
        byte[] called = Encoding.ASCII.GetBytes(name + "\0");
        byte[] head = new byte[16 + 176];
        "NanoVDB0"u8.CopyTo(head);
        BinaryPrimitives.WriteUInt16LittleEndian(head.AsSpan(12), 1);
        BinaryPrimitives.WriteUInt16LittleEndian(head.AsSpan(14), (ushort)codec);
        Span<byte> meta = head.AsSpan(16);
        BinaryPrimitives.WriteInt64LittleEndian(meta, grid.Length);
        BinaryPrimitives.WriteInt64LittleEndian(meta[8..], stored.Length);
        BinaryPrimitives.WriteUInt32LittleEndian(meta[32..], type);
        BinaryPrimitives.WriteInt32LittleEndian(meta[136..], called.Length);
        return [.. head, .. called, .. stored];
    }

    private static byte[] Packed(byte[] grid)
    {
        using MemoryStream packed = new();
        using (ZLibStream zip = new(packed, CompressionLevel.Fastest, leaveOpen: true))
        {
            zip.Write(grid);
        }

        return [.. BitConverter.GetBytes(packed.Length), .. packed.ToArray()];
    }

    private static byte[] Grid((int X, int Y, int Z) first, (int X, int Y, int Z) last, Func<int, int, int, float> value, uint type)
    {
        (int x, int y, int z) = (first.X >> 3, first.Y >> 3, first.Z >> 3);
        (int nx, int ny, int nz) = ((last.X >> 3) - x + 1, (last.Y >> 3) - y + 1, (last.Z >> 3) - z + 1);
        byte[] bytes = new byte[Leaf + (nx * ny * nz * LeafSize)];
        void Int(int at, int number) => BinaryPrimitives.WriteInt32LittleEndian(bytes.AsSpan(at), number);
        void Long(int at, long number) => BinaryPrimitives.WriteInt64LittleEndian(bytes.AsSpan(at), number);
        Encoding.ASCII.GetBytes("NanoVDB1").CopyTo(bytes, 0);
        Int(636, (int)type);

        // Voxels of a quarter, moved by 10, 20 and 30.
        double[] map = [0.25, 0, 0, 0, 0.25, 0, 0, 0, 0.25, 4, 0, 0, 0, 4, 0, 0, 0, 4, 10, 20, 30, 1];
        MemoryMarshal.AsBytes(map.AsSpan()).CopyTo(bytes.AsSpan(296 + 88));
        Long(672 + 24, 64);
        int[] corners = [first.X, first.Y, first.Z, last.X, last.Y, last.Z, 1];
        MemoryMarshal.AsBytes(corners.AsSpan()).CopyTo(bytes.AsSpan(Root));
        ulong Key(int i) => (uint)i >> 12;
        Long(Root + 64, (long)(Key(first.Z) | (Key(first.Y) << 21) | (Key(first.X) << 42)));
        Long(Root + 64 + 8, Upper - Root);
        int inUpper = ((first.X & 4095) >> 7 << 10) | ((first.Y & 4095) >> 7 << 5) | ((first.Z & 4095) >> 7);
        bytes[Upper + 32 + 4096 + (inUpper >> 3)] |= (byte)(1 << (inUpper & 7));
        Long(Upper + 8256 + (8 * inUpper), Lower - Upper);
        for (int leaf = 0; leaf < nx * ny * nz; leaf++)
        {
            (int i, int j, int k) = ((x + (leaf % nx)) * 8, (y + (leaf / nx % ny)) * 8, (z + (leaf / (nx * ny))) * 8);
            int at = Leaf + (leaf * LeafSize);
            int inLower = ((i & 127) >> 3 << 8) | ((j & 127) >> 3 << 4) | ((k & 127) >> 3);
            bytes[Lower + 32 + 512 + (inLower >> 3)] |= (byte)(1 << (inLower & 7));
            Long(Lower + 1088 + (8 * inLower), at - Lower);
            for (int n = 0; n < 512; n++)
            {
                BinaryPrimitives.WriteSingleLittleEndian(bytes.AsSpan(at + 96 + (4 * n)), value(i + (n >> 6), j + ((n >> 3) & 7), k + (n & 7)));
            }
        }

        return bytes;
    }
}
