using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Acceleration;

/// <summary>
/// All shapes of one kind in a scene, packed for intersection. The shapes have consecutive primitive numbers. A ray starts a
/// little off the surface that it leaves (<see cref="SurfaceW.Offset"/>), so every hit at a distance above zero counts.
/// </summary>
/// <param name="count">Number of shapes.</param>
/// <param name="constants">Floats a shape in the packed table.</param>
public abstract unsafe class ShapeBatch(int count, int constants) : SurfaceTable(count, constants)
{
    private readonly PinnedBuffer<float> _memory = new(Math.Max(1L, (long)count * constants));

    /// <summary>The packed table.</summary>
    private protected float* Table => _memory.Pointer;

    /// <inheritdoc/>
    public override long MemoryBytes => (long)Count * Stride * sizeof(float);

    /// <summary>Shortens rays to the nearest shape of this kind.</summary>
    /// <param name="origin">The points from which the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">Distance of the nearest hit so far; shortened.</param>
    /// <param name="primitive">The primitive hit so far; replaced where the ray was shortened. Among equal distances the lowest number
    /// wins.</param>
    public void ClosestHit(in Vec3W origin, in Vec3W direction, ref FloatW distance, ref UIntW primitive) =>
        ClosestHit(0, Count, origin, direction, ref distance, ref primitive);

    /// <summary>Shortens rays to the nearest of some shapes of this kind.</summary>
    /// <param name="from">Index of the first shape.</param>
    /// <param name="to">Index behind the last shape.</param>
    /// <param name="origin">The points from which the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">Distance of the nearest hit so far; shortened.</param>
    /// <param name="primitive">The primitive hit so far; replaced where the ray was shortened. Among equal distances the lowest number
    /// wins.</param>
    public abstract void ClosestHit(int from, int to, in Vec3W origin, in Vec3W direction, ref FloatW distance, ref UIntW primitive);

    /// <summary>Finds out which rays are free (report: ShadowHit, which ends at the first hit here).</summary>
    /// <param name="origin">The points from which the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">The distance over which the rays must be free.</param>
    /// <param name="skip">A primitive that does not count: the light source that the rays end on, of which only what lies before that end
    /// may be in the way; −1 for none.</param>
    /// <param name="free">The rays that are free so far; cleared where a shape stands in the way.</param>
    public void Occlude(in Vec3W origin, in Vec3W direction, in FloatW distance, int skip, ref MaskW free) =>
        Occlude(0, Count, origin, direction, distance, skip, ref free);

    /// <summary>Finds out which rays are free of some shapes of this kind.</summary>
    /// <param name="from">Index of the first shape.</param>
    /// <param name="to">Index behind the last shape.</param>
    /// <param name="origin">The points from which the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">The distance over which the rays must be free.</param>
    /// <param name="skip">A primitive that does not count, as above.</param>
    /// <param name="free">The rays that are free so far; cleared where a shape stands in the way.</param>
    public abstract void Occlude(int from, int to, in Vec3W origin, in Vec3W direction, in FloatW distance, int skip, ref MaskW free);
}
