using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>Models of one mesh without materials.</summary>
internal static class MeshModel
{
    /// <summary>Makes a model; meshes with vertex colours get a white material, so that the colours are unchanged.</summary>
    /// <param name="path">The file, after which the mesh is named.</param>
    /// <param name="mesh">The triangles.</param>
    /// <param name="notes">What is said about the file.</param>
    /// <exception cref="ModelException">There are no triangles.</exception>
    public static ImportedModel Of(string path, MeshData mesh, IReadOnlyList<string> notes)
    {
        if (mesh.TriangleCount == 0)
        {
            throw new ModelException($"there are no triangles in it ({mesh.Positions.Length} corners)");
        }

        MaterialDescription material = mesh.Colors is null ? ShapeDescription.DefaultMaterial : White;
        MeshDescription shape = new() { Name = Path.GetFileNameWithoutExtension(path), Data = mesh, Material = material };
        return new ImportedModel(new SceneDescription { Shapes = [shape] }, notes);
    }

    /// <summary>The material of meshes with vertex colours.</summary>
    public static MaterialDescription White { get; } = new DiffuseMaterialDescription { Color = new SolidTextureDescription { Color = Rgb.White } };
}
