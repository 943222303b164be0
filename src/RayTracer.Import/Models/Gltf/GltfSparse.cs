namespace RayTracer.Import;

/// <summary>The elements of a sparse accessor that are not those of its buffer view (glTF 2.0, section 3.6.2.3).</summary>
internal sealed class GltfSparse
{
    private readonly ReadOnlyMemory<byte> _indices;
    private readonly ReadOnlyMemory<byte> _values;
    private readonly GltfComponentType _indexType;
    private readonly int _size;

    /// <summary>Checks the lists of places and values.</summary>
    /// <param name="document">The file.</param>
    /// <param name="buffers">Its buffers.</param>
    /// <param name="sparse">The accessor's property "sparse".</param>
    /// <param name="elements">The number of elements of the accessor.</param>
    /// <param name="size">Bytes of an element.</param>
    public GltfSparse(GltfDocument document, GltfBuffers buffers, GltfObject sparse, int elements, int size)
    {
        Count = sparse.RequiredInteger("count", 1, elements);
        GltfObject indices = sparse.RequiredChild("indices");
        _indexType = GltfAccessor.ComponentType(indices);
        if (_indexType is not (GltfComponentType.UnsignedByte or GltfComponentType.UnsignedShort or GltfComponentType.UnsignedInt))
        {
            throw indices.Error("componentType", "places must be unsigned whole numbers (5121, 5123 or 5125)");
        }

        _size = size;
        _indices = Bytes(document, buffers, indices, Count, GltfComponent.Size(_indexType));
        _values = Bytes(document, buffers, sparse.RequiredChild("values"), Count, size);
        for (int i = 0; i < Count; i++)
        {
            uint place = GltfComponent.Whole(_indexType, _indices.Span[(i * GltfComponent.Size(_indexType))..]);
            if (place >= elements)
            {
                throw indices.Error($"place {i} is {place}, but the accessor has only {elements} elements");
            }
        }
    }

    /// <summary>The number of elements that are replaced.</summary>
    public int Count { get; }

    /// <summary>The element that is replaced.</summary>
    public int Element(int i) => (int)GltfComponent.Whole(_indexType, _indices.Span[(i * GltfComponent.Size(_indexType))..]);

    /// <summary>The bytes from where the replacement begins.</summary>
    public ReadOnlySpan<byte> Value(int i) => _values.Span[(i * _size)..];

    private static ReadOnlyMemory<byte> Bytes(GltfDocument document, GltfBuffers buffers, GltfObject from, int count, int size)
    {
        GltfBufferView view = buffers.View(document.RequiredReference(from, "bufferView", "bufferViews"));
        int offset = from.Integer("byteOffset") ?? 0;
        long needed = (long)count * size;
        return offset + needed <= view.Bytes.Length
            ? view.Bytes.Slice(offset, (int)needed)
            : throw from.Error($"{needed} bytes from byte {offset} are beyond the end of {view.Object.Path}, which has {view.Bytes.Length} bytes");
    }
}
