namespace RayTracer.RenderTests.Oracle;

/// <summary>A chess board.</summary>
internal sealed class CheckerTexture(Texture even, Texture odd, (double U, double V) scale, (double U, double V) offset) : Texture
{
    public override Vec Value(Shape shape, Vec point)
    {
        (double U, double V) uv = shape.Uv(point);
        double column = Math.Floor((uv.U * scale.U) + offset.U);
        double row = Math.Floor((uv.V * scale.V) + offset.V);
        return ((column + row) % 2 == 0 ? even : odd).Value(shape, point);
    }
}
