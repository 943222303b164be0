using System.Numerics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>
/// Up to 64 rays through a tree of triangles together, as a set of bits: a node is fetched and unpacked once for all rays that meet it. Which lanes
/// a register holds depends on how many rays are left: many rays against one box, or one ray against eight boxes; and a ray that is
/// alone goes on by itself.
/// </summary>
internal unsafe ref struct BlockTraversal<TSearch>(BvhNode* nodes, float* triangles, BlockWorkspace* workspace)
    where TSearch : ISearch
{
    // Above so many rays, a box is tested against eight of them at once; measured between 8 and 16.
    private const int ManyRays = 12;
    private readonly BvhNode* _nodes = nodes;
    private readonly float* _triangles = triangles;
    private readonly BlockWorkspace* _workspace = workspace;
    private RayInterval _interval;
    private int _octant;
    private bool _backward;
    private float _farthest;
    private ulong _alive;
    private PendingVisit* _top;

    /// <summary>Follows the rays that the workspace holds.</summary>
    /// <param name="alive">The rays that can hit something.</param>
    /// <returns>Those of them that are left: for any hit, the rays without one.</returns>
    public ulong Follow(ulong alive)
    {
        if (alive == 0)
        {
            return 0;
        }

        PendingVisit* bottom = (PendingVisit*)_workspace->Pending;
        _alive = alive;
        _top = bottom;
        _interval.Enclose(&_workspace->Rays, alive);
        _farthest = RayInterval.Farthest(&_workspace->Rays, alive);
        SetOrder(_interval.Octant);
        *_top++ = new() { Rays = alive };
        while (_top != bottom)
        {
            PendingVisit visit = *--_top;
            if (TSearch.EndsAtAnyHit)
            {
                visit.Rays &= _alive;
            }

            if (visit.Rays == 0 || visit.Entry > _farthest)
            {
                continue;
            }

            if ((visit.Rays & (visit.Rays - 1)) == 0)
            {
                FollowAlone(visit);
            }
            else if ((visit.Reference & BvhNode.LeafBit) != 0)
            {
                VisitLeaf(visit);
            }
            else
            {
                VisitNode(visit);
            }
        }

        return _alive;
    }

    private void SetOrder(int octant)
    {
        _backward = (octant & 4) != 0;
        _octant = _backward ? ~octant & 3 : octant & 3;
    }

    private void FollowAlone(in PendingVisit visit)
    {
        int ray = BitOperations.TrailingZeroCount(visit.Rays);
        TriangleLeaves<TSearch> leaves = new(_triangles, &_workspace->Rays, ray, &_workspace->Single);
        if (SingleRayTraversal.Follow<TSearch, TriangleLeaves<TSearch>>(_nodes, &_workspace->Rays, ray, visit.Reference, &_workspace->Single, ref leaves))
        {
            _alive &= ~visit.Rays;
        }
    }

    private void VisitNode(in PendingVisit visit)
    {
        BvhNode* node = _nodes + visit.Reference;
        Unpack(node);
        if (!_interval.SameOctant)
        {
            VisitOneByOneAnyDirection(node, visit.Rays);
            return;
        }

        uint met = MeetTogether(node);
        if (met == 0)
        {
            return;
        }

        if (BitOperations.PopCount(visit.Rays) > ManyRays)
        {
            VisitBoxByBox(node, visit.Rays, met);
        }
        else
        {
            VisitOneByOne(node, visit.Rays);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Unpack(BvhNode* node)
    {
        float* boxes = _workspace->Boxes;
        for (int axis = 0; axis < 3; axis++)
        {
            Vector256<float> step = Lanes8.Broadcast(node->Step + axis);
            Vector256<float> origin = Lanes8.Broadcast(node->Origin + axis);
            Lanes8.MultiplyAdd(Lanes8.FromBytes(node->Lower + (8 * axis)), step, origin).Store(boxes + (8 * axis));
            Lanes8.MultiplyAdd(Lanes8.FromBytes(node->Upper + (8 * axis)), step, origin).Store(boxes + 24 + (8 * axis));
        }
    }

    /// <summary>Bounds where the rays enter the boxes.</summary>
    /// <returns>The children that rays may meet.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private uint MeetTogether(BvhNode* node)
    {
        float* nearX = Near(0);
        float* nearY = Near(1);
        float* nearZ = Near(2);
        Vector256<float> entry = Lanes8.Max(
            Lanes8.Max(_interval.Enter(Vector256.Load(nearX), 0), _interval.Enter(Vector256.Load(nearY), 1)),
            Lanes8.Max(_interval.Enter(Vector256.Load(nearZ), 2), Vector256<float>.Zero));
        Vector256<float> exit = Lanes8.Min(
            Lanes8.Min(_interval.Leave(Vector256.Load(Far(0)), 0), _interval.Leave(Vector256.Load(Far(1)), 1)),
            Lanes8.Min(_interval.Leave(Vector256.Load(Far(2)), 2), Vector256.Create(_farthest)));
        entry.Store(_workspace->Entry);
        return Lanes8.Bits(Vector256.LessThanOrEqual(entry, exit)) & ((1u << node->Count) - 1);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private float* Near(int axis) => _workspace->Boxes + (8 * axis) + ((_interval.Octant >> axis & 1) != 0 ? 24 : 0);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private float* Far(int axis) => _workspace->Boxes + (8 * axis) + ((_interval.Octant >> axis & 1) != 0 ? 0 : 24);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private float* NearShift(int axis) =>
        ((_interval.Octant >> axis & 1) != 0 ? _workspace->Rays.UpperShift : _workspace->Rays.LowerShift) + (RayBlock.Size * axis);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private float* FarShift(int axis) =>
        ((_interval.Octant >> axis & 1) != 0 ? _workspace->Rays.LowerShift : _workspace->Rays.UpperShift) + (RayBlock.Size * axis);

    /// <summary>One box and eight rays at a time.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void VisitBoxByBox(BvhNode* node, ulong set, uint met)
    {
        float* inverse = _workspace->Rays.Inverse;
        float* distance = _workspace->Rays.Distance;
        float* near = NearShift(0);
        float* nearY = NearShift(1);
        float* nearZ = NearShift(2);
        float* far = FarShift(0);
        float* farY = FarShift(1);
        float* farZ = FarShift(2);
        for (int place = 0; place < 8; place++)
        {
            int child = Child(node, place);
            if ((met >> child & 1) == 0)
            {
                continue;
            }

            Vector256<float> lowX = Lanes8.Broadcast(Near(0) + child);
            Vector256<float> lowY = Lanes8.Broadcast(Near(1) + child);
            Vector256<float> lowZ = Lanes8.Broadcast(Near(2) + child);
            Vector256<float> highX = Lanes8.Broadcast(Far(0) + child);
            Vector256<float> highY = Lanes8.Broadcast(Far(1) + child);
            Vector256<float> highZ = Lanes8.Broadcast(Far(2) + child);
            ulong passed = 0;
            for (int lane = 0; lane < RayBlock.Size; lane += 8)
            {
                if ((set >> lane & 0xff) == 0)
                {
                    continue;
                }

                Vector256<float> inverseX = Vector256.Load(inverse + lane);
                Vector256<float> inverseY = Vector256.Load(inverse + RayBlock.Size + lane);
                Vector256<float> inverseZ = Vector256.Load(inverse + (2 * RayBlock.Size) + lane);
                Vector256<float> entry = Lanes8.Max(
                    Lanes8.Max(Lanes8.MultiplyAdd(lowX, inverseX, Vector256.Load(near + lane)), Lanes8.MultiplyAdd(lowY, inverseY, Vector256.Load(nearY + lane))),
                    Lanes8.Max(Lanes8.MultiplyAdd(lowZ, inverseZ, Vector256.Load(nearZ + lane)), Vector256<float>.Zero));
                Vector256<float> exit = Lanes8.Min(
                    Lanes8.Min(Lanes8.MultiplyAdd(highX, inverseX, Vector256.Load(far + lane)), Lanes8.MultiplyAdd(highY, inverseY, Vector256.Load(farY + lane))),
                    Lanes8.Min(Lanes8.MultiplyAdd(highZ, inverseZ, Vector256.Load(farZ + lane)), Vector256.Load(distance + lane)));
                passed |= (ulong)Lanes8.Bits(Vector256.LessThanOrEqual(entry, exit)) << lane;
            }

            Push(passed & set, node->Child[child], _workspace->Entry[child]);
        }
    }

    /// <summary>One ray and eight boxes at a time.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void VisitOneByOne(BvhNode* node, ulong set)
    {
        Vector256<float> lowX = Vector256.Load(Near(0));
        Vector256<float> lowY = Vector256.Load(Near(1));
        Vector256<float> lowZ = Vector256.Load(Near(2));
        Vector256<float> highX = Vector256.Load(Far(0));
        Vector256<float> highY = Vector256.Load(Far(1));
        Vector256<float> highZ = Vector256.Load(Far(2));
        float* near = NearShift(0);
        float* nearY = NearShift(1);
        float* nearZ = NearShift(2);
        float* far = FarShift(0);
        float* farY = FarShift(1);
        float* farZ = FarShift(2);
        byte* met = ClearMet();
        uint all = 0;
        for (ulong left = set; left != 0; left &= left - 1)
        {
            int ray = BitOperations.TrailingZeroCount(left);
            float* inverse = _workspace->Rays.Inverse + ray;
            Vector256<float> inverseX = Lanes8.Broadcast(inverse);
            Vector256<float> inverseY = Lanes8.Broadcast(inverse + RayBlock.Size);
            Vector256<float> inverseZ = Lanes8.Broadcast(inverse + (2 * RayBlock.Size));
            Vector256<float> entry = Lanes8.Max(
                Lanes8.Max(Lanes8.MultiplyAdd(lowX, inverseX, Lanes8.Broadcast(near + ray)), Lanes8.MultiplyAdd(lowY, inverseY, Lanes8.Broadcast(nearY + ray))),
                Lanes8.Max(Lanes8.MultiplyAdd(lowZ, inverseZ, Lanes8.Broadcast(nearZ + ray)), Vector256<float>.Zero));
            Vector256<float> exit = Lanes8.Min(
                Lanes8.Min(Lanes8.MultiplyAdd(highX, inverseX, Lanes8.Broadcast(far + ray)), Lanes8.MultiplyAdd(highY, inverseY, Lanes8.Broadcast(farY + ray))),
                Lanes8.Min(Lanes8.MultiplyAdd(highZ, inverseZ, Lanes8.Broadcast(farZ + ray)), Lanes8.Broadcast(_workspace->Rays.Distance + ray)));
            uint hits = Lanes8.Bits(Vector256.LessThanOrEqual(entry, exit));
            all |= hits;
            met[ray] = (byte)hits;
        }

        PushMet(node, set, all & ((1u << node->Count) - 1));
    }

    /// <summary>One ray and eight boxes at a time, for rays that point into different octants.</summary>
    [MethodImpl(MethodImplOptions.NoInlining)]
    private void VisitOneByOneAnyDirection(BvhNode* node, ulong set)
    {
        float* boxes = _workspace->Boxes;
        Vector256<float> lowerX = Vector256.Load(boxes);
        Vector256<float> lowerY = Vector256.Load(boxes + 8);
        Vector256<float> lowerZ = Vector256.Load(boxes + 16);
        Vector256<float> upperX = Vector256.Load(boxes + 24);
        Vector256<float> upperY = Vector256.Load(boxes + 32);
        Vector256<float> upperZ = Vector256.Load(boxes + 40);
        Vector256<float> first = Vector256.Create(float.PositiveInfinity);
        byte* met = ClearMet();
        uint all = 0;
        for (ulong left = set; left != 0; left &= left - 1)
        {
            int ray = BitOperations.TrailingZeroCount(left);
            float* inverse = _workspace->Rays.Inverse + ray;
            float* lower = _workspace->Rays.LowerShift + ray;
            float* upper = _workspace->Rays.UpperShift + ray;
            Vector256<float> inverseX = Lanes8.Broadcast(inverse);
            Vector256<float> inverseY = Lanes8.Broadcast(inverse + RayBlock.Size);
            Vector256<float> inverseZ = Lanes8.Broadcast(inverse + (2 * RayBlock.Size));
            Vector256<float> x = Lanes8.MultiplyAdd(lowerX, inverseX, Lanes8.Broadcast(lower));
            Vector256<float> otherX = Lanes8.MultiplyAdd(upperX, inverseX, Lanes8.Broadcast(upper));
            Vector256<float> y = Lanes8.MultiplyAdd(lowerY, inverseY, Lanes8.Broadcast(lower + RayBlock.Size));
            Vector256<float> otherY = Lanes8.MultiplyAdd(upperY, inverseY, Lanes8.Broadcast(upper + RayBlock.Size));
            Vector256<float> z = Lanes8.MultiplyAdd(lowerZ, inverseZ, Lanes8.Broadcast(lower + (2 * RayBlock.Size)));
            Vector256<float> otherZ = Lanes8.MultiplyAdd(upperZ, inverseZ, Lanes8.Broadcast(upper + (2 * RayBlock.Size)));
            Vector256<float> entry = Lanes8.Max(Lanes8.Max(Lanes8.Min(x, otherX), Lanes8.Min(y, otherY)), Lanes8.Max(Lanes8.Min(z, otherZ), Vector256<float>.Zero));
            Vector256<float> exit = Lanes8.Min(
                Lanes8.Min(Lanes8.Max(x, otherX), Lanes8.Max(y, otherY)),
                Lanes8.Min(Lanes8.Max(z, otherZ), Lanes8.Broadcast(_workspace->Rays.Distance + ray)));
            first = Lanes8.Min(entry, first);
            uint hits = Lanes8.Bits(Vector256.LessThanOrEqual(entry, exit));
            all |= hits;
            met[ray] = (byte)hits;
        }

        first.Store(_workspace->Entry);
        float* sample = _workspace->Rays.Inverse + BitOperations.TrailingZeroCount(set);
        SetOrder((sample[0] < 0f ? 1 : 0) | (sample[RayBlock.Size] < 0f ? 2 : 0) | (sample[2 * RayBlock.Size] < 0f ? 4 : 0));
        PushMet(node, set, all & ((1u << node->Count) - 1));
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private byte* ClearMet()
    {
        byte* met = _workspace->Met;
        Vector256<byte>.Zero.Store(met);
        Vector256<byte>.Zero.Store(met + 32);
        return met;
    }

    /// <summary>Turns sets of children by ray into sets of rays by child, and puts them aside, the nearest last.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void PushMet(BvhNode* node, ulong set, uint met)
    {
        if (met == 0)
        {
            return;
        }

        Vector256<ushort> lower = Vector256.Load((ushort*)_workspace->Met);
        Vector256<ushort> upper = Vector256.Load((ushort*)(_workspace->Met + 32));
        for (int place = 0; place < 8; place++)
        {
            int child = Child(node, place);
            if ((met >> child & 1) != 0)
            {
                // The child's bit moves to the top of each byte; what comes from the neighbour stays below.
                ulong passed = Vector256.ShiftLeft(lower, 7 - child).AsByte().ExtractMostSignificantBits()
                    | ((ulong)Vector256.ShiftLeft(upper, 7 - child).AsByte().ExtractMostSignificantBits() << 32);
                Push(passed & set, node->Child[child], _workspace->Entry[child]);
            }
        }
    }

    /// <summary>The child at a place in the order from far to near.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private int Child(BvhNode* node, int place) => node->Order[_octant] >> (3 * (_backward ? 7 - place : place)) & 7;

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Push(ulong rays, uint reference, float entry)
    {
        TriangleLeaf.Prefetch(_nodes, _triangles, reference);
        *_top = new() { Rays = rays, Reference = reference, Entry = entry };
        _top += rays != 0 ? 1 : 0;
    }

    private void VisitLeaf(in PendingVisit visit)
    {
        int count = BvhNode.LeafCount(visit.Reference);
        float* rows = _triangles + ((nint)BvhNode.LeafFirst(visit.Reference) * TriangleLeaf.Rows);
        ulong changed = 0;
        for (int major = 0; major < 3; major++)
        {
            ulong set = visit.Rays & _interval.ByMajor[major];
            if (set != 0)
            {
                changed |= Intersect(rows, count, set, major);
            }
        }

        if (TSearch.EndsAtAnyHit)
        {
            _alive &= ~changed;
        }
        else if (changed != 0)
        {
            _farthest = RayInterval.Farthest(&_workspace->Rays, _alive);
        }
    }

    /// <summary>Tests a leaf against rays with the same major axis, in whichever way fills the registers better.</summary>
    private ulong Intersect(float* rows, int count, ulong set, int major)
    {
        RayBlock* rays = &_workspace->Rays;
        ulong eights = set | (set >> 4);
        eights |= eights >> 2;
        eights |= eights >> 1;
        int groups = BitOperations.PopCount(eights & 0x0101010101010101);
        if (groups * count >= BitOperations.PopCount(set))
        {
            return TriangleLeaf.IntersectRays<TSearch>(rows, count, rays, set, major);
        }

        ulong changed = 0;
        for (int triangle = 0; triangle < count; triangle++)
        {
            changed |= TriangleLeaf.IntersectTriangle<TSearch>(rows, count, triangle, rays, set, major);
            if (TSearch.EndsAtAnyHit)
            {
                set &= ~changed;
            }
        }

        return changed;
    }
}
