namespace RayTracer.Shapes;

/// <summary>The edges of a <see cref="PolygonMesh"/>, and what lies around its places.</summary>
internal sealed class MeshTopology
{
    private readonly List<(int From, int To)> _ends = [];
    private readonly List<(int First, int Second, int Count)> _faces = [];
    private readonly List<bool> _isSharp = [];

    private MeshTopology(int corners) => EdgeOf = new int[corners];

    /// <summary>For each corner of each face, the edge from it to the next one.</summary>
    public int[] EdgeOf { get; }

    /// <summary>The number of edges.</summary>
    public int EdgeCount => _ends.Count;

    /// <summary>The edges of a mesh.</summary>
    public static MeshTopology Of(PolygonMesh mesh)
    {
        MeshTopology topology = new(mesh.Corners.Length);
        Dictionary<(int, int), int> known = [];
        for (int face = 0; face < mesh.FaceCount; face++)
        {
            for (int corner = mesh.Starts[face]; corner < mesh.Starts[face + 1]; corner++)
            {
                topology.Add(known, face, corner, mesh.Corners[corner], mesh.Corners[mesh.Next(face, corner)], mesh.Creases[corner]);
            }
        }

        for (int edge = 0; edge < topology.EdgeCount; edge++)
        {
            topology._isSharp[edge] |= topology._faces[edge].Count != 2;
        }

        return topology;
    }

    /// <summary>The two places at the ends of an edge.</summary>
    public (int From, int To) Ends(int edge) => _ends[edge];

    /// <summary>The two faces of an edge that is not sharp.</summary>
    public (int First, int Second) Faces(int edge) => (_faces[edge].First, _faces[edge].Second);

    /// <summary>True for a crease, a border, and where more than two faces meet.</summary>
    public bool IsSharp(int edge) => _isSharp[edge];

    /// <summary>The other face of an edge; −1 where there is none, or several.</summary>
    public int OppositeFace(int edge, int face) => _faces[edge] switch
    {
        (var first, var second, 2) => first == face ? second : first,
        _ => -1,
    };

    private void Add(Dictionary<(int, int), int> known, int face, int corner, int from, int to, bool isCrease)
    {
        (int, int) key = from < to ? (from, to) : (to, from);
        if (!known.TryGetValue(key, out int edge))
        {
            edge = _ends.Count;
            known.Add(key, edge);
            _ends.Add((from, to));
            _faces.Add((face, -1, 1));
            _isSharp.Add(false);
        }
        else
        {
            (int first, _, int count) = _faces[edge];

            // Two faces that go along it in the same direction do not lie side by side.
            _faces[edge] = (first, face, _ends[edge] == (from, to) ? 3 : count + 1);
        }

        _isSharp[edge] |= isCrease;
        EdgeOf[corner] = edge;
    }
}
