using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Media;

/// <summary>
/// A medium whose density varies: its extinction is that of an even one times a grid, within the grid's box, and nothing outside. Its majorants, the most extinction
/// that there is, stand on a coarse grid of cells, so that rays need not look closely where there is little (Novák, Selle &amp; Jarosz 2014).
/// </summary>
internal sealed unsafe class VaryingMedium
{
    // So many cells along the longest side, or up to twice as many.
    private const int Cells = 32;

    // Where a medium shines but lets light through, places still come this often in a cell, on average.
    private const float PlacesInCell = 0.5f;
    private readonly PlacedGrid _density;
    private readonly PlacedGrid? _albedos;
    private readonly PinnedBuffer<float> _most;
    private readonly PinnedBuffer<float> _least;
    private readonly PlacedGrid? _lights;
    private readonly Microflakes? _flakes;
    private readonly AffineW _fromVoxels;
    private readonly AffineW _toAlbedos;
    private readonly AffineW _toLights;
    private readonly Rgb _extinction;
    private readonly Rgb _albedo;
    private readonly Rgb _emission;
    private readonly float _leastRate;

    /// <summary>Makes the medium.</summary>
    /// <param name="density">The density, by which the extinction is multiplied.</param>
    /// <param name="albedos">Factors on the albedo; null for none.</param>
    /// <param name="extinction">The extinction where the density is 1.</param>
    /// <param name="albedo">The part of the extinction that is scattered.</param>
    /// <param name="emission">The light sent for each unit of length, where the density is 1.</param>
    /// <param name="lights">Factors on that instead of the density; null for none.</param>
    /// <param name="flakes">The flakes that it consists of; null for none.</param>
    public VaryingMedium(PlacedGrid density, PlacedGrid? albedos, Rgb extinction, Rgb albedo, Rgb emission = default, PlacedGrid? lights = null, Microflakes? flakes = null)
    {
        (_density, _albedos, _extinction, _albedo) = (density, albedos, extinction, albedo);
        (_emission, _lights, _flakes, _fromVoxels) = (emission, lights, flakes, new(density.FromVoxels));
        VolumeGrid grid = density.Grid;
        Size = (grid.Width, grid.Height, grid.Depth);
        Largest = float.Max(extinction.R, float.Max(extinction.G, extinction.B));
        IsGrey = grid.Channels == 1 && extinction.R == extinction.G && extinction.R == extinction.B;
        ToVoxels = new(density.ToVoxels);
        _toAlbedos = new((albedos?.ToVoxels ?? Transform.Identity) * density.FromVoxels);
        _toLights = new((lights?.ToVoxels ?? Transform.Identity) * density.FromVoxels);
        CellSize = 1;
        while (int.Max(Size.X, int.Max(Size.Y, Size.Z)) > 2 * Cells * CellSize)
        {
            CellSize *= 2;
        }

        CellCounts = ((Size.X + CellSize - 1) / CellSize, (Size.Y + CellSize - 1) / CellSize, (Size.Z + CellSize - 1) / CellSize);
        long cells = (long)CellCounts.X * CellCounts.Y * CellCounts.Z;
        (_most, _least) = (new(cells), new(cells));
        Vector3[] sides = [.. ((Vector3[])[Vector3.UnitX, Vector3.UnitY, Vector3.UnitZ]).Select(s => density.FromVoxels.Vector(s * CellSize))];
        _leastRate = Emits ? PlacesInCell / sides.Min(s => s.Norm()) : 0;
        Parallel.For(0, CellCounts.Z, FillCells);
    }

    /// <summary>The points of the density along each axis.</summary>
    public (int X, int Y, int Z) Size { get; }

    /// <summary>The sides of a cell, in voxels.</summary>
    public int CellSize { get; }

    /// <summary>The cells along each axis.</summary>
    public (int X, int Y, int Z) CellCounts { get; }

    /// <summary>The largest of the extinction's channels where the density is 1.</summary>
    public float Largest { get; }

    /// <summary>True where all channels are alike.</summary>
    public bool IsGrey { get; }

    /// <summary>True where some light is scattered.</summary>
    public bool Scatters => !_albedo.IsBlack;

    /// <summary>True where it sends light itself.</summary>
    public bool Emits => !_emission.IsBlack;

    /// <summary>Its temperatures, which colour what it sends; null for none.</summary>
    public MediumHeat? Heat { get; init; }

    /// <summary>The map from the world to voxels.</summary>
    public AffineW ToVoxels { get; }

    /// <summary>The most extinction of any channel in each cell, per scene unit; times <see cref="LargestArea"/>.</summary>
    public float* Most => _most.Pointer;

    /// <summary>The least extinction in each cell, of the largest channel; 0 where channels have densities of their own, or flakes depend on the place. Times <see cref="LargestArea"/>.</summary>
    public float* Least => _least.Pointer;

    /// <summary>Extinction over its largest channel, where channels have no densities of their own.</summary>
    public Rgb Share => Largest > 0 ? _extinction * (1 / Largest) : Rgb.White;

    /// <summary>A factor on the most and the least extinction, along directions in voxels.</summary>
    public FloatW LargestArea(in Vec3W along)
    {
        if (_flakes is null)
        {
            return 1f;
        }

        _fromVoxels.Vector(along, out Vec3W direction);
        return _flakes.LargestArea(direction);
    }

    /// <summary>The extinction at points in voxels, along directions in voxels.</summary>
    public void Extinction(in Vec3W at, in Vec3W along, out RgbW extinction)
    {
        _density.Value(at, out extinction);
        extinction *= _extinction;
        if (_flakes is not null)
        {
            _fromVoxels.Point(at, out Vec3W point);
            _fromVoxels.Vector(along, out Vec3W direction);
            extinction *= _flakes.Area(point, direction);
        }
    }

    /// <summary>The albedo at points in voxels of the density.</summary>
    public void Albedo(in Vec3W at, out RgbW albedo)
    {
        albedo = _albedo;
        if (_albedos is not null)
        {
            _toAlbedos.Point(at, out Vec3W there);
            _albedos.Value(there, out RgbW factor);
            albedo = new(FloatW.Min(albedo.R * factor.R, 1f), FloatW.Min(albedo.G * factor.G, 1f), FloatW.Min(albedo.B * factor.B, 1f));
        }
    }

    /// <summary>The light sent for each unit of length, at points in voxels of the density.</summary>
    public void Emission(in Vec3W at, out RgbW emission)
    {
        if (_lights is null)
        {
            _density.Value(at, out emission);
        }
        else
        {
            _toLights.Point(at, out Vec3W there);
            _lights.Value(there, out emission);
        }

        emission *= _emission;
        if (Heat is not null)
        {
            emission *= Heat.Color(at);
        }
    }

    private void FillCells(int z)
    {
        (int, int) Voxels(int cell, int count) => (cell * CellSize, int.Min((cell + 1) * CellSize, count) - 1);
        for (int y = 0; y < CellCounts.Y; y++)
        {
            for (int x = 0; x < CellCounts.X; x++)
            {
                int cell = x + (CellCounts.X * (y + (CellCounts.Y * z)));
                (float r, float g, float b) = (_extinction.R, _extinction.G, _extinction.B);
                bool shines = false;
                for (int channel = 0; channel < _density.Grid.Channels; channel++)
                {
                    (float least, float most) = _density.Range(channel, Voxels(x, Size.X), Voxels(y, Size.Y), Voxels(z, Size.Z));
                    float factor = _density.Grid.Channels == 1 ? Largest : channel == 0 ? r : channel == 1 ? g : b;
                    _most.Pointer[cell] = float.Max(_most.Pointer[cell], most * factor);
                    _least.Pointer[cell] = _density.Grid.Channels == 1 && _flakes is not { Vary: true } ? least * factor : 0;
                    shines |= Emits && (_lights is not null || most > 0);
                }

                _most.Pointer[cell] = shines ? float.Max(_most.Pointer[cell], _leastRate) : _most.Pointer[cell];
            }
        }
    }
}

/// <summary>An affine map of lanes, in single precision.</summary>
/// <param name="map">The map.</param>
internal sealed unsafe class AffineW(Transform map)
{
    private readonly PinnedBuffer<float> _rows = Rows(map);

    /// <summary>The images of points.</summary>
    public void Point(in Vec3W p, out Vec3W image)
    {
        float* m = _rows.Pointer;
        Vector(p, out image);
        image += new Vec3W(m[3], m[7], m[11]);
    }

    /// <summary>The images of differences of points.</summary>
    public void Vector(in Vec3W v, out Vec3W image)
    {
        float* m = _rows.Pointer;
        image = new(Vec3W.Dot(v, new(m[0], m[1], m[2])), Vec3W.Dot(v, new(m[4], m[5], m[6])), Vec3W.Dot(v, new(m[8], m[9], m[10])));
    }

    private static PinnedBuffer<float> Rows(Transform map)
    {
        PinnedBuffer<float> rows = new(12);
        map.Write(rows.Pointer);
        return rows;
    }
}
