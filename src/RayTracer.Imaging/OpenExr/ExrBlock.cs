using System.Buffers.Binary;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>
/// Pixels of an OpenEXR file that are compressed together, rows or a tile, and where they are in it; rows and columns count from 0.
/// </summary>
internal readonly record struct ExrBlock(int FirstRow, int Rows, int FirstColumn, int Columns, int Bytes, int Offset, int PackedBytes)
{
    /// <summary>Bytes of a channel's part of a row, before compression.</summary>
    /// <param name="header">The file's header.</param>
    /// <param name="channel">The channel.</param>
    /// <param name="row">The row within the block, from 0.</param>
    public int RowBytes(ExrHeader header, ExrChannel channel, int row) =>
        (int)channel.Bytes(header.Top + FirstRow + row, 1, header.Left + FirstColumn, Columns);

    /// <summary>
    /// Finds all blocks of full size through the table of their offsets; they may be in any order, but each must be there once.
    /// </summary>
    /// <exception cref="PictureException">A block is missing or cannot be what it claims to be.</exception>
    public static ExrBlock[] Find(ReadOnlySpan<byte> file, ExrHeader header)
    {
        // Where there are smaller copies of the picture too, their blocks come after those of the picture itself.
        long count = (long)header.BlocksAcross * header.BlocksDown;
        Require((file.Length - header.End) / 8 >= count, $"the file is cut off: its table of {count} blocks is not complete");

        var blocks = new ExrBlock[count];
        var seen = new bool[count];
        long packed = 0;
        for (int i = 0; i < count; i++)
        {
            long offset = BinaryPrimitives.ReadInt64LittleEndian(file[(header.End + (8 * i))..]);
            (ExrBlock block, int index) = At(file, header, offset);
            packed += block.PackedBytes;
            Require(!seen[index] && packed <= file.Length, "its table of blocks has the same pixels twice");

            seen[index] = true;
            blocks[i] = block;
        }

        return blocks;
    }

    private static (ExrBlock Block, int Index) At(ReadOnlySpan<byte> file, ExrHeader header, long offset)
    {
        int headBytes = 4 * ((header.IsMultiPart ? 1 : 0) + (header.IsTiled ? 4 : 1) + 1);
        if (offset < header.End || offset > file.Length - headBytes)
        {
            throw new PictureException("the file is cut off or incomplete: a block of pixels is not where its table says");
        }

        ReadOnlySpan<byte> head = file[(int)offset..];
        if (header.IsMultiPart)
        {
            Require(Word(ref head) == 0, "its table of blocks leads to a block of another part");
        }

        (int column, int row) = header.IsTiled ? Tile(ref head, header) : (0, Row(ref head, header));
        int packedBytes = Word(ref head);
        int rows = Math.Min(header.BlockHeight, header.Height - row);
        int columns = Math.Min(header.BlockWidth, header.Width - column);
        long bytes = 0;
        foreach (ExrChannel channel in header.Channels)
        {
            bytes += channel.Bytes(header.Top + row, rows, header.Left + column, columns);
        }

        Require(
            packedBytes >= 0 && packedBytes <= bytes && packedBytes <= head.Length && bytes <= packedBytes * ExrFormat.MaxRatio(header.Compression) && bytes <= int.MaxValue,
            $"a block of pixels of {bytes} bytes claims to be packed in {packedBytes}: the file is cut off or damaged");
        ExrBlock block = new(row, rows, column, columns, (int)bytes, (int)offset + headBytes, packedBytes);
        return (block, (row / header.BlockHeight * header.BlocksAcross) + (column / header.BlockWidth));
    }

    private static int Row(ref ReadOnlySpan<byte> head, ExrHeader header)
    {
        long row = (long)Word(ref head) - header.Top;
        Require(row >= 0 && row < header.Height && row % header.BlockHeight == 0, "a block of pixels claims rows that the picture does not have");
        return (int)row;
    }

    private static (int Column, int Row) Tile(ref ReadOnlySpan<byte> head, ExrHeader header)
    {
        (int x, int y, int levelX, int levelY) = (Word(ref head), Word(ref head), Word(ref head), Word(ref head));
        Require((uint)x < (uint)header.BlocksAcross && (uint)y < (uint)header.BlocksDown, "a tile claims pixels that the picture does not have");
        Require(levelX == 0 && levelY == 0, "its table of tiles leads to a tile of a smaller copy of the picture");
        return (x * header.BlockWidth, y * header.BlockHeight);
    }

    private static int Word(ref ReadOnlySpan<byte> head)
    {
        int word = BinaryPrimitives.ReadInt32LittleEndian(head);
        head = head[4..];
        return word;
    }
}
