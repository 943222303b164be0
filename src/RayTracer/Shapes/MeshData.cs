using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// Triangles that share corners, as model files hold them: what importers make and meshes are built from. Nothing is checked
/// here; what is wrong with a model is found and mended when its mesh is built.
/// </summary>
/// <param name="positions">The corners.</param>
/// <param name="indices">Three corners a triangle, counter-clockwise as seen from its front.</param>
public sealed class MeshData(Vector3[] positions, int[] indices)
{
    /// <summary>The corners, in the mesh's own space.</summary>
    public Vector3[] Positions => positions;

    /// <summary>Three indices of corners a triangle, counter-clockwise as seen from its front.</summary>
    public int[] Indices => indices;

    /// <summary>Number of triangles.</summary>
    public int TriangleCount => indices.Length / 3;

    /// <summary>A shading normal for each corner, need not be of unit length; null where the triangles are flat.</summary>
    public Vector3[]? Normals { get; init; }

    /// <summary>uv for each corner, v upwards (the picture's lower left corner is 0, 0); null where there is none.</summary>
    public Vector2[]? Uv { get; init; }

    /// <summary>A linear colour for each corner, which the material's colour is multiplied by; null where there is none.</summary>
    public Rgb[]? Colors { get; init; }

    /// <summary>A second linear colour for each corner, which textures may show; null where there is none.</summary>
    public Rgb[]? SecondColors { get; init; }

    /// <summary>
    /// A tangent for each corner, along growing u, whose fourth number is the sign of the bitangent (glTF 2.0, section 3.7.2.1); null where
    /// there is none.
    /// </summary>
    public Vector4[]? Tangents { get; init; }

    /// <summary>The index of each triangle's material; null where all are made of the first.</summary>
    public int[]? MaterialOfTriangle { get; init; }

    /// <summary>The number of the polygon that each triangle is a part of, whose triangles follow one another; null where each is a face of its own.</summary>
    public int[]? FaceOfTriangle { get; init; }

    /// <summary>Further colours that the file has, of which scenes may choose one instead of <see cref="Colors"/>, and another one as <see cref="SecondColors"/>.</summary>
    public IReadOnlyList<MeshAttribute> Attributes { get; init; } = [];
}

/// <summary>Colours of a mesh's corners or triangles, or single numbers as grey.</summary>
/// <param name="Name">The name; where it begins with "face", there is one for each triangle.</param>
/// <param name="Values">The colours: as many as corners, or triangles.</param>
public sealed record MeshAttribute(string Name, Rgb[] Values)
{
    /// <summary>True where triangles have the colours.</summary>
    public bool IsOfTriangles => Name.StartsWith("face", StringComparison.Ordinal);
}
