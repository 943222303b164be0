using System.Buffers.Binary;

namespace RayTracer.Imaging;

/// <summary>Cuts what is written to it into IDAT chunks.</summary>
internal sealed class PngChunkStream(Stream output) : Stream
{
    private readonly byte[] _data = new byte[1 << 16];
    private int _count;

    public override bool CanRead => false;

    public override bool CanSeek => false;

    public override bool CanWrite => true;

    public override long Length => throw new NotSupportedException();

    public override long Position
    {
        get => throw new NotSupportedException();
        set => throw new NotSupportedException();
    }

    /// <summary>Writes one chunk of any type.</summary>
    public static void WriteChunk(Stream output, ReadOnlySpan<byte> type, ReadOnlySpan<byte> data)
    {
        Span<byte> word = stackalloc byte[4];
        BinaryPrimitives.WriteInt32BigEndian(word, data.Length);
        output.Write(word);
        output.Write(type);
        output.Write(data);
        BinaryPrimitives.WriteUInt32BigEndian(word, Crc32.Of(type, data));
        output.Write(word);
    }

    public override void Write(ReadOnlySpan<byte> buffer)
    {
        while (buffer.Length > 0)
        {
            int fits = Math.Min(buffer.Length, _data.Length - _count);
            buffer[..fits].CopyTo(_data.AsSpan(_count));
            _count += fits;
            buffer = buffer[fits..];
            if (_count == _data.Length)
            {
                EndChunk();
            }
        }
    }

    public override void Write(byte[] buffer, int offset, int count) => Write(buffer.AsSpan(offset, count));

    /// <summary>Does nothing: a chunk ends when it is full, or with the stream.</summary>
    public override void Flush()
    {
    }

    public override int Read(byte[] buffer, int offset, int count) => throw new NotSupportedException();

    public override long Seek(long offset, SeekOrigin origin) => throw new NotSupportedException();

    public override void SetLength(long value) => throw new NotSupportedException();

    protected override void Dispose(bool disposing)
    {
        if (disposing && _count > 0)
        {
            EndChunk();
        }

        base.Dispose(disposing);
    }

    private void EndChunk()
    {
        WriteChunk(output, "IDAT"u8, _data.AsSpan(0, _count));
        _count = 0;
    }
}
