using System.Numerics;
using RayTracer.Description;

namespace RayTracer.Shapes;

/// <summary>The normals that a mesh is shaded with.</summary>
public enum MeshShading
{
    /// <summary>Its own, and none where it has none.</summary>
    Own,

    /// <summary>None: every triangle is flat.</summary>
    Flat,

    /// <summary>Its own, and where it has none the mean of those of the triangles around each corner.</summary>
    Smooth,
}

/// <summary>Describes a mesh of triangles, from a file, from numbers in the scene file, or from a program.</summary>
[SceneType("mesh", "Triangles that share corners, from a model file or from numbers written here. Their front, which shines if they are a "
    + "luminaire, is where the corners are seen counter-clockwise. Faults of a mesh are repaired where possible, and reported.")]
public sealed record MeshDescription : ShapeDescription
{
    /// <summary>A model file, of which only the triangles are taken.</summary>
    [Parameter("A model file, of which only the triangles are used, not its materials, lights and cameras (the shape model uses them all).",
        IsFile = true)]
    public string File { get; init; } = "";

    /// <summary>The corners.</summary>
    [Parameter("The corners.", Unit = "scene units")]
    public IReadOnlyList<Vector3> Positions { get; init; } = [];

    /// <summary>Three corners a triangle.</summary>
    [Parameter("The triangles: for each, the indices of three corners, from 0, counter-clockwise as seen from its front.")]
    public IReadOnlyList<TriangleIndices> Triangles { get; init; } = [];

    /// <summary>A shading normal for each corner; empty for flat triangles.</summary>
    [Parameter("A normal for each corner, of any length; they shade the surface as if it were smooth. Without them each triangle is flat.")]
    public IReadOnlyList<Vector3> Normals { get; init; } = [];

    /// <summary>uv for each corner.</summary>
    [Parameter("uv for each corner.")]
    public IReadOnlyList<Vector2> Uv { get; init; } = [];

    /// <summary>A colour for each corner; empty where the mesh has none.</summary>
    [Parameter("A colour for each corner, linear red, green and blue: diffuse colours are multiplied by it, unless the material shows it "
        + "with a texture of type vertexColor.", Minimum = 0)]
    public IReadOnlyList<Vector3> Colors { get; init; } = [];

    /// <summary>Materials for <see cref="MaterialOfTriangle"/>; empty where all triangles are of the mesh's material.</summary>
    [Parameter("Materials to choose from for each triangle. Without them, all are made of the mesh's material.")]
    public IReadOnlyList<MaterialDescription> Materials { get; init; } = [];

    /// <summary>The index of each triangle's material in <see cref="Materials"/>; empty where all are made of the first.</summary>
    [Parameter("For each triangle, the index of its material, from 0.")]
    public IReadOnlyList<int> MaterialOfTriangle { get; init; } = [];

    /// <summary>The number of the polygon that each triangle is a part of; empty where each is a face of its own.</summary>
    [Parameter("For each triangle, the number of the polygon that it is a part of: triangles of the same number that follow one another are one face where the mesh is subdivided.")]
    public IReadOnlyList<int> FaceOfTriangle { get; init; } = [];

    /// <summary>The index of the mesh in <see cref="File"/>, from 0; −1 for all.</summary>
    [Parameter("The index of the mesh in the file, from 0; −1 uses all of them.", Minimum = -1)]
    public int Part { get; init; } = -1;

    /// <summary>The normals that the mesh is shaded with.</summary>
    [Parameter("Which normals the mesh is shaded with: its own (flat triangles where it has none), none at all, or its own and, where it "
        + "has none, the mean of the triangles around each corner, weighted by their angles there.")]
    public MeshShading Shading { get; init; } = MeshShading.Own;

    /// <summary>True where the mesh is turned inside out.</summary>
    [Parameter("Whether the mesh is turned inside out: its front becomes its back.")]
    public bool FlipNormals { get; init; }

    /// <summary>True where v is counted from the other end.</summary>
    [Parameter("Whether v is counted from the other end: 1 − v replaces it.")]
    public bool FlipV { get; init; }

    /// <summary>True where the colours of corners are left out.</summary>
    [Parameter("Whether the colours that a file gives its corners are ignored. Otherwise the material's colour is multiplied by them.")]
    public bool IgnoreColors { get; init; }

    /// <summary>The name of the attribute whose colours replace those of the corners; empty for none.</summary>
    [Parameter("Which further colours of a PLY file replace those of its corners: of properties r, g, b of faces, \"face_color\"; of heat_0, heat_1, heat_2 of vertices, "
        + "\"vertex_heat\"; of heat_r …, \"vertex_heat_color\". They are linear.")]
    public string ColorAttribute { get; init; } = "";

    /// <summary>The name of the attribute that textures show as second colours; empty for none.</summary>
    [Parameter("As colorAttribute: further colours, which \"vertexColor\" textures show whose second is true. Not of a mesh that is refined.")]
    public string SecondColorAttribute { get; init; } = "";

    /// <summary>What makes the mesh fine and round.</summary>
    [Parameter("What makes a coarse mesh fine and round: subdivision, creases, displacement.")]
    public RefinementDescription Refinement { get; init; } = new();

    /// <summary>The triangles as a program gives them, instead of the file or the lists; null where there are none.</summary>
    public MeshData? Data { get; init; }

    /// <inheritdoc/>
    public override SketchKinds SketchedAs => SketchKinds.None;

    /// <summary>The mesh of a file, or a pyramid.</summary>
    public override ShapeDescription Sketch(SketchView view) => view.File is { } file ? this with { File = file } : this with
    {
        Positions = [.. ((Vector3[])[new(-1, -1, -1), new(1, -1, -1), new(1, -1, 1), new(-1, -1, 1), new(0, 1, 0)]).Select(view.At)],
        Triangles = [new(0, 1, 2), new(0, 2, 3), new(0, 4, 1), new(1, 4, 2), new(2, 4, 3), new(3, 4, 0)],
    };

    /// <summary>Returns null: it is no single shape.</summary>
    public override Shape? Build(SceneBuilder builder) => null;
}

/// <summary>The corners of one triangle of a mesh, as positions in its list of corners, from 0.</summary>
/// <param name="A">First corner.</param>
/// <param name="B">Second corner.</param>
/// <param name="C">Third corner.</param>
public readonly record struct TriangleIndices(int A, int B, int C);
