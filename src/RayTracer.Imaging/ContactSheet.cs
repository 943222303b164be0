using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>Images of one size in a grid whose columns, rows and blocks of rows are labelled with what changes along them.</summary>
public sealed class ContactSheet
{
    /// <summary>The most pixels that a sheet may have.</summary>
    public const long MaxPixels = 1 << 27;

    private const int LongestLabel = 40;

    private readonly SheetAxis _columns;
    private readonly SheetAxis _rows;
    private readonly SheetAxis _blocks;
    private readonly int _width;
    private readonly int _height;
    private readonly SheetCanvas _canvas;

    /// <summary>Draws the labels of an empty sheet.</summary>
    /// <param name="columns">The axis from left to right.</param>
    /// <param name="rows">The axis from top to bottom.</param>
    /// <param name="blocks">The axis from one block of rows to the next one below.</param>
    /// <param name="width">Width of each image.</param>
    /// <param name="height">Height of each image.</param>
    /// <exception cref="ArgumentException">The sheet would be larger than <see cref="MaxPixels"/>.</exception>
    public ContactSheet(SheetAxis columns, SheetAxis rows, SheetAxis blocks, int width, int height)
    {
        (_columns, _rows, _blocks, _width, _height) = (columns, rows, blocks, width, height);
        int dot = SheetCanvas.DotFor(width, height);
        int letters = Math.Min(LongestLabel, rows.Values.Append(rows.Name).Max(t => t.Length));
        Margin = letters == 0 ? 0 : SheetCanvas.WidthOf(letters, dot) + SheetCanvas.Gap;
        int line = SheetCanvas.LineFor(dot);
        Head = (columns.Name.Length > 0 || rows.Name.Length > 0 ? 2 * line : 0) + (blocks.Name.Length > 0 ? line : 0);
        long across = Margin + SheetCanvas.Gap + ((long)columns.Values.Count * (width + SheetCanvas.Gap));
        long down = SheetCanvas.Gap + (blocks.Values.Count * BlockHeight);
        if (across * down > MaxPixels || across > int.MaxValue || down > int.MaxValue)
        {
            throw new ArgumentException($"a sheet of {across}×{down} pixels is too large");
        }

        _canvas = new((int)across, (int)down, dot);
        for (int block = 0; block < blocks.Values.Count; block++)
        {
            Label(block);
        }
    }

    /// <summary>The drawing: linear RGB.</summary>
    public Picture Picture => _canvas.Picture;

    /// <summary>Width of each image.</summary>
    public int CellWidth => _width;

    /// <summary>Height of each image.</summary>
    public int CellHeight => _height;

    private int Margin { get; }

    private int Head { get; }

    private long BlockHeight => Head + ((long)_rows.Values.Count * (_height + SheetCanvas.Gap));

    /// <summary>Places an image.</summary>
    /// <param name="image">Linear RGB, of the sheet's size of images, between 0 and 1.</param>
    /// <param name="column">Its column, from 0.</param>
    /// <param name="row">Its row in the block, from 0.</param>
    /// <param name="block">Its block, from 0.</param>
    public void Place(IImageRows image, int column, int row, int block) => _canvas.Place(image, Left(column), Top(row, block));

    private int Left(int column) => Margin + SheetCanvas.Gap + (column * (_width + SheetCanvas.Gap));

    private int Top(int row, int block) => (int)(SheetCanvas.Gap + (block * BlockHeight) + Head + (row * (_height + SheetCanvas.Gap)));

    private void Label(int block)
    {
        int top = (int)(SheetCanvas.Gap + (block * BlockHeight));
        if (_blocks.Name.Length > 0)
        {
            _canvas.Write($"{_blocks.Name} = {_blocks.Values[block]}", SheetCanvas.Gap, top, Picture.Width - (2 * SheetCanvas.Gap));
            top += _canvas.Line;
        }

        if (Head > 0)
        {
            _canvas.Write(_columns.Name, Left(0), top, Picture.Width - Left(0) - SheetCanvas.Gap);
            top += _canvas.Line;
            _canvas.Write(_rows.Name, SheetCanvas.Gap, top, Math.Max(0, Margin - SheetCanvas.Gap));
        }

        for (int column = 0; column < _columns.Values.Count; column++)
        {
            _canvas.Write(_columns.Values[column], Left(column), top, _width);
        }

        for (int row = 0; row < _rows.Values.Count; row++)
        {
            _canvas.Write(_rows.Values[row], SheetCanvas.Gap, Top(row, block) + ((_height - _canvas.Line) / 2), Math.Max(0, Margin - SheetCanvas.Gap));
        }
    }
}

/// <summary>The setting that changes along an axis of a <see cref="ContactSheet"/>.</summary>
/// <param name="Name">The name.</param>
/// <param name="Values">The value at each step.</param>
public sealed record SheetAxis(string Name, IReadOnlyList<string> Values)
{
    /// <summary>An axis of one step without a name.</summary>
    public static SheetAxis None { get; } = new("", [""]);
}
