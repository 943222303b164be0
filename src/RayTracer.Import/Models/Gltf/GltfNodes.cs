using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>A glTF file's hierarchy of nodes, and where they are at any time.</summary>
internal sealed class GltfNodes
{
    private readonly GltfDocument _document;
    private readonly List<(int Index, int Parent)> _order = [];
    private readonly GltfPlace?[] _places;

    /// <summary>Walks through the scene that is shown.</summary>
    /// <param name="document">The file.</param>
    /// <exception cref="ModelException">A node is below itself, or below two parents.</exception>
    public GltfNodes(GltfDocument document)
    {
        _document = document;
        IReadOnlyList<GltfObject> nodes = document.List("nodes");
        _places = new GltfPlace?[nodes.Count];
        Stack<(int Index, int Parent)> open = [];
        foreach (int root in Roots().Reverse())
        {
            open.Push((root, -1));
        }

        while (open.TryPop(out (int Index, int Parent) next))
        {
            GltfObject node = nodes[next.Index];
            if (_places[next.Index] is not null)
            {
                throw node.Error("the node is reached twice: it is below itself, or has two parents");
            }

            _places[next.Index] = GltfPlace.Of(node);
            _order.Add(next);
            foreach (int child in document.References(node, "children", "nodes").Reverse())
            {
                open.Push((child, next.Index));
            }
        }
    }

    /// <summary>The numbers of the nodes of the scene that is shown, parents first.</summary>
    public IEnumerable<int> Shown => _order.Select(n => n.Index);

    /// <summary>Returns whether a node is in the scene that is shown.</summary>
    public bool IsShown(int node) => _places[node] is not null;

    /// <summary>The places of the nodes in the world at a time, by their numbers.</summary>
    /// <param name="clip">The animation that is played; null for none.</param>
    /// <param name="time">The time in it, in seconds.</param>
    public Transform[] Worlds(GltfClip? clip, double time)
    {
        Transform[] worlds = new Transform[_places.Length];
        foreach ((int index, int parent) in _order)
        {
            Transform local = _places[index]!.At(index, clip, time);
            worlds[index] = parent < 0 ? local : worlds[parent] * local;
        }

        return worlds;
    }

    /// <summary>The keys by which an animation moves a node, itself or with those that it is below.</summary>
    public IReadOnlyList<GltfSampler> KeysOf(GltfClip clip, int node)
    {
        Dictionary<int, int> parents = _order.ToDictionary(n => n.Index, n => n.Parent);
        List<GltfSampler> keys = [];
        for (; node >= 0; node = parents[node])
        {
            int at = node;
            keys.AddRange(clip.Channels.Where(c => c.Key.Node == at && c.Key.Property != GltfProperty.Weights).Select(c => c.Value));
        }

        return keys;
    }

    private IReadOnlyList<int> Roots()
    {
        if (_document.List("scenes").Count > 0)
        {
            int scene = _document.Reference(_document.Root, "scene", "scenes") ?? 0;
            if (_document.List("scenes").Count > 1)
            {
                _document.Notes.Add($"of {_document.List("scenes").Count} scenes in the file, only scenes[{scene}] is shown");
            }

            return _document.References(_document.List("scenes")[scene], "nodes", "nodes");
        }

        HashSet<int> children = [];
        foreach (GltfObject node in _document.List("nodes"))
        {
            children.UnionWith(_document.References(node, "children", "nodes"));
        }

        int[] roots = [.. Enumerable.Range(0, _document.List("nodes").Count).Where(n => !children.Contains(n))];
        return roots.Length > 0 || children.Count == 0 ? roots : throw _document.Root.Error("nodes", "every node is below another one: there is a cycle");
    }
}

/// <summary>The place of a node within its parent: a matrix, or scale, then rotation, then translation (glTF 2.0, section 3.5.2).</summary>
/// <param name="Matrix">The matrix; null where there is none.</param>
/// <param name="Translation">How far it is moved.</param>
/// <param name="Rotation">How it is turned, of length 1.</param>
/// <param name="Scale">Its size along its axes.</param>
internal sealed record GltfPlace(Transform? Matrix, float[] Translation, Quaternion64 Rotation, float[] Scale)
{
    /// <summary>Reads what a node says.</summary>
    public static GltfPlace Of(GltfObject node)
    {
        float[] t = node.Numbers("translation", 3) ?? [0, 0, 0];
        float[] r = node.Numbers("rotation", 4) ?? [0, 0, 0, 1];
        float[] s = node.Numbers("scale", 3) ?? [1, 1, 1];
        double norm = Math.Sqrt(((double)r[0] * r[0]) + ((double)r[1] * r[1]) + ((double)r[2] * r[2]) + ((double)r[3] * r[3]));
        if (!(norm > 0))
        {
            throw node.Error("rotation", "a quaternion of zeros is no rotation");
        }

        float[]? m = node.Numbers("matrix", 16);
        if (m is not null && (m[3] != 0 || m[7] != 0 || m[11] != 0 || m[15] != 1))
        {
            throw node.Error("matrix", "its last row (elements 4, 8, 12 and 16) must be 0, 0, 0, 1");
        }

        return new(m is null ? null : OfColumns(m), t, new(r[0] / norm, r[1] / norm, r[2] / norm, r[3] / norm), s);
    }

    /// <summary>The map of a matrix that is written column by column.</summary>
    public static Transform OfColumns(ReadOnlySpan<float> m) => new(new(m[0], m[4], m[8], m[12]), new(m[1], m[5], m[9], m[13]), new(m[2], m[6], m[10], m[14]));

    /// <summary>The map of translation, rotation and scale.</summary>
    public static Transform Of(ReadOnlySpan<double> t, Quaternion64 rotation, ReadOnlySpan<double> s) =>
        Transform.Translation(new((float)t[0], (float)t[1], (float)t[2])) * rotation.ToRotation() * Transform.Scaling(new((float)s[0], (float)s[1], (float)s[2]));

    /// <summary>The place at a time: what is not animated is as the node says, but for a matrix, which then counts no more.</summary>
    /// <param name="node">The node's number.</param>
    /// <param name="clip">The animation; null for none.</param>
    /// <param name="time">The time in it.</param>
    public Transform At(int node, GltfClip? clip, double time)
    {
        GltfSampler? translation = Channel(clip, node, GltfProperty.Translation);
        GltfSampler? rotation = Channel(clip, node, GltfProperty.Rotation);
        GltfSampler? scale = Channel(clip, node, GltfProperty.Scale);
        return Matrix is { } matrix && translation is null && rotation is null && scale is null
            ? matrix
            : Of(translation?.At(time) ?? Doubles(Translation), rotation?.Rotation(time) ?? Rotation, scale?.At(time) ?? Doubles(Scale));
    }

    private static GltfSampler? Channel(GltfClip? clip, int node, GltfProperty property) => clip?.Channels.GetValueOrDefault((node, property));

    private static double[] Doubles(float[] numbers) => [.. numbers.Select(n => (double)n)];
}
