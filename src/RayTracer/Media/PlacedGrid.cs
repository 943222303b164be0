using System.Runtime.CompilerServices;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Media;

/// <summary>A grid in the world, and its numbers between its points. In voxels, point i stands at i + ½.</summary>
/// <param name="grid">The grid.</param>
/// <param name="place">The map from the unit cube to the box that it fills in the world.</param>
/// <param name="interpolation">How numbers between points are found.</param>
/// <param name="wrapping">What is beyond the outermost points.</param>
internal sealed unsafe class PlacedGrid(VolumeGrid grid, Transform place, GridInterpolation interpolation, Wrapping wrapping)
{
    // Places that are computed on the way along a ray differ from where the ray is by less than this, in voxels.
    private const float Slack = 0.01f;
    private readonly float* _values = grid.Memory.Pointer;
    private readonly int _stride = grid.Channels;

    /// <summary>The grid.</summary>
    public VolumeGrid Grid => grid;

    /// <summary>The map from the world to voxels.</summary>
    public Transform ToVoxels { get; } = Transform.Scaling(new(grid.Width, grid.Height, grid.Depth)) * place.Inverse();

    /// <summary>The map from voxels to the world.</summary>
    public Transform FromVoxels { get; } = place * Transform.Scaling(new(1f / grid.Width, 1f / grid.Height, 1f / grid.Depth));

    /// <summary>The numbers at points; all three are the same where the grid has one channel.</summary>
    /// <param name="at">The points, in voxels.</param>
    /// <param name="value">The numbers.</param>
    public void Value(in Vec3W at, out RgbW value) => Value(at, _values, out value);

    /// <summary>The numbers of symmetric matrices at points, of a grid that has six channels.</summary>
    /// <param name="at">The points, in voxels.</param>
    /// <param name="diagonal">xx, yy and zz.</param>
    /// <param name="beside">xy, xz and yz.</param>
    public void Matrix(in Vec3W at, out RgbW diagonal, out RgbW beside)
    {
        Value(at, _values, out diagonal);
        Value(at, _values + 3, out beside);
    }

    private void Value(in Vec3W at, float* values, out RgbW value)
    {
        if (interpolation == GridInterpolation.Nearest)
        {
            UIntW point = Row(FloatW.Floor(at.Z), grid.Depth, (uint)(grid.Width * grid.Height * _stride))
                + Row(FloatW.Floor(at.Y), grid.Height, (uint)(grid.Width * _stride)) + Row(FloatW.Floor(at.X), grid.Width, (uint)_stride);
            value = _stride == 1 ? Same(FloatW.Gather(values, point)) : RgbW.Gather(values, point);
            return;
        }

        Between(at.X, grid.Width, (uint)_stride, out UIntW x0, out UIntW x1, out FloatW x);
        Between(at.Y, grid.Height, (uint)(grid.Width * _stride), out UIntW y0, out UIntW y1, out FloatW y);
        Between(at.Z, grid.Depth, (uint)(grid.Width * grid.Height * _stride), out UIntW z0, out UIntW z1, out FloatW z);
        UIntW a = y0 + z0;
        UIntW b = y1 + z0;
        UIntW c = y0 + z1;
        UIntW d = y1 + z1;
        if (_stride > 1)
        {
            RgbW Line(UIntW row) => RgbW.Mix(RgbW.Gather(values, row + x0), RgbW.Gather(values, row + x1), x);
            value = RgbW.Mix(RgbW.Mix(Line(a), Line(b), y), RgbW.Mix(Line(c), Line(d), y), z);
        }
        else if (UIntW.Equal(x1, x0 + 1u).Bits == MaskW.All.Bits)
        {
            FloatW Line(UIntW row)
            {
                FloatW.Gather(values, row, out FloatW low, out FloatW high);
                return FloatW.Mix(low, high, x);
            }

            value = Same(FloatW.Mix(FloatW.Mix(Line(a + x0), Line(b + x0), y), FloatW.Mix(Line(c + x0), Line(d + x0), y), z));
        }
        else
        {
            // Where the grid ends.
            FloatW Line(UIntW row) => FloatW.Mix(FloatW.Gather(values, row + x0), FloatW.Gather(values, row + x1), x);
            value = Same(FloatW.Mix(FloatW.Mix(Line(a), Line(b), y), FloatW.Mix(Line(c), Line(d), y), z));
        }
    }

    /// <summary>The least and the most that a channel comes to in a block of voxels, or a little beside it.</summary>
    /// <param name="channel">The channel.</param>
    /// <param name="x">First and last voxel along x.</param>
    /// <param name="y">The same along y.</param>
    /// <param name="z">The same along z.</param>
    public (float Least, float Most) Range(int channel, (int First, int Last) x, (int First, int Last) y, (int First, int Last) z)
    {
        (float least, float most) = (float.PositiveInfinity, 0);
        foreach (long k in Points(z, grid.Depth))
        {
            foreach (long j in Points(y, grid.Height))
            {
                foreach (long i in Points(x, grid.Width))
                {
                    float value = _values[(((((k * grid.Height) + j) * grid.Width) + i) * _stride) + channel];
                    (least, most) = (float.Min(least, value), float.Max(most, value));
                }
            }
        }

        return (least, most);
    }

    // The points on which numbers within some voxels depend.
    private List<int> Points((int First, int Last) voxels, int count)
    {
        float half = interpolation == GridInterpolation.Nearest ? 0 : 0.5f;
        int first = (int)float.Floor(voxels.First - half - Slack);
        int last = (int)float.Floor(voxels.Last + 1 - half + Slack) + (half > 0 ? 1 : 0);
        List<int> points = [];
        for (int i = first; i <= last; i++)
        {
            points.Add((int)wrapping.Index(i, count)[0] is var wrapped ? int.Clamp(wrapped, 0, count - 1) : 0);
        }

        return points;
    }

    private void Between(FloatW at, int count, uint stride, out UIntW low, out UIntW high, out FloatW part)
    {
        FloatW fromFirst = at - 0.5f;
        FloatW first = FloatW.Floor(fromFirst);
        part = fromFirst - first;
        low = Row(first, count, stride);
        high = Row(first + 1f, count, stride);
    }

    // The clamp also catches what is no number, so that no lane can read outside the grid.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private UIntW Row(FloatW i, int count, uint stride) => FloatW.Max(0f, FloatW.Min(wrapping.Index(i, count), count - 1)).ToIntInRange() * stride;

    private static RgbW Same(FloatW value) => new(value, value, value);
}
