namespace Lab7;

/// <summary>Photons, sorted into the cells of a grid, so that those around a place are found without asking all.</summary>
public sealed class PhotonMap
{
    private readonly Dictionary<(int X, int Y, int Z), List<Photon>> _cells = [];
    private readonly double _radius;

    /// <summary>Sorts photons.</summary>
    /// <param name="photons">The photons.</param>
    /// <param name="radius">The radius within which they are looked for. The cells are as wide.</param>
    public PhotonMap(IEnumerable<Photon> photons, double radius)
    {
        _radius = radius;
        foreach (Photon photon in photons)
        {
            if (!_cells.TryGetValue(Cell(photon.Point, radius), out List<Photon>? cell))
            {
                _cells.Add(Cell(photon.Point, radius), cell = []);
            }

            cell.Add(photon);
        }
    }

    /// <summary>The cell that a point lies in.</summary>
    /// <param name="p">The point.</param>
    /// <param name="width">The width of a cell.</param>
    public static (int X, int Y, int Z) Cell(Vector p, double width) => ((int)Math.Floor(p.X / width), (int)Math.Floor(p.Y / width), (int)Math.Floor(p.Z / width));

    /// <summary>The photons that are nearer to a point than the radius.</summary>
    /// <param name="point">The point.</param>
    public List<Photon> Near(Vector point)
    {
        //? PhotonMap.Near: those of the point's own cell and of the 26 around it, as far as they are near enough.
        List<Photon> near = [];
        (int x, int y, int z) = Cell(point, _radius);
        for (int i = 0; i < 27; i++)
        {
            if (_cells.TryGetValue((x + (i % 3) - 1, y + (i / 3 % 3) - 1, z + (i / 9) - 1), out List<Photon>? cell))
            {
                near.AddRange(cell.Where(p => (p.Point - point).Length < _radius));
            }
        }

        return near;
        //!
    }

    /// <summary>The light of the photons around a place that the surface sends to the viewer.</summary>
    /// <param name="hit">The place.</param>
    /// <param name="toViewer">The direction to the viewer, in the surface's frame.</param>
    public Rgb Radiance(in Hit hit, Vector toViewer)
    {
        //? PhotonMap.Radiance: the sum of BSDF · power, over the area of the circle in which the photons lie.
        Rgb sum = Rgb.Black;
        foreach (Photon photon in Near(hit.Point))
        {
            sum += hit.Thing!.Material.Evaluate(hit, toViewer, hit.Frame.ToLocal(photon.From)) * photon.Power;
        }

        return sum * (1 / (Math.PI * _radius * _radius));
        //!
    }
}
