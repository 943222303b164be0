using System.Buffers.Binary;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>
/// An animated PNG (W3C PNG specification, third edition, sections 11.3.4.1 to 11.3.4.3): pictures of one size, shown one after the other
/// without end. Programs that know no animation show the first. The compressed pictures are in memory until they are written.
/// </summary>
/// <param name="texts">Texts to keep in the file.</param>
/// <param name="secondsPerFrame">The time for which each picture is shown, in seconds.</param>
public sealed class AnimatedPng(IEnumerable<KeyValuePair<string, string>> texts, double secondsPerFrame)
{
    private readonly List<byte[]> _frames = [];
    private int _bitDepth;
    private int _width;
    private int _height;

    /// <summary>Returns whether a file's name is that of an animated PNG and of nothing else.</summary>
    public static bool IsNamed(string path) => path.EndsWith(".apng", StringComparison.OrdinalIgnoreCase);

    /// <summary>The number of its pictures.</summary>
    public int Count => _frames.Count;

    /// <summary>Adds a picture.</summary>
    /// <param name="png">A whole PNG file, as <see cref="PngWriter"/> makes it.</param>
    /// <exception cref="PictureException">It is damaged.</exception>
    /// <exception cref="ArgumentException">It has another size than the first.</exception>
    public void Add(ReadOnlySpan<byte> png)
    {
        using MemoryStream data = new();
        PngChunks chunks = new(png);
        while (chunks.Next())
        {
            if (chunks.Type == "IHDR")
            {
                Fit(BinaryPrimitives.ReadInt32BigEndian(chunks.Data), BinaryPrimitives.ReadInt32BigEndian(chunks.Data[4..]), chunks.Data[8]);
            }
            else if (chunks.Type == "IDAT")
            {
                data.Write(chunks.Data);
            }
        }

        _frames.Add(data.ToArray());
    }

    private void Fit(int width, int height, int bitDepth)
    {
        if (_frames.Count > 0 && (width, height, bitDepth) != (_width, _height, _bitDepth))
        {
            throw new ArgumentException($"The pictures of an animated PNG have one size: {width}×{height} follows {_width}×{_height}.", nameof(width));
        }

        (_width, _height, _bitDepth) = (width, height, bitDepth);
    }

    /// <summary>Writes the file, whole or not at all (<see cref="AtomicFile"/>).</summary>
    /// <param name="path">The file.</param>
    /// <exception cref="ImageWriteException">It cannot be written.</exception>
    /// <exception cref="InvalidOperationException">There is no picture.</exception>
    public void Write(string path)
    {
        if (_frames.Count == 0)
        {
            throw new InvalidOperationException("An animation needs a picture.");
        }

        AtomicFile.Write(path, Write);
    }

    private void Write(Stream output)
    {
        PngWriter.WriteStart(output, _width, _height, _bitDepth);
        Span<byte> control = stackalloc byte[8];
        control.Clear();
        BinaryPrimitives.WriteInt32BigEndian(control, _frames.Count);
        PngChunkStream.WriteChunk(output, "acTL"u8, control);
        PngWriter.WriteTexts(output, texts);
        int sequence = 0;
        for (int i = 0; i < _frames.Count; i++)
        {
            WriteControl(output, sequence++);
            if (i == 0)
            {
                PngChunkStream.WriteChunk(output, "IDAT"u8, _frames[i]);
                continue;
            }

            byte[] data = new byte[4 + _frames[i].Length];
            BinaryPrimitives.WriteInt32BigEndian(data, sequence++);
            _frames[i].CopyTo(data, 4);
            PngChunkStream.WriteChunk(output, "fdAT"u8, data);
        }

        PngChunkStream.WriteChunk(output, "IEND"u8, []);
    }

    // The whole picture, in place of the one before.
    private void WriteControl(Stream output, int sequence)
    {
        (ushort numerator, ushort denominator) = Delay(secondsPerFrame);
        Span<byte> control = stackalloc byte[26];
        control.Clear();
        BinaryPrimitives.WriteInt32BigEndian(control, sequence);
        BinaryPrimitives.WriteInt32BigEndian(control[4..], _width);
        BinaryPrimitives.WriteInt32BigEndian(control[8..], _height);
        BinaryPrimitives.WriteUInt16BigEndian(control[20..], numerator);
        BinaryPrimitives.WriteUInt16BigEndian(control[22..], denominator);
        PngChunkStream.WriteChunk(output, "fcTL"u8, control);
    }

    // One over a whole number where it is that, else as finely as the two numbers allow.
    private static (ushort Numerator, ushort Denominator) Delay(double seconds)
    {
        double rate = 1 / seconds;
        if (double.Abs(rate - double.Round(rate)) < 1e-6 * rate && double.Round(rate) is >= 1 and <= ushort.MaxValue)
        {
            return ((ushort)1, (ushort)double.Round(rate));
        }

        double parts = double.Clamp(double.Floor(ushort.MaxValue / double.Max(seconds, 1)), 1, ushort.MaxValue);
        return ((ushort)double.Clamp(double.Round(seconds * parts), 1, ushort.MaxValue), (ushort)parts);
    }
}
