namespace Lab2;

/// <summary>Asks every shape.</summary>
/// <param name="shapes">The shapes.</param>
public sealed class Loop(IReadOnlyList<IShape> shapes) : IAccelerator
{
    /// <inheritdoc/>
    public bool Intersect(in Ray ray, ref Hit hit)
    {
        //? Loop.Intersect: let each shape look for a hit nearer than hit.Distance; keep the number of the last one that finds some in hit.Index.
        bool isHit = false;
        for (int i = 0; i < shapes.Count; i++)
        {
            if (shapes[i].Intersect(ray, ref hit))
            {
                hit.Index = i;
                isHit = true;
            }
        }

        return isHit;
        //!
    }
}
