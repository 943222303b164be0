using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>Makes triangles of a glTF file's primitives; primitives that are alike share them.</summary>
internal sealed class GltfMeshes(GltfDocument document, GltfAccessors accessors)
{
    // What one triangle takes besides its three indices: its share of the tree over the mesh, roughly.
    private const int TriangleBytes = 12;

    private readonly Dictionary<string, MeshData> _built = new(StringComparer.Ordinal);
    private readonly Dictionary<string, MeshData?> _whole = new(StringComparer.Ordinal);
    private readonly Dictionary<(int Accessor, Type Element), Array> _vertices = [];

    /// <summary>The triangles of a primitive; null where it has none: points and lines are left out.</summary>
    /// <param name="primitive">The primitive in the file.</param>
    /// <param name="uvSet">Which set of uv its material uses.</param>
    /// <param name="deformation">What bends it; null for nothing.</param>
    /// <exception cref="ModelException">It refers to what is not there.</exception>
    public MeshData? Build(GltfObject primitive, int uvSet, GltfDeformation? deformation = null)
    {
        int mode = primitive.Integer("mode", 0, TriangleAssembly.Fan) ?? TriangleAssembly.Triangles;
        if (mode < TriangleAssembly.Triangles)
        {
            document.Notes.Add(mode == 0 ? "points are ignored: only triangles are shown" : "lines are ignored: only triangles are shown");
            return null;
        }

        GltfObject attributes = primitive.RequiredChild("attributes");
        if (primitive.Extension("KHR_draco_mesh_compression") is not null)
        {
            NoteDraco(primitive, attributes);
        }

        string key = Key(primitive, attributes, mode, uvSet);
        MeshData? whole = _whole.Remember(key, () => Build(primitive, attributes, mode, uvSet));
        return whole is null ? null
            : deformation is not null ? Compacted(deformation.Bend(whole, primitive, accessors))
            : _built.Remember(key, () => Compacted(whole));
    }

    // Without a copy, the accessors have no bytes, which would make all positions zeros.
    private void NoteDraco(GltfObject primitive, GltfObject attributes)
    {
        if (accessors.Find(attributes, "POSITION") is { HasBytes: false })
        {
            throw primitive.Error("it is compressed with KHR_draco_mesh_compression, which is not read: export it without compression");
        }

        document.Notes.Add("meshes compressed with KHR_draco_mesh_compression are read from their uncompressed copy");
    }

    // Exporters let many primitives share one long list of vertices, of which each uses a few.
    private static MeshData Compacted(MeshData whole) => whole.Indices.Length < whole.Positions.Length / 2 ? MeshCompaction.Compact(whole) : whole;

    private string Key(GltfObject primitive, GltfObject attributes, int mode, int uvSet)
    {
        IEnumerable<string> used = ((string[])["POSITION", "NORMAL", "TANGENT", "COLOR_0", $"TEXCOORD_{uvSet}"])
            .Select(name => $"{document.Reference(attributes, name, "accessors")}");
        return $"{mode} {document.Reference(primitive, "indices", "accessors")} {string.Join(' ', used)}";
    }

    private MeshData? Build(GltfObject primitive, GltfObject attributes, int mode, int uvSet)
    {
        if (!attributes.Has("POSITION"))
        {
            document.Notes.Add("a primitive without positions is ignored");
            return null;
        }

        Vector3[] positions = Vertices<Vector3>(attributes, "POSITION", null)!;
        int[] indices = Indices(primitive, mode, positions.Length);
        if (indices.Length == 0)
        {
            document.Notes.Add("a primitive with fewer than three vertices is ignored");
            return null;
        }

        return new(positions, indices)
        {
            Normals = Vertices<Vector3>(attributes, "NORMAL", positions.Length),
            Tangents = Vertices<Vector4>(attributes, "TANGENT", positions.Length),
            Colors = Vertices<Rgb>(attributes, "COLOR_0", positions.Length),
            Uv = Vertices<Vector2>(attributes, $"TEXCOORD_{uvSet}", positions.Length),
        };
    }

    // One array for each accessor and kind of element, so that primitives share it.
    private T[]? Vertices<T>(GltfObject attributes, string name, int? expected)
        where T : struct
    {
        if (document.Reference(attributes, name, "accessors") is not { } index)
        {
            return null;
        }

        GltfAccessor accessor = accessors.Find(attributes, name)!;
        if (accessor.Count != (expected ?? accessor.Count))
        {
            throw attributes.Error(name, $"it has {accessor.Count} elements, but there are {expected} positions");
        }

        if (_vertices.TryGetValue((index, typeof(T)), out Array? known))
        {
            return (T[])known;
        }

        int taken = Marshal.SizeOf<T>() / sizeof(float);
        if (accessor.Components < taken || accessor.Components > 4)
        {
            throw attributes.Error(name, $"its accessor has {accessor.Components} numbers an element: {taken} are needed");
        }

        T[] elements = new T[accessors.Ask(accessor, (long)accessor.Count * taken * sizeof(float))];
        accessor.Read(MemoryMarshal.Cast<T, float>(elements.AsSpan()), taken);
        if (elements is Vector2[] uv)
        {
            // The origin of uv is the picture's upper left corner in glTF, its lower left one here.
            for (int i = 0; i < uv.Length; i++)
            {
                uv[i].Y = 1 - uv[i].Y;
            }
        }

        _vertices.Add((index, typeof(T)), elements);
        return elements;
    }

    private int[] Indices(GltfObject primitive, int mode, int vertexCount)
    {
        GltfAccessor? accessor = accessors.Find(primitive, "indices");
        uint[]? list = accessor is null ? null : Listed(primitive, accessor, vertexCount);
        int count = list?.Length ?? vertexCount;
        if (mode == TriangleAssembly.Triangles && count % 3 != 0)
        {
            document.Notes.Add("vertices left over after the last whole triangle are ignored");
        }

        int triangles = TriangleAssembly.Count(mode, count);
        accessors.Ask(accessor?.Object ?? primitive, (long)triangles * ((3 * sizeof(int)) + TriangleBytes));
        int[] indices = new int[3 * triangles];
        for (int t = 0; t < triangles; t++)
        {
            (int a, int b, int c) = TriangleAssembly.Corners(mode, t);
            indices[3 * t] = list is null ? a : (int)list[a];
            indices[(3 * t) + 1] = list is null ? b : (int)list[b];
            indices[(3 * t) + 2] = list is null ? c : (int)list[c];
        }

        return indices;
    }

    private uint[] Listed(GltfObject primitive, GltfAccessor accessor, int vertexCount) =>
        accessor.Components == 1 && accessor.Type is (GltfComponentType.UnsignedByte or GltfComponentType.UnsignedShort or GltfComponentType.UnsignedInt)
            ? accessors.Whole(accessor, primitive, "indices", vertexCount, "vertices")
            : throw primitive.Error("indices", $"{accessor.Object.Path} must be a SCALAR of unsigned whole numbers (5121, 5123 or 5125)");
}

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
