using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Textures;

namespace RayTracer.Rendering;

/// <summary>
/// The shapes of one kind that share one material: hits on them are shaded together, with one call for a packet of lanes.
/// </summary>
/// <param name="material">The material.</param>
/// <param name="batch">The batch that the shapes belong to; null for what is no shape.</param>
/// <param name="onlyIndex">Index in the batch of the group's only shape; −1 if it has several.</param>
/// <param name="isInstanced">True if the shapes stand in a space that instances show.</param>
public sealed class ShadingGroup(Material material, SurfaceTable? batch, int onlyIndex, bool isInstanced)
{
    private MaterialTraits _traits = material.Traits;

    /// <summary>It is that of the points at which media scatter light.</summary>
    internal bool IsOfMedia => batch is null;

    /// <summary>The material.</summary>
    public Material Material => material;

    /// <summary>The material's constants, but that it disperses light where another one around it may, too.</summary>
    public ref readonly MaterialTraits Traits => ref _traits;

    internal SurfaceTable Batch => batch!;

    internal bool IsInstanced => isInstanced;

    internal bool HasShadingNormals { get; } = batch is { HasShadingNormals: true };

    /// <summary>Light is scattered with other normals than the surface's own, so that it could leak through it.</summary>
    public bool MayLeak { get; } = batch is { HasShadingNormals: true } || material.Traits.TurnsNormal;

    /// <summary>Shading normals may be all that counts (<see cref="Scene.IsLiteral"/>).</summary>
    internal bool MayBeLiteral { get; } = (batch is { HasShadingNormals: true } || material.Traits.TurnsNormal) && !material.Traits.MirrorsNormal;

    /// <summary>How surfaces face rays where normals are mended.</summary>
    internal NormalRules MendedRules { get; } = RulesOf(material, batch is { HasShadingNormals: true }, isLiteral: false);

    /// <summary>How surfaces face rays where normals are taken literally.</summary>
    internal NormalRules LiteralRules { get; } = RulesOf(material, batch is { HasShadingNormals: true }, isLiteral: true);

    /// <summary>The diffuse colour is multiplied by the surface's own colours: where no texture of the material shows them.</summary>
    internal bool HasTint { get; } = batch is { HasTint: true } && (material.Inputs & TextureInputs.VertexColor) == TextureInputs.None;

    /// <summary>The surface has no colours of its own.</summary>
    internal bool LacksTint { get; } = batch is not { HasTint: true };

    /// <summary>A texture asks for second colours, and the surface has none.</summary>
    internal bool LacksSecondTint { get; } = batch is not { HasSecondTint: true } && (material.Inputs & TextureInputs.SecondColor) != TextureInputs.None;

    /// <summary>A texture asks for the point in the shape's own coordinates.</summary>
    internal bool UsesLocal { get; } = (material.Inputs & TextureInputs.ObjectPoint) != TextureInputs.None;

    internal int OnlyIndex => onlyIndex;

    /// <summary>Number of what is inside; 0 for nothing.</summary>
    internal uint Interior { get; set; }

    internal bool IsNested { get; } = material.Traits.Nesting is not null;

    /// <summary>Makes the groups of a scene, and the table that names the group of each primitive.</summary>
    internal static ShadingGroup[] Create(World world, out int[] groupOf)
    {
        List<ShadingGroup> groups = [];
        groupOf = new int[world.Count + 2];
        foreach (Space space in world.Spaces)
        {
            foreach (SurfaceTable table in space.Tables)
            {
                Add(space, table, space != world.Itself, groupOf, groups);
            }
        }

        // Rays that hit nothing come after all groups, and then those that a medium scatters.
        groupOf[^2] = groups.Count;
        groupOf[^1] = groups.Count + 1;
        return [.. groups];
    }

    /// <summary>Gives the insides of groups numbers from 1, the same to equal ones, and returns them.</summary>
    internal static Interior[] NumberInteriors(ShadingGroup[] groups)
    {
        Interior[] interiors = [.. groups.Select(InteriorOf).OfType<Interior>().Distinct()];
        bool nestedDisperse = Array.Exists(groups, g => g.IsNested && g.Traits.Disperses);
        foreach (ShadingGroup group in groups)
        {
            group.Interior = (uint)(Array.IndexOf(interiors, InteriorOf(group)) + 1);
            group._traits = group.Traits with { Disperses = group.Traits.Disperses || (nestedDisperse && group.IsNested) };
        }

        return interiors;
    }

    internal static NormalRules RulesOf(Material material, bool isSmooth, bool isLiteral)
    {
        MaterialTraits traits = material.Traits;
        bool takesLiterally = isLiteral && !traits.MirrorsNormal;
        NormalRules shading = !isSmooth ? NormalRules.None : takesLiterally ? NormalRules.Literal : NormalRules.Smooth;
        NormalRules map = traits.TurnsNormal ? NormalRules.Mapped : NormalRules.None;
        NormalRules leaks = (isSmooth || traits.TurnsNormal) && !takesLiterally ? NormalRules.DropsLeaks : NormalRules.None;
        NormalRules tangent = traits.UsesTangent ? NormalRules.HasTangent : NormalRules.None;
        return shading | map | leaks | tangent | (material.PreparesByRay ? NormalRules.ByRay : NormalRules.None);
    }

    private static Interior? InteriorOf(ShadingGroup group) =>
        group.Traits is { Interior: null, Nesting: null } ? null : new(group.Traits.Interior, group.Traits.Nesting);

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
