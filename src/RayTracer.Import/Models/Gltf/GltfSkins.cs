using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>The skins of a glTF file (glTF 2.0, section 3.7.3).</summary>
internal sealed class GltfSkins(GltfDocument document, GltfAccessors accessors, GltfNodes nodes)
{
    private const int NumbersOfMatrix = 16;

    /// <summary>The maps of a skin's joints from where a mesh was modelled to the world.</summary>
    /// <param name="index">Which skin: an index that has been checked.</param>
    /// <param name="worlds">Where the nodes are.</param>
    public Transform[] Joints(int index, Transform[] worlds)
    {
        GltfObject skin = document.List("skins")[index];
        IReadOnlyList<int> joints = document.References(skin, "joints", "nodes");
        float[]? inverses = accessors.Floats(skin, "inverseBindMatrices", NumbersOfMatrix);
        if (joints.Count == 0)
        {
            throw skin.Error("joints", "a skin needs at least one joint");
        }

        if (inverses is not null && inverses.Length < NumbersOfMatrix * joints.Count)
        {
            throw skin.Error("inverseBindMatrices", $"it has {inverses.Length / NumbersOfMatrix} matrices for {joints.Count} joints");
        }

        int hidden = joints.ToList().FindIndex(j => !nodes.IsShown(j));
        return hidden < 0
            ? [.. joints.Select((j, i) => inverses is null ? worlds[j] : worlds[j] * GltfPlace.OfColumns(inverses.AsSpan(NumbersOfMatrix * i, NumbersOfMatrix)))]
            : throw skin.Error("joints", $"nodes[{joints[hidden]}] is not in the scene that is shown");
    }
}
