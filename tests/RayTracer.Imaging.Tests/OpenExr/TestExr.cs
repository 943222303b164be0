using System.Text;

namespace RayTracer.Imaging.Tests;

/// <summary>Makes OpenEXR files of any kind, uncompressed, valid or not, without the code under test.</summary>
internal sealed class TestExr
{
    public (string Name, int Type, int StepX, int StepY)[] Channels { get; init; } = [("B", 2, 1, 1), ("G", 2, 1, 1), ("R", 2, 1, 1)];

    public int[] DataWindow { get; init; } = [0, 0, 3, 2];

    public int Compression { get; init; }

    public int Version { get; init; } = 2;

    /// <summary>The size of tiles; null for rows.</summary>
    public (int Width, int Height)? Tile { get; init; }

    /// <summary>The rows in the order in which they stand in the file, counted from 0 at the top.</summary>
    public int[]? RowOrder { get; init; }

    /// <summary>The value of channel, column and row (of the data window's coordinates); stored as the channel's type.</summary>
    public Func<int, int, int, float> Value { get; init; } = (_, x, y) => x + (10 * y);

    public byte[] File()
    {
        using var file = new MemoryStream();
        using var writer = new BinaryWriter(file);
        writer.Write(20000630);
        writer.Write(Version);
        Attribute(writer, "channels", "chlist", [.. Channels.SelectMany(Channel), 0]);
        Attribute(writer, "compression", "compression", [(byte)Compression]);
        Attribute(writer, "custom", "myType", [1, 2, 3]);
        Attribute(writer, "dataWindow", "box2i", [.. DataWindow.SelectMany(BitConverter.GetBytes)]);
        Attribute(writer, "owner", "string", Encoding.UTF8.GetBytes("Zoë"));
        if (Tile is { } tile)
        {
            Attribute(writer, "tiles", "tiledesc", [.. BitConverter.GetBytes(tile.Width), .. BitConverter.GetBytes(tile.Height), 0]);
        }

        writer.Write((byte)0);
        if (Tile is not null)
        {
            WriteTiles(file, writer);
            return file.ToArray();
        }

        int height = DataWindow[3] - DataWindow[1] + 1;
        int[] order = RowOrder ?? [.. Enumerable.Range(0, height)];
        long table = file.Position;
        writer.Write(new byte[8 * height]);
        foreach (int row in order)
        {
            long offset = file.Position;
            file.Position = table + (8 * row);
            writer.Write(offset);
            file.Position = offset;
            byte[] data = Row(row + DataWindow[1], DataWindow[0], DataWindow[2]);
            writer.Write(row + DataWindow[1]);
            writer.Write(data.Length);
            writer.Write(data);
        }

        return file.ToArray();
    }

    private static IEnumerable<byte> Channel((string Name, int Type, int StepX, int StepY) channel) =>
        [.. Encoding.ASCII.GetBytes(channel.Name), 0, .. new[] { channel.Type, 0, channel.StepX, channel.StepY }.SelectMany(BitConverter.GetBytes)];

    private static void Attribute(BinaryWriter writer, string name, string type, byte[] value)
    {
        writer.Write(Encoding.ASCII.GetBytes($"{name}\0{type}\0"));
        writer.Write(value.Length);
        writer.Write(value);
    }

    // In no order that a program would choose: the last one first.
    private void WriteTiles(MemoryStream file, BinaryWriter writer)
    {
        (int width, int height) = Tile!.Value;
        int across = (DataWindow[2] - DataWindow[0] + width) / width;
        int down = (DataWindow[3] - DataWindow[1] + height) / height;
        long table = file.Position;
        writer.Write(new byte[8 * across * down]);
        for (int i = (across * down) - 1; i >= 0; i--)
        {
            long offset = file.Position;
            file.Position = table + (8 * i);
            writer.Write(offset);
            file.Position = offset;
            int left = DataWindow[0] + (i % across * width);
            int top = DataWindow[1] + (i / across * height);
            int bottom = Math.Min(top + height - 1, DataWindow[3]);
            byte[] data = [.. Enumerable.Range(top, bottom - top + 1).SelectMany(y => Row(y, left, Math.Min(left + width - 1, DataWindow[2])))];
            foreach (int word in new[] { i % across, i / across, 0, 0, data.Length })
            {
                writer.Write(word);
            }

            writer.Write(data);
        }
    }

    private byte[] Row(int y, int left, int right)
    {
        var bytes = new List<byte>();
        for (int c = 0; c < Channels.Length; c++)
        {
            for (int x = left; x <= right; x++)
            {
                if (x % Channels[c].StepX == 0 && y % Channels[c].StepY == 0)
                {
                    float value = Value(c, x, y);
                    bytes.AddRange(Channels[c].Type switch
                    {
                        0 => BitConverter.GetBytes((uint)value),
                        1 => BitConverter.GetBytes((Half)value),
                        _ => BitConverter.GetBytes(value),
                    });
                }
            }
        }

        return [.. bytes];
    }
}
