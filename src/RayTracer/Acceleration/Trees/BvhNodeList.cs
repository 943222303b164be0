using System.Runtime.InteropServices;

namespace RayTracer.Acceleration;

/// <summary>Nodes of a part of a tree while it grows.</summary>
internal sealed unsafe class BvhNodeList(int capacity) : IDisposable
{
    private NativeMemoryBlock _memory = new((long)capacity * BvhNode.Bytes);
    private int _capacity = capacity;

    /// <summary>Number of nodes.</summary>
    public int Count { get; private set; }

    /// <summary>A node; the pointer holds until the next <see cref="Add"/>.</summary>
    public BvhNode* this[int index] => (BvhNode*)_memory.Pointer + index;

    /// <summary>Adds a node, whose contents are undefined.</summary>
    /// <returns>Its index.</returns>
    public int Add()
    {
        if (Count == _capacity)
        {
            _capacity *= 2;
            NativeMemoryBlock larger = new((long)_capacity * BvhNode.Bytes);
            NativeMemory.Copy(_memory.Pointer, larger.Pointer, (nuint)Count * BvhNode.Bytes);
            _memory.Dispose();
            _memory = larger;
        }

        return Count++;
    }

    /// <summary>Copies all nodes to their place in the whole tree.</summary>
    /// <param name="target">The index of the first one.</param>
    /// <param name="first">Its index there.</param>
    public void MoveTo(BvhNode* target, int first)
    {
        for (int index = 0; index < Count; index++)
        {
            target[index] = *this[index];
            for (int child = 0; child < target[index].Count; child++)
            {
                uint reference = target[index].Child[child];
                bool isLeaf = (reference & BvhNode.LeafBit) != 0;
                target[index].Child[child] = isLeaf ? reference : reference + (uint)first;
            }
        }
    }

    public void Dispose() => _memory.Dispose();
}
