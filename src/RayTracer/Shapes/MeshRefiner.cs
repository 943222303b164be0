using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Shapes;

/// <summary>Refines meshes: subdivides them, moves their corners, and gives them normals that are smooth up to creases.</summary>
internal static unsafe class MeshRefiner
{
    // While it is made: its places and corners, their dictionary, and the triangles.
    private const long BytesPerTriangle = 400;

    /// <summary>The memory that a refined mesh takes while it is made, and the number of its triangles.</summary>
    public static (long Bytes, long Triangles) Cost(MeshData mesh, RefinementDescription wanted)
    {
        long triangles = mesh.TriangleCount;
        for (int level = 0; level < wanted.Subdivide; level++)
        {
            // Three quadrilaterals of a triangle, and then four of each.
            triangles *= wanted.Scheme == SubdivisionScheme.CatmullClark && level == 0 ? 6 : 4;
        }

        return (triangles * BytesPerTriangle, triangles);
    }

    /// <summary>A refined mesh.</summary>
    /// <param name="mesh">A mesh without faults.</param>
    /// <param name="wanted">What it is to become.</param>
    /// <param name="displacement">The texture that moves corners; null for none.</param>
    /// <param name="isFlat">True where every triangle is flat.</param>
    public static MeshData Refine(MeshData mesh, RefinementDescription wanted, Texture? displacement, bool isFlat)
    {
        PolygonMesh refined = PolygonMesh.Of(mesh, wanted.Scheme == SubdivisionScheme.Loop || wanted.Subdivide == 0, wanted.CreaseAngle);
        for (int level = 0; level < wanted.Subdivide; level++)
        {
            refined = Subdivision.Once(refined, wanted.Scheme);
        }

        if (wanted.Subdivide > 0)
        {
            refined = Moved(refined, Subdivision.Limit(refined, wanted.Scheme));
        }

        if (displacement is not null)
        {
            refined = Moved(refined, Displaced(refined, wanted, displacement));
        }

        return Triangles(refined, isFlat ? null : Normals(refined));
    }

    private static PolygonMesh Moved(PolygonMesh mesh, Vector3[] positions) => new()
    {
        Positions = positions,
        Starts = mesh.Starts,
        Corners = mesh.Corners,
        Creases = mesh.Creases,
        Uv = mesh.Uv,
        Colors = mesh.Colors,
        Materials = mesh.Materials,
    };

    // One movement for each place, so that there are no cracks where uv of its faces differ.
    private static Vector3[] Displaced(PolygonMesh mesh, RefinementDescription wanted, Texture texture)
    {
        float[] sums = new float[mesh.Positions.Length];
        int[] counts = new int[mesh.Positions.Length];
        Vector3[] normals = new Vector3[mesh.Positions.Length];
        float[] values = Values(mesh, texture);
        for (int face = 0; face < mesh.FaceCount; face++)
        {
            for (int corner = mesh.Starts[face]; corner < mesh.Starts[face + 1]; corner++)
            {
                int place = mesh.Corners[corner];
                sums[place] += values[corner];
                counts[place]++;
                normals[place] += WeightedNormal(mesh, face, corner);
            }
        }

        return [.. mesh.Positions.Select((at, i) =>
        {
            Vector3 normal = normals[i].Unit();
            return counts[i] == 0 || !normal.IsFinite() ? at : at + (normal * (((sums[i] / counts[i]) - wanted.Middle) * wanted.Height));
        })];
    }

    // The texture's red channel at each corner of each face.
    private static float[] Values(PolygonMesh mesh, Texture texture)
    {
        float[] values = new float[mesh.Corners.Length];
        float* memory = stackalloc float[8 * 16];
        for (int first = 0; first < values.Length; first += FloatW.Count)
        {
            int count = Math.Min(FloatW.Count, values.Length - first);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                int corner = first + Math.Min(lane, count - 1);
                (Vector3 at, Vector2 uv, Rgb color) = (mesh.Positions[mesh.Corners[corner]], mesh.Uv?[corner] ?? default, mesh.Colors?[corner] ?? Rgb.White);
                (memory[lane], memory[16 + lane]) = (uv.X, uv.Y);
                (memory[32 + lane], memory[48 + lane], memory[64 + lane]) = (at.X, at.Y, at.Z);
                (memory[80 + lane], memory[96 + lane], memory[112 + lane]) = (color.R, color.G, color.B);
            }

            TexturePointW point = new() { U = FloatW.Load(memory), V = FloatW.Load(memory + 16) };
            point.Local = point.World = new(FloatW.Load(memory + 32), FloatW.Load(memory + 48), FloatW.Load(memory + 64));
            point.VertexColor = new(FloatW.Load(memory + 80), FloatW.Load(memory + 96), FloatW.Load(memory + 112));
            point.SecondColor = Rgb.White;
            texture.Evaluate(point, out RgbW value);
            for (int lane = 0; lane < count; lane++)
            {
                values[first + lane] = value.R[lane];
            }
        }

        return values;
    }

    // Around each place, the mean of the faces on the same side of all creases, weighted by their angles there (Thürmer & Wüthrich 1998): one for each corner of each face.
    private static Vector3[] Normals(PolygonMesh mesh)
    {
        int[] groups = SmoothGroups(mesh);
        Vector3[] sums = new Vector3[groups.Length];
        for (int face = 0; face < mesh.FaceCount; face++)
        {
            for (int corner = mesh.Starts[face]; corner < mesh.Starts[face + 1]; corner++)
            {
                sums[groups[corner]] += WeightedNormal(mesh, face, corner);
            }
        }

        return [.. groups.Select(g => sums[g].Unit() is var unit && unit.IsFinite() ? unit : default)];
    }

    private static Vector3 WeightedNormal(PolygonMesh mesh, int face, int corner)
    {
        Vector3 at = mesh.Positions[mesh.Corners[corner]];
        Vector3 next = mesh.Positions[mesh.Corners[mesh.Next(face, corner)]] - at;
        Vector3 last = mesh.Positions[mesh.Corners[mesh.Previous(face, corner)]] - at;
        Vector3 across = next.Cross(last);
        Vector3 weighted = across.Unit() * LaneMath.Atan2(across.Norm(), next.Dot(last));
        return weighted.IsFinite() ? weighted : default;
    }

    // For each corner of each face, the first of those that share its place and are joined with it across edges that are not sharp.
    private static int[] SmoothGroups(PolygonMesh mesh)
    {
        MeshTopology edges = MeshTopology.Of(mesh);
        int[] groups = [.. Enumerable.Range(0, mesh.Corners.Length)];
        int[] firstOf = new int[edges.EdgeCount];
        Array.Fill(firstOf, -1);
        for (int face = 0; face < mesh.FaceCount; face++)
        {
            for (int corner = mesh.Starts[face]; corner < mesh.Starts[face + 1]; corner++)
            {
                int edge = edges.EdgeOf[corner];
                if (edges.IsSharp(edge))
                {
                    continue;
                }

                if (firstOf[edge] < 0)
                {
                    firstOf[edge] = corner;
                    continue;
                }

                // The other face goes along it from the other end.
                int other = edges.OppositeFace(edge, face);
                Join(groups, corner, mesh.Next(other, firstOf[edge]));
                Join(groups, mesh.Next(face, corner), firstOf[edge]);
            }
        }

        return [.. groups.Select((_, i) => RootOf(groups, i))];
    }

    private static void Join(int[] groups, int a, int b)
    {
        (a, b) = (RootOf(groups, a), RootOf(groups, b));
        groups[Math.Max(a, b)] = Math.Min(a, b);
    }

    private static int RootOf(int[] groups, int corner)
    {
        while (groups[corner] != corner)
        {
            corner = groups[corner] = groups[groups[corner]];
        }

        return corner;
    }

    // Corners that agree in everything are one again.
    private static MeshData Triangles(PolygonMesh mesh, Vector3[]? normals)
    {
        Dictionary<(int Place, Vector3 Normal, Vector2 Uv, Rgb Color), int> known = [];
        List<int> corners = [];
        int[] vertexOf = new int[mesh.Corners.Length];
        for (int i = 0; i < vertexOf.Length; i++)
        {
            (int, Vector3, Vector2, Rgb) key = (mesh.Corners[i], normals?[i] ?? default, mesh.Uv?[i] ?? default, mesh.Colors?[i] ?? Rgb.Black);
            if (!known.TryGetValue(key, out vertexOf[i]))
            {
                vertexOf[i] = corners.Count;
                known.Add(key, corners.Count);
                corners.Add(i);
            }
        }

        List<int> indices = [];
        List<int> materials = [];
        for (int face = 0; face < mesh.FaceCount; face++)
        {
            for (int i = mesh.Starts[face] + 1; i + 1 < mesh.Starts[face + 1]; i++)
            {
                indices.AddRange([vertexOf[mesh.Starts[face]], vertexOf[i], vertexOf[i + 1]]);
                materials.Add(mesh.Materials?[face] ?? 0);
            }
        }

        return new([.. corners.Select(c => mesh.Positions[mesh.Corners[c]])], [.. indices])
        {
            Normals = normals is null ? null : [.. corners.Select(c => normals[c])],
            Uv = mesh.Uv is { } uv ? [.. corners.Select(c => uv[c])] : null,
            Colors = mesh.Colors is { } colors ? [.. corners.Select(c => colors[c])] : null,
            MaterialOfTriangle = mesh.Materials is null ? null : [.. materials],
        };
    }
}
