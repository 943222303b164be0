using System.Numerics;
using System.Runtime.InteropServices;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// What the paths of some samples see of what is behind everything, for <see cref="FilmPlane.Alpha"/>: a path sees it where it leaves the scene
/// and has met nothing, or has only gone straight through things or been refracted by smooth ones. What stands for a thing of a photograph
/// (<see cref="MatteRole"/>) is seen as behind everything where a path has come straight to it.
/// </summary>
internal sealed unsafe class Backdrop : PathObserver
{
    // Of a path: what it has seen, how much comes through what it has passed, and the light that it found behind all, or had gathered before what is matte.
    private const int Columns = 5;

    // What a path has seen, in the order in which it cannot be taken back.
    private const float Bent = 1;
    private const float Thing = 2;
    private const float Holdout = 3;
    private const float Catcher = 4;
    // The cosine of less than a hundredth of a degree.
    private const float Straight = 1 - 1e-6f;
    private PinnedBuffer<float> _numbers = new(0);
    private int _room;

    private float* Seen => _numbers.Pointer;

    private float* Through => Seen + _room;

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
        Mark(UIntW.Pick(stream.Path, index), alive.Except(passes), Thing);
        Mark(UIntW.Pick(stream.Path, index), alive & passes & (Vec3W.Dot(scatter.Direction, surface.Incoming) < Straight), Bent);
    }

    /// <inheritdoc/>
    public override void Met(ShadingGroup group, PathStream stream, uint* index, in MaskW lanes)
    {
        if (group.Traits.Matte == MatteRole.None)
        {
            return;
        }

        float seen = group.Traits.Matte == MatteRole.Holdout ? Holdout : Catcher;
        RgbW before = stream.PickRadiance(index);
        RgbW throughput = stream.PickThroughput(index);
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            uint path = stream.Path[index[lane]];
            if (Seen[path] == 0)
            {
                Seen[path] = seen;
                Put(path, lane, throughput, before);
            }
        }
    }

    /// <inheritdoc/>
    public override void ScatteredInMedium(PathStream stream, uint* index, in MaskW active, in MaskW alive, in Vec3W point, in FloatW pdf) =>
        Mark(UIntW.Pick(stream.Path, index), alive, Thing);

    /// <inheritdoc/>
    public override void Missed(PathStream stream, uint* index, in MaskW lanes, in RgbW arriving)
    {
        RgbW throughput = stream.PickThroughput(index);
        RgbW light = throughput * arriving;
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            uint path = stream.Path[index[lane]];
            if (Seen[path] <= Bent)
            {
                Put(path, lane, throughput, light);
            }
        }
    }

    /// <summary>Returns what paths that have ended saw behind all.</summary>
    /// <param name="path">The paths' numbers.</param>
    /// <param name="gathered">All the light that they have gathered.</param>
    /// <param name="through">The share that comes through what they have passed; 0 where they saw something.</param>
    /// <param name="light">The light; black where they saw something.</param>
    /// <returns>The lanes that saw a shadow catcher.</returns>
    public MaskW Pick(in UIntW path, in RgbW gathered, out FloatW through, out RgbW light)
    {
        through = FloatW.Gather(Through, path);
        light = new(FloatW.Gather(Light, path), FloatW.Gather(Light + _room, path), FloatW.Gather(Light + (2 * _room), path));
        FloatW seen = FloatW.Gather(Seen, path);
        light = (seen >= Holdout).Select(gathered + (light * -1f), light);
        return seen >= Catcher;
    }

    private void Put(uint path, int lane, in RgbW throughput, in RgbW light)
    {
        Through[path] = (throughput.R[lane] + throughput.G[lane] + throughput.B[lane]) * (1f / 3f);
        Light[path] = light.R[lane];
        Light[path + _room] = light.G[lane];
        Light[path + (2 * _room)] = light.B[lane];
    }

    // What stands for a thing of a photograph stays what was seen first.
    private void Mark(in UIntW path, MaskW lanes, float seen)
    {
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            ref float own = ref Seen[path[BitOperations.TrailingZeroCount(rest)]];
            own = own < Holdout && own < seen ? seen : own;
        }
    }
}
