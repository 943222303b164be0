using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// What the paths of some samples see of what is behind everything, for <see cref="FilmPlane.Alpha"/>: a path sees it where it leaves the scene
/// and has met nothing, or has only gone straight through things or been refracted by smooth ones.
/// </summary>
internal sealed unsafe class Backdrop : PathObserver
{
    // Of a path: whether it has seen a thing, how much comes through what it has passed, and the light that it found behind all.
    private const int Columns = 5;
    private PinnedBuffer<float> _numbers = new(0);
    private int _room;

    private float* HasSeen => _numbers.Pointer;

    private float* Through => HasSeen + _room;

    private float* Light => Through + _room;

    /// <summary>Forgets all paths.</summary>
    /// <param name="paths">Their number.</param>
    public void Begin(int paths)
    {
        if (paths > _room)
        {
            _numbers = new((long)paths * Columns);
            _room = paths;
        }

        NativeMemory.Clear(_numbers.Pointer, (nuint)_room * Columns * sizeof(float));
    }

    /// <inheritdoc/>
    public override void Scattered(
        PathStream stream, uint* index, in MaskW active, in MaskW alive, Material material, in SurfaceW surface, in ScatterW scatter, bool isByLobe)
    {
        MaskW passes = scatter.Delta & (Vec3W.Dot(scatter.Direction, surface.Facing) < 0f);
        Mark(UIntW.Pick(stream.Path, index), alive.Except(passes));
    }

    /// <inheritdoc/>
    public override void ScatteredInMedium(PathStream stream, uint* index, in MaskW active, in MaskW alive, in Vec3W point, in FloatW pdf) =>
        Mark(UIntW.Pick(stream.Path, index), alive);

    /// <inheritdoc/>
    public override void Missed(PathStream stream, uint* index, in MaskW lanes, in RgbW arriving)
    {
        RgbW throughput = stream.PickThroughput(index);
        RgbW light = throughput * arriving;
        FloatW through = (throughput.R + throughput.G + throughput.B) * (1f / 3f);
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            uint path = stream.Path[index[lane]];
            if (HasSeen[path] == 0)
            {
                Through[path] = through[lane];
                Light[path] = light.R[lane];
                Light[path + _room] = light.G[lane];
                Light[path + (2 * _room)] = light.B[lane];
            }
        }
    }

    /// <summary>Returns what paths that have ended saw behind all.</summary>
    /// <param name="path">The paths' numbers.</param>
    /// <param name="through">The share that comes through what they have passed; 0 where they saw something.</param>
    /// <param name="light">The light; black where they saw something.</param>
    public void Pick(in UIntW path, out FloatW through, out RgbW light)
    {
        through = FloatW.Gather(Through, path);
        light = new(FloatW.Gather(Light, path), FloatW.Gather(Light + _room, path), FloatW.Gather(Light + (2 * _room), path));
    }

    private void Mark(in UIntW path, MaskW seen)
    {
        for (uint rest = seen.Bits; rest != 0; rest &= rest - 1)
        {
            HasSeen[path[BitOperations.TrailingZeroCount(rest)]] = 1;
        }
    }
}
