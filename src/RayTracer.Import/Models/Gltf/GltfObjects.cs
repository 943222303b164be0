using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>Describes a glTF file's meshes, so that nodes that show the same one share it.</summary>
internal sealed class GltfObjects(GltfDocument document, GltfMeshes meshes, GltfMaterials materials)
{
    private readonly Dictionary<(int Mesh, int? Variant), ShapeDescription?> _described = [];
    private readonly Dictionary<string, ShapeDescription> _shared = new(StringComparer.Ordinal);

    /// <summary>The objects that several nodes show, by name.</summary>
    public IReadOnlyDictionary<string, ShapeDescription> Shared => _shared;

    /// <summary>A mesh for a node to show; null where it has no triangles.</summary>
    /// <param name="mesh">Which mesh: an index that has been checked.</param>
    /// <param name="isShared">True where other nodes show it too.</param>
    /// <param name="variant">The look of its materials; null for their own.</param>
    public ShapeDescription? Place(int mesh, bool isShared, int? variant)
    {
        ShapeDescription? shape = _described.Remember((mesh, variant), () => Describe(mesh, null, variant));

        // Every lamp is sampled for itself.
        if (shape is null || !isShared || Shines(shape))
        {
            return shape;
        }

        _shared[$"mesh {mesh}{variant}"] = shape;
        return new InstanceDescription { Name = shape.Name, Of = shape };
    }

    /// <summary>A mesh that is bent.</summary>
    /// <param name="mesh">Which mesh: an index that has been checked.</param>
    /// <param name="deformation">What bends it.</param>
    /// <param name="variant">The look of its materials; null for their own.</param>
    public ShapeDescription? Bent(int mesh, GltfDeformation deformation, int? variant) => Describe(mesh, deformation, variant);

    private ShapeDescription? Describe(int index, GltfDeformation? deformation, int? variant)
    {
        GltfObject mesh = document.List("meshes")[index];
        string name = mesh.Text("name") ?? "";
        List<ShapeDescription> parts = [];
        foreach (GltfObject primitive in mesh.Children("primitives"))
        {
            GltfMaterial material = materials.Describe(Variant(primitive, variant) ?? document.Reference(primitive, "material", "materials"));
            if (meshes.Build(primitive, material.UvSet, deformation) is { } data)
            {
                parts.Add(new MeshDescription { Name = name, Data = data, Material = material.Description });
            }
        }

        return parts.Count > 1 ? new GroupDescription { Name = name, Shapes = parts } : parts.FirstOrDefault();
    }

    // The material that a primitive has in a look of the file (KHR_materials_variants); null where that says nothing of it.
    private int? Variant(GltfObject primitive, int? variant) =>
        variant is { } look && primitive.Extension("KHR_materials_variants")?.Children("mappings").FirstOrDefault(m => m.Integers("variants").Contains(look)) is { } mapping
            ? document.RequiredReference(mapping, "material", "materials") : null;

    private static bool Shines(ShapeDescription shape) =>
        shape is GroupDescription group ? group.Shapes.Any(Shines) : shape.Material is LuminaireMaterialDescription;
}
