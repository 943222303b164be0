using System.Runtime.CompilerServices;

namespace RayTracer.Acceleration;

/// <summary>Primitives that become one subtree.</summary>
internal unsafe struct BvhRange
{
    /// <summary>The first of them, in one of the builder's two arrays.</summary>
    public PrimitiveReference* First;

    /// <summary>The number of primitives.</summary>
    public int Count;

    /// <summary>Place of the first one in the order of the whole tree.</summary>
    public int Start;

    /// <summary>The box that holds them all.</summary>
    public Box4 Bounds;

    /// <summary>The box that holds twice their middles.</summary>
    public Box4 Middles;

    /// <summary>Half the surface area of the bounds.</summary>
    public float Area;

    /// <summary>Adds a primitive to the boxes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Grow(in PrimitiveReference primitive)
    {
        Bounds.Grow(primitive.Lower, primitive.Upper);
        var middle = primitive.Middle;
        Middles.Grow(middle, middle);
    }
}
