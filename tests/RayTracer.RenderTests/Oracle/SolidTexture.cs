namespace RayTracer.RenderTests.Oracle;

/// <summary>The same colour everywhere.</summary>
internal sealed class SolidTexture(Vec color) : Texture
{
    public override Vec Value(Shape shape, Vec point) => color;
}
