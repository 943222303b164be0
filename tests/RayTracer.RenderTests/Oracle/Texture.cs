namespace RayTracer.RenderTests.Oracle;

/// <summary>A colour that depends on texture coordinates.</summary>
internal abstract class Texture
{
    public abstract Vec Value((double U, double V) uv);
}
