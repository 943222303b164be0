using System.Text;

namespace RayTracer.Benchmarks.Standing;

/// <summary>A ball with bumps of three sizes, as a binary PLY file: bytes that are the same on every machine.</summary>
internal static class BumpyBall
{
    // Few enough for the last bit of a sine, which machines differ in, to be lost.
    private const int Digits = 5;

    /// <summary>Writes a ball of 2·columns·(rows − 1) triangles, whose corners lie on circles of latitude.</summary>
    public static void Write(string path, int columns, int rows)
    {
        using BinaryWriter file = new(File.Create(path));
        file.Write(Encoding.ASCII.GetBytes($"""
            ply
            format binary_little_endian 1.0
            element vertex {columns * (rows + 1)}
            property float x
            property float y
            property float z
            element face {2 * columns * (rows - 1)}
            property list uchar int vertex_indices
            end_header

            """.ReplaceLineEndings("\n")));
        for (int i = 0; i < columns * (rows + 1); i++)
        {
            Corner(file, i % columns * 2 * Math.PI / columns, i / columns * Math.PI / rows);
        }

        for (int i = 0; i < columns * rows; i++)
        {
            int next = i % columns == columns - 1 ? i + 1 - columns : i + 1;

            // Around the poles, one of the two triangles has no area.
            if (i >= columns)
            {
                Triangle(file, i, next, i + columns);
            }

            if (i < columns * (rows - 1))
            {
                Triangle(file, next, next + columns, i + columns);
            }
        }
    }

    private static void Corner(BinaryWriter file, double longitude, double polar)
    {
        double around = Math.Sin(polar);
        double radius = 1 + (0.05 * Math.Sin(9 * longitude) * Math.Sin(8 * polar))
            + (around * around * ((0.02 * Math.Sin((41 * longitude) + (3 * Math.Cos(13 * polar)))) + (0.006 * Math.Sin(150 * longitude) * Math.Sin(140 * polar))));
        Coordinate(file, radius * around * Math.Cos(longitude));
        Coordinate(file, radius * Math.Cos(polar));
        Coordinate(file, radius * around * Math.Sin(longitude));
    }

    private static void Coordinate(BinaryWriter file, double value) => file.Write((float)Math.Round(value, Digits));

    private static void Triangle(BinaryWriter file, int a, int b, int c)
    {
        file.Write((byte)3);
        file.Write(a);
        file.Write(b);
        file.Write(c);
    }
}
