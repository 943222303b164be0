namespace RayTracer.Textbook;

/// <summary>
/// Photon mapping (Jensen, Global illumination using photon maps, 1996): paths from the lights leave photons on all surfaces but mirrors; how dense
/// they lie around what the camera sees says how bright it is. Each sample has photons of its own, and a smaller circle in which they count, so that the
/// mean becomes right in the end (Knaus &amp; Zwicker, Progressive photon mapping: a probabilistic approach, 2011).
/// </summary>
/// <param name="maxDepth">The largest number of edges of a path; below 0 for no limit.</param>
/// <param name="rouletteDepth">The number of edges after which paths may end at random.</param>
/// <param name="firstRadius">The radius of the circle in the first sample; 0 for a 200th of the scene.</param>
public sealed class PhotonIntegrator(int maxDepth, int rouletteDepth, double firstRadius) : IIntegrator
{
    // The share of its photons that the circle keeps from sample to sample (Knaus & Zwicker, eq. 15).
    private const double Kept = 2.0 / 3;
    private readonly Dictionary<(int X, int Y, int Z), List<Photon>> _cells = [];
    private double _radius;

    /// <summary>Shoots as many photons as there are pixels.</summary>
    public void BeginPass(Scene scene, int pass, int pixels, ISampler sampler)
    {
        double square = Math.Pow(firstRadius > 0 ? firstRadius : scene.Bounds.Size.Length / 200, 2);
        for (int i = 1; i <= pass; i++)
        {
            square *= (i + Kept) / (i + 1);
        }

        _radius = Math.Sqrt(square);
        _cells.Clear();
        for (int i = 0; i < pixels; i++)
        {
            LightPath path = new(scene, sampler, rouletteDepth);
            while ((maxDepth < 0 || path.Edges + 2 <= maxDepth) && path.Next())
            {
                Store(new(path.Hit.Point, path.Hit.Frame.ToWorld(path.From), path.Hit.Normal, path.Power * (1.0 / pixels), path.Edges));
            }
        }
    }

    /// <inheritdoc/>
    public Rgb Radiance(Scene scene, Ray ray, ISampler sampler) =>
        MirrorPath.Radiance(scene, ray, sampler, maxDepth, rouletteDepth, (hit, toViewer, edges) => Gather(hit, toViewer, edges));

    // The light of all photons in a circle, over its area.
    private Rgb Gather(in Hit hit, Vector toViewer, int edges)
    {
        Rgb sum = default;
        (int x, int y, int z) = Cell(hit.Point);
        for (int i = 0; i < 27; i++)
        {
            if (!_cells.TryGetValue((x + (i % 3) - 1, y + (i / 3 % 3) - 1, z + (i / 9) - 1), out List<Photon>? photons))
            {
                continue;
            }

            foreach (Photon photon in photons)
            {
                Vector off = photon.Point - hit.Point;
                bool counts = Vector.Dot(off, off) < _radius * _radius && Vector.Dot(photon.Normal, hit.Normal) > 0.5
                    && (maxDepth < 0 || photon.Edges + edges <= maxDepth);
                if (counts)
                {
                    sum += photon.Power * hit.Thing!.Material.Evaluate(hit, toViewer, hit.Frame.ToLocal(photon.From));
                }
            }
        }

        return sum * (1 / (Math.PI * _radius * _radius));
    }

    private void Store(in Photon photon)
    {
        (int, int, int) cell = Cell(photon.Point);
        if (!_cells.TryGetValue(cell, out List<Photon>? photons))
        {
            _cells.Add(cell, photons = []);
        }

        photons.Add(photon);
    }

    // Cells are as wide as the circle's diameter, so that it reaches only those around.
    private (int X, int Y, int Z) Cell(Vector p) => ((int)Math.Floor(p.X / (2 * _radius)), (int)Math.Floor(p.Y / (2 * _radius)), (int)Math.Floor(p.Z / (2 * _radius)));

    private readonly record struct Photon(Vector Point, Vector From, Vector Normal, Rgb Power, int Edges);
}
