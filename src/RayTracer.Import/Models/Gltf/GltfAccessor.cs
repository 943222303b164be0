using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>An accessor: how to find so many elements in a buffer view, checked against the view's bytes (glTF 2.0, section 3.6.2).</summary>
internal sealed class GltfAccessor
{
    private readonly GltfBufferView? _view;
    private readonly int _offset;
    private readonly int _stride;
    private readonly GltfSparse? _sparse;
    private readonly bool _isNormalized;

    /// <summary>Reads what the accessor says of itself, and checks it.</summary>
    /// <param name="document">The file.</param>
    /// <param name="buffers">Its buffers.</param>
    /// <param name="index">Which accessor: an index that has been checked.</param>
    public GltfAccessor(GltfDocument document, GltfBuffers buffers, int index)
    {
        Object = document.List("accessors")[index];
        Type = ComponentType(Object);
        Count = Object.RequiredInteger("count", 1);
        string shape = Object.Text("type") ?? throw Object.Missing("type");
        Components = shape switch
        {
            "SCALAR" => 1,
            "VEC2" => 2,
            "VEC3" => 3,
            "VEC4" or "MAT2" => 4,
            "MAT3" => 9,
            "MAT4" => 16,
            _ => throw Object.Error("type", $"{Quotation.Of(shape)} is not one of SCALAR, VEC2, VEC3, VEC4, MAT2, MAT3, MAT4"),
        };
        _isNormalized = Object.Flag("normalized");
        int size = Components * GltfComponent.Size(Type);
        _offset = Object.Integer("byteOffset") ?? 0;
        _stride = size;
        if (document.Reference(Object, "bufferView", "bufferViews") is { } view)
        {
            _view = buffers.View(view);
            _stride = _view.Stride ?? size;
            CheckRange(size);
        }

        if (Object.Child("sparse") is { } sparse)
        {
            _sparse = new(document, buffers, sparse, Count, size);
        }
    }

    /// <summary>The accessor in the file.</summary>
    public GltfObject Object { get; }

    /// <summary>The type of its numbers.</summary>
    public GltfComponentType Type { get; }

    /// <summary>The number of elements: not more than the file has bytes for, unless most are zeros that the file leaves out.</summary>
    public int Count { get; }

    /// <summary>The number of components of an element.</summary>
    public int Components { get; }

    /// <summary>False where all elements are zeros, since there is nothing in the file for them.</summary>
    public bool HasBytes => _view is not null || _sparse is not null;

    /// <summary>Reads the first numbers of every element, one element after the other.</summary>
    /// <param name="into">Takes the numbers: <see cref="Count"/> times <paramref name="taken"/>.</param>
    /// <param name="taken">The number of numbers read of each element, at most <see cref="Components"/>.</param>
    public void Read(Span<float> into, int taken)
    {
        int size = GltfComponent.Size(Type);
        for (int i = 0; _view is not null && i < Count; i++)
        {
            ReadElement(_view.Bytes.Span[(_offset + (i * _stride))..], into.Slice(i * taken, taken), size);
        }

        for (int i = 0; i < (_sparse?.Count ?? 0); i++)
        {
            ReadElement(_sparse!.Value(i), into.Slice(_sparse.Element(i) * taken, taken), size);
        }
    }

    /// <summary>Reads whole numbers.</summary>
    /// <param name="into">Takes the numbers: <see cref="Count"/> times <see cref="Components"/>.</param>
    public void Read(Span<uint> into)
    {
        int size = GltfComponent.Size(Type);
        for (int i = 0; i < Count * Components && _view is not null; i++)
        {
            into[i] = GltfComponent.Whole(Type, _view.Bytes.Span[(_offset + (i / Components * _stride) + (i % Components * size))..]);
        }

        for (int i = 0; i < (_sparse?.Count ?? 0) * Components; i++)
        {
            into[(_sparse!.Element(i / Components) * Components) + (i % Components)] = GltfComponent.Whole(Type, _sparse.Value(i / Components)[(i % Components * size)..]);
        }
    }

    /// <summary>The place of an element, for messages.</summary>
    public string Place(int element) => _view is null ? $"element {element}"
        : $"element {element} (byte {(long)_view.Offset + _offset + ((long)element * _stride)} of buffers[{_view.Buffer}])";

    internal static GltfComponentType ComponentType(GltfObject from)
    {
        int code = from.RequiredInteger("componentType");
        return Enum.IsDefined((GltfComponentType)code)
            ? (GltfComponentType)code
            : throw from.Error("componentType", $"{code} is not one of 5120 (byte), 5121, 5122 (short), 5123, 5125 (unsigned int), 5126 (float)");
    }

    private void CheckRange(int size)
    {
        long end = _offset + ((long)(Count - 1) * _stride) + size;
        if (end > _view!.Bytes.Length)
        {
            throw Object.Error($"its {Count} elements end at byte {end} of {_view.Object.Path}, which has {_view.Bytes.Length} bytes");
        }
    }

    private void ReadElement(ReadOnlySpan<byte> bytes, Span<float> into, int size)
    {
        for (int c = 0; c < into.Length; c++)
        {
            into[c] = GltfComponent.Real(Type, _isNormalized, bytes[(c * size)..]);
        }
    }
}
