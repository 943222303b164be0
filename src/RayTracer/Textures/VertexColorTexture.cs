using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Textures;

/// <summary>Describes a <see cref="VertexColorTexture"/>.</summary>
[SceneType("vertexColor", "The colours of a mesh's corners, linear in between; white on shapes without any. Where a material uses it, "
    + "these colours do not also tint its diffuse colour.")]
public sealed record VertexColorTextureDescription : TextureDescription
{
    /// <summary>True for the second colours of the mesh.</summary>
    [Parameter("Whether it shows the mesh's second colours, its secondColorAttribute.")]
    public bool Second { get; init; }

    /// <inheritdoc/>
    public override Texture Build(SceneBuilder builder) => Second ? new SecondColorTexture() : new VertexColorTexture();
}

/// <summary>The colours of a mesh's corners.</summary>
internal sealed class VertexColorTexture() : Texture(TextureInputs.VertexColor)
{
    /// <inheritdoc/>
    public override void Evaluate(in TexturePointW at, out RgbW color) => color = at.VertexColor;
}

/// <summary>The second colours of a mesh's corners.</summary>
internal sealed class SecondColorTexture() : Texture(TextureInputs.VertexColor | TextureInputs.SecondColor)
{
    /// <inheritdoc/>
    public override void Evaluate(in TexturePointW at, out RgbW color) => color = at.SecondColor;
}
