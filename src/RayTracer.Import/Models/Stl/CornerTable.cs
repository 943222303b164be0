using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>Makes one corner of all that have the same position, bit for bit (zeros of both signs are one).</summary>
internal sealed class CornerTable
{
    private readonly List<Vector3> _positions = [];
    private readonly List<int> _indices;
    private int[] _slots; // one more than a corner's number, or 0 where there is none
    private int _shift;

    /// <summary>Makes an empty table.</summary>
    /// <param name="triangles">About how many triangles there will be.</param>
    public CornerTable(int triangles)
    {
        _indices = new List<int>(3 * triangles);
        _slots = [];
        Resize(Math.Max(16, triangles));
    }

    /// <summary>Adds the next corner of a triangle.</summary>
    public void Add(Vector3 position)
    {
        position += Vector3.Zero; // makes −0 to 0
        int slot = (int)(Hash(position) >> _shift);
        while (true)
        {
            int corner = _slots[slot] - 1;
            if (corner < 0)
            {
                _positions.Add(position);
                _slots[slot] = _positions.Count;
                _indices.Add(_positions.Count - 1);
                if (2L * _positions.Count > _slots.Length)
                {
                    Resize(_slots.Length);
                }

                return;
            }

            if (IsSame(_positions[corner], position))
            {
                _indices.Add(corner);
                return;
            }

            slot = (slot + 1) & (_slots.Length - 1);
        }
    }

    /// <summary>The triangles of all corners.</summary>
    public MeshData ToMesh() => new([.. _positions], [.. _indices]);

    // By bits, so that what is no number is equal to itself.
    private static bool IsSame(Vector3 a, Vector3 b) => Bits(a.X) == Bits(b.X) && Bits(a.Y) == Bits(b.Y) && Bits(a.Z) == Bits(b.Z);

    private static uint Bits(float value) => BitConverter.SingleToUInt32Bits(value);

    // Multiplied by odd numbers (of the golden ratio, Knuth 1998), so that the upper bits depend on all.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static ulong Hash(Vector3 p)
    {
        ulong xy = (((ulong)Bits(p.X) << 32) | Bits(p.Y)) * 0x9E3779B97F4A7C15;
        return ((xy ^ (xy >> 29)) + Bits(p.Z)) * 0x9E3779B97F4A7C15;
    }

    // Takes at least twice as many slots as there may be corners.
    private void Resize(int corners)
    {
        int bits = 1 + BitOperations.Log2((uint)corners) + 1;
        _slots = new int[1 << Math.Min(bits, 30)];
        _shift = 64 - BitOperations.Log2((uint)_slots.Length);
        Span<Vector3> positions = CollectionsMarshal.AsSpan(_positions);
        for (int i = 0; i < positions.Length; i++)
        {
            int slot = (int)(Hash(positions[i]) >> _shift);
            while (_slots[slot] != 0)
            {
                slot = (slot + 1) & (_slots.Length - 1);
            }

            _slots[slot] = i + 1;
        }
    }
}
