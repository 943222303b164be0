namespace RayTracer.Rendering;

/// <summary>
/// A quadtree over the square that <see cref="GuideMap"/> maps directions to, whose cells take the light that came from there. It is refined
/// where much did (Müller, Gross &amp; Novák 2017, section 3.2). Sums are integers, so that they are the same whatever the order.
/// </summary>
internal sealed class DirectionTree
{
    private const int Quadrants = 4;
    private const int MostLevels = 14;

    // A cell with more of the light than this share is divided.
    private const double LargestShare = 0.03;
    private readonly int[] _children;
    private readonly long[] _sums;
    private long _records;

    /// <summary>Makes one of four cells.</summary>
    public DirectionTree()
        : this([0, 0, 0, 0])
    {
    }

    private DirectionTree(int[] children) => (_children, _sums) = (children, new long[children.Length]);

    /// <summary>The number of records so far.</summary>
    public long Records => Interlocked.Read(ref _records);

    /// <summary>Adds a record; any number of threads may.</summary>
    /// <param name="u">First coordinate, in [0, 1).</param>
    /// <param name="v">Second coordinate, in [0, 1).</param>
    /// <param name="value">The light, never negative.</param>
    public void Add(float u, float v, long value)
    {
        Interlocked.Increment(ref _records);
        if (value == 0)
        {
            return;
        }

        int slot = Slot(0, ref u, ref v);
        while (_children[slot] is > 0 and int child)
        {
            slot = Slot(child, ref u, ref v);
        }

        Interlocked.Add(ref _sums[slot], value);
    }

    /// <summary>Returns a tree without records, finer where this one found much light, and coarser where it found little.</summary>
    public DirectionTree Refined()
    {
        List<int> refined = [0, 0, 0, 0];
        double all = Sum(0);
        Refine(refined, 0, 0, all, LargestShare * all, 1);
        return new([.. refined]);
    }

    /// <summary>Appends the tree's nodes to a table of a guide.</summary>
    /// <param name="nodes">The table; <see cref="PathGuide.NodeWords"/> words a node.</param>
    /// <returns>The number of the root; 0 where there is no light.</returns>
    public uint AppendTo(List<uint> nodes) => Sum(0) > 0 ? Append(0, nodes) : 0;

    private static int Slot(int node, ref float u, ref float v)
    {
        int right = u >= 0.5f ? 1 : 0;
        int upper = v >= 0.5f ? 1 : 0;
        (u, v) = ((2 * u) - right, (2 * v) - upper);
        return (Quadrants * node) + (2 * upper) + right;
    }

    private long Sum(int node)
    {
        long sum = 0;
        for (int slot = Quadrants * node; slot < Quadrants * (node + 1); slot++)
        {
            sum += InSlot(slot);
        }

        return sum;
    }

    private long InSlot(int slot) => _children[slot] > 0 ? Sum(_children[slot]) : _sums[slot];

    // Makes a node of another tree for one of this, or for −1 where this one has no cells so small and all quarters count the same.
    private void Refine(List<int> refined, int to, int from, double all, double most, int level)
    {
        for (int i = 0; i < Quadrants; i++)
        {
            int slot = (Quadrants * from) + i;
            double light = from < 0 ? all / Quadrants : InSlot(slot);
            if (light > most && level < MostLevels)
            {
                int child = refined.Count / Quadrants;
                refined[(Quadrants * to) + i] = child;
                refined.AddRange([0, 0, 0, 0]);
                Refine(refined, child, from < 0 || _children[slot] == 0 ? -1 : _children[slot], light, most, level + 1);
            }
        }
    }

    private uint Append(int node, List<uint> nodes)
    {
        int at = nodes.Count;
        nodes.AddRange(new uint[PathGuide.NodeWords]);
        double[] light = [.. Enumerable.Range(Quadrants * node, Quadrants).Select(s => (double)InSlot(s))];
        double left = light[0] + light[2];
        double right = light[1] + light[3];
        nodes[at + PathGuide.Left] = Share(left, right);
        nodes[at + PathGuide.LowerLeft] = Share(light[0], light[2]);
        nodes[at + PathGuide.LowerRight] = Share(light[1], light[3]);
        for (int i = 0; i < Quadrants; i++)
        {
            if (_children[(Quadrants * node) + i] is > 0 and int child && light[i] > 0)
            {
                nodes[at + PathGuide.FirstChild + i] = Append(child, nodes);
            }
        }

        return (uint)(at / PathGuide.NodeWords);
    }

    private static uint Share(double one, double other) => BitConverter.SingleToUInt32Bits(one + other > 0 ? (float)(one / (one + other)) : 0.5f);
}
