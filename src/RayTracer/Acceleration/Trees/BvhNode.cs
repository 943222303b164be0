using System.Runtime.CompilerServices;
using System.Runtime.InteropServices;
using System.Runtime.Intrinsics;

namespace RayTracer.Acceleration;

/// <summary>
/// A node with up to eight children in two cache lines. The children's boxes are stored as bytes on a grid over the node's own box
/// (after Ylitie, Karras &amp; Laine 2017), rounded outwards. Of eight directions by sign, four have the order of the children stored; the
/// opposite ones read it backwards.
/// </summary>
[StructLayout(LayoutKind.Explicit, Size = Bytes)]
internal unsafe struct BvhNode
{
    /// <summary>Size of a node.</summary>
    public const int Bytes = 128;

    /// <summary>Log₂ of the size.</summary>
    public const int Shift = 7;

    /// <summary>The bit of a reference that means a leaf.</summary>
    public const uint LeafBit = 0x80000000;

    /// <summary>Most primitives that references can address.</summary>
    public const int MaxPrimitives = 1 << 28;

    /// <summary>Bytes from the lower bounds of an axis to its upper bounds.</summary>
    public const int LowerToUpper = 24;

    /// <summary>Lower corner of the grid.</summary>
    [FieldOffset(0)]
    public fixed float Origin[3];

    /// <summary>Width of the grid's cells.</summary>
    [FieldOffset(12)]
    public fixed float Step[3];

    /// <summary>
    /// Children from far to near, three bits each, for directions with z ≥ 0 and x or y negative by bits 0 and 1 of the index.
    /// </summary>
    [FieldOffset(24)]
    public fixed int Order[4];

    /// <summary>The children: index of a node, or <see cref="LeafReference"/>.</summary>
    [FieldOffset(40)]
    public fixed uint Child[8];

    /// <summary>Lower bounds: eight for x, for y, for z.</summary>
    [FieldOffset(72)]
    public fixed byte Lower[24];

    /// <summary>Upper bounds: eight for x, for y, for z.</summary>
    [FieldOffset(96)]
    public fixed byte Upper[24];

    /// <summary>Number of children; they come first.</summary>
    [FieldOffset(120)]
    public int Count;

    /// <summary>Refers to a leaf.</summary>
    /// <param name="first">Its first primitive in the tree's order.</param>
    /// <param name="count">The number of children, 1 to 8.</param>
    public static uint LeafReference(int first, int count) => LeafBit | ((uint)(count - 1) << 28) | (uint)first;

    /// <summary>Number of primitives of a leaf.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int LeafCount(uint reference) => (int)(reference >> 28 & 7) + 1;

    /// <summary>First primitive of a leaf.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static int LeafFirst(uint reference) => (int)(reference & 0x0FFFFFFF);

    /// <summary>Fills a node.</summary>
    /// <param name="node">The node.</param>
    /// <param name="boxes">The children's boxes.</param>
    /// <param name="count">Number of children, 0 to 8.</param>
    public static void Encode(BvhNode* node, ReadOnlySpan<Box4> boxes, int count)
    {
        *node = default;
        node->Count = count;
        float* lower = stackalloc float[24];
        float* upper = stackalloc float[24];
        for (int child = 0; child < 8; child++)
        {
            Box4 box = child < count ? boxes[child] : Box4.Empty;
            for (int axis = 0; axis < 3; axis++)
            {
                lower[(8 * axis) + child] = box.Lower[axis];
                upper[(8 * axis) + child] = box.Upper[axis];
            }
        }

        Vector256<int> used = Vector256.LessThan(Vector256<int>.Indices, Vector256.Create(count));
        for (int axis = 0; axis < 3; axis++)
        {
            Quantize(node, axis, Vector256.Load(lower + (8 * axis)), Vector256.Load(upper + (8 * axis)), used);
        }

        Vector256<float> x = Vector256.Load(lower) + Vector256.Load(upper);
        Vector256<float> y = Vector256.Load(lower + 8) + Vector256.Load(upper + 8);
        Vector256<float> z = Vector256.Load(lower + 16) + Vector256.Load(upper + 16);
        for (int octant = 0; octant < 4; octant++)
        {
            Vector256<float> along = ((octant & 1) != 0 ? -x : x) + ((octant & 2) != 0 ? -y : y) + z;
            Vector256<float> unused = Vector256.Create(float.PositiveInfinity);
            node->Order[octant] = FarToNear(Vector256.ConditionalSelect(used.AsSingle(), along, unused));
        }
    }

    /// <summary>The box of a child as rays meet it.</summary>
    public static Box4 Decode(BvhNode* node, int child)
    {
        Vector128<float> origin = Vector128.Create(node->Origin[0], node->Origin[1], node->Origin[2], 0f);
        Vector128<float> step = Vector128.Create(node->Step[0], node->Step[1], node->Step[2], 0f);
        Vector128<float> lower = Vector128.Create((float)node->Lower[child], node->Lower[8 + child], node->Lower[16 + child], 0f);
        Vector128<float> upper = Vector128.Create((float)node->Upper[child], node->Upper[8 + child], node->Upper[16 + child], 0f);
        return new() { Lower = origin + (lower * step), Upper = origin + (upper * step) };
    }

    private static void Quantize(BvhNode* node, int axis, Vector256<float> lower, Vector256<float> upper, Vector256<int> used)
    {
        if (used == Vector256<int>.Zero)
        {
            return;
        }

        // A step is a little wider than 1/255 of the box, and bounds are moved outwards by a thousandth of it before they are
        // rounded: that covers the rounding of these lines.
        float origin = Lanes8.Smallest(lower);
        float step = MathF.Max((Lanes8.Largest(upper) - origin) * (1.00001f / 255f), 1e-37f);
        Vector256<float> inverse = Vector256.Create(1f / step);
        Vector256<float> from = Vector256.Create(origin);
        Vector256<float> first = Vector256.Floor(((lower - from) * inverse) - Vector256.Create(0.001f));
        Vector256<float> last = Vector256.Ceiling(((upper - from) * inverse) + Vector256.Create(0.001f));
        node->Origin[axis] = origin;
        node->Step[axis] = step;
        for (int child = 0; child < 8; child++)
        {
            bool exists = used[child] != 0;
            node->Lower[(8 * axis) + child] = exists ? (byte)Math.Clamp((int)first[child], 0, 255) : (byte)255;
            node->Upper[(8 * axis) + child] = exists ? (byte)Math.Clamp((int)last[child], 0, 255) : (byte)0;
        }
    }

    /// <summary>Sorts eight keys, greatest first; of equal ones the lower child comes first.</summary>
    private static int FarToNear(Vector256<float> keys)
    {
        Vector256<int> indices = Vector256<int>.Indices;
        Vector256<int> place = Vector256<int>.Zero;
        for (int other = 0; other < 8; other++)
        {
            Vector256<float> key = Vector256.Create(keys[other]);
            Vector256<int> farther = Vector256.GreaterThan(key, keys).AsInt32();
            Vector256<int> equalAndBefore = Vector256.Equals(key, keys).AsInt32() & Vector256.LessThan(Vector256.Create(other), indices);
            place -= farther | equalAndBefore;
        }

        int order = 0;
        for (int child = 0; child < 8; child++)
        {
            order |= child << (3 * place[child]);
        }

        return order;
    }
}
