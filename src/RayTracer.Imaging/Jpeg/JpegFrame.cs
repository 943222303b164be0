using System.Buffers.Binary;
using RayTracer.Textures;
using static RayTracer.Imaging.PictureLimits;

namespace RayTracer.Imaging;

/// <summary>The frame header (ITU-T T.81, section B.2.2), which describes the whole picture.</summary>
internal sealed class JpegFrame
{
    private JpegFrame(int width, int height, bool progressive, JpegComponent[] components)
    {
        Width = width;
        Height = height;
        IsProgressive = progressive;
        Components = components;
        MaxHorizontal = components.Max(c => c.Horizontal);
        MaxVertical = components.Max(c => c.Vertical);
        UnitsAcross = Divide(width, JpegComponent.Side * MaxHorizontal);
        UnitsDown = Divide(height, JpegComponent.Side * MaxVertical);
        foreach (JpegComponent c in components)
        {
            c.SetSize(Divide(width * c.Horizontal, MaxHorizontal), Divide(height * c.Vertical, MaxVertical), UnitsAcross, UnitsDown);
        }
    }

    /// <summary>Width in pixels.</summary>
    public int Width { get; }

    /// <summary>Height in pixels.</summary>
    public int Height { get; }

    /// <summary>True where the scans refine each other.</summary>
    public bool IsProgressive { get; }

    /// <summary>One, three or four components.</summary>
    public JpegComponent[] Components { get; }

    /// <summary>The largest number of blocks of a unit side by side.</summary>
    public int MaxHorizontal { get; }

    /// <summary>The largest number of blocks of a unit one above the other.</summary>
    public int MaxVertical { get; }

    /// <summary>Units (MCUs) side by side.</summary>
    public int UnitsAcross { get; }

    /// <summary>Units one above the other.</summary>
    public int UnitsDown { get; }

    /// <summary>Blocks of all components.</summary>
    public long Blocks => (long)UnitsAcross * UnitsDown * Components.Sum(c => c.Horizontal * c.Vertical);

    /// <summary>Reads a frame header.</summary>
    /// <param name="marker">Its marker's second byte: 0xC0 to 0xC2.</param>
    /// <param name="data">The bytes after the header's length.</param>
    /// <exception cref="PictureException">It is damaged, or the picture is of a kind that is not read.</exception>
    public static JpegFrame Parse(int marker, ReadOnlySpan<byte> data)
    {
        Require(data.Length >= 6 && data.Length == 6 + (3 * data[5]), "its frame header has the wrong length");
        Require(data[0] == 8, $"it has {data[0]} bits per sample, and only JPEG files of 8 bits are read");
        int height = BinaryPrimitives.ReadUInt16BigEndian(data[1..]);
        int width = BinaryPrimitives.ReadUInt16BigEndian(data[3..]);
        Require(height != 0, "its height is not in its header but after its first scan (marker DNL), which is not read");
        PictureLimits.CheckSize(width, height);
        int count = data[5];
        Require(count is 1 or 3 or 4, $"it has {count} components, and only pictures of 1 (grey), 3 (colour) or 4 (ink) are read");
        var components = new JpegComponent[count];
        for (int i = 0; i < count; i++)
        {
            ReadOnlySpan<byte> c = data.Slice(6 + (3 * i), 3);
            (int horizontal, int vertical) = (c[1] >> 4, c[1] & 15);
            Require(horizontal is >= 1 and <= 4 && vertical is >= 1 and <= 4, $"its sampling factors {horizontal}×{vertical} are not from 1 to 4");
            Require(c[2] < 4, $"its quantization table {c[2]} is not from 0 to 3");
            components[i] = new JpegComponent(c[0], horizontal, vertical, c[2]);
            Require(components.Take(i).All(other => other.Id != components[i].Id), "two of its components have the same name");
        }

        return new JpegFrame(width, height, marker == 0xC2, components);
    }

    /// <summary>Divides and rounds up.</summary>
    public static int Divide(int a, int b) => (a + b - 1) / b;
}
