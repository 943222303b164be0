using System.Buffers.Binary;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Rows of an OpenEXR file that are compressed together, and where they are in it.</summary>
internal readonly record struct ExrBlock(int FirstRow, int Rows, int Bytes, int Offset, int PackedBytes)
{
    /// <summary>Finds all blocks through the table of their offsets; they may be in any order, but each must be there once.</summary>
    /// <exception cref="PictureException">A block is missing or cannot be what it claims to be.</exception>
    public static ExrBlock[] Find(ReadOnlySpan<byte> file, ExrHeader header)
    {
        int rows = ExrFormat.RowsOfBlock(header.Compression);
        int count = (header.Height + rows - 1) / rows;
        if ((file.Length - header.End) / 8 < count)
        {
            throw new PictureException($"the file is cut off: its table of {count} blocks is not complete");
        }

        var blocks = new ExrBlock[count];
        var seen = new bool[count];
        long packed = 0;
        for (int i = 0; i < count; i++)
        {
            long offset = BinaryPrimitives.ReadInt64LittleEndian(file[(header.End + (8 * i))..]);
            ExrBlock block = At(file, header, offset, rows);
            int index = block.FirstRow / rows;
            packed += block.PackedBytes;
            if (seen[index] || packed > file.Length)
            {
                throw new PictureException("its table of blocks leads twice to the same rows");
            }

            seen[index] = true;
            blocks[i] = block;
        }

        return blocks;
    }

    private static ExrBlock At(ReadOnlySpan<byte> file, ExrHeader header, long offset, int rows)
    {
        if (offset < header.End || offset > file.Length - 8)
        {
            throw new PictureException("the file is cut off or incomplete: a block of pixels is not where its table says");
        }

        ReadOnlySpan<byte> head = file[(int)offset..];
        long firstRow = (long)BinaryPrimitives.ReadInt32LittleEndian(head) - header.Top;
        int packedBytes = BinaryPrimitives.ReadInt32LittleEndian(head[4..]);
        if (firstRow < 0 || firstRow >= header.Height || firstRow % rows != 0)
        {
            throw new PictureException("a block of pixels claims rows that the picture does not have");
        }

        int count = Math.Min(rows, header.Height - (int)firstRow);
        long bytes = 0;
        for (int y = 0; y < count; y++)
        {
            bytes += header.RowBytes((int)firstRow + y);
        }

        if (packedBytes < 0 || packedBytes > bytes || packedBytes > head.Length - 8
            || bytes > packedBytes * PictureLimits.MaxDeflateRatio || bytes > int.MaxValue)
        {
            throw new PictureException($"a block of pixels of {bytes} bytes claims to be packed in {packedBytes}: the file is cut off or damaged");
        }

        return new ExrBlock((int)firstRow, count, (int)bytes, (int)offset + 8, packedBytes);
    }
}
