using RayTracer.Materials;

namespace RayTracer.Rendering;

/// <summary>The guided materials of a thread.</summary>
/// <param name="guide">The guide.</param>
internal sealed class GuidedMaterials(PathGuide guide)
{
    private readonly Dictionary<Material, GuidedMaterial> _materials = new(ReferenceEqualityComparer.Instance);

    /// <summary>Returns the material of a group as guided at a packet of points; null where it only has single directions.</summary>
    public GuidedMaterial? At(ShadingGroup group, in SurfaceW surface)
    {
        if (!group.Traits.HasDensity)
        {
            return null;
        }

        if (!_materials.TryGetValue(group.Material, out GuidedMaterial? guided))
        {
            guided = new(guide, group.Material);
            _materials.Add(group.Material, guided);
        }

        guided.Begin(surface);
        return guided;
    }
}
