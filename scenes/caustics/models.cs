// Makes the meshes of these scenes: `dotnet run scenes/caustics/models.cs` writes them beside this file.
#:property PublishAot=false
using System.Numerics;
using System.Runtime.CompilerServices;

string folder = Path.GetDirectoryName(Here())!;
Write("lens", Lens(0.05f, 0.236f));
Write("water", Water(1.22f, 72));

// A lens of two caps of spheres, which meet in a sharp edge around the y axis.
static Mesh Lens(float aperture, float radius)
{
    const int Rings = 20, Around = 80;
    Mesh mesh = new();
    float middle = MathF.Sqrt((radius * radius) - (aperture * aperture));
    foreach (float side in new[] { 1f, -1f })
    {
        mesh.Grid(Rings, Around, (u, v) =>
        {
            // The pole is a ring that is too small to be seen.
            (float sin, float cos) = MathF.SinCos(-side * MathF.Tau * (v % 1));
            float r = aperture * MathF.Max(u, 1e-4f);
            Vector3 p = new(r * cos, MathF.Sqrt((radius * radius) - (r * r)), r * sin);
            return (new Vector3(p.X, side * (p.Y - middle), p.Z), new Vector3(p.X, side * p.Y, p.Z));
        });
    }

    return mesh;
}

// The surface of a pool, whose waves run in all directions, and below it straight sides and a level bottom, to be hidden within walls and floor.
static Mesh Water(float half, int cells)
{
    const float Depth = 0.92f;
    Random random = new(11);
    (Vector2 Wave, float Height, float Phase)[] waves = [.. Enumerable.Range(0, 9).Select(i =>
    {
        (float sin, float cos) = MathF.SinCos(MathF.Tau * (i + (0.7f * random.NextSingle())) / 9);
        float perMetre = MathF.Tau / (0.28f + (0.08f * i));
        return (perMetre * new Vector2(cos, sin), 1.1f / (perMetre * perMetre), MathF.Tau * random.NextSingle());
    })];
    Mesh mesh = new();
    mesh.Grid(cells, cells, (u, v) =>
    {
        Vector2 at = new(half * ((2 * u) - 1), half * ((2 * v) - 1));
        float height = waves.Sum(w => w.Height * MathF.Sin(Vector2.Dot(w.Wave, at) + w.Phase));
        float x = waves.Sum(w => w.Height * w.Wave.X * MathF.Cos(Vector2.Dot(w.Wave, at) + w.Phase));
        float z = waves.Sum(w => w.Height * w.Wave.Y * MathF.Cos(Vector2.Dot(w.Wave, at) + w.Phase));
        return (new Vector3(at.X, height, at.Y), new Vector3(-x, 1, -z));
    });
    Vector3 Surface(float u, float v) => mesh.Corners[((int)MathF.Round(u * cells) * (cells + 1)) + (int)MathF.Round(v * cells)].Position;
    Vector3 Below(Vector3 p, float t) => p with { Y = p.Y + (t * (-Depth - p.Y)) };
    mesh.Grid(cells, 1, (u, v) => (Below(Surface(u, 1), v), Vector3.UnitZ));
    mesh.Grid(cells, 1, (u, v) => (Below(Surface(1 - u, 0), v), -Vector3.UnitZ));
    mesh.Grid(cells, 1, (u, v) => (Below(Surface(1, 1 - u), v), Vector3.UnitX));
    mesh.Grid(cells, 1, (u, v) => (Below(Surface(0, u), v), -Vector3.UnitX));
    mesh.Grid(1, 1, (u, v) => (new Vector3(half * ((2 * u) - 1), -Depth, half * (1 - (2 * v))), -Vector3.UnitY));
    return mesh;
}

static string Here([CallerFilePath] string path = "") => path;

void Write(string name, Mesh mesh)
{
    using BinaryWriter writer = new(File.Create(Path.Combine(folder, name + ".ply")));
    writer.Write($"""
        ply
        format binary_little_endian 1.0
        element vertex {mesh.Corners.Count}
        property float x
        property float y
        property float z
        property float nx
        property float ny
        property float nz
        element face {mesh.Triangles.Count}
        property list uchar int vertex_indices
        end_header

        """.ReplaceLineEndings("\n").ToCharArray());
    foreach ((Vector3 p, Vector3 normal) in mesh.Corners)
    {
        Vector3 n = Vector3.Normalize(normal);
        foreach (float x in new[] { p.X, p.Y, p.Z, n.X, n.Y, n.Z })
        {
            writer.Write(x);
        }
    }

    foreach ((int a, int b, int c) in mesh.Triangles)
    {
        writer.Write((byte)3);
        writer.Write(a);
        writer.Write(b);
        writer.Write(c);
    }

    Console.WriteLine($"{name}.ply: {mesh.Triangles.Count} triangles, {writer.BaseStream.Length / 1000} kB");
}

/// <summary>Triangles with a normal at each corner.</summary>
internal sealed class Mesh
{
    public List<(Vector3 Position, Vector3 Normal)> Corners { get; } = [];

    public List<(int A, int B, int C)> Triangles { get; } = [];

    /// <summary>A surface over the unit square; seen from its front, u grows downwards and v to the right.</summary>
    public void Grid(int rows, int columns, Func<float, float, (Vector3 Position, Vector3 Normal)> corner)
    {
        int first = Corners.Count;
        for (int i = 0; i <= rows; i++)
        {
            for (int j = 0; j <= columns; j++)
            {
                Corners.Add(corner((float)i / rows, (float)j / columns));
            }
        }

        for (int i = 0; i < rows; i++)
        {
            for (int j = 0; j < columns; j++)
            {
                int a = first + (i * (columns + 1)) + j;
                int below = a + columns + 1;
                Add(a, below, below + 1);
                Add(a, below + 1, a + 1);
            }
        }
    }

    // In the order that the normals ask for.
    private void Add(int a, int b, int c)
    {
        Vector3 front = Vector3.Cross(Corners[b].Position - Corners[a].Position, Corners[c].Position - Corners[a].Position);
        Triangles.Add(Vector3.Dot(front, Corners[a].Normal) > 0 ? (a, b, c) : (a, c, b));
    }
}
