using RayTracer.Acceleration;
using RayTracer.Materials;

namespace RayTracer.Rendering;

/// <summary>
/// The shapes of one kind that share one material: hits on them are shaded together, with one call for a packet of lanes.
/// </summary>
/// <param name="material">The material.</param>
/// <param name="batch">The batch that the shapes belong to.</param>
/// <param name="onlyIndex">Index in the batch of the group's only shape; −1 if it has several.</param>
internal sealed class ShadingGroup(Material material, ShapeBatch batch, int onlyIndex)
{
    public Material Material => material;

    public ShapeBatch Batch => batch;

    public int OnlyIndex => onlyIndex;

    // The material's constant answers, asked once.
    public bool IsLit { get; } = material.IsLit;

    public bool Emits { get; } = material.Emits;

    public bool UsesUv { get; } = material.UsesUv;

    /// <summary>Makes the groups of a scene, and the table that names the group of each primitive.</summary>
    public static ShadingGroup[] Create(Scene scene, out int[] groupOf)
    {
        List<ShadingGroup> groups = [];
        groupOf = new int[scene.Shapes.Count + 1];
        foreach (ShapeBatch batch in scene.Batches)
        {
            foreach (IGrouping<Material, int> group in Enumerable.Range(batch.FirstPrimitive, batch.Count).GroupBy(p => scene.Shapes[p].Material))
            {
                int[] primitives = [.. group];
                foreach (int primitive in primitives)
                {
                    groupOf[primitive] = groups.Count;
                }

                groups.Add(new(group.Key, batch, primitives.Length == 1 ? primitives[0] - batch.FirstPrimitive : -1));
            }
        }

        // Rays that hit nothing come after all groups.
        groupOf[^1] = groups.Count;
        return [.. groups];
    }
}
