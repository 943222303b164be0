using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Description;

/// <summary>The things that a builder has put into one space: the world, or that of an object which instances show.</summary>
internal sealed class SpaceContents
{
    /// <summary>The name of the object that it is; null where it is the world, or has none.</summary>
    public string? Name { get; init; }

    /// <summary>Shapes, in coordinates of the space.</summary>
    public List<Shape> Shapes { get; } = [];

    /// <summary>Meshes at their places.</summary>
    public List<PlacedMesh> Meshes { get; } = [];

    /// <summary>Other spaces, none of which holds visible instances itself: those are listed here too.</summary>
    public List<PlacedSpace> Instances { get; } = [];

    /// <summary>Lights without extent, those of instances among them.</summary>
    public List<PlacedLight> Lights { get; } = [];

    /// <summary>True where there is anything besides instances that rays can meet.</summary>
    public bool HasSurfaces => Shapes.Count + Meshes.Count > 0;

    /// <summary>How many things of each kind there are.</summary>
    public (int Shapes, int Meshes, int Instances, int Lights) Counts => (Shapes.Count, Meshes.Count, Instances.Count, Lights.Count);

    /// <summary>Returns whether anything is made of such a material.</summary>
    public bool Has(Func<Material, bool> isWanted) =>
        Shapes.Any(s => isWanted(s.Material)) || Meshes.Any(m => m.Materials.Any(isWanted)) || Instances.Any(i => i.Contents.Has(isWanted));

    /// <summary>The things made of such a material (meshes, of one such at least), and the lights without extent.</summary>
    public SpaceContents Only(Func<Material, bool> isWanted) => Only(isWanted, new(ReferenceEqualityComparer.Instance));

    // What several instances show stays one.
    private SpaceContents Only(Func<Material, bool> isWanted, Dictionary<SpaceContents, SpaceContents> known)
    {
        if (!known.TryGetValue(this, out SpaceContents? only))
        {
            known.Add(this, only = new());
            only.Shapes.AddRange(Shapes.Where(s => isWanted(s.Material)));
            only.Meshes.AddRange(Meshes.Where(m => m.Materials.Any(isWanted)));
            only.Instances.AddRange(Instances.Select(i => i with { Contents = i.Contents.Only(isWanted, known) }).Where(i => i.Contents.HasSurfaces));
            only.Lights.AddRange(Lights);
        }

        return only;
    }

    /// <summary>Returns whether something shines that was added when there was this much already.</summary>
    public bool ShinesBeyond((int Shapes, int Meshes, int Instances, int Lights) before) => Lights.Count > before.Lights
        || Shapes.Skip(before.Shapes).Any(s => s.Material.Traits.Emits)
        || Meshes.Skip(before.Meshes).Any(m => m.Materials.Any(material => material.Traits.Emits))
        || Instances.Skip(before.Instances).Any(i => i.Contents.ShinesBeyond(default));
}

/// <summary>A mesh in a space.</summary>
/// <param name="Data">The triangles, checked and mended.</param>
/// <param name="Materials">The materials; at least one.</param>
/// <param name="Place">The place of the mesh.</param>
/// <param name="Source">The source that it was made from; null where that is not kept.</param>
/// <param name="Label">The label of its light.</param>
internal sealed record PlacedMesh(MeshData Data, Material[] Materials, Transform Place, ShapeDescription? Source, LightGroupLabel? Label);

/// <summary>A space in another one.</summary>
/// <param name="Contents">The contents of the instance.</param>
/// <param name="Motion">The instance's place over time.</param>
/// <param name="Source">The source that it was made from; null where that is not kept.</param>
/// <param name="Label">The label of its light, where its contents have none.</param>
internal sealed record PlacedSpace(SpaceContents Contents, Motion Motion, ShapeDescription? Source, LightGroupLabel? Label);

/// <summary>A light without extent in a space.</summary>
/// <param name="Light">The light's description, found free of faults.</param>
/// <param name="Motion">The place of its own space over time.</param>
/// <param name="Label">The label of its light.</param>
/// <param name="Picture">The picture through which it shines; null where there is none.</param>
internal sealed record PlacedLight(PunctualLightDescription Light, Motion Motion, LightGroupLabel? Label, Texture? Picture);
