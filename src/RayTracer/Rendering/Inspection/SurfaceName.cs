namespace RayTracer.Rendering;

/// <summary>The name of a surface that a ray meets.</summary>
/// <param name="Primitive">The primitive's number; −1 for none.</param>
/// <param name="Instance">The instance that shows it; 0 for the world itself.</param>
public readonly record struct SurfaceName(int Primitive, int Instance)
{
    /// <summary>Nothing is met.</summary>
    public static SurfaceName None => new(-1, 0);
}
