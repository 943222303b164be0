using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Acceleration;

/// <summary>
/// All shapes of one kind in a scene, packed for intersection. The shapes have consecutive primitive numbers. A ray starts a
/// little off the surface that it leaves (<see cref="SurfaceW.Offset"/>), so every hit at a distance above zero counts.
/// </summary>
/// <param name="count">Number of shapes.</param>
/// <param name="constants">Floats a shape in the packed table.</param>
public abstract unsafe class ShapeBatch(int count, int constants)
{
    private readonly PinnedBuffer<float> _memory = new(Math.Max(1L, (long)count * constants));

    /// <summary>The packed table.</summary>
    private protected float* Table => _memory.Pointer;

    /// <summary>Number of shapes.</summary>
    public int Count { get; } = count;

    /// <summary>Floats a shape in the packed table.</summary>
    public int Stride { get; } = constants;

    /// <summary>Number of the first shape among the scene's primitives.</summary>
    public int FirstPrimitive { get; internal set; }

    /// <summary>Memory of the table in bytes.</summary>
    public long MemoryBytes => (long)Count * Stride * sizeof(float);

    /// <summary>Shortens rays to the nearest shape of this kind.</summary>
    /// <param name="origin">Where the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">Distance of the nearest hit so far; shortened.</param>
    /// <param name="primitive">The primitive hit so far; replaced where the ray was shortened. Among equal distances the lowest number wins.</param>
    public abstract void ClosestHit(in Vec3W origin, in Vec3W direction, ref FloatW distance, ref UIntW primitive);

    /// <summary>Finds out which rays are free (report: ShadowHit, which ends at the first hit here).</summary>
    /// <param name="origin">Where the rays start.</param>
    /// <param name="direction">Unit directions.</param>
    /// <param name="distance">How far the rays must be free.</param>
    /// <param name="skip">A primitive that does not count: the light source that the rays end on, of which only what lies before that end may be in the way; −1 for none.</param>
    /// <param name="free">The rays that are free so far; cleared where a shape stands in the way.</param>
    public abstract void Occlude(in Vec3W origin, in Vec3W direction, in FloatW distance, int skip, ref MaskW free);

    /// <summary>Describes the surface where rays met it.</summary>
    /// <param name="primitives">The primitives hit.</param>
    /// <param name="needsUv">Whether uv is wanted.</param>
    /// <param name="surface">
    /// In: the hit point as computed along the ray. Out: that point moved onto the surface, the outward normal, the offset, and uv where wanted.
    /// </param>
    public abstract void Describe(in PrimitiveIndex primitives, bool needsUv, ref SurfaceW surface);
}

/// <summary>
/// Which shapes of one batch the lanes of a packet have hit. Often all hit the same one: its constants are then
/// broadcast, which is several times faster than gathering them.
/// </summary>
public readonly unsafe struct PrimitiveIndex
{
    private readonly UIntW _offset;
    private readonly int _uniform;

    /// <summary>One shape for all lanes.</summary>
    /// <param name="index">Its index in the batch.</param>
    /// <param name="stride">Floats a shape in the table.</param>
    public PrimitiveIndex(int index, int stride)
    {
        _uniform = index * stride;
        _offset = default;
    }

    /// <summary>A shape for each lane.</summary>
    /// <param name="index">Their indices in the batch.</param>
    /// <param name="stride">Floats a shape in the table.</param>
    public PrimitiveIndex(UIntW index, int stride)
    {
        _uniform = -1;
        _offset = index * (uint)stride;
    }

    /// <summary>One constant of each lane's shape.</summary>
    /// <param name="table">The packed table.</param>
    /// <param name="constant">Position of the constant in a shape's entry.</param>
    internal FloatW Read(float* table, int constant) =>
        _uniform >= 0 ? table[_uniform + constant] : FloatW.Gather(table + constant, _offset);

    /// <summary>Three constants in a row.</summary>
    /// <param name="table">The packed table.</param>
    /// <param name="constant">Position of the first one in a shape's entry.</param>
    internal Vec3W ReadVector(float* table, int constant) =>
        new(Read(table, constant), Read(table, constant + 1), Read(table, constant + 2));
}
