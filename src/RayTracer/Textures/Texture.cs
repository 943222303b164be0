using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>
/// A colour that may vary over a surface. (0, 0) in uv is the lower left corner of a picture, u grows to the right, v upwards.
/// </summary>
public abstract class Texture
{
    /// <summary>The colour if it is the same everywhere, else null; users may then skip computing uv.</summary>
    public virtual Rgb? Constant => null;

    /// <summary>The smallest rectangle of memory the texture keeps, in bytes: what <c>info</c> reports.</summary>
    public virtual long MemoryBytes => 0;

    /// <summary>The colour at a point of the surface.</summary>
    /// <param name="u">First surface coordinate.</param>
    /// <param name="v">Second surface coordinate.</param>
    /// <param name="color">The colour there, linear.</param>
    public abstract void Evaluate(in FloatW u, in FloatW v, out RgbW color);
}
