using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="VertexColorTexture"/>.</summary>
[SceneType("vertexColor", "The colours of a mesh's corners, linear in between; white on shapes without any. Where a material uses it, "
    + "these colours do not also tint its diffuse colour.")]
public sealed record VertexColorTextureDescription : TextureDescription
{
    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => new VertexColorTexture();
}

/// <summary>The colours of a mesh's corners.</summary>
internal sealed class VertexColorTexture() : Texture(TextureInputs.VertexColor)
{
    /// <inheritdoc/>
    public override void Evaluate(in TexturePointW at, out RgbW color) => color = at.VertexColor;
}
