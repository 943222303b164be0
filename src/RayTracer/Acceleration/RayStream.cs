namespace RayTracer.Acceleration;

/// <summary>Many rays, one array a quantity. The pointers need no alignment; the caller keeps the memory where it is.</summary>
internal unsafe struct RayStream
{
    /// <summary>The x coordinates of the rays' origins.</summary>
    public float* OriginX;

    /// <summary>The y coordinates of the rays' origins.</summary>
    public float* OriginY;

    /// <summary>The z coordinates of the rays' origins.</summary>
    public float* OriginZ;

    /// <summary>Directions of any length; distances count in multiples of it.</summary>
    public float* DirectionX;

    /// <summary>Directions of any length; distances count in multiples of it.</summary>
    public float* DirectionY;

    /// <summary>Directions of any length; distances count in multiples of it.</summary>
    public float* DirectionZ;

    /// <summary>
    /// In: hits count above zero and below this distance. Out of a search for closest hits: that of the hit, if there is one.
    /// </summary>
    public float* Distance;

    /// <summary>
    /// Out: −1 where nothing was hit; else the primitive of the closest hit, or 0 where any hit was asked for. What it holds before does
    /// not matter.
    /// </summary>
    public int* Primitive;

    /// <summary>Number of rays.</summary>
    public int Count;

    /// <summary>Rays whose quantities stand one array after the other: origins, directions, distances.</summary>
    /// <param name="first">The first array.</param>
    /// <param name="stride">From one array to the next, in floats.</param>
    /// <param name="primitive">Takes the hits.</param>
    /// <param name="count">Number of rays.</param>
    public static RayStream OfColumns(float* first, nint stride, int* primitive, int count) => new()
    {
        OriginX = first,
        OriginY = first + stride,
        OriginZ = first + (2 * stride),
        DirectionX = first + (3 * stride),
        DirectionY = first + (4 * stride),
        DirectionZ = first + (5 * stride),
        Distance = first + (6 * stride),
        Primitive = primitive,
        Count = count,
    };
}
