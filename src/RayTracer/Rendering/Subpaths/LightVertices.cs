using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// The vertices of all light paths of a pass, path by path, and those of a path in their order: so what is computed from them does not depend on the
/// threads that made them.
/// </summary>
/// <param name="paths">The number of paths.</param>
internal sealed unsafe class LightVertices(int paths)
{
    /// <summary>The number of paths that one thread follows at a time.</summary>
    public const int BlockSize = 4096;

    // Kept for the next pass: memory that each pass allocates has to be collected.
    private readonly LightVertex[][] _blocks = [.. Enumerable.Repeat<LightVertex[]>([], ((paths - 1) / BlockSize) + 1)];
    private readonly int[] _counts = new int[((paths - 1) / BlockSize) + 1];
    private readonly PinnedBuffer<uint> _first = new(paths + 1L);
    private PinnedBuffer<LightVertex> _vertices = new(0);
    private int _capacity;

    /// <summary>The number of paths.</summary>
    public int Paths => paths;

    /// <summary>The number of blocks of paths.</summary>
    public int Blocks => _blocks.Length;

    /// <summary>The number of vertices.</summary>
    public int Count => (int)_first.Pointer[paths];

    /// <summary>The vertices.</summary>
    public LightVertex* Vertices => _vertices.Pointer;

    /// <summary>Of each path, the number of its first vertex; those of the next path follow.</summary>
    public uint* First => _first.Pointer;

    /// <summary>Takes the vertices of a block of paths, in any order in which those of a path are in theirs.</summary>
    /// <param name="block">Number of the block.</param>
    /// <param name="vertices">The vertices.</param>
    public void SetBlock(int block, ReadOnlySpan<LightVertex> vertices)
    {
        int firstPath = block * BlockSize;
        int count = Math.Min(BlockSize, paths - firstPath);
        Span<int> next = stackalloc int[BlockSize + 1];
        next.Clear();
        foreach (ref readonly LightVertex vertex in vertices)
        {
            next[(int)vertex.Path - firstPath + 1]++;
        }

        for (int path = 0; path < count; path++)
        {
            _first.Pointer[firstPath + path] = (uint)next[path];
            next[path + 1] += next[path];
        }

        if (_blocks[block].Length < vertices.Length)
        {
            _blocks[block] = GC.AllocateUninitializedArray<LightVertex>(vertices.Length * 9 / 8);
        }

        LightVertex[] sorted = _blocks[block];
        foreach (ref readonly LightVertex vertex in vertices)
        {
            sorted[next[(int)vertex.Path - firstPath]++] = vertex;
        }

        _counts[block] = vertices.Length;
    }

    /// <summary>Puts all blocks together.</summary>
    /// <exception cref="OutOfMemoryException">There is not so much memory.</exception>
    public void Join(int threads)
    {
        int[] starts = new int[_blocks.Length + 1];
        for (int block = 0; block < _blocks.Length; block++)
        {
            starts[block + 1] = checked(starts[block] + _counts[block]);
        }

        if (_capacity < starts[^1])
        {
            _capacity = (int)Math.Min(starts[^1] * 9L / 8, Array.MaxLength / 8);
            _vertices = new(_capacity);
        }

        Parallel.For(0, _blocks.Length, new ParallelOptions { MaxDegreeOfParallelism = threads }, block =>
        {
            _blocks[block].AsSpan(0, _counts[block]).CopyTo(new(_vertices.Pointer + starts[block], _counts[block]));
            for (int path = block * BlockSize; path < Math.Min((block + 1) * BlockSize, paths); path++)
            {
                _first.Pointer[path] += (uint)starts[block];
            }
        });
        _first.Pointer[paths] = (uint)starts[^1];
    }
}
