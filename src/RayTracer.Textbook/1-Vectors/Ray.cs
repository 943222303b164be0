namespace RayTracer.Textbook;

/// <summary>A half-line: all points Origin + t·Direction with t above 0.</summary>
/// <param name="Origin">Where it starts.</param>
/// <param name="Direction">Where it goes; of length 1, unless a shape sees it in its own space.</param>
public readonly record struct Ray(Vector Origin, Vector Direction)
{
    /// <summary>The point at t.</summary>
    public Vector At(double t) => Origin + (t * Direction);
}
