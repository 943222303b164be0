using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Study;

/// <summary>
/// Space cut in two by planes across the axes, again and again, where the surface area heuristic expects the least work (MacDonald &amp;
/// Booth 1990), with the candidates in equal steps. A triangle on both sides of a plane is listed on both.
/// </summary>
internal sealed class KdTree : Accelerator
{
    private const int Leaf = 3;
    private const int Candidates = 32;
    private const int SmallLeaf = 3;
    private const float TraversalCost = 1;
    private const float TriangleCost = 1.5f;
    private const float EmptyBonus = 0.8f;
    private const int DeepestStack = 64;
    private readonly Bounds _bounds;
    private readonly Bounds[] _triangleBounds;
    private readonly List<Node> _nodes = [];
    private readonly List<int> _listed = [];

    /// <summary>Builds the tree.</summary>
    /// <param name="mesh">The triangles.</param>
    public KdTree(MeshData mesh)
        : base(mesh)
    {
        _triangleBounds = [.. Enumerable.Range(0, Count).Select(BoundsOf)];
        _bounds = BoundsOfAll();
        int deepest = Math.Min(DeepestStack - 1, 8 + (int)(1.3f * BitOperations.Log2((uint)Count + 1)));
        Build([.. Enumerable.Range(0, Count)], _bounds, deepest);
        _triangleBounds = [];
    }

    /// <inheritdoc/>
    public override string Name => "kd-tree";

    /// <inheritdoc/>
    public override unsafe long MemoryBytes => ((long)sizeof(Node) * _nodes.Count) + (sizeof(int) * (long)_listed.Count);

    /// <inheritdoc/>
    public override int ClosestHit(in Ray ray, ref float distance)
    {
        int hit = -1;
        Span<(int Node, float Begin, float End)> stack = stackalloc (int, float, float)[DeepestStack];
        int height = 0;
        (float begin, float end) = ray.Within(_bounds.Minimum, _bounds.Maximum);
        int at = 0;
        while (true)
        {
            if (begin > end || begin > distance)
            {
                // Nothing here, or only behind what was hit; what waits on the stack may begin no earlier.
            }
            else if (_nodes[at].Axis == Leaf)
            {
                Node leaf = _nodes[at];
                for (int i = 0; i < leaf.Count; i++)
                {
                    Meet(_listed[leaf.First + i], ray, ref distance, ref hit);
                }
            }
            else
            {
                // The half where the ray comes from, then the other; only one, where the ray is past the plane by more than roundings.
                Node node = _nodes[at];
                int axis = node.Axis;
                float t = (node.Split - ray.Origin[axis]) * ray.Inverse[axis];
                bool isBelow = ray.Origin[axis] < node.Split || (ray.Origin[axis] == node.Split && ray.Direction[axis] <= 0);
                (int near, int far) = isBelow ? (at + 1, node.Above) : (node.Above, at + 1);
                float slack = Ray.Slack * Math.Abs(t);
                if (t > end + slack || t <= 0)
                {
                    at = near;
                }
                else if (t < begin - slack)
                {
                    at = far;
                }
                else if (float.IsNaN(t) || float.IsInfinity(t))
                {
                    // Along the plane, or in it.
                    stack[height++] = (far, begin, end);
                    at = near;
                }
                else
                {
                    stack[height++] = (far, t - slack > begin ? t - slack : begin, end);
                    at = near;
                    end = t + slack < end ? t + slack : end;
                }

                continue;
            }

            if (height == 0)
            {
                return hit;
            }

            (at, begin, end) = stack[--height];
        }
    }

    private void Build(int[] triangles, Bounds box, int depthLeft)
    {
        (int axis, float split) = depthLeft == 0 || triangles.Length <= SmallLeaf ? (Leaf, 0) : ChooseSplit(triangles, box);
        if (axis == Leaf)
        {
            _nodes.Add(new() { Axis = Leaf, First = _listed.Count, Count = triangles.Length });
            _listed.AddRange(triangles);
            return;
        }

        int at = _nodes.Count;
        _nodes.Add(new() { Axis = axis, Split = split });
        (Bounds below, Bounds above) = Cut(box, axis, split);
        Build([.. triangles.Where(t => _triangleBounds[t].Minimum[axis] <= split)], below, depthLeft - 1);
        _nodes[at] = _nodes[at] with { Above = _nodes.Count };
        Build([.. triangles.Where(t => _triangleBounds[t].Maximum[axis] >= split)], above, depthLeft - 1);
    }

    // The cheapest plane; a leaf where none is cheaper than that.
    private (int Axis, float Split) ChooseSplit(int[] triangles, Bounds box)
    {
        (int Axis, float Split) best = (Leaf, 0);
        float lowest = TriangleCost * triangles.Length;
        Span<int> begins = stackalloc int[Candidates + 1];
        Span<int> ends = stackalloc int[Candidates + 1];
        for (int axis = 0; axis < 3; axis++)
        {
            float step = (box.Maximum[axis] - box.Minimum[axis]) / Candidates;
            if (!(step > 0))
            {
                continue;
            }

            begins.Clear();
            ends.Clear();
            foreach (int triangle in triangles)
            {
                // The first plane not below the triangle's low end, and the last not above its high end.
                begins[Math.Clamp((int)Math.Ceiling((_triangleBounds[triangle].Minimum[axis] - box.Minimum[axis]) / step), 0, Candidates)]++;
                ends[Math.Clamp((int)Math.Floor((_triangleBounds[triangle].Maximum[axis] - box.Minimum[axis]) / step), 0, Candidates)]++;
            }

            int below = begins[0];
            int above = triangles.Length - ends[0];
            for (int i = 1; i < Candidates; i++)
            {
                below += begins[i];
                float split = box.Minimum[axis] + (i * step);
                (Bounds low, Bounds high) = Cut(box, axis, split);
                float cost = TraversalCost + (TriangleCost * ((HalfArea(low) * below) + (HalfArea(high) * above)) / HalfArea(box));
                cost *= below == 0 || above == 0 ? EmptyBonus : 1;
                if (cost < lowest)
                {
                    (lowest, best) = (cost, (axis, split));
                }

                above -= ends[i];
            }
        }

        return best;
    }

    private static (Bounds Below, Bounds Above) Cut(Bounds box, int axis, float split)
    {
        Vector3 maximum = box.Maximum;
        Vector3 minimum = box.Minimum;
        maximum[axis] = minimum[axis] = split;
        return (box with { Maximum = maximum }, box with { Minimum = minimum });
    }

    private static float HalfArea(Bounds box)
    {
        Vector3 e = box.Maximum - box.Minimum;
        return (e.X * e.Y) + (e.Y * e.Z) + (e.Z * e.X);
    }

    // An inner node is followed by the one below its plane.
    private readonly record struct Node
    {
        public int Axis { get; init; }

        public float Split { get; init; }

        public int Above { get; init; }

        public int First { get => Above; init => Above = value; }

        public int Count { get; init; }
    }
}
