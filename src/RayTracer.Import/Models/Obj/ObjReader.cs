using System.Buffers.Text;
using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Description;
using RayTracer.Numerics;
using static RayTracer.Import.ModelCheck;

namespace RayTracer.Import;

/// <summary>
/// Reads OBJ files (Wavefront's <i>Advanced Visualizer Manual</i>, appendix B) and the MTL files that they name: polygons with uv and normals,
/// groups, smoothing groups, materials; also colours of vertices behind their positions, as MeshLab writes them. Curves, surfaces, lines
/// and points are left out.
/// </summary>
internal sealed class ObjReader
{
    // A mesh for each of more names than this would be of no use, and take much memory.
    private const int MostParts = 1000;

    // Statements that are not read, and what notes say of them: nothing where they mean nothing here.
    private static readonly (string What, string[] Words)[] s_ignored =
    [
        ("lines and points", ["l", "p"]),
        ("curves and curved surfaces",
            ["vp", "cstype", "deg", "bmat", "step", "curv", "curv2", "surf", "parm", "trim", "hole", "scrv", "sp", "end", "con"]),
        ("other files that it includes", ["call", "csh"]),
        ("", ["mg", "lod", "bevel", "c_interp", "d_interp", "ctech", "stech", "shadow_obj", "trace_obj", "usemap", "maplib"]),
    ];

    private readonly ObjMesh _mesh = new();
    private readonly MtlLibrary _library;
    private readonly List<(int Position, int Uv, int Normal)> _face = [];
    private readonly List<Vector3> _facePositions = [];
    private readonly List<int> _faceTriangles = [];
    private readonly PolygonCutter _cutter = new();
    private readonly List<string> _notes = [];
    private readonly SortedSet<string> _leftOut = new(StringComparer.Ordinal);
    private string? _stranger;
    private int _group;
    private int? _tooSmall; // the first line
    private string _name = "";
    private int _material = ObjMesh.NoMaterial;

    private ObjReader(string folder) => _library = new MtlLibrary(folder);

    /// <summary>Reads a file.</summary>
    /// <exception cref="ModelException">Something is wrong with it, or with a material file.</exception>
    public static ImportedModel Read(string path) => Parse(ModelBytes.Read(path), Path.GetDirectoryName(Path.GetFullPath(path)) ?? "", Path.GetFileNameWithoutExtension(path));

    /// <summary>Reads the content of a file.</summary>
    /// <param name="file">The whole file.</param>
    /// <param name="folder">The folder in which the files that it names are looked for.</param>
    /// <param name="name">The name of a mesh that the file gives none.</param>
    /// <exception cref="ModelException">Something is wrong with it, or with a material file.</exception>
    public static ImportedModel Parse(ReadOnlySpan<byte> file, string folder, string name)
    {
        var reader = new ObjReader(folder) { _name = name };
        var text = new ModelText(file, hasContinuations: true) { AcceptsOddNumbers = true };
        while (!text.IsAtEnd)
        {
            reader.ReadStatement(ref text);
            text.SkipLine();
        }

        Require(reader._mesh.TriangleCount != 0, $"there are no faces in it ({reader._mesh.Positions.Count} vertices)");

        reader.NoteWhatIsLeft(text);
        IReadOnlyList<MaterialDescription> materials = reader._library.Materials(reader._notes);
        return new ImportedModel(new SceneDescription { Shapes = reader._mesh.ToShapes(materials, MostParts) }, reader._notes);
    }

    private void ReadStatement(ref ModelText text)
    {
        ReadOnlySpan<byte> keyword = text.Word();
        switch (keyword)
        {
            case [(byte)'v']:
                ReadVertex(ref text);
                break;
            case [(byte)'v', (byte)'t']:
                _mesh.Uv.Add(new Vector2(text.Number(), text.IsAtLineEnd() ? 0 : text.Number()));
                break;
            case [(byte)'v', (byte)'n']:
                _mesh.Normals.Add(new Vector3(text.Number(), text.Number(), text.Number()));
                break;
            case [(byte)'f'] or [(byte)'f', (byte)'o']:
                ReadFace(ref text);
                break;
            case [(byte)'s']:
                ReadSmoothing(ref text);
                break;
            case [(byte)'o'] or [(byte)'g']:
                _name = text.IsAtLineEnd() ? "" : text.RestOfLine();
                break;
            case []:
                break;
            default:
                ReadRareStatement(ModelText.Decode(keyword[..Math.Min(keyword.Length, 100)]), ref text);
                break;
        }
    }

    private void ReadRareStatement(string keyword, ref ModelText text)
    {
        if (keyword == "usemtl")
        {
            _material = text.IsAtLineEnd() ? ObjMesh.NoMaterial : _library.Use(text.RestOfLine());
        }
        else if (keyword == "mtllib")
        {
            _library.Read(text.IsAtLineEnd() ? "" : text.RestOfLine());
        }
        else if (Array.Find(s_ignored, i => i.Words.Contains(keyword)).What is { } what)
        {
            _ = what.Length == 0 || _leftOut.Add(what);
        }
        else
        {
            _stranger ??= $"{Quotation.Of(keyword)} in line {text.Line} and other lines that are not OBJ statements";
        }
    }

    // x y z, perhaps w; perhaps red, green and blue.
    private void ReadVertex(ref ModelText text)
    {
        _mesh.Positions.Add(new Vector3(text.Number(), text.Number(), text.Number()));
        if (text.IsAtLineEnd())
        {
            _mesh.AddColor(null);
            return;
        }

        Span<float> more = stackalloc float[4];
        int count = 0;
        while (count < more.Length && !text.IsAtLineEnd())
        {
            more[count++] = text.Number();
        }

        more = more[(count == 4 ? 1 : 0)..];
        _mesh.AddColor(count >= 3 ? new Rgb(VertexColor.Decode(more[0]), VertexColor.Decode(more[1]), VertexColor.Decode(more[2])) : null);
    }

    // A number, or "off".
    private void ReadSmoothing(ref ModelText text)
    {
        ReadOnlySpan<byte> word = text.Word();
        bool isNumber = Utf8Parser.TryParse(word, out int group, out int length) && length == word.Length;
        _group = isNumber && group > 0 ? group : word.SequenceEqual("on"u8) ? 1 : 0;
    }

    private void ReadFace(ref ModelText text)
    {
        _face.Clear();
        bool hasNormals = true;
        while (!text.IsAtLineEnd())
        {
            (int Position, int Uv, int Normal) corner = ReadCorner(ref text);
            hasNormals &= corner.Normal >= 0;
            _face.Add(corner);
        }

        if (_face.Count < 3)
        {
            _tooSmall ??= text.Line;
            return;
        }

        bool isSmooth = !hasNormals && _group > 0;
        _mesh.Begin(_name, _material, isFlat: !hasNormals && !isSmooth);
        int first = _mesh.TriangleCount;
        if (_face.Count == 3)
        {
            AddTriangle(0, 1, 2, first, hasNormals, isSmooth);
            return;
        }

        _facePositions.Clear();
        foreach ((int position, _, _) in _face)
        {
            _facePositions.Add(_mesh.Positions[position]);
        }

        _cutter.Cut(CollectionsMarshal.AsSpan(_facePositions), _faceTriangles);
        for (int i = 0; i < _faceTriangles.Count; i += 3)
        {
            AddTriangle(_faceTriangles[i], _faceTriangles[i + 1], _faceTriangles[i + 2], first, hasNormals, isSmooth);
        }
    }

    private void AddTriangle(int a, int b, int c, int face, bool hasNormals, bool isSmooth)
    {
        ObjCorners corners = _mesh.Corners;
        Span<int> triangle = [Corner(a, hasNormals, isSmooth), Corner(b, hasNormals, isSmooth), Corner(c, hasNormals, isSmooth)];
        _mesh.Indices.AddRange(triangle);
        _mesh.Faces.Add(face);
        if (isSmooth)
        {
            Vector3 origin = _mesh.Positions[_face[a].Position];
            Vector3 normal = (_mesh.Positions[_face[b].Position] - origin).Cross(_mesh.Positions[_face[c].Position] - origin);
            foreach (int corner in triangle)
            {
                corners.AddNormal(corner, normal);
            }
        }
    }

    private int Corner(int place, bool hasNormals, bool isSmooth)
    {
        (int position, int uv, int normal) = _face[place];
        return _mesh.Corners.Find(position, uv, hasNormals ? normal : isSmooth ? _mesh.Corners.Smooth(position, _group) : ObjCorners.None);
    }

    // "position", "position/uv", "position//normal" or "position/uv/normal".
    private (int Position, int Uv, int Normal) ReadCorner(ref ModelText text)
    {
        int begin = text.Position;
        ReadOnlySpan<byte> word = text.Word();
        int uv = ObjCorners.None;
        int normal = ObjCorners.None;
        int at = 0;
        int position = Index(text, begin, word, ref at, _mesh.Positions.Count, "vertex");
        if (at < word.Length && word[at++] == '/' && at < word.Length && word[at] != '/')
        {
            uv = Index(text, begin, word, ref at, _mesh.Uv.Count, "uv (vt)");
        }

        if (at < word.Length && word[at] == '/' && ++at < word.Length)
        {
            normal = Index(text, begin, word, ref at, _mesh.Normals.Count, "normal (vn)");
        }

        return at == word.Length ? (position, uv, normal) : throw NoCorner(text, begin, word);
    }

    // Counted from 1 at the file's begin, or back from −1, the last before this face.
    private static int Index(in ModelText text, int begin, ReadOnlySpan<byte> word, ref int at, int count, string what)
    {
        bool isNegative = at < word.Length && word[at] == '-';
        int start = at + (isNegative ? 1 : 0);
        long number = 0;
        for (at = start; at < word.Length && (uint)(word[at] - '0') <= 9 && number <= int.MaxValue; at++)
        {
            number = (number * 10) + word[at] - '0';
        }

        if (at == start)
        {
            throw NoCorner(text, begin, word);
        }

        long index = isNegative ? count - number : number - 1;
        return number > 0 && index >= 0 && index < count ? (int)index
            : throw text.ErrorAt(begin, $"there is no {what} {(isNegative ? "-" : "")}{number}: {count} come before this face, counted from 1, or back from -1");
    }

    private static ModelException NoCorner(in ModelText text, int begin, ReadOnlySpan<byte> word) =>
        text.ErrorAt(begin, $"expected a corner such as 1, 1/2, 1//3 or 1/2/3 instead of {Quotation.Of(ModelText.Decode(word[..Math.Min(word.Length, 200)]))}");

    private void NoteWhatIsLeft(in ModelText text)
    {
        if (text.OddNumber >= 0)
        {
            _notes.Add($"line {text.ErrorAt(text.OddNumber, "").Line}: a number is followed by stray characters, which are ignored");
        }

        if (_tooSmall is not null)
        {
            _notes.Add($"line {_tooSmall}: faces with fewer than three corners are ignored");
        }

        if (_cutter.Unresolved > 0)
        {
            _notes.Add($"{_cutter.Unresolved} self-intersecting polygons are not triangulated properly");
        }

        if (_stranger is not null)
        {
            _leftOut.Add(_stranger);
        }

        if (_leftOut.Count > 0)
        {
            _notes.Add($"ignored: {string.Join("; ", _leftOut)}");
        }
    }
}
