using RayTracer.Numerics;
using RayTracer.Spectra;

namespace RayTracer.Media;

/// <summary>The temperatures of a medium that glows.</summary>
/// <param name="grid">Numbers in space.</param>
/// <param name="offset">What is subtracted from them.</param>
/// <param name="scale">Then, kelvins for each unit.</param>
/// <param name="density">The grid in whose voxels places are given.</param>
internal sealed class MediumHeat(PlacedGrid grid, float offset, float scale, PlacedGrid density)
{
    private readonly AffineW _toGrid = new(grid.ToVoxels * density.FromVoxels);

    /// <summary>The colours of black bodies of the temperatures at places, 1 at the wavelength of most radiance; black outside of the box of the temperatures.</summary>
    /// <param name="at">The places, in voxels of the density.</param>
    public RgbW Color(in Vec3W at)
    {
        _toGrid.Point(at, out Vec3W there);
        grid.Value(there, out RgbW value);
        FloatW kelvins = (value.R - offset) * scale;
        MaskW within = Within(there.X, grid.Grid.Width) & Within(there.Y, grid.Grid.Height) & Within(there.Z, grid.Grid.Depth);
        return BlackBody.Color(within.Select(kelvins, 0f));
    }

    private static MaskW Within(FloatW at, int count) => (at >= 0f) & (at <= count);
}
