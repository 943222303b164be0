using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>The points where textures are evaluated.</summary>
public struct TexturePointW
{
    /// <summary>Surface coordinates.</summary>
    public FloatW U, V;

    /// <summary>
    /// The point in the coordinates in which the shape's own numbers are given; set only for <see cref="TextureInputs.ObjectPoint"/>.
    /// </summary>
    public Vec3W Local;

    /// <summary>The point in the world; set only for <see cref="TextureInputs.WorldPoint"/>.</summary>
    public Vec3W World;

    /// <summary>The vertex colour of the surface; set only for <see cref="TextureInputs.VertexColor"/>.</summary>
    public RgbW VertexColor;

    /// <summary>The second vertex colour of the surface; set only for <see cref="TextureInputs.SecondColor"/>.</summary>
    public RgbW SecondColor;
}

/// <summary>The inputs that a texture's colours depend on.</summary>
[Flags]
public enum TextureInputs
{
    /// <summary>On nothing.</summary>
    None = 0,

    /// <summary>On uv.</summary>
    Uv = 1,

    /// <summary>On the point in the shape's own coordinates.</summary>
    ObjectPoint = 2,

    /// <summary>On the point in the world.</summary>
    WorldPoint = 4,

    /// <summary>On the colours of a mesh's corners.</summary>
    VertexColor = 8,

    /// <summary>On the second colours of a mesh's corners.</summary>
    SecondColor = 16,

    /// <summary>On more than uv, which is all that lights know of a point.</summary>
    BeyondUv = ObjectPoint | WorldPoint | VertexColor | SecondColor,
}
