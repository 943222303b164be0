using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Scenes;
using RayTracer.Shapes;

namespace RayTracer.Benchmarks.Embree;

/// <summary>A landscape with boulders and trees of loose leaves, of any number of triangles: long slopes, fine detail of many sizes, and triangles that overlap.</summary>
internal sealed unsafe class BenchmarkMesh
{
    private const float Extent = 200f;
    private readonly Vector3[] _positions;
    private readonly int[] _indices;

    public BenchmarkMesh(Vector3[] positions, int[] indices)
    {
        // Pinned for good: the peer keeps pointers.
        _positions = GC.AllocateUninitializedArray<Vector3>(positions.Length + 1, pinned: true);
        positions.CopyTo(_positions, 0);
        _indices = GC.AllocateUninitializedArray<int>(indices.Length, pinned: true);
        indices.CopyTo(_indices, 0);
        PositionCount = positions.Length;
    }

    public int PositionCount { get; }

    public int TriangleCount => _indices.Length / 3;

    public Vector3* Positions => (Vector3*)Marshal.UnsafeAddrOfPinnedArrayElement(_positions, 0);

    public int* Indices => (int*)Marshal.UnsafeAddrOfPinnedArrayElement(_indices, 0);

    public Vector3 Corner(int triangle, int corner) => _positions[_indices[(3 * triangle) + corner]];

    public TriangleBvh Build(int threads) => TriangleBvh.Build(new(_positions, 0, PositionCount), _indices, threads);

    /// <summary>The mesh of a file that holds nothing else, as PLY and STL files do.</summary>
    /// <exception cref="ModelException">It cannot be read.</exception>
    public static BenchmarkMesh OfFile(string path) => ModelFile.Read(path).Scene.Shapes is [MeshDescription { Data: MeshData mesh }]
        ? new(mesh.Positions, mesh.Indices)
        : throw new ModelException($"{path} does not hold one mesh and nothing else");

    /// <summary>The landscape: 35 % ground, 35 % boulders, 30 % trees.</summary>
    public static BenchmarkMesh Landscape(int triangles)
    {
        List<Vector3> positions = new(triangles * 2);
        List<int> indices = new(triangles * 3);
        Random random = new(20250621);
        Ground(positions, indices, (int)Math.Sqrt(triangles * 0.175));
        while (indices.Count < triangles * 2.1)
        {
            Boulder(positions, indices, random, triangles);
        }

        while (indices.Count < triangles * 3)
        {
            Tree(positions, indices, random, triangles);
        }

        return new([.. positions], [.. indices.Take(triangles * 3)]);
    }

    /// <summary>Height of the ground.</summary>
    public static float Height(float x, float z)
    {
        float sum = 0f;
        float amplitude = 22f;
        float frequency = 0.02f;
        for (int octave = 0; octave < 9; octave++, amplitude *= 0.5f, frequency *= 2.03f)
        {
            sum += amplitude * (Noise(x * frequency, z * frequency, (uint)octave) - 0.5f);
        }

        return sum;
    }

    private static float Noise(float x, float z, uint seed)
    {
        int left = (int)MathF.Floor(x);
        int back = (int)MathF.Floor(z);
        float s = x - left;
        float t = z - back;
        s = s * s * (3f - (2f * s));
        t = t * t * (3f - (2f * t));
        float near = float.Lerp(Lattice(left, back + 1, seed), Lattice(left + 1, back + 1, seed), s);
        return float.Lerp(float.Lerp(Lattice(left, back, seed), Lattice(left + 1, back, seed), s), near, t);
    }

    private static float Lattice(int x, int z, uint seed)
    {
        uint h = ((uint)x * 0x9E3779B1) ^ ((uint)z * 0x85EBCA77) ^ (seed * 0xC2B2AE3D);
        h = (h ^ (h >> 15)) * 0x2C1B3C6D;
        h = (h ^ (h >> 12)) * 0x297A2D39;
        return ((h ^ (h >> 15)) >> 8) / 16777216f;
    }

    private static void Ground(List<Vector3> positions, List<int> indices, int edge)
    {
        for (int i = 0; i < (edge + 1) * (edge + 1); i++)
        {
            float x = ((i % (edge + 1) / (float)edge) - 0.5f) * Extent;
            float z = ((i / (edge + 1) / (float)edge) - 0.5f) * Extent;
            positions.Add(new(x, Height(x, z), z));
        }

        Grid(indices, 0, edge, edge);
    }

    private static void Grid(List<int> indices, int first, int columns, int rows)
    {
        for (int i = 0; i < columns * rows; i++)
        {
            int corner = first + (i / columns * (columns + 1)) + (i % columns);
            indices.AddRange([corner, corner + 1, corner + columns + 1, corner + 1, corner + columns + 2, corner + columns + 1]);
        }
    }

    private static void Boulder(List<Vector3> positions, List<int> indices, Random random, int triangles)
    {
        float radius = MathF.Min(8f, 0.15f * MathF.Pow(1f - (0.9995f * random.NextSingle()), -0.55f));
        Vector3 middle = Place(random, radius * 0.5f);
        int columns = Math.Min(1200, (int)(6 + (Math.Sqrt(triangles / 1e5) * radius * 6 * (0.3 + (1.4 * random.NextDouble())))));
        int rows = (columns / 2) + 2;
        float flatness = 0.4f + (1.2f * random.NextSingle());
        float roughness = 0.7f * random.NextSingle();
        float phase = 100f * random.NextSingle();
        int first = positions.Count;
        for (int i = 0; i < (columns + 1) * (rows + 1); i++)
        {
            float polar = MathF.PI * (i / (columns + 1)) / rows;
            float azimuth = 2f * MathF.PI * (i % (columns + 1) % columns) / columns;
            Vector3 way = new(MathF.Sin(polar) * MathF.Cos(azimuth), MathF.Cos(polar), MathF.Sin(polar) * MathF.Sin(azimuth));
            float bump = 1f + (roughness * Height(150f * (phase + way.X + way.Y), 150f * (way.Z + way.Y)) / 22f);
            positions.Add(middle + (way * bump * new Vector3(radius * flatness, radius, radius)));
        }

        Grid(indices, first, columns, rows);
    }

    private static void Tree(List<Vector3> positions, List<int> indices, Random random, int triangles)
    {
        float height = 2f + (6f * random.NextSingle());
        Vector3 crown = Place(random, height);
        int leaves = (int)(Math.Pow(triangles / 1e5, 0.6) * (60 + (300 * random.NextDouble())));
        float size = 0.9f * 0.35f * height / MathF.Sqrt(leaves);
        for (int leaf = 0; leaf < leaves; leaf++)
        {
            Vector3 way = Vector3.Normalize(Cube(random) + new Vector3(1e-6f));
            Vector3 middle = crown + (way * 0.35f * height * MathF.Pow(random.NextSingle(), 0.4f));
            for (int corner = 0; corner < 3; corner++)
            {
                indices.Add(positions.Count);
                positions.Add(middle + (Cube(random) * size));
            }
        }
    }

    private static Vector3 Place(Random random, float above)
    {
        float x = (random.NextSingle() - 0.5f) * Extent;
        float z = (random.NextSingle() - 0.5f) * Extent;
        return new(x, Height(x, z) + above, z);
    }

    private static Vector3 Cube(Random random) => new((2f * random.NextSingle()) - 1f, (2f * random.NextSingle()) - 1f, (2f * random.NextSingle()) - 1f);
}
