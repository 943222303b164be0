using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Acceleration;

/// <summary>
/// Finds the shapes that a ray may meet: a tree over their boxes, through which each ray goes by itself. The shapes are met by the same
/// code as without the tree, so the hits are the same to the bit.
/// </summary>
internal sealed class ShapeTree
{
    // How far boxes are made wider, as a fraction of their largest coordinate: outlines are (OutlineSlack), and hits are rounded.
    private const float BoxSlack = 1f / (1 << 18);
    private readonly ShapeBatch[] _batches;
    private readonly WideBvh _tree;

    /// <summary>Builds the tree.</summary>
    /// <param name="shapes">The shapes, in the order of their primitive numbers.</param>
    /// <param name="batches">The same, packed.</param>
    public ShapeTree(Shape[] shapes, ShapeBatch[] batches)
    {
        _batches = batches;
        float[] boxes = new float[6L * shapes.Length];
        for (int i = 0; i < shapes.Length; i++)
        {
            Bounds box = shapes[i].Bounds;
            Vector3 slack = new(BoxSlack * Vector3.Max(Vector3.Abs(box.Minimum), Vector3.Abs(box.Maximum)).Largest());
            (box.Minimum - slack).CopyTo(boxes.AsSpan(6 * i));
            (box.Maximum + slack).CopyTo(boxes.AsSpan((6 * i) + 3));
        }

        _tree = WideBvh.Build(boxes, 1, Environment.ProcessorCount);
    }

    /// <summary>The shapes that are in the tree: those that have an end.</summary>
    public ReadOnlySpan<int> Members => _tree.Order;

    /// <summary>Memory of the tree.</summary>
    public long MemoryBytes => _tree.MemoryBytes;

    /// <summary>Shortens a ray to the nearest hit. Of equal distances the lowest primitive number wins.</summary>
    /// <param name="ray">The ray; its direction has unit length.</param>
    /// <param name="limit">The distance at which hits counted at first.</param>
    /// <param name="distance">Distance of the nearest hit so far.</param>
    /// <param name="primitive">The primitive hit so far.</param>
    public void ClosestHit(in SpaceRay ray, float limit, ref float distance, ref uint primitive)
    {
        Nearest search = new(this, ray, limit, distance, primitive);
        SingleRayTraversal.Follow<ClosestSearch, Nearest>(_tree, ray, distance, ref search, out _);
        (distance, primitive) = (search.Distance, search.Primitive);
    }

    /// <summary>Returns whether a shape stands in the way of a ray.</summary>
    /// <param name="ray">The ray; its direction has unit length.</param>
    /// <param name="distance">The distance over which the ray must be free.</param>
    /// <param name="skip">A primitive that does not count; −1 for none.</param>
    public bool AnyHit(in SpaceRay ray, float distance, int skip)
    {
        Any search = new(this, ray, skip);
        return SingleRayTraversal.Follow<AnySearch, Any>(_tree, ray, distance, ref search, out _);
    }

    // The batch of the shape in a leaf, and its number in the batch.
    private ShapeBatch BatchOf(uint leaf, out int shape)
    {
        shape = _tree.Order[BvhNode.LeafFirst(leaf)];
        int batch = 0;
        for (; shape >= _batches[batch].Count; batch++)
        {
            shape -= _batches[batch].Count;
        }

        return _batches[batch];
    }

    private struct Nearest(ShapeTree tree, in SpaceRay ray, float limit, float distance, uint primitive) : ILeaves
    {
        private readonly Vec3W _origin = ray.Origin;
        private readonly Vec3W _direction = ray.Direction;

        public float Distance = distance;

        public uint Primitive = primitive;

        public readonly unsafe void Prefetch(BvhNode* nodes, uint reference)
        {
        }

        public bool Meet(uint leaf, ref float distance)
        {
            // An equally near hit must be seen, for its number may be lower; but not one at the limit.
            ShapeBatch batch = tree.BatchOf(leaf, out int thing);
            FloatW t = float.Min(float.BitIncrement(Distance), limit);
            UIntW hit = uint.MaxValue;
            batch.ClosestHit(thing, thing + 1, _origin, _direction, ref t, ref hit);
            if (hit[0] != uint.MaxValue && (t[0] < Distance || hit[0] < Primitive))
            {
                (Distance, Primitive) = (t[0], hit[0]);
                distance = Distance;
            }

            return true;
        }
    }

    private readonly struct Any(ShapeTree tree, in SpaceRay ray, int skip) : ILeaves
    {
        private readonly Vec3W _origin = ray.Origin;
        private readonly Vec3W _direction = ray.Direction;

        public unsafe void Prefetch(BvhNode* nodes, uint reference)
        {
        }

        public bool Meet(uint leaf, ref float distance)
        {
            ShapeBatch batch = tree.BatchOf(leaf, out int thing);
            MaskW free = MaskW.All;
            batch.Occlude(thing, thing + 1, _origin, _direction, distance, skip, ref free);
            return !free.Any;
        }
    }
}
