namespace RayTracer.Textbook;

/// <summary>
/// Finds what a ray meets among many shapes. All of them give the same hits, and differ in how many shapes they ask: a loop asks every one, a tree
/// those that are near the ray (report, section 3.5). Their constructors take the shapes, whose boxes must be finite.
/// </summary>
public interface IAccelerator
{
    /// <summary>
    /// Finds the nearest hit. Where that is nearer than <see cref="Hit.Distance"/>, this is set, and <see cref="Hit.Index"/> to the number of the shape.
    /// Nodes and shapes on the way are counted in <see cref="Hit.Visits"/> and <see cref="Hit.Tests"/>.
    /// </summary>
    /// <param name="ray">The ray.</param>
    /// <param name="hit">The nearest hit so far.</param>
    /// <returns>True where it was changed.</returns>
    bool Intersect(in Ray ray, ref Hit hit);
}
