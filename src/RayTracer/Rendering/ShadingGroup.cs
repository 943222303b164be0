using RayTracer.Acceleration;
using RayTracer.Materials;

namespace RayTracer.Rendering;

/// <summary>
/// The shapes of one kind that share one material: hits on them are shaded together, with one call for a packet of lanes.
/// </summary>
/// <param name="material">The material.</param>
/// <param name="batch">The batch that the shapes belong to.</param>
/// <param name="onlyIndex">Index in the batch of the group's only shape; −1 if it has several.</param>
/// <param name="isInstanced">Whether the shapes stand in a space that instances show.</param>
internal sealed class ShadingGroup(Material material, SurfaceTable batch, int onlyIndex, bool isInstanced)
{
    public Material Material => material;

    public SurfaceTable Batch => batch;

    public bool IsInstanced => isInstanced;

    public bool HasShadingNormals { get; } = batch.HasShadingNormals;

    /// <summary>Whether light is scattered with other normals than the surface's own, so that it could leak through it.</summary>
    public bool MayLeak { get; } = batch.HasShadingNormals || material.TurnsNormal;

    public bool UsesTangent { get; } = material.UsesTangent;

    public bool HasTint { get; } = batch.HasTint;

    public int OnlyIndex => onlyIndex;

    // The material's constant answers, asked once.
    public bool IsLit { get; } = material.IsLit;

    public bool HasDensity { get; } = material.HasDensity;

    public bool Emits { get; } = material.Emits;

    public bool UsesUv { get; } = material.UsesUv;

    /// <summary>Makes the groups of a scene, and the table that names the group of each primitive.</summary>
    public static ShadingGroup[] Create(World world, out int[] groupOf)
    {
        List<ShadingGroup> groups = [];
        groupOf = new int[world.Count + 1];
        foreach (Space space in world.Spaces)
        {
            foreach (SurfaceTable table in space.Tables)
            {
                Add(space, table, space != world.Itself, groupOf, groups);
            }
        }

        // Rays that hit nothing come after all groups.
        groupOf[^1] = groups.Count;
        return [.. groups];
    }

    private static void Add(Space space, SurfaceTable table, bool isInstanced, int[] groupOf, List<ShadingGroup> groups)
    {
        Dictionary<Material, int> counts = new(ReferenceEqualityComparer.Instance);
        Dictionary<Material, int> groupOfMaterial = new(ReferenceEqualityComparer.Instance);
        int first = groups.Count;
        (Material? last, int group) = (null, 0);
        for (int primitive = table.FirstPrimitive; primitive < table.FirstPrimitive + table.Count; primitive++)
        {
            Material material = space.MaterialOf(primitive);
            if (material != last && !groupOfMaterial.TryGetValue(material, out group))
            {
                group = first + groupOfMaterial.Count;
                groupOfMaterial.Add(material, group);
            }

            last = material;
            groupOf[primitive] = group;
            counts[material] = counts.GetValueOrDefault(material) + 1;
        }

        foreach ((Material material, int number) in groupOfMaterial.OrderBy(g => g.Value))
        {
            int only = counts[material] == 1 && table is ShapeBatch ? Array.IndexOf(groupOf, number, table.FirstPrimitive, table.Count) - table.FirstPrimitive : -1;
            groups.Add(new(material, table, only, isInstanced));
        }
    }
}
