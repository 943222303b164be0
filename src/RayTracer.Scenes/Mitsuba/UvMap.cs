using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Scenes;

/// <summary>An affine map of uv: what a texture's <c>to_uv</c> does before the texture is looked up.</summary>
/// <param name="First">The row that gives u: factors on u and v, and what is added.</param>
/// <param name="Second">The row that gives v.</param>
/// <param name="At">Where it stands.</param>
/// <param name="Log">Takes what is wrong.</param>
internal sealed record UvMap(Vector3 First, Vector3 Second, SourcePlace At, MitsubaLog Log)
{
    // What angles in single precision leave of a right angle.
    private const float Tolerance = 1e-5f;

    /// <summary>Whether nothing is turned.</summary>
    public bool IsStraight => First.Y == 0 && Second.X == 0;

    /// <summary>Factors on u and v of a map that turns nothing.</summary>
    public Vector2 Scale => new(First.X, Second.Y);

    /// <summary>What is added.</summary>
    public Vector2 Offset => new(First.Z, Second.Z);

    /// <summary>A texture's map.</summary>
    public static UvMap Read(MitsubaObject texture)
    {
        Transform map = texture.Transform("to_uv");
        return new(
            new((float)map.X.A, (float)map.X.B, (float)map.X.D), new((float)map.Y.A, (float)map.Y.B, (float)map.Y.D), texture.PlaceOf("to_uv"), texture.Log);
    }

    /// <summary>A texture that is looked up at mapped uv: one that is scaled and then turned, or turned and then scaled.</summary>
    public TextureDescription Place(TextureDescription texture)
    {
        (Vector2 forU, Vector2 forV) = (new(First.X, Second.X), new(First.Y, Second.Y));
        if (float.Abs(Dot(forU, forV)) <= Tolerance * Norm(forU) * Norm(forV))
        {
            Vector2 scale = new(Norm(forU), Norm(forV) * Sign);
            return new PlacedTextureDescription { Texture = texture, Scale = scale, Rotate = Degrees(forU), Offset = Offset };
        }

        (Vector2 rowU, Vector2 rowV) = (new(First.X, First.Y), new(Second.X, Second.Y));
        if (float.Abs(Dot(rowU, rowV)) > Tolerance * Norm(rowU) * Norm(rowV))
        {
            Log.Error(At, "a map of uv that shears is not read here: only scales, turns and translations are");
        }

        PlacedTextureDescription scaled = new() { Texture = texture, Scale = new(Norm(rowU), Norm(rowV) * Sign), Offset = Offset };
        return new PlacedTextureDescription { Texture = scaled, Rotate = -Degrees(rowU) };
    }

    // Below zero for maps that mirror: then v is.
    private float Sign => (First.X * Second.Y) - (First.Y * Second.X) < 0 ? -1 : 1;

    private static float Dot(Vector2 a, Vector2 b) => (a.X * b.X) + (a.Y * b.Y);

    private static float Norm(Vector2 a) => float.Sqrt(Dot(a, a));

    private static float Degrees(Vector2 a) => LaneMath.Atan2(a.Y, a.X) * (180 / float.Pi);
}
