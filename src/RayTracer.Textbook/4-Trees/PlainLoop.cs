namespace RayTracer.Textbook;

/// <summary>Asks every shape: the time of a ray grows in proportion to their number.</summary>
/// <param name="shapes">The shapes.</param>
public sealed class PlainLoop(IReadOnlyList<IShape> shapes) : IAccelerator
{
    /// <inheritdoc/>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        bool isHit = false;
        for (int i = 0; i < shapes.Count; i++)
        {
            hit.Watch?.Invoke(shapes[i].Bounds.Corners, hit.Tests);
            hit.Tests++;
            if (shapes[i].Intersect(ray, ref hit))
            {
                hit.Index = i;
                isHit = true;
            }
        }

        return isHit;
    }
}
