using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>Describes a glTF file's meshes, so that nodes that show the same one share it.</summary>
internal sealed class GltfObjects(GltfDocument document, GltfMeshes meshes, GltfMaterials materials)
{
    private readonly Dictionary<int, ShapeDescription?> _described = [];
    private readonly Dictionary<string, ShapeDescription> _shared = new(StringComparer.Ordinal);

    /// <summary>The objects that several nodes show, by name.</summary>
    public IReadOnlyDictionary<string, ShapeDescription> Shared => _shared;

    /// <summary>A mesh for a node to show; null where it has no triangles.</summary>
    /// <param name="mesh">Which mesh: an index that has been checked.</param>
    /// <param name="isShared">True where other nodes show it too.</param>
    public ShapeDescription? Place(int mesh, bool isShared)
    {
        ShapeDescription? shape = _described.Remember(mesh, () => Describe(mesh));

        // Every lamp is sampled for itself.
        if (shape is null || !isShared || Shines(shape))
        {
            return shape;
        }

        _shared[$"mesh {mesh}"] = shape;
        return new InstanceDescription { Name = shape.Name, Of = shape };
    }

    /// <summary>A mesh that is bent.</summary>
    /// <param name="mesh">Which mesh: an index that has been checked.</param>
    /// <param name="deformation">What bends it.</param>
    public ShapeDescription? Bent(int mesh, GltfDeformation deformation) => Describe(mesh, deformation);

    private ShapeDescription? Describe(int index, GltfDeformation? deformation = null)
    {
        GltfObject mesh = document.List("meshes")[index];
        string name = mesh.Text("name") ?? "";
        List<ShapeDescription> parts = [];
        foreach (GltfObject primitive in mesh.Children("primitives"))
        {
            GltfMaterial material = materials.Describe(document.Reference(primitive, "material", "materials"));
            if (meshes.Build(primitive, material.UvSet, deformation) is { } data)
            {
                parts.Add(new MeshDescription { Name = name, Data = data, Material = material.Description });
            }
        }

        return parts.Count > 1 ? new GroupDescription { Name = name, Shapes = parts } : parts.FirstOrDefault();
    }

    private static bool Shines(ShapeDescription shape) =>
        shape is GroupDescription group ? group.Shapes.Any(Shines) : shape.Material is LuminaireMaterialDescription;
}
