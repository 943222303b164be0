using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Security.Cryptography;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Where light comes from, as paths have learned it: a binary tree over space, each of whose leaves has a quadtree over directions (Müller,
/// Gross &amp; Novák 2017). Never changes.
/// </summary>
internal sealed unsafe class PathGuide
{
    /// <summary>Words of a node of space: where it is divided, then 4 · number of its first child + axis, or 4 · root + 3 of a leaf.</summary>
    public const int SpaceWords = 2;

    /// <summary>In the place of an axis: the node is a leaf.</summary>
    public const uint IsLeaf = 3;

    /// <summary>
    /// Words of a node of directions: three chances, and the numbers of four children, 0 for none. Node 0 is none.
    /// </summary>
    public const int NodeWords = 1 << NodeShift;

    /// <summary>The chance of the left half.</summary>
    public const int Left = 0;

    /// <summary>In the left half, the chance of the lower quarter.</summary>
    public const int LowerLeft = 1;

    /// <summary>The same in the right half.</summary>
    public const int LowerRight = 2;

    /// <summary>Children: lower left, lower right, upper left, upper right.</summary>
    public const int FirstChild = 4;
    private const int NodeShift = 3;
    private readonly PinnedArray<uint> _space;
    private readonly PinnedArray<uint> _nodes;

    /// <summary>Makes one of its tables.</summary>
    public PathGuide(uint[] space, uint[] nodes)
    {
        (_space, _nodes) = (new(space), new(nodes));
        using IncrementalHash hash = IncrementalHash.CreateHash(HashAlgorithmName.SHA256);
        hash.AppendData(MemoryMarshal.AsBytes<uint>(space));
        hash.AppendData(MemoryMarshal.AsBytes<uint>(nodes));
        Hash = Convert.ToHexStringLower(hash.GetHashAndReset().AsSpan(0, 8));
    }

    /// <summary>The nodes of space, <see cref="SpaceWords"/> words each.</summary>
    public ReadOnlySpan<uint> Space => _space.Values;

    /// <summary>The nodes of directions, <see cref="NodeWords"/> words each.</summary>
    public ReadOnlySpan<uint> Nodes => _nodes.Values;

    /// <summary>Stands for all of it, in 16 digits.</summary>
    public string Hash { get; }

    /// <summary>True if all links lead on to nodes that exist, so that every search ends; of tables that come from outside.</summary>
    public bool IsWhole => Space.Length >= SpaceWords && Space.Length % SpaceWords == 0 && Nodes.Length >= NodeWords && Nodes.Length % NodeWords == 0
        && IsSpaceWhole() && AreNodesWhole();

    /// <summary>Returns the roots of the trees over directions at some points; 0 where nothing was learned.</summary>
    public UIntW Find(in Vec3W point)
    {
        UIntW node = 0u;
        while (true)
        {
            FloatW split = FloatW.Gather((float*)_space.Pointer, node << 1);
            UIntW link = UIntW.Gather(_space.Pointer, (node << 1) + 1u);
            UIntW axis = link & 3u;
            MaskW isInner = ~UIntW.Equal(axis, IsLeaf);
            if (!isInner.Any)
            {
                return link >> 2;
            }

            FloatW place = UIntW.Equal(axis, 0u).Select(point.X, UIntW.Equal(axis, 1u).Select(point.Y, point.Z));
            UIntW child = (link >> 2) + (place >= split).Select((UIntW)1u, 0u);
            node = isInner.Select(child, node);
        }
    }

    /// <summary>Returns how densely points of the square are chosen by <see cref="Descend"/>.</summary>
    /// <param name="root">The trees; 0 for none, where the density is 0.</param>
    /// <param name="u">First coordinate.</param>
    /// <param name="v">Second coordinate.</param>
    public FloatW Density(in UIntW root, FloatW u, FloatW v)
    {
        UIntW node = root;
        MaskW goes = ~UIntW.Equal(root, 0u);
        FloatW density = goes.Select(1f, 0f);
        while (goes.Any)
        {
            MaskW right = u >= 0.5f;
            MaskW upper = v >= 0.5f;
            FloatW left = Chance(node, Left);
            FloatW lower = Chance(node, right.Select((UIntW)LowerRight, LowerLeft));
            density = goes.Select(density * right.Select(1f - left, left) * upper.Select(1f - lower, lower) * 4f, density);
            u = FloatW.MultiplyAdd(u, 2f, right.Select(-1f, 0f));
            v = FloatW.MultiplyAdd(v, 2f, upper.Select(-1f, 0f));
            node = Child(goes, node, right, upper);
            goes = ~UIntW.Equal(node, 0u);
        }

        return density;
    }

    /// <summary>
    /// Chooses points of the square by the trees, or finds how densely given points are chosen (McCool &amp; Harwood 1997: by descent, where
    /// at each level what is left of the random numbers is stretched, so that stratification survives).
    /// </summary>
    /// <param name="root">The trees; 0 for none, where nothing is chosen and the density is 0.</param>
    /// <param name="chooses">The lanes that choose; in others, the point is given.</param>
    /// <param name="u">Random number, or the first coordinate; becomes the first coordinate.</param>
    /// <param name="v">Random number, or the second coordinate; becomes the second coordinate.</param>
    /// <param name="density">Per unit of area.</param>
    public void Descend(in UIntW root, MaskW chooses, ref FloatW u, ref FloatW v, out FloatW density)
    {
        UIntW node = root;
        MaskW goes = ~UIntW.Equal(root, 0u);
        (FloatW x, FloatW y, FloatW size) = (0f, 0f, 1f);
        (FloatW s, FloatW t, FloatW chance) = (u, v, goes.Select(1f, 0f));
        while (goes.Any)
        {
            FloatW left = Chance(node, Left);
            FloatW across = chooses.Select(left, 0.5f);
            MaskW right = s >= across;
            FloatW lower = Chance(node, right.Select((UIntW)LowerRight, LowerLeft));
            FloatW along = chooses.Select(lower, 0.5f);
            MaskW upper = t >= along;
            chance = goes.Select(chance * right.Select(1f - left, left) * upper.Select(1f - lower, lower) * 4f, chance);
            s = goes.Select(Rest(s, across, right), s);
            t = goes.Select(Rest(t, along, upper), t);
            size = goes.Select(size * 0.5f, size);
            x += (goes & right).Select(size, 0f);
            y += (goes & upper).Select(size, 0f);
            node = Child(goes, node, right, upper);
            goes = ~UIntW.Equal(node, 0u);
        }

        density = chance;
        u = FloatW.Min(FloatW.MultiplyAdd(s, size, x), FloatBits.OneMinusEpsilon);
        v = FloatW.Min(FloatW.MultiplyAdd(t, size, y), FloatBits.OneMinusEpsilon);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private FloatW Chance(UIntW node, UIntW word) => FloatW.Gather((float*)_nodes.Pointer, (node << NodeShift) + word);

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private UIntW Child(MaskW goes, UIntW node, MaskW right, MaskW upper)
    {
        UIntW word = right.Select((UIntW)(FirstChild + 1), FirstChild) + upper.Select((UIntW)2u, 0u);
        return goes.Select(UIntW.Gather(_nodes.Pointer, (node << NodeShift) + word), 0u);
    }

    // What is left of a number in one of two parts of the unit interval, again spread over all of it.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static FloatW Rest(FloatW number, FloatW border, MaskW isSecond)
    {
        FloatW rest = (number - isSecond.Select(border, 0f)) / isSecond.Select(1f - border, border);
        return FloatW.Min(rest, FloatBits.OneMinusEpsilon);
    }

    private bool IsSpaceWhole()
    {
        uint count = (uint)(Space.Length / SpaceWords);
        for (uint i = 0; i < count; i++)
        {
            uint link = Space[(int)(SpaceWords * i) + 1];
            bool isGood = (link & 3) == IsLeaf ? link >> 2 < Nodes.Length / NodeWords : link >> 2 > i && (link >> 2) + 1 < count;
            if (!isGood)
            {
                return false;
            }
        }

        return true;
    }

    private bool AreNodesWhole()
    {
        for (int i = 0; i < Nodes.Length; i++)
        {
            (int node, int word) = int.DivRem(i, NodeWords);
            bool isGood = word == FirstChild - 1 || (word < FirstChild ? BitConverter.UInt32BitsToSingle(Nodes[i]) is >= 0 and <= 1
                : Nodes[i] == 0 || (Nodes[i] > node && Nodes[i] < Nodes.Length / NodeWords));
            if (!isGood)
            {
                return false;
            }
        }

        return true;
    }
}
