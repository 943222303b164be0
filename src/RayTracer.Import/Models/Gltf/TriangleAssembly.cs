namespace RayTracer.Import;

/// <summary>The assembly of a primitive's vertices into triangles (glTF 2.0, section 3.7.2.1, "mode").</summary>
internal static class TriangleAssembly
{
    /// <summary>Every three vertices are a triangle.</summary>
    public const int Triangles = 4;

    /// <summary>Every vertex after the second makes a triangle with the two before it.</summary>
    public const int Strip = 5;

    /// <summary>Every vertex after the second makes a triangle with the one before it and the first.</summary>
    public const int Fan = 6;

    /// <summary>The number of triangles that a number of vertices makes.</summary>
    public static int Count(int mode, int vertices) => mode == Triangles ? vertices / 3 : int.Max(vertices - 2, 0);

    /// <summary>The corners of triangle <paramref name="triangle"/>, as places in the list of vertices, with the front kept in front.</summary>
    public static (int A, int B, int C) Corners(int mode, int triangle) => mode switch
    {
        Triangles => (3 * triangle, (3 * triangle) + 1, (3 * triangle) + 2),
        Strip => (triangle, triangle + 1 + (triangle & 1), triangle + 2 - (triangle & 1)),
        _ => (triangle + 1, triangle + 2, 0),
    };
}
