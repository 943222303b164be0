using System.Globalization;
using System.Numerics;
using System.Runtime.InteropServices;
using System.Text;

namespace RayTracer.Benchmarks.Embree;

/// <summary>Reads the plainest of PLY files: binary little endian, float x y z first in each vertex, faces of three corners and nothing else.</summary>
internal static class PlyMesh
{
    public static BenchmarkMesh Read(string path)
    {
        using BinaryReader reader = new(File.OpenRead(path));
        int vertices = 0;
        int faces = 0;
        int floats = 0;
        for (string line = Line(reader); line != "end_header"; line = Line(reader))
        {
            string[] words = line.Split(' ', StringSplitOptions.RemoveEmptyEntries);
            switch (words)
            {
                case ["format", not "binary_little_endian", ..]:
                    throw new InvalidDataException("Only binary little-endian PLY files can be measured.");
                case ["element", "vertex", string count]:
                    vertices = int.Parse(count, CultureInfo.InvariantCulture);
                    break;
                case ["element", "face", string count]:
                    faces = int.Parse(count, CultureInfo.InvariantCulture);
                    break;
                case ["property", "float" or "float32", _]:
                    floats++;
                    break;
                case ["property", "list", "uchar" or "uint8", "int" or "uint" or "int32" or "uint32", _] or ["ply"] or ["format", ..] or ["comment" or "obj_info", ..]:
                    break;
                default:
                    throw new InvalidDataException($"PLY files with \"{line}\" cannot be measured.");
            }
        }

        return new(Positions(reader, vertices, floats), Indices(reader, faces));
    }

    private static Vector3[] Positions(BinaryReader reader, int count, int floats)
    {
        Vector3[] positions = new Vector3[count];
        float[] vertex = new float[floats];
        for (int i = 0; i < count; i++)
        {
            reader.BaseStream.ReadExactly(MemoryMarshal.AsBytes(vertex.AsSpan()));
            positions[i] = new(vertex[0], vertex[1], vertex[2]);
        }

        return positions;
    }

    private static int[] Indices(BinaryReader reader, int faces)
    {
        int[] indices = new int[3 * faces];
        for (int face = 0; face < faces; face++)
        {
            if (reader.ReadByte() != 3)
            {
                throw new InvalidDataException("Only PLY files of triangles can be measured.");
            }

            reader.BaseStream.ReadExactly(MemoryMarshal.AsBytes(indices.AsSpan(3 * face, 3)));
        }

        return indices;
    }

    private static string Line(BinaryReader reader)
    {
        StringBuilder line = new();
        for (char c = (char)reader.ReadByte(); c != '\n'; c = (char)reader.ReadByte())
        {
            line.Append(c);
        }

        return line.ToString().TrimEnd('\r');
    }
}
