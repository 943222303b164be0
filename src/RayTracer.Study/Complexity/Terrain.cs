using System.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;

namespace RayTracer.Study;

/// <summary>A landscape with as many triangles as wanted, and rays through it: more triangles show more of the same hills.</summary>
internal static class Terrain
{
    private const int Octaves = 12;
    private const float Height = 0.25f;

    /// <summary>Makes a landscape over the unit square.</summary>
    /// <param name="triangles">The number of triangles; an even number.</param>
    public static MeshData Create(int triangles)
    {
        int squares = triangles / 2;
        int columns = (int)Math.Sqrt(squares);
        while (squares % columns != 0)
        {
            columns--;
        }

        int rows = squares / columns;
        Vector3[] positions = new Vector3[(rows + 1) * (columns + 1)];
        Parallel.For(0, rows + 1, row =>
        {
            for (int column = 0; column <= columns; column++)
            {
                (float x, float z) = ((float)column / columns, (float)row / rows);
                positions[(row * (columns + 1)) + column] = new(x, HeightAt(x, z), z);
            }
        });
        int[] indices = new int[6 * squares];
        for (int square = 0; square < squares; square++)
        {
            int corner = square + (square / columns);
            int below = corner + columns + 1;
            ReadOnlySpan<int> corners = [corner, below, corner + 1, corner + 1, below, below + 1];
            corners.CopyTo(indices.AsSpan(6 * square));
        }

        return new(positions, indices);
    }

    /// <summary>Rays from above and from the sides to random points of the landscape's box, in no order.</summary>
    public static (Vector3 Origin, Vector3 Direction)[] Rays(int count) => [.. Enumerable.Range(0, count).Select(i =>
    {
        Vector3 to = new(Random(i, 0), Random(i, 1) * Height, Random(i, 2));
        Vector3 from = new((3 * Random(i, 3)) - 1, 0.3f + Random(i, 4), (3 * Random(i, 5)) - 1);
        return (from, Vector3.Normalize(to - from));
    })];

    // Noise of ever finer lattices, each octave half as high as the one before.
    private static float HeightAt(float x, float z)
    {
        float height = 0;
        for (int octave = 0; octave < Octaves; octave++)
        {
            float scale = 3 << octave;
            height += Noise(x * scale, z * scale, octave) / (2 << octave);
        }

        return height * Height;
    }

    private static float Noise(float x, float z, int octave)
    {
        (int column, int row) = ((int)x, (int)z);
        (float u, float v) = (Smooth(x - column), Smooth(z - row));
        float Lattice(int dx, int dz) => Random(((row + dz) << 16) + column + dx, 100 + octave);
        float near = float.Lerp(Lattice(0, 0), Lattice(1, 0), u);
        float far = float.Lerp(Lattice(0, 1), Lattice(1, 1), u);
        return float.Lerp(near, far, v);
    }

    private static float Smooth(float t) => t * t * (3 - (2 * t));

    private static float Random(int index, int dimension) => (Hash.PixelKey((uint)dimension, (uint)index) >> 8) / (float)(1 << 24);
}
