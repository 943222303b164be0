using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Import;

/// <summary>The places at which a node shows its mesh over and over (EXT_mesh_gpu_instancing).</summary>
internal sealed class GltfInstances(GltfDocument document, GltfAccessors accessors)
{
    // A description with its matrix.
    private const int BytesPerInstance = 300;

    /// <summary>The places within a node; null where it shows its mesh once.</summary>
    public IReadOnlyList<Transform>? Of(GltfObject node)
    {
        if (node.Extension("EXT_mesh_gpu_instancing") is not { } instancing)
        {
            return null;
        }

        GltfObject attributes = instancing.RequiredChild("attributes");
        float[]? translations = accessors.Floats(attributes, "TRANSLATION", 3);
        float[]? rotations = accessors.Floats(attributes, "ROTATION", 4);
        float[]? scales = accessors.Floats(attributes, "SCALE", 3);
        int[] counts = [.. ((int?[])[translations?.Length / 3, rotations?.Length / 4, scales?.Length / 3]).OfType<int>().Distinct()];
        if (counts.Length != 1)
        {
            throw attributes.Error(counts.Length == 0 ? "instances need a TRANSLATION, a ROTATION or a SCALE" : $"the lists of instances have different lengths: {string.Join(", ", counts)}");
        }

        document.Notes.AddIf(attributes.Node.Members.Any(m => m.Key is not ("TRANSLATION" or "ROTATION" or "SCALE")),
            "attributes of instances besides TRANSLATION, ROTATION and SCALE are ignored");
        accessors.Ask(attributes, (long)counts[0] * BytesPerInstance);
        return [.. Enumerable.Range(0, counts[0]).Select(i => GltfPlace.Of(Part(translations, i, 3, 0), Rotation(Part(rotations, i, 4, 0)), Part(scales, i, 3, 1)))];
    }

    private static double[] Part(float[]? numbers, int index, int count, double otherwise) =>
        [.. Enumerable.Range(count * index, count).Select(i => numbers?[i] ?? otherwise)];

    private static Quaternion64 Rotation(double[] parts)
    {
        Quaternion64 q = new(parts[0], parts[1], parts[2], parts[3]);
        return q.Dot(q) > 0 ? q.Unit() : new(0, 0, 0, 1);
    }
}
