using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Acceleration;

/// <summary>
/// The functions by which <see cref="KernelBatch{TKernel}"/> meets shapes of one kind with rays, a packet of lanes at a time. An entry of the packed
/// table holds the constants of one shape. Rays start at distance 0; of their directions, all have unit length.
/// </summary>
public unsafe interface IShapeKernel
{
    /// <summary>Floats a shape in the packed table.</summary>
    static abstract int Constants { get; }

    /// <summary>Writes a shape's entry.</summary>
    static abstract void Pack(Shape shape, float* entry);

    /// <summary>
    /// The smallest distance above zero at which rays meet the shape of an entry; where they do not, NaN, infinity, or anything not above
    /// zero.
    /// </summary>
    static abstract FloatW Meet(float* q, in Vec3W origin, in Vec3W direction);

    /// <summary>
    /// Which segments that end on the shape, on a side that faces them, cross it before. Only shapes that are not convex can hide a part of
    /// themselves.
    /// </summary>
    static virtual MaskW HidesItself(float* q, in Vec3W origin, in Vec3W direction, in FloatW distance) => MaskW.None;

    /// <summary>As <see cref="SurfaceTable.Describe"/>.</summary>
    static abstract void Describe(in PrimitiveIndex primitives, float* table, bool needsUv, ref SurfaceW surface);

    /// <summary>As <see cref="SurfaceTable.DescribeTangents"/>.</summary>
    static abstract void DescribeTangents(in PrimitiveIndex primitives, float* table, ref SurfaceW surface);
}

/// <summary>Shapes whose occlusion follows from the nearest hit.</summary>
/// <typeparam name="TKernel">How they are met.</typeparam>
public sealed unsafe class KernelBatch<TKernel> : ShapeBatch
    where TKernel : struct, IShapeKernel
{
    /// <summary>Packs shapes.</summary>
    public KernelBatch(IReadOnlyList<Shape> shapes)
        : base(shapes.Count, TKernel.Constants)
    {
        for (int i = 0; i < shapes.Count; i++)
        {
            TKernel.Pack(shapes[i], Table + (i * TKernel.Constants));
        }
    }

    /// <inheritdoc/>
    public override void ClosestHit(int from, int to, in Vec3W origin, in Vec3W direction, ref FloatW distance, ref UIntW primitive)
    {
        FloatW nearest = distance;
        UIntW hitPrimitive = primitive;
        float* q = Table + ((long)from * TKernel.Constants);
        for (int i = from; i < to; i++, q += TKernel.Constants)
        {
            FloatW t = TKernel.Meet(q, origin, direction);
            MaskW hit = (t > 0f) & (t < nearest);
            nearest = hit.Select(t, nearest);
            hitPrimitive = hit.Select((uint)(FirstPrimitive + i), hitPrimitive);
        }

        distance = nearest;
        primitive = hitPrimitive;
    }

    /// <inheritdoc/>
    public override void Occlude(int from, int to, in Vec3W origin, in Vec3W direction, in FloatW distance, int skip, ref MaskW free)
    {
        int skipped = skip - FirstPrimitive;
        float* q = Table + ((long)from * TKernel.Constants);
        for (int i = from; i < to && free.Any; i++, q += TKernel.Constants)
        {
            if (i == skipped)
            {
                free = free.Except(TKernel.HidesItself(q, origin, direction, distance));
            }
            else
            {
                FloatW t = TKernel.Meet(q, origin, direction);
                free = free.Except((t > 0f) & (t < distance));
            }
        }
    }

    /// <inheritdoc/>
    public override void Describe(in PrimitiveIndex primitives, bool needsUv, ref SurfaceW surface) =>
        TKernel.Describe(primitives, Table, needsUv, ref surface);

    /// <inheritdoc/>
    public override void DescribeTangents(in PrimitiveIndex primitives, ref SurfaceW surface) =>
        TKernel.DescribeTangents(primitives, Table, ref surface);
}
