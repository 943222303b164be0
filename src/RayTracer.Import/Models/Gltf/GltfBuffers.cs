namespace RayTracer.Import;

/// <summary>The buffers of a glTF file and the views of them, checked against the bytes that there really are.</summary>
internal sealed class GltfBuffers(GltfDocument document, GltfFiles files)
{
    private static readonly string[] Compressions = ["EXT_meshopt_compression", "KHR_meshopt_compression"];
    private readonly Dictionary<int, ReadOnlyMemory<byte>> _buffers = [];

    /// <summary>The bytes of a buffer view.</summary>
    /// <param name="index">Which view: an index that has been checked.</param>
    public GltfBufferView View(int index)
    {
        GltfObject view = document.List("bufferViews")[index];
        int bufferIndex = document.RequiredReference(view, "buffer", "buffers");
        ReadOnlyMemory<byte> buffer = Buffer(bufferIndex);
        int offset = view.Integer("byteOffset") ?? 0;
        int length = view.RequiredInteger("byteLength", 1);
        if ((long)offset + length > buffer.Length)
        {
            throw view.Error($"bytes {offset} to {(long)offset + length - 1} are beyond the end of buffers[{bufferIndex}], which has {buffer.Length} bytes");
        }

        // The specification asks for strides of 4 to 252 in steps of 4; any stride can be read.
        return new(view, buffer.Slice(offset, length), bufferIndex, offset, view.Integer("byteStride", 1));
    }

    private ReadOnlyMemory<byte> Buffer(int index)
    {
        if (_buffers.TryGetValue(index, out ReadOnlyMemory<byte> known))
        {
            return known;
        }

        GltfObject buffer = document.List("buffers")[index];
        int length = buffer.RequiredInteger("byteLength", 1);
        ReadOnlyMemory<byte> bytes = buffer.Text("uri") is { } uri ? files.Read(buffer, uri)
            : index == 0 && document.BinaryChunk is { } chunk ? chunk
            : Compressions.FirstOrDefault(c => buffer.Extension(c) is not null) is { } compression
            ? throw buffer.Error($"it is compressed with {compression}, which is not read: export it without compression")
            : throw buffer.Error("it has no \"uri\", and the file has no binary chunk for it");
        if (length > bytes.Length)
        {
            throw buffer.Error("byteLength", $"the buffer claims {length} bytes, but there are only {bytes.Length}");
        }

        bytes = bytes[..length];
        _buffers.Add(index, bytes);
        return bytes;
    }
}

/// <summary>A part of a buffer.</summary>
/// <param name="Object">The view in the file.</param>
/// <param name="Bytes">The view's bytes.</param>
/// <param name="Buffer">Which buffer they are of.</param>
/// <param name="Offset">The offset in the buffer at which they begin.</param>
/// <param name="Stride">Bytes from one element to the next; null where elements are packed.</param>
internal sealed record GltfBufferView(GltfObject Object, ReadOnlyMemory<byte> Bytes, int Buffer, int Offset, int? Stride);
