using System.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Takes records of the light that paths found, and where: a binary tree over space (Müller, Gross &amp; Novák 2017, section 3.1) whose
/// leaves have a <see cref="DirectionTree"/> each. It is fixed while records are taken; a pass of learning has one.
/// </summary>
internal sealed class GuideSums
{
    private const int MostLevels = 40;
    private readonly Node[] _nodes;

    // The same, for a quick search: where nodes are divided, and their first children · 4 + axis; of leaves, 3.
    private readonly float[] _splits;
    private readonly int[] _links;

    private GuideSums(IReadOnlyList<Node> nodes)
    {
        _nodes = [.. nodes];
        _splits = [.. nodes.Select(n => n.Split)];
        _links = [.. nodes.Select(n => n.Tree is null ? (4 * n.Child) + n.Axis : (int)PathGuide.IsLeaf)];
    }

    /// <summary>Makes one with a single leaf.</summary>
    /// <param name="least">A corner of the box in which points are.</param>
    /// <param name="most">The corner opposite.</param>
    public GuideSums(Vector3 least, Vector3 most)
        : this([new Node { Least = least, Most = most, Tree = new() }])
    {
    }

    /// <summary>The number of leaves.</summary>
    public int Leaves => (_nodes.Length + 1) / 2;

    /// <summary>Adds a record; any number of threads may.</summary>
    /// <param name="point">The place to which light came.</param>
    /// <param name="u">First coordinate of the direction that it came from.</param>
    /// <param name="v">Second coordinate of the direction.</param>
    /// <param name="value">The light.</param>
    public void Add(Vector3 point, float u, float v, long value)
    {
        int node = 0;
        for (int axis = _links[0] & 3; axis != PathGuide.IsLeaf; axis = _links[node] & 3)
        {
            node = (_links[node] >> 2) + (point[axis] >= _splits[node] ? 1 : 0);
        }

        _nodes[node].Tree!.Add(u, v, value);
    }

    /// <summary>Returns one without records, whose leaves are refined, and divided where they have more records than a number.</summary>
    public GuideSums Refined(double mostRecords)
    {
        List<Node> refined = [.. _nodes];
        for (int i = 0; i < _nodes.Length; i++)
        {
            if (_nodes[i].Tree is { } tree)
            {
                Divide(refined, i, tree, tree.Records, mostRecords, 0);
            }
        }

        return new(refined);
    }

    /// <summary>Returns the guide by all records.</summary>
    public PathGuide ToGuide()
    {
        List<uint> directions = [.. new uint[PathGuide.NodeWords]];
        List<uint> space = [];
        foreach (Node node in _nodes)
        {
            space.Add(BitConverter.SingleToUInt32Bits(node.Split));
            space.Add(node.Tree is { } tree ? (tree.AppendTo(directions) << 2) | PathGuide.IsLeaf : ((uint)node.Child << 2) | (uint)node.Axis);
        }

        return new([.. space], [.. directions]);
    }

    // Records are taken to be spread evenly: half of them in each half. The longest side is divided.
    private static void Divide(List<Node> nodes, int at, DirectionTree tree, double records, double mostRecords, int level)
    {
        Node node = nodes[at];
        Vector3 size = node.Most - node.Least;
        int axis = size.X >= size.Y && size.X >= size.Z ? 0 : size.Y >= size.Z ? 1 : 2;
        float split = node.Least[axis] + (size[axis] * 0.5f);
        if (records <= mostRecords || level == MostLevels || !(split > node.Least[axis] && split < node.Most[axis]))
        {
            nodes[at] = node with { Tree = tree.Refined() };
            return;
        }

        int child = nodes.Count;
        nodes[at] = node with { Tree = null, Axis = axis, Split = split, Child = child };
        nodes.Add(new() { Least = node.Least, Most = With(node.Most, axis, split) });
        nodes.Add(new() { Least = With(node.Least, axis, split), Most = node.Most });
        Divide(nodes, child, tree, records / 2, mostRecords, level + 1);
        Divide(nodes, child + 1, tree, records / 2, mostRecords, level + 1);
    }

    private static Vector3 With(Vector3 v, int axis, float value)
    {
        v[axis] = value;
        return v;
    }

    private sealed record Node
    {
        public Vector3 Least { get; init; }

        public Vector3 Most { get; init; }

        public int Axis { get; init; }

        public float Split { get; init; }

        public int Child { get; init; }

        // Null where the node is divided.
        public DirectionTree? Tree { get; init; }
    }
}
