using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Testing;

/// <summary>A texture whose colour is (u, v, 1): it shows where it was evaluated.</summary>
internal sealed class UvTexture : Texture
{
    /// <inheritdoc/>
    public override void Evaluate(in TexturePointW at, out RgbW color) => color = new(at.U, at.V, 1f);
}
