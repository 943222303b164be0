using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Import;

/// <summary>Makes meshes of model files. Where a file has no normals they have smooth ones, unless faces are asked for.</summary>
internal static class MitsubaMeshes
{
    /// <summary>A mesh of a file.</summary>
    public static ShapeDescription? Read(MitsubaObject shape, MaterialDescription material)
    {
        // The front of flat faces follows from the order of their corners after the transform, so a mirror turns it inwards.
        Transform place = shape.Transform();
        bool isFlat = shape.Boolean("face_normals", false);
        MeshDescription mesh = new()
        {
            File = shape.FileName() ?? "",
            Part = shape.Type == "serialized" ? shape.Integer("shape_index", 0, 0) : -1,
            Shading = isFlat ? MeshShading.Flat : MeshShading.Smooth,
            FlipNormals = shape.Boolean("flip_normals", false) != (isFlat && place.Determinant < 0),
            FlipV = shape.Boolean("flip_tex_coords", shape.Type == "obj"),
            IgnoreColors = !MaterialTextures.UseColors(material),
            Material = material,
            Transform = MitsubaSurfaces.Steps(place),
        };
        return mesh.File.Length > 0 ? mesh : null;
    }
}
