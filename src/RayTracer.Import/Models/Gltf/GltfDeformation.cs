using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>What bends a mesh: first its morph targets, then the joints of its skin (glTF 2.0, sections 3.7.2.2 and 3.7.3.3).</summary>
/// <param name="Weights">The weights of the morph targets.</param>
/// <param name="Joints">The maps of the joints from where the mesh was modelled to the world; null without a skin.</param>
internal sealed record GltfDeformation(IReadOnlyList<float> Weights, Transform[]? Joints)
{
    // Position, normal and tangent.
    private const int BytesPerVertex = 40;
    private const int StepsPerVertex = 16;
    private const int StepsPerTarget = 3;

    /// <summary>Bends a mesh.</summary>
    /// <param name="mesh">The mesh with all of its vertices.</param>
    /// <param name="primitive">It in the file.</param>
    /// <param name="accessors">The file's accessors.</param>
    public MeshData Bend(MeshData mesh, GltfObject primitive, GltfAccessors accessors)
    {
        long vertices = mesh.Positions.Length;
        int targets = Weights.Count(w => w != 0);
        if (SceneBudget.Open?.Take($"{vertices} bent vertices", BytesPerVertex * vertices, vertices * (StepsPerVertex + (StepsPerTarget * targets))) is { } complaint)
        {
            throw primitive.Error(complaint);
        }

        Vector3[] positions = Copy(mesh.Positions)!;
        Vector3[]? normals = Copy(mesh.Normals);
        Vector4[]? tangents = Copy(mesh.Tangents);
        foreach ((GltfObject target, float weight) in primitive.Children("targets").Zip(Weights).Where(t => t.Second != 0))
        {
            Add(target, "POSITION", positions, weight, accessors);
            Add(target, "NORMAL", normals, weight, accessors);
            AddTangents(target, tangents, weight, accessors);
        }

        if (Joints is not null)
        {
            new GltfSkinning(primitive, accessors, Joints, positions.Length).Bend(positions, normals, tangents);
        }

        return new(positions, mesh.Indices) { Normals = normals, Tangents = tangents, Uv = mesh.Uv, Colors = mesh.Colors };
    }

    private static T[]? Copy<T>(T[]? all) => (T[]?)all?.Clone();

    private static void Add(GltfObject target, string name, Vector3[]? vertices, float weight, GltfAccessors accessors)
    {
        ReadOnlySpan<Vector3> moves = Moves(target, name, vertices?.Length, accessors);
        for (int i = 0; i < moves.Length; i++)
        {
            vertices![i] += moves[i] * weight;
        }
    }

    private static void AddTangents(GltfObject target, Vector4[]? tangents, float weight, GltfAccessors accessors)
    {
        ReadOnlySpan<Vector3> moves = Moves(target, "TANGENT", tangents?.Length, accessors);
        for (int i = 0; i < moves.Length; i++)
        {
            tangents![i] += new Vector4(moves[i] * weight, 0);
        }
    }

    // None where the target does not move such a thing, or the mesh has none.
    private static ReadOnlySpan<Vector3> Moves(GltfObject target, string name, int? expected, GltfAccessors accessors)
    {
        if (expected is null || accessors.Floats(target, name, 3) is not { } numbers)
        {
            return [];
        }

        return numbers.Length == 3 * expected ? MemoryMarshal.Cast<float, Vector3>(numbers)
            : throw target.Error(name, $"it has {numbers.Length / 3} elements, but there are {expected} positions");
    }
}

/// <summary>The joints that each vertex of a primitive follows.</summary>
internal sealed class GltfSkinning
{
    private const int JointsOfSet = 4;
    private readonly Transform[] _joints;
    private readonly List<(uint[] Joints, float[] Weights)> _sets = [];

    /// <summary>Reads them.</summary>
    /// <param name="primitive">The primitive.</param>
    /// <param name="accessors">The file's accessors.</param>
    /// <param name="joints">The maps of the joints.</param>
    /// <param name="vertices">The number of vertices.</param>
    public GltfSkinning(GltfObject primitive, GltfAccessors accessors, Transform[] joints, int vertices)
    {
        _joints = joints;
        GltfObject attributes = primitive.RequiredChild("attributes");
        for (int set = 0; attributes.Has($"JOINTS_{set}"); set++)
        {
            _sets.Add((Joints(attributes, $"JOINTS_{set}", accessors), accessors.Floats(attributes, $"WEIGHTS_{set}", JointsOfSet) ?? throw attributes.Missing($"WEIGHTS_{set}")));
            if (_sets[^1].Joints.Length != JointsOfSet * vertices || _sets[^1].Weights.Length != JointsOfSet * vertices)
            {
                throw attributes.Error($"JOINTS_{set}", $"it and its weights must have an element for each of the {vertices} positions");
            }
        }

        if (_sets.Count == 0)
        {
            throw attributes.Missing("JOINTS_0");
        }
    }

    /// <summary>Bends vertices with what lies at them.</summary>
    public void Bend(Vector3[] positions, Vector3[]? normals, Vector4[]? tangents)
    {
        for (int i = 0; i < positions.Length; i++)
        {
            Transform map = Map(i);
            positions[i] = map.Point(positions[i]);
            if (normals is not null)
            {
                normals[i] = Normal(map, normals[i]);
            }

            if (tangents is not null)
            {
                tangents[i] = new(map.Vector(new(tangents[i].X, tangents[i].Y, tangents[i].Z)).Unit(), tangents[i].W);
            }
        }
    }

    private uint[] Joints(GltfObject attributes, string name, GltfAccessors accessors)
    {
        GltfAccessor accessor = accessors.Find(attributes, name)!;
        return accessor.Components == JointsOfSet && accessor.Type is (GltfComponentType.UnsignedByte or GltfComponentType.UnsignedShort)
            ? accessors.Whole(accessor, attributes, name, _joints.Length, "joints")
            : throw attributes.Error(name, $"{accessor.Object.Path} must be a VEC4 of unsigned whole numbers (5121 or 5123)");
    }

    // The mean of the maps of the vertex's joints by their weights, which small whole numbers do not let come to 1 exactly.
    private Transform Map(int vertex)
    {
        double all = 0;
        Span<double> rows = stackalloc double[12];
        rows.Clear();
        foreach ((uint[] joints, float[] weights) in _sets)
        {
            for (int i = JointsOfSet * vertex; i < JointsOfSet * (vertex + 1); i++)
            {
                all += weights[i];
                if (weights[i] != 0)
                {
                    Add(_joints[joints[i]], weights[i], rows);
                }
            }
        }

        double scale = 1 / all;
        return !(double.Abs(all) > 0) ? _joints[_sets[0].Joints[JointsOfSet * vertex]] : new(Row(rows, scale), Row(rows[4..], scale), Row(rows[8..], scale));
    }

    private static void Add(in Transform map, double weight, Span<double> rows)
    {
        Add(map.X, weight, rows);
        Add(map.Y, weight, rows[4..]);
        Add(map.Z, weight, rows[8..]);
    }

    private static void Add(TransformRow row, double weight, Span<double> to)
    {
        to[0] += weight * row.A;
        to[1] += weight * row.B;
        to[2] += weight * row.C;
        to[3] += weight * row.D;
    }

    private static TransformRow Row(ReadOnlySpan<double> row, double scale) => new(row[0] * scale, row[1] * scale, row[2] * scale, row[3] * scale);

    private static Vector3 Normal(in Transform map, Vector3 normal) => map.Inverse().TransposedVector(normal).Unit();
}
