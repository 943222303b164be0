using RayTracer.Description;

namespace RayTracer.Import;

/// <summary>The accessors of a glTF file, and the memory for what is read by them.</summary>
internal sealed class GltfAccessors(GltfDocument document, GltfBuffers buffers)
{
    private readonly Dictionary<int, GltfAccessor> _accessors = [];
    private readonly Dictionary<(int Accessor, int Taken), float[]> _floats = [];

    /// <summary>The accessor that a property names; null where there is no such property.</summary>
    /// <param name="owner">The object that holds the index.</param>
    /// <param name="key">The property that is the index.</param>
    public GltfAccessor? Find(GltfObject owner, string key) =>
        document.Reference(owner, key, "accessors") is { } index ? _accessors.Remember(index, () => new(document, buffers, index)) : null;

    /// <summary>The numbers of an accessor, those of one element after those of the other; null where there is no such property.</summary>
    /// <param name="owner">The object that holds the index.</param>
    /// <param name="key">The property that is the index.</param>
    /// <param name="components">The number of numbers of an element, which the accessor must have.</param>
    public float[]? Floats(GltfObject owner, string key, int components)
    {
        if (Find(owner, key) is not { } accessor)
        {
            return null;
        }

        if (accessor.Components != components)
        {
            throw owner.Error(key, $"its accessor has {accessor.Components} numbers an element, but {components} are needed");
        }

        return _floats.Remember((document.Reference(owner, key, "accessors")!.Value, components), () =>
        {
            float[] numbers = new float[Ask(accessor, (long)accessor.Count * components * sizeof(float)) * components];
            accessor.Read(numbers, components);
            return numbers;
        });
    }

    /// <summary>Whole numbers; each must be below a limit.</summary>
    /// <param name="accessor">Their accessor.</param>
    /// <param name="owner">The object that names it.</param>
    /// <param name="key">The property that does.</param>
    /// <param name="limit">What they must be below.</param>
    /// <param name="what">What they are numbers of, for messages.</param>
    public uint[] Whole(GltfAccessor accessor, GltfObject owner, string key, int limit, string what)
    {
        uint[] list = new uint[Ask(accessor, (long)accessor.Count * accessor.Components * sizeof(uint)) * accessor.Components];
        accessor.Read(list);
        int wrong = Array.FindIndex(list, n => n >= limit);
        return wrong < 0 ? list
            : throw owner.Error(key, $"{accessor.Place(wrong / accessor.Components)} of {accessor.Object.Path} is {list[wrong]}, but there are only {limit} {what}");
    }

    /// <summary>Asks for memory for the elements of an accessor.</summary>
    /// <returns>Their number.</returns>
    public int Ask(GltfAccessor accessor, long bytes)
    {
        Ask(accessor.Object, bytes);
        return accessor.Count;
    }

    /// <summary>Asks for memory.</summary>
    /// <param name="about">What it is for.</param>
    /// <param name="bytes">How much.</param>
    /// <exception cref="ModelException">No file of this size needs so much.</exception>
    public void Ask(GltfObject about, long bytes)
    {
        if (!document.Memory.TryUse(bytes))
        {
            throw about.Error("the meshes need far more memory than a file of this size can account for");
        }
    }
}
