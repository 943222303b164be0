using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>The triangles of an OBJ file while it is read; then they are parted by the names of groups, and into flat and smooth ones.</summary>
internal sealed class ObjMesh
{
    /// <summary>Instead of a material: none was named.</summary>
    public const int NoMaterial = -1;

    private readonly Dictionary<(string Name, bool IsFlat), int> _parts = [];
    private readonly List<(int FirstIndex, int Part, int Material)> _runs = [];
    private readonly List<Rgb> _colors = [];
    private string? _name;
    private int _flatPart;
    private int _smoothPart;

    /// <summary>The vertices.</summary>
    public List<Vector3> Positions { get; } = [];

    /// <summary>The uv that faces name.</summary>
    public List<Vector2> Uv { get; } = [];

    /// <summary>The normals that faces name.</summary>
    public List<Vector3> Normals { get; } = [];

    /// <summary>The corners of the triangles.</summary>
    public ObjCorners Corners { get; } = new();

    /// <summary>Three corners a triangle.</summary>
    public List<int> Indices { get; } = [];

    /// <summary>For each triangle, the number of the first of the polygon that it is a part of.</summary>
    public List<int> Faces { get; } = [];

    /// <summary>Number of triangles.</summary>
    public int TriangleCount => Indices.Count / 3;

    /// <summary>Adds the colour of the last vertex; null for none.</summary>
    public void AddColor(Rgb? color)
    {
        if (color is null && _colors.Count == 0)
        {
            return;
        }

        while (_colors.Count < Positions.Count - 1)
        {
            _colors.Add(Rgb.White);
        }

        _colors.Add(color ?? Rgb.White);
    }

    /// <summary>Says what the next triangles belong to.</summary>
    /// <param name="name">Their group's name.</param>
    /// <param name="material">Their material.</param>
    /// <param name="isFlat">True where they have no normals.</param>
    public void Begin(string name, int material, bool isFlat)
    {
        if (!ReferenceEquals(name, _name))
        {
            (_name, _flatPart, _smoothPart) = (name, -1, -1);
        }

        ref int part = ref isFlat ? ref _flatPart : ref _smoothPart;
        if (part < 0 && !_parts.TryGetValue((name, isFlat), out part))
        {
            part = _parts.Count;
            _parts.Add((name, isFlat), part);
        }

        if (_runs.Count == 0 || _runs[^1].Part != part || _runs[^1].Material != material)
        {
            _runs.Add((Indices.Count, part, material));
        }
    }

    /// <summary>Makes a mesh of each part.</summary>
    /// <param name="materials">The materials.</param>
    /// <param name="mostParts">Of more parts, only flat and smooth ones are distinguished.</param>
    public IReadOnlyList<ShapeDescription> ToShapes(IReadOnlyList<MaterialDescription> materials, int mostParts)
    {
        (string Name, bool IsFlat)[] parts = [.. _parts.OrderBy(p => p.Value).Select(p => p.Key)];
        if (parts.Length > mostParts)
        {
            Span<(int FirstIndex, int Part, int Material)> runs = CollectionsMarshal.AsSpan(_runs);
            foreach (ref (int FirstIndex, int Part, int Material) run in runs)
            {
                run.Part = parts[run.Part].IsFlat ? 0 : 1;
            }

            parts = [("", true), ("", false)];
        }

        var runsOfPart = Enumerable.Range(0, _runs.Count).ToLookup(r => _runs[r].Part);
        var owner = new int[Corners.Count];
        var place = new int[Corners.Count];
        List<ShapeDescription> shapes = [];
        for (int part = 0; part < parts.Length; part++)
        {
            if (runsOfPart[part].Any())
            {
                shapes.Add(ToShape(parts[part].Name, parts[part].IsFlat, [.. runsOfPart[part]], materials, owner, place, part + 1));
            }
        }

        return shapes;
    }

    private MeshDescription ToShape(string name, bool isFlat, int[] runs, IReadOnlyList<MaterialDescription> materials, int[] owner, int[] place, int mark)
    {
        var indices = new int[runs.Sum(r => End(r) - _runs[r].FirstIndex)];
        int[] used = [.. runs.Select(r => _runs[r].Material).Distinct()];
        int[]? materialOfTriangle = used.Length > 1 ? new int[indices.Length / 3] : null;
        int[] faces = [.. runs.SelectMany(r => Faces[(_runs[r].FirstIndex / 3)..(End(r) / 3)])];
        List<int> corners = [];
        int at = 0;
        foreach (int run in runs)
        {
            materialOfTriangle?.AsSpan(at / 3, (End(run) - _runs[run].FirstIndex) / 3).Fill(Array.IndexOf(used, _runs[run].Material));
            for (int i = _runs[run].FirstIndex; i < End(run); i++)
            {
                int corner = Indices[i];
                if (owner[corner] != mark)
                {
                    owner[corner] = mark;
                    place[corner] = corners.Count;
                    corners.Add(corner);
                }

                indices[at++] = place[corner];
            }
        }

        bool hasPolygons = faces.Zip(faces.Skip(1)).Any(f => f.First == f.Second);
        MeshData data = ToData(corners, indices, isFlat, materialOfTriangle, hasPolygons ? faces : null);
        MaterialDescription none = data.Colors is null ? ShapeDescription.DefaultMaterial : MeshModel.White;
        MaterialDescription[] all = [.. used.Select(m => m == NoMaterial ? none : materials[m])];
        return new MeshDescription { Name = name, Data = data, Material = all[0], Materials = all.Length > 1 ? all : [] };
    }

    private int End(int run) => run + 1 < _runs.Count ? _runs[run + 1].FirstIndex : Indices.Count;

    private MeshData ToData(List<int> corners, int[] indices, bool isFlat, int[]? materialOfTriangle, int[]? faces)
    {
        ReadOnlySpan<Vector3> normals = CollectionsMarshal.AsSpan(Normals);
        var positions = new Vector3[corners.Count];
        Vector3[]? cornerNormals = isFlat ? null : new Vector3[corners.Count];
        Vector2[]? uv = corners.Exists(c => Corners.UvOf(c) >= 0) ? new Vector2[corners.Count] : null;
        Rgb[]? colors = _colors.Count > 0 ? new Rgb[corners.Count] : null;
        for (int i = 0; i < positions.Length; i++)
        {
            int corner = corners[i];
            int position = Corners.PositionOf(corner);
            positions[i] = Positions[position];
            if (cornerNormals is not null)
            {
                cornerNormals[i] = Corners.NormalOf(corner, normals);
            }

            if (uv is not null && Corners.UvOf(corner) >= 0)
            {
                uv[i] = Uv[Corners.UvOf(corner)];
            }

            if (colors is not null)
            {
                colors[i] = position < _colors.Count ? _colors[position] : Rgb.White;
            }
        }

        return new MeshData(positions, indices) { Normals = cornerNormals, Uv = uv, Colors = colors, MaterialOfTriangle = materialOfTriangle, FaceOfTriangle = faces };
    }
}
