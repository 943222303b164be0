using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Media;

/// <summary>
/// Rays on their way through the cells of a <see cref="VaryingMedium"/> (Amanatides &amp; Woo 1987), in voxels; lengths along them are those of the world. In each
/// cell, places at which something may happen come with a constant density per length (Woodcock et al. 1965).
/// </summary>
internal unsafe struct FlightW
{
    // No direction is quite along an axis, so that no difference of nothing is divided by nothing.
    private const float Least = 1e-18f;

    /// <summary>Where rays meet the box.</summary>
    public Vec3W Origin;

    /// <summary>Their directions, of which the world's have length 1.</summary>
    public Vec3W Direction;

    /// <summary>How far the box is from where rays start.</summary>
    public FloatW Before;

    /// <summary>How far they go from <see cref="Origin"/>.</summary>
    public FloatW End;

    /// <summary>How far they have come.</summary>
    public FloatW At;

    /// <summary>The cells, as whole numbers in floats.</summary>
    public FloatW CellX, CellY, CellZ;

    /// <summary>The optical depth of majorants to the next place.</summary>
    public FloatW Depth;

    /// <summary>The density of places in the cells.</summary>
    public FloatW Rate;

    /// <summary>The least extinction in the cells.</summary>
    public FloatW Base;

    /// <summary>The optical depth of that least extinction on the way so far; kept only where it counts.</summary>
    public FloatW BaseDepth;

    /// <summary>The keys of the random numbers.</summary>
    public UIntW Key;

    /// <summary>How many of them were drawn.</summary>
    public UIntW Drawn;

    /// <summary>Turns to rays in the world.</summary>
    /// <param name="medium">The medium.</param>
    /// <param name="origin">Where they start.</param>
    /// <param name="direction">Their unit directions.</param>
    /// <param name="distance">How far they go.</param>
    /// <returns>Those that meet the box.</returns>
    public MaskW Begin(VaryingMedium medium, in Vec3W origin, in Vec3W direction, in FloatW distance)
    {
        medium.ToVoxels.Point(origin, out Vec3W from);
        medium.ToVoxels.Vector(direction, out Vec3W along);
        Direction = new(OffAxis(along.X), OffAxis(along.Y), OffAxis(along.Z));
        FloatW near = 0f;
        FloatW far = distance;
        Clip(from.X, Direction.X, medium.Size.X, ref near, ref far);
        Clip(from.Y, Direction.Y, medium.Size.Y, ref near, ref far);
        Clip(from.Z, Direction.Z, medium.Size.Z, ref near, ref far);
        MaskW meets = near < far;
        Before = near;
        End = meets.Select(far - near, 0f);
        Origin = Vec3W.MultiplyAdd(Direction, near, from);
        At = 0f;
        BaseDepth = 0f;
        CellX = First(Origin.X, medium.CellSize, medium.CellCounts.X);
        CellY = First(Origin.Y, medium.CellSize, medium.CellCounts.Y);
        CellZ = First(Origin.Z, medium.CellSize, medium.CellCounts.Z);
        return meets;
    }

    /// <summary>Goes on, each ray to the next place or to its end.</summary>
    /// <param name="medium">The medium.</param>
    /// <param name="among">The rays.</param>
    /// <param name="aboveBase">True where the places are those of the extinction beyond the least one in each cell.</param>
    /// <returns>Those that have come to a place.</returns>
    public MaskW Seek(VaryingMedium medium, MaskW among, bool aboveBase)
    {
        float size = medium.CellSize;
        (int nx, int ny, int nz) = medium.CellCounts;
        Vec3W inverse = new(1f / Direction.X, 1f / Direction.Y, 1f / Direction.Z);
        FloatW stepX = FloatW.CopySign(1f, Direction.X);
        FloatW stepY = FloatW.CopySign(1f, Direction.Y);
        FloatW stepZ = FloatW.CopySign(1f, Direction.Z);
        Vec3W ahead = new(FloatW.Max(stepX, 0f), FloatW.Max(stepY, 0f), FloatW.Max(stepZ, 0f));
        FloatW area = medium.LargestArea(Direction);
        (FloatW cellX, FloatW cellY, FloatW cellZ, FloatW at, FloatW depth) = (CellX, CellY, CellZ, At, Depth);
        MaskW arrived = MaskW.None;
        for (MaskW going = among; going.Any;)
        {
            FloatW nextX = FloatW.MultiplyAdd(cellX + ahead.X, size, -Origin.X) * inverse.X;
            FloatW nextY = FloatW.MultiplyAdd(cellY + ahead.Y, size, -Origin.Y) * inverse.Y;
            FloatW nextZ = FloatW.MultiplyAdd(cellZ + ahead.Z, size, -Origin.Z) * inverse.Z;
            FloatW border = FloatW.Min(nextX, FloatW.Min(nextY, nextZ));
            FloatW next = FloatW.Max(FloatW.Min(border, End), at);
            UIntW cell = FloatW.MultiplyAdd(FloatW.MultiplyAdd(cellZ, ny, cellY), nx, cellX).ToIntInRange();
            FloatW rate = FloatW.Gather(medium.Most, cell) * area;
            FloatW least = 0f;
            if (aboveBase)
            {
                least = FloatW.Gather(medium.Least, cell) * area;
                rate -= least;
            }

            FloatW crossed = rate * (next - at);
            MaskW arrives = going & (depth < crossed);
            FloatW to = arrives.Select(FloatW.Min(at + (depth / rate), next), next);
            if (aboveBase)
            {
                BaseDepth = going.Select(FloatW.MultiplyAdd(least, to - at, BaseDepth), BaseDepth);
                Base = going.Select(least, Base);
            }

            Rate = going.Select(rate, Rate);
            at = going.Select(to, at);
            depth = going.Select(arrives.Select(0f, depth - crossed), depth);
            arrived |= arrives;
            going = going.Except(arrives) & (border < End);
            MaskW alongX = going & (nextX <= border);
            MaskW alongY = going.Except(alongX) & (nextY <= border);
            MaskW alongZ = going.Except(alongX).Except(alongY);
            cellX += alongX.Select(stepX, 0f);
            cellY += alongY.Select(stepY, 0f);
            cellZ += alongZ.Select(stepZ, 0f);
            going &= (cellX >= 0f) & (cellX < nx) & (cellY >= 0f) & (cellY < ny) & (cellZ >= 0f) & (cellZ < nz);
        }

        // Rays that have left stay in some cell, whose number is a valid one.
        CellX = FloatW.Max(0f, FloatW.Min(cellX, nx - 1));
        CellY = FloatW.Max(0f, FloatW.Min(cellY, ny - 1));
        CellZ = FloatW.Max(0f, FloatW.Min(cellZ, nz - 1));
        (At, Depth) = (at, depth);
        return arrived;
    }

    /// <summary>The places, in voxels.</summary>
    public readonly Vec3W Place() => Vec3W.MultiplyAdd(Direction, At, Origin);

    /// <summary>The next random numbers of some of the rays, in [0, 1).</summary>
    public FloatW Draw(in MaskW among)
    {
        Drawn += among.Select((UIntW)1u, 0u);
        return Hash.Mix(Key + (Drawn * Hash.Golden)).ToUnit();
    }

    /// <summary>The optical depth to the next place.</summary>
    public static FloatW DepthOf(in FloatW u) => -LaneMath.Log(1f - u);

    private static FloatW OffAxis(in FloatW along) => (FloatW.Abs(along) < Least).Select(FloatW.CopySign(Least, along), along);

    private static void Clip(in FloatW from, in FloatW along, int size, ref FloatW near, ref FloatW far)
    {
        FloatW inverse = 1f / along;
        FloatW one = -from * inverse;
        FloatW other = (size - from) * inverse;
        near = FloatW.Max(near, FloatW.Min(one, other));
        far = FloatW.Min(far, FloatW.Max(one, other));
    }

    private static FloatW First(in FloatW at, int size, int count) => FloatW.Max(0f, FloatW.Min(FloatW.Floor(at * (1f / size)), count - 1));
}
