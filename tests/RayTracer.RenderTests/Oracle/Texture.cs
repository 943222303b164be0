namespace RayTracer.RenderTests.Oracle;

/// <summary>A colour that depends on texture coordinates.</summary>
internal abstract class Texture
{
    public abstract Vec Value(Shape shape, Vec point);
}
