using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;
using static RayTracer.Import.ModelCheck;

namespace RayTracer.Import;

/// <summary>Models of one mesh without materials.</summary>
internal static class MeshModel
{
    /// <summary>Makes a model; meshes with vertex colours get a white material, so that the colours are unchanged.</summary>
    /// <param name="path">The file, after which the mesh is named.</param>
    /// <param name="mesh">The triangles.</param>
    /// <param name="notes">The notes on the file.</param>
    /// <exception cref="ModelException">There are no triangles.</exception>
    public static ImportedModel Of(string path, MeshData mesh, IReadOnlyList<string> notes)
    {
        Require(mesh.TriangleCount != 0, $"there are no triangles in it ({mesh.Positions.Length} corners)");

        MaterialDescription material = mesh.Colors is null ? ShapeDescription.DefaultMaterial : White;
        MeshDescription shape = new() { Name = Path.GetFileNameWithoutExtension(path), Data = mesh, Material = material };
        return new ImportedModel(new SceneDescription { Shapes = [shape] }, notes);
    }

    /// <summary>The material of meshes with vertex colours.</summary>
    public static MaterialDescription White { get; } = new DiffuseMaterialDescription { Color = new SolidTextureDescription { Color = Rgb.White } };
}

/// <summary>Colours of vertices: model files hold what is to be seen on a screen, that is, sRGB.</summary>
internal static class VertexColor
{
    /// <summary>Linear light of a value from 0 to 1.</summary>
    public static float Decode(float encoded) => encoded > 0 ? (float)SrgbCurve.Decode(float.Min(encoded, 1)) : 0;

    /// <summary>Linear light of a number in a PLY file: whole ones are codes from 0 to the type's largest, others go from 0 to 1.</summary>
    public static float Decode(float number, PlyType type) => type switch
    {
        PlyType.Float32 or PlyType.Float64 => Decode(number),
        PlyType.UInt16 => SrgbCurve.Decode16((ushort)number),
        _ => SrgbCurve.Decode8((byte)Math.Clamp(number, 0, 255)),
    };
}
