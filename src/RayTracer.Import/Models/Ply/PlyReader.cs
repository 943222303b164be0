using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Description;
using RayTracer.Imaging;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>
/// Reads PLY files (Turk 1994), text and binary of both byte orders: vertices with positions, normals, uv and colours under their
/// usual names; faces, or strips of triangles. Everything else is skipped.
/// </summary>
internal static class PlyReader
{
    // Which names stand for which number of a vertex.
    private static readonly (string[] Names, int Slot)[] s_slots =
    [
        (["x"], 0), (["y"], 1), (["z"], 2), (["nx", "normal_x"], 3), (["ny", "normal_y"], 4), (["nz", "normal_z"], 5),
        (["u", "s", "texture_u", "texture_s", "tex_u"], 6), (["v", "t", "texture_v", "texture_t", "tex_v"], 7),
        (["red", "r", "diffuse_red", "color_0"], 8), (["green", "g", "diffuse_green", "color_1"], 9), (["blue", "b", "diffuse_blue", "color_2"], 10),
    ];

    private const int Slots = 11;

    /// <summary>Reads a file.</summary>
    /// <exception cref="ModelException">Something is wrong with it.</exception>
    public static ImportedModel Read(string path)
    {
        List<string> notes = [];
        MeshData mesh = Parse(ModelBytes.Read(path), notes);
        return MeshModel.Of(path, mesh, notes);
    }

    /// <summary>Reads the content of a file.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="notes">Receives what is not represented.</param>
    /// <exception cref="ModelException">Something is wrong with it.</exception>
    public static MeshData Parse(ReadOnlySpan<byte> file, List<string> notes)
    {
        var text = new ModelText(file);
        PlyHeader header = PlyHeader.Parse(ref text);
        notes.AddRange(header.Notes.Take(1));
        var values = new PlyValues(file, header.Format, text);
        Vertices? vertices = null;
        List<int> indices = [];
        List<int> faces = [];
        List<MeshAttribute> attributes = [];
        foreach (PlyElement element in header.Elements)
        {
            switch (element.Name)
            {
                case "vertex" when vertices is null:
                    vertices = ReadVertices(ref values, element, attributes);
                    break;
                case "face" or "faces" or "tristrips":
                    if (vertices is null)
                    {
                        throw new ModelException("faces come before the vertices that they refer to", element.Line);
                    }

                    ReadFaces(ref values, element, vertices.Positions, indices, faces, attributes, notes);
                    break;
                default:
                    Skip(ref values, element);
                    break;
            }
        }

        return vertices is null
            ? throw new ModelException("there are no vertices in it")
            : new MeshData(vertices.Positions, [.. indices])
            {
                Normals = vertices.Normals,
                Uv = vertices.Uv,
                Colors = vertices.Colors,
                Attributes = attributes,
                FaceOfTriangle = faces.Where((face, triangle) => face != triangle).Any() ? [.. faces] : null,
            };
    }

    // Mitsuba's own files hold linear light, as numbers with a point and by these names.
    private static (PlyType Type, bool IsLinear) Encoding(PlyProperty red) =>
        (red.Type, red.Name is "color_0" or "r" && red.Type is (PlyType.Float32 or PlyType.Float64));

    private sealed record Vertices(Vector3[] Positions, Vector3[]? Normals, Vector2[]? Uv, Rgb[]? Colors);

    private static void Skip(ref PlyValues values, PlyElement element)
    {
        int count = values.CheckCount(element);
        for (int i = 0; i < count; i++)
        {
            foreach (PlyProperty property in element.Properties)
            {
                values.Skip(property);
            }
        }
    }

    private static Vertices ReadVertices(ref PlyValues values, PlyElement element, List<MeshAttribute> attributes)
    {
        PlyAttributes more = new("vertex", element, p => SlotOf(p) >= 0);
        int[] slots = [.. element.Properties.Select(SlotOf)];
        bool Has(params int[] all) => all.All(slots.Contains);
        if (!Has(0, 1, 2))
        {
            throw new ModelException("the vertices have no x, y and z", element.Line);
        }

        int count = values.CheckCount(element);
        var vertices = new Vertices(new Vector3[count], Has(3, 4, 5) ? new Vector3[count] : null, Has(6, 7) ? new Vector2[count] : null, Has(8, 9, 10) ? new Rgb[count] : null);
        PlyProperty[] properties = [.. element.Properties];
        (PlyType colorType, bool isLinear) = vertices.Colors is null ? default : Encoding(properties[Array.IndexOf(slots, 8)]);
        Span<float> v = stackalloc float[Slots];
        for (int i = 0; i < count; i++)
        {
            for (int p = 0; p < properties.Length; p++)
            {
                if (slots[p] >= 0)
                {
                    v[slots[p]] = (float)values.Number(properties[p].Type);
                }
                else
                {
                    more.Read(ref values, element, p);
                }
            }

            more.Add(1);
            vertices.Positions[i] = new Vector3(v[0], v[1], v[2]);
            Set(vertices.Normals, i, new Vector3(v[3], v[4], v[5]));
            Set(vertices.Uv, i, new Vector2(v[6], v[7]));
            if (vertices.Colors is { } colors)
            {
                colors[i] = isLinear ? new Rgb(v[8], v[9], v[10]) : new Rgb(VertexColor.Decode(v[8], colorType), VertexColor.Decode(v[9], colorType), VertexColor.Decode(v[10], colorType));
            }
        }

        attributes.AddRange(more.All);
        return vertices;
    }

    private static void Set<T>(T[]? array, int index, T value)
    {
        if (array is not null)
        {
            array[index] = value;
        }
    }

    private static int SlotOf(PlyProperty property) => property.CountType is null
        ? Array.Find(s_slots, s => s.Names.Contains(property.Name)) is { Names: not null } found ? found.Slot : -1
        : -1;

    private static void ReadFaces(
        ref PlyValues values, PlyElement element, Vector3[] positions, List<int> indices, List<int> faces, List<MeshAttribute> attributes, List<string> notes)
    {
        int place = element.Properties.FindIndex(p => p.CountType is not null && p.Name is "vertex_indices" or "vertex_index");
        if (place < 0)
        {
            throw new ModelException("the faces have no list vertex_indices", element.Line);
        }

        bool isStrip = element.Name == "tristrips";
        int count = values.CheckCount(element);
        indices.EnsureCapacity(isStrip ? 0 : 3 * count);
        var cutter = new PolygonCutter();
        var face = new Face();
        PlyProperty[] properties = [.. element.Properties];
        PlyAttributes more = new("face", element, _ => isStrip);
        for (int i = 0; i < count; i++)
        {
            int before = indices.Count;
            for (int p = 0; p < properties.Length; p++)
            {
                if (p != place)
                {
                    more.Read(ref values, element, p);
                    continue;
                }

                ReadOnlySpan<int> corners = face.Read(ref values, properties[p]);
                if (isStrip)
                {
                    AddStrips(corners, indices);
                }
                else if (corners.Length == 3)
                {
                    indices.Add(corners[0]);
                    indices.Add(corners[1]);
                    indices.Add(corners[2]);
                }
                else
                {
                    face.AddPolygon(cutter, positions, indices);
                }
            }

            more.Add((indices.Count - before) / 3);

            // A polygon has the number of its first triangle.
            for (int triangle = before / 3; triangle < indices.Count / 3; triangle++)
            {
                faces.Add(isStrip ? triangle : before / 3);
            }
        }

        attributes.AddRange(more.All);
        NoteWhatIsLeft(element, face, cutter, notes);
    }

    private static void NoteWhatIsLeft(PlyElement element, Face face, PolygonCutter cutter, List<string> notes)
    {
        if (face.TooSmall > 0)
        {
            notes.Add($"{face.TooSmall} faces with fewer than three corners are ignored");
        }

        if (cutter.Unresolved > 0)
        {
            notes.Add($"{cutter.Unresolved} self-intersecting polygons are not triangulated properly");
        }

        if (element.Properties.Exists(p => p.Name is "texcoord" or "red" or "diffuse_red"))
        {
            notes.Add("uv and colours of faces are ignored: only those of vertices are read");
        }
    }

    // Every corner but the first two ends a triangle, whose order around alternates; −1 starts over.
    private static void AddStrips(ReadOnlySpan<int> corners, List<int> indices)
    {
        int begin = 0;
        for (int i = 0; i < corners.Length; i++)
        {
            if (corners[i] < 0)
            {
                begin = i + 1;
            }
            else if (i >= begin + 2)
            {
                bool isOdd = ((i - begin) & 1) != 0;
                indices.AddRange([corners[i - 2], corners[isOdd ? i : i - 1], corners[isOdd ? i - 1 : i]]);
            }
        }
    }

    // The corners of one face, and memory for them that serves all faces.
    private sealed class Face
    {
        private readonly List<int> _corners = [];
        private readonly List<Vector3> _positions = [];
        private readonly List<int> _triangles = [];

        public int TooSmall { get; private set; }

        public ReadOnlySpan<int> Read(ref PlyValues values, PlyProperty list)
        {
            int count = values.ListLength(list);
            CollectionsMarshal.SetCount(_corners, count);
            Span<int> corners = CollectionsMarshal.AsSpan(_corners);
            for (int i = 0; i < corners.Length; i++)
            {
                double index = values.Number(list.Type);
                corners[i] = index is >= -1 and < int.MaxValue ? (int)index : int.MaxValue;
            }

            return corners;
        }

        public void AddPolygon(PolygonCutter cutter, Vector3[] positions, List<int> indices)
        {
            TooSmall += _corners.Count < 3 ? 1 : 0;
            _positions.Clear();
            foreach (int corner in _corners)
            {
                // Corners that are not there are the mesh doctor's matter.
                _positions.Add((uint)corner < (uint)positions.Length ? positions[corner] : default);
            }

            cutter.Cut(CollectionsMarshal.AsSpan(_positions), _triangles);
            foreach (int corner in _triangles)
            {
                indices.Add(_corners[corner]);
            }
        }
    }
}
