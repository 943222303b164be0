using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Acceleration;

/// <summary>Meets rays with all shapes of a space, kind by kind (report: Intersect and ShadowHit).</summary>
/// <param name="batches">The shapes, packed by kind, in the order of their primitive numbers.</param>
/// <param name="nothing">What stands for no primitive: a number that none has.</param>
public sealed class PrimitiveList(ShapeBatch[] batches, int nothing)
{
    private readonly ShapeBatch[] _batches = batches;

    /// <summary>Number of primitives.</summary>
    public int Count { get; } = batches.Sum(b => b.Count);

    /// <summary>Finds the nearest hit of each ray.</summary>
    /// <param name="origin">Where the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">Distance to the nearest hit; infinite where there is none.</param>
    /// <param name="primitive">The primitive hit; the number that stands for nothing where there is none.</param>
    public void ClosestHit(in Vec3W origin, in Vec3W direction, out FloatW distance, out UIntW primitive)
    {
        distance = float.PositiveInfinity;
        primitive = (uint)nothing;
        Shorten(origin, direction, ref distance, ref primitive);
    }

    /// <summary>Shortens rays to their nearest hits.</summary>
    /// <param name="origin">Where the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">Distance to the nearest hit so far.</param>
    /// <param name="primitive">The primitive hit so far.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Shorten(in Vec3W origin, in Vec3W direction, ref FloatW distance, ref UIntW primitive)
    {
        foreach (ShapeBatch batch in _batches)
        {
            batch.ClosestHit(origin, direction, ref distance, ref primitive);
        }
    }

    /// <summary>Clears those rays that something stands in the way of.</summary>
    /// <param name="origin">Where the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">How far they must be free.</param>
    /// <param name="skip">A primitive that does not count; −1 for none.</param>
    /// <param name="free">The rays to look at; cleared where they are not free.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Occlude(in Vec3W origin, in Vec3W direction, in FloatW distance, int skip, ref MaskW free)
    {
        foreach (ShapeBatch batch in _batches)
        {
            batch.Occlude(origin, direction, distance, skip, ref free);
            if (!free.Any)
            {
                return;
            }
        }
    }
}
