using RayTracer.Description;
using RayTracer.Textures;

namespace RayTracer.Shapes;

/// <summary>The rules by which meshes are subdivided.</summary>
public enum SubdivisionScheme
{
    /// <summary>Catmull and Clark's: every face becomes as many quadrilaterals as it has corners.</summary>
    CatmullClark,

    /// <summary>Loop's, with Warren's weights: every triangle becomes four.</summary>
    Loop,
}

/// <summary>What makes a coarse mesh fine and round: subdivision, creases, displacement.</summary>
public sealed record RefinementDescription
{
    /// <summary>The number of subdivisions.</summary>
    [Parameter("How often every face is subdivided; each time there are four times as many. Corners are then moved onto the surface that subdividing for ever would give, and shading is smooth "
        + "(unless the shading is flat).", Minimum = 0, Maximum = 10)]
    public int Subdivide { get; init; }

    /// <summary>The rules of subdivision.</summary>
    [Parameter("By which rules: Catmull and Clark's, which takes the polygons of a file as they are; or Loop's, for triangles, with Warren's weights. Borders and creases "
        + "become cubic B-splines; uv and colours are linear within each face.")]
    public SubdivisionScheme Scheme { get; init; }

    /// <summary>The angle beyond which an edge is a crease.</summary>
    [Parameter("An edge whose two faces differ in direction by more than this is a crease: it stays sharp in subdivision, and shading is not smooth across it. At 180, only borders are.",
        Unit = "degrees", Minimum = 0, Maximum = 180)]
    public float CreaseAngle { get; init; } = 180;

    /// <summary>What moves the corners along their normals; null for nothing.</summary>
    [Parameter("A texture whose red channel moves each corner along its normal, once faces are subdivided: by height times what is above the middle. Textures in space see the mesh's own coordinates.")]
    public TextureDescription? Displace { get; init; }

    /// <summary>The displacement where the texture is 1 above its middle.</summary>
    [Parameter("How far a texture of 1 above the middle moves corners outwards; inwards where it is below zero.", Unit = "scene units")]
    public float Height { get; init; } = 1;

    /// <summary>The value of the texture that moves nothing.</summary>
    [Parameter("The value of the texture that moves nothing.")]
    public float Middle { get; init; }

    /// <summary>True where corners are moved, or there are more of them.</summary>
    internal bool MovesCorners => Subdivide > 0 || Displace is not null;
}
