using RayTracer.Numerics;
using RayTracer.Textbook;
using Texture = RayTracer.Textures.Texture;

namespace RayTracer.Adapters;

/// <summary>A texture of the fast edition that is asked for one place at a time.</summary>
/// <param name="texture">The texture, which depends on u and v alone.</param>
internal sealed class LaneTexture(Texture texture) : ITexture
{
    /// <inheritdoc/>
    public Textbook.Rgb At(double u, double v)
    {
        texture.Evaluate((float)u, (float)v, out RgbW color);
        return new(color.R[0], color.G[0], color.B[0]);
    }
}
