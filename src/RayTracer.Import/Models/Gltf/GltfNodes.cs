using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>Walks through a glTF file's hierarchy of nodes.</summary>
internal sealed class GltfNodes(GltfDocument document)
{
    /// <summary>The nodes of the scene that is shown, parents first, each with its place in the world.</summary>
    /// <exception cref="ModelException">A node is below itself, or below two parents.</exception>
    public IEnumerable<(GltfObject Node, Transform World)> Walk()
    {
        IReadOnlyList<GltfObject> nodes = document.List("nodes");
        bool[] seen = new bool[nodes.Count];
        Stack<(int Index, Transform Parent)> open = [];
        foreach (int root in Roots().Reverse())
        {
            open.Push((root, Transform.Identity));
        }

        while (open.TryPop(out (int Index, Transform Parent) next))
        {
            GltfObject node = nodes[next.Index];
            if (seen[next.Index])
            {
                throw node.Error("the node is reached twice: it is below itself, or has two parents");
            }

            seen[next.Index] = true;
            Transform world = next.Parent * Local(node);
            yield return (node, world);
            foreach (int child in document.References(node, "children", "nodes").Reverse())
            {
                open.Push((child, world));
            }
        }
    }

    private IReadOnlyList<int> Roots()
    {
        if (document.List("scenes").Count > 0)
        {
            int scene = document.Reference(document.Root, "scene", "scenes") ?? 0;
            if (document.List("scenes").Count > 1)
            {
                document.Notes.Add($"of {document.List("scenes").Count} scenes in the file, only scenes[{scene}] is shown");
            }

            return document.References(document.List("scenes")[scene], "nodes", "nodes");
        }

        HashSet<int> children = [];
        foreach (GltfObject node in document.List("nodes"))
        {
            children.UnionWith(document.References(node, "children", "nodes"));
        }

        int[] roots = [.. Enumerable.Range(0, document.List("nodes").Count).Where(n => !children.Contains(n))];
        return roots.Length > 0 || children.Count == 0 ? roots : throw document.Root.Error("nodes", "every node is below another one: there is a cycle");
    }

    private static Transform Local(GltfObject node)
    {
        if (node.Numbers("matrix", 16) is { } m)
        {
            return m[3] == 0 && m[7] == 0 && m[11] == 0 && m[15] == 1
                ? new(new(m[0], m[4], m[8], m[12]), new(m[1], m[5], m[9], m[13]), new(m[2], m[6], m[10], m[14]))
                : throw node.Error("matrix", "its last row (elements 4, 8, 12 and 16) must be 0, 0, 0, 1");
        }

        float[] t = node.Numbers("translation", 3) ?? [0, 0, 0];
        float[] r = node.Numbers("rotation", 4) ?? [0, 0, 0, 1];
        float[] s = node.Numbers("scale", 3) ?? [1, 1, 1];
        double norm = Math.Sqrt(((double)r[0] * r[0]) + ((double)r[1] * r[1]) + ((double)r[2] * r[2]) + ((double)r[3] * r[3]));
        return norm > 0
            ? Transform.Translation(new(t[0], t[1], t[2])) * Rotation(r[0] / norm, r[1] / norm, r[2] / norm, r[3] / norm) * Transform.Scaling(new(s[0], s[1], s[2]))
            : throw node.Error("rotation", "a quaternion of zeros is no rotation");
    }

    // The rotation of a unit quaternion.
    private static Transform Rotation(double x, double y, double z, double w) => new(
        new(1 - (2 * ((y * y) + (z * z))), 2 * ((x * y) - (z * w)), 2 * ((x * z) + (y * w)), 0),
        new(2 * ((x * y) + (z * w)), 1 - (2 * ((x * x) + (z * z))), 2 * ((y * z) - (x * w)), 0),
        new(2 * ((x * z) - (y * w)), 2 * ((y * z) + (x * w)), 1 - (2 * ((x * x) + (y * y))), 0));
}
