using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Import;

/// <summary>An affine map of uv: what a texture's <c>to_uv</c> does before the texture is looked up.</summary>
/// <param name="First">The row that gives u: factors on u and v, and what is added.</param>
/// <param name="Second">The row that gives v.</param>
internal sealed record UvMap(Vector3 First, Vector3 Second)
{
    /// <summary>True where nothing is turned.</summary>
    public bool IsStraight => First.Y == 0 && Second.X == 0;

    /// <summary>Factors on u and v of a map that turns nothing.</summary>
    public Vector2 Scale => new(First.X, Second.Y);

    /// <summary>The offset.</summary>
    public Vector2 Offset => new(First.Z, Second.Z);

    /// <summary>A texture's map.</summary>
    public static UvMap Read(MitsubaObject texture)
    {
        Transform map = texture.Transform("to_uv");
        return new(new((float)map.X.A, (float)map.X.B, (float)map.X.D), new((float)map.Y.A, (float)map.Y.B, (float)map.Y.D));
    }

    /// <summary>A texture that is looked up at mapped uv.</summary>
    public TextureDescription Place(TextureDescription texture) =>
        new PlacedTextureDescription { Texture = texture, Matrix = [First.X, First.Y, First.Z, Second.X, Second.Y, Second.Z] };
}
