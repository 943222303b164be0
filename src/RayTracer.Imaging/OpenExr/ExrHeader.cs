using System.Buffers.Binary;
using System.Text;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>The header of a single-part OpenEXR file of rows.</summary>
internal sealed class ExrHeader
{
    // Keeps the work on each row of a hostile file bounded.
    private const int MaxChannels = 1024;

    private readonly List<KeyValuePair<string, string>> _texts = [];
    private List<ExrChannel>? _channels;
    private int? _compression;
    private int[]? _dataWindow;

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

    /// <summary>Where the table of blocks begins.</summary>
    public int End { get; private set; }

    /// <summary>Bytes of row y of the picture (0 is the top), before compression.</summary>
    public long RowBytes(int y)
    {
        long bytes = 0;
        foreach (ExrChannel channel in Channels)
        {
            bytes += channel.RowBytes(Top + y, Left, Left + Width - 1);
        }

        return bytes;
    }

    public static ExrHeader Parse(ReadOnlySpan<byte> file)
    {
        var header = new ExrHeader();
        var reader = new ExrBytes(file);
        header.CheckVersion(ref reader);
        for (string name = reader.Name(); name.Length > 0; name = reader.Name())
        {
            string type = reader.Name();
            int size = reader.Int();
            if (size < 0 || size > reader.Left)
            {
                throw new PictureException($"its attribute '{name}' claims {size} bytes, and {reader.Left} are left");
            }

            header.Take(name, type, reader.Bytes(size));
        }

        header.End = reader.Position;
        header.CheckComplete();
        return header;
    }

    private void CheckVersion(ref ExrBytes reader)
    {
        if (!reader.Bytes(4).SequenceEqual(ExrFormat.Magic))
        {
            throw new PictureException("it does not begin as an OpenEXR file does");
        }

        int version = reader.Int();
        string? kind = (version & ExrFormat.MultiPartFlag) != 0 ? "of several parts"
            : (version & ExrFormat.DeepFlag) != 0 ? "of deep data"
            : (version & ExrFormat.TiledFlag) != 0 ? "of tiles"
            : null;
        if (kind is not null)
        {
            throw new PictureException($"it is an OpenEXR file {kind}; only single-part files of rows (scanlines) are read");
        }

        if ((version & ~ExrFormat.LongNamesFlag) != ExrFormat.Version)
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
            reader.Bytes(4);
            int stepX = reader.Int();
            int stepY = reader.Int();
            if (type is < 0 or > 2 || stepX < 1 || stepY < 1)
            {
                throw new PictureException($"its channel '{name}' has type {type} and steps {stepX} and {stepY}, which do not exist in OpenEXR");
            }

            if (channels.Count == MaxChannels)
            {
                throw new PictureException($"it has more than {MaxChannels} channels");
            }

            channels.Add(new ExrChannel(name, (ExrPixelType)type, stepX, stepY));
        }

        return channels;
    }

    private void CheckComplete()
    {
        string? missing = _channels is null ? "channels" : _compression is null ? "compression" : _dataWindow is null ? "dataWindow" : null;
        if (missing is not null)
        {
            throw new PictureException($"its header has no (valid) attribute '{missing}'");
        }

        if (_compression > (int)ExrCompression.Zip && Compression != ExrFormat.Piz)
        {
            string[] names = ["PIZ", "PXR24", "B44", "B44A", "DWAA", "DWAB"];
            int index = _compression!.Value - 4;
            string name = index < names.Length ? names[index] : $"number {_compression}";
            throw new PictureException($"its compression is {name}, and only NONE, RLE, ZIPS, ZIP and PIZ are read");
        }

        PictureLimits.CheckSize((long)_dataWindow![2] - Left + 1, (long)_dataWindow[3] - Top + 1);
    }
}
