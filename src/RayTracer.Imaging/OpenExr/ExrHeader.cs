using System.Buffers.Binary;
using System.Text;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>The header of an OpenEXR file, of rows or tiles; in a file of several parts, of the first one.</summary>
internal sealed class ExrHeader
{
    // Keeps the work on each row of a hostile file bounded.
    private const int MaxChannels = 1024;
    private const long MostRowsOfChannels = 1L << 27;

    private const string Deep = "it is an OpenEXR file of deep data, with several depths in a pixel; only flat ones are read";

    private readonly List<KeyValuePair<string, string>> _texts = [];
    private List<ExrChannel>? _channels;
    private int? _compression;
    private int[]? _dataWindow;
    private string? _type;
    private (uint Width, uint Height)? _tile;

    private ExrHeader()
    {
    }

    /// <summary>Every channel, in the order in which rows hold them.</summary>
    public IReadOnlyList<ExrChannel> Channels => _channels!;

    public ExrCompression Compression => (ExrCompression)_compression!;

    public int Left => _dataWindow![0];

    public int Top => _dataWindow![1];

    public int Width => _dataWindow![2] - Left + 1;

    public int Height => _dataWindow![3] - Top + 1;

    /// <summary>The string attributes that are not the format's own, in their order.</summary>
    public IReadOnlyList<KeyValuePair<string, string>> Texts => _texts;

    /// <summary>True where the file is one of several parts, even if there is only one.</summary>
    public bool IsMultiPart { get; private set; }

    /// <summary>True where blocks are tiles rather than rows.</summary>
    public bool IsTiled { get; private set; }

    /// <summary>Columns of a block; fewer at the right edge.</summary>
    public int BlockWidth { get; private set; }

    /// <summary>Rows of a block; fewer at the lower edge.</summary>
    public int BlockHeight { get; private set; }

    /// <summary>Blocks side by side.</summary>
    public int BlocksAcross => (int)(((long)Width + BlockWidth - 1) / BlockWidth);

    /// <summary>Blocks one above the other.</summary>
    public int BlocksDown => (int)(((long)Height + BlockHeight - 1) / BlockHeight);

    /// <summary>The position of the table of blocks.</summary>
    public int End { get; private set; }

    public static ExrHeader Parse(ReadOnlySpan<byte> file)
    {
        var header = new ExrHeader();
        var reader = new ExrBytes(file);
        header.CheckVersion(ref reader);
        header.ReadPart(ref reader, isFirst: true);
        while (header.IsMultiPart && header.ReadPart(ref reader, isFirst: false))
        {
        }

        header.End = reader.Position;
        header.CheckComplete();
        header.SetBlocks();
        return header;
    }

    // Attributes up to an empty name. Those of later parts are gone over; an empty part is the end of all.
    private bool ReadPart(ref ExrBytes reader, bool isFirst)
    {
        bool any = false;
        for (string name = reader.Name(); name.Length > 0; name = reader.Name())
        {
            any = true;
            string type = reader.Name();
            int size = reader.Int();
            Require(size >= 0 && size <= reader.Left, $"its attribute '{name}' claims {size} bytes, and {reader.Left} are left");

            ReadOnlySpan<byte> value = reader.Bytes(size);
            if (isFirst)
            {
                Take(name, type, value);
            }
        }

        return any;
    }

    private void CheckVersion(ref ExrBytes reader)
    {
        Require(reader.Bytes(4).SequenceEqual(ExrFormat.Magic), "it does not begin as an OpenEXR file does");

        int version = reader.Int();
        Require((version & ExrFormat.DeepFlag) == 0, Deep);

        IsMultiPart = (version & ExrFormat.MultiPartFlag) != 0;
        IsTiled = (version & ExrFormat.TiledFlag) != 0;
        const int Known = ExrFormat.LongNamesFlag | ExrFormat.MultiPartFlag | ExrFormat.TiledFlag;
        if ((version & ~Known) != ExrFormat.Version)
        {
            throw new PictureException($"its version word is {version}, and only version {ExrFormat.Version} of OpenEXR is read");
        }
    }

    private void Take(string name, string type, ReadOnlySpan<byte> value)
    {
        switch (name, type)
        {
            case ("channels", "chlist"):
                _channels = ParseChannels(value);
                break;
            case ("compression", "compression") when value.Length == 1:
                _compression = value[0];
                break;
            case ("dataWindow", "box2i") when value.Length == 16:
                _dataWindow = new int[4];
                for (int i = 0; i < 4; i++)
                {
                    _dataWindow[i] = BinaryPrimitives.ReadInt32LittleEndian(value[(4 * i)..]);
                }

                break;
            case ("tiles", "tiledesc") when value.Length == 9:
                _tile = (BinaryPrimitives.ReadUInt32LittleEndian(value), BinaryPrimitives.ReadUInt32LittleEndian(value[4..]));
                break;
            case ("type", "string"):
                _type = ExrBytes.Printable(value);
                break;
            case (_, "string") when value.Length <= PictureLimits.MaxTextBytes && !ExrFormat.Attributes.Contains(name):
                _texts.Add(new(name, Encoding.UTF8.GetString(value)));
                break;
        }
    }

    private static List<ExrChannel> ParseChannels(ReadOnlySpan<byte> value)
    {
        var channels = new List<ExrChannel>();
        var reader = new ExrBytes(value);
        for (string name = reader.Name(); name.Length > 0; name = reader.Name())
        {
            int type = reader.Int();
            bool isPerceptual = reader.Bytes(4)[0] != 0;
            int stepX = reader.Int();
            int stepY = reader.Int();
            if (type is < 0 or > 2 || stepX < 1 || stepY < 1)
            {
                throw new PictureException($"its channel '{name}' has type {type} and steps {stepX} and {stepY}, which do not exist in OpenEXR");
            }

            Require(channels.Count != MaxChannels, $"it has more than {MaxChannels} channels");

            channels.Add(new ExrChannel(name, (ExrPixelType)type, isPerceptual, stepX, stepY));
        }

        return channels;
    }

    private void CheckComplete()
    {
        string? missing = _channels is null ? "channels" : _compression is null ? "compression" : _dataWindow is null ? "dataWindow" : null;
        Require(missing is null, $"its header has no (valid) attribute '{missing}'");

        if (_compression > (int)ExrFormat.B44A)
        {
            string name = _compression switch { 8 => "DWAA", 9 => "DWAB", _ => $"number {_compression}" };
            throw new PictureException($"its compression is {name}, and only NONE, RLE, ZIPS, ZIP, PIZ, PXR24, B44 and B44A are read");
        }

        PictureLimits.CheckSize((long)_dataWindow![2] - Left + 1, (long)_dataWindow[3] - Top + 1);
    }

    // Of several parts, each says itself what it is; a single one says so in the version, whatever its type.
    private void SetBlocks()
    {
        if (IsMultiPart && _type is not ("scanlineimage" or "tiledimage"))
        {
            throw new PictureException(_type is "deepscanline" or "deeptile" ? Deep : $"its first part is of the kind '{_type}', which does not exist in OpenEXR");
        }

        IsTiled = IsMultiPart ? _type == "tiledimage" : IsTiled;
        if (!IsTiled)
        {
            (BlockWidth, BlockHeight) = (Width, ExrFormat.RowsOfBlock(Compression));
            if ((long)Height * Channels.Count > MostRowsOfChannels)
            {
                throw new PictureException($"it has {Height} rows of {Channels.Count} channels, which is more than is read");
            }

            return;
        }

        (uint width, uint height) = _tile ?? throw new PictureException("its header has no (valid) attribute 'tiles'");
        Require(width != 0 && height != 0, $"its tiles have {width}×{height} pixels");

        (BlockWidth, BlockHeight) = ((int)Math.Min(width, (uint)Width), (int)Math.Min(height, (uint)Height));
        if ((long)BlocksAcross * Height * Channels.Count > MostRowsOfChannels)
        {
            throw new PictureException($"its tiles of {width}×{height} pixels are too small for a picture of {Width}×{Height} pixels with {Channels.Count} channels");
        }
    }
}

/// <summary>A channel of an OpenEXR file: it has a value where x and y are multiples of the steps.</summary>
internal readonly record struct ExrChannel(string Name, ExrPixelType Type, bool IsPerceptual, int StepX, int StepY)
{
    /// <summary>Bytes of one value.</summary>
    public int ValueBytes => Type == ExrPixelType.Half ? 2 : 4;

    /// <summary>Bytes of the channel's part of a rectangle.</summary>
    public long Bytes(int top, int rows, int left, int columns) =>
        Multiples(left, columns, StepX) * Multiples(top, rows, StepY) * ValueBytes;

    private static long Multiples(int first, int count, int step) =>
        FloorDivide((long)first + count - 1, step) - FloorDivide((long)first - 1, step);

    private static long FloorDivide(long a, int b) => a >= 0 ? a / b : -((-a + b - 1) / b);
}
