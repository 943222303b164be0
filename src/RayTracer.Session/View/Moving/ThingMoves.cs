using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Session;

/// <summary>How things have moved between two pictures of a moving view: each is scaled and shifted along the axes.</summary>
internal sealed unsafe class ThingMoves
{
    private readonly int _count;

    // For each thing, a plane for each axis of the scale, and of the offset.
    private readonly PinnedBuffer<float>? _moves;

    /// <summary>Takes those that have moved.</summary>
    /// <param name="moved">By the things' numbers, the scale and offset that give the place before.</param>
    /// <param name="count">The number of all things.</param>
    public ThingMoves(IReadOnlyDictionary<int, (Vector3 Scale, Vector3 Offset)> moved, int count)
    {
        if (moved.Count == 0)
        {
            return;
        }

        (_count, _moves) = (count, new(6L * count));
        new Span<float>(_moves.Pointer, 3 * count).Fill(1);
        foreach ((int thing, (Vector3 scale, Vector3 offset)) in moved)
        {
            for (int axis = 0; axis < 3; axis++)
            {
                (_moves.Pointer[(axis * count) + thing], _moves.Pointer[((3 + axis) * count) + thing]) = (scale[axis], offset[axis]);
            }
        }
    }

    /// <summary>Returns whether any thing is not where it was.</summary>
    public bool HaveMoved => _moves is not null;

    /// <summary>Where points of things were before; of what is none, where they are.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public Vec3W Before(in UIntW things, in Vec3W points) => _moves is null ? points : Moved(things, points);

    private Vec3W Moved(in UIntW things, in Vec3W points)
    {
        UIntW thing = (things < (uint)_count).Select(things, 0u);
        FloatW Of(int plane) => FloatW.Gather(_moves!.Pointer + (plane * _count), thing);
        return new((points.X * Of(0)) + Of(3), (points.Y * Of(1)) + Of(4), (points.Z * Of(2)) + Of(5));
    }
}
