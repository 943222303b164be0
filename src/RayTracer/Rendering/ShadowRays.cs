using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Lights;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Rays that ask whether anything stands in a way, kept until there are many: a tree is searched faster by many rays than by few. Each has a load, which
/// counts where it is free, and a number for whom that is.
/// </summary>
/// <param name="scene">The scene.</param>
/// <param name="capacity">The most rays.</param>
internal sealed unsafe class ShadowRays(Scene scene, int capacity)
{
    private const int Columns = 16;
    private const int LoadColumn = 8;
    private const int InstanceColumn = 12;
    private readonly int _stride = capacity + 48;
    private readonly LightSource[] _lights = [.. scene.SampledLights];

    // Of rays: origin, direction, distance, time, load (four numbers), and where there are instances, that of the start, and where in its space.
    private readonly PinnedBuffer<float> _rays = new((long)Columns * (capacity + 48));
    private readonly PinnedBuffer<uint> _owners = new(capacity + 48);
    private readonly PinnedBuffer<int> _lightOf = new(capacity + 48);
    private readonly PinnedBuffer<int> _hits = new(capacity + 48);

    /// <summary>The number of rays.</summary>
    public int Count { get; private set; }

    /// <summary>After <see cref="Trace"/>: what stands in the way of each; negative for nothing.</summary>
    public int* Hits => _hits.Pointer;

    /// <summary>For whom each ray is.</summary>
    public uint* Owners => _owners.Pointer;

    /// <summary>Returns whether so many more rays have room.</summary>
    public bool HasRoomFor(int rays) => Count + rays <= capacity;

    /// <summary>Adds rays.</summary>
    /// <param name="lanes">The lanes.</param>
    /// <param name="origin">The points from which they start.</param>
    /// <param name="instance">The instances on which they start; 0 for none.</param>
    /// <param name="inner">Those points in the instances' spaces.</param>
    /// <param name="direction">Their unit directions.</param>
    /// <param name="distance">The distances that must be free.</param>
    /// <param name="time">Their times in seconds; used only where something moves.</param>
    /// <param name="light">Number of the light that does not stand in its own way; −1 where there is none.</param>
    /// <param name="load">Three numbers of the load.</param>
    /// <param name="more">The fourth.</param>
    /// <param name="owner">For whom they are.</param>
    public void Add(
        uint lanes, in Vec3W origin, in UIntW instance, in Vec3W inner, in Vec3W direction, in FloatW distance, in FloatW time, int light,
        in RgbW load, in FloatW more, in UIntW owner)
    {
        float* to = _rays.Pointer + Count;
        origin.X.Compress(to, lanes);
        origin.Y.Compress(to + _stride, lanes);
        origin.Z.Compress(to + (2 * _stride), lanes);
        direction.X.Compress(to + (3 * _stride), lanes);
        direction.Y.Compress(to + (4 * _stride), lanes);
        direction.Z.Compress(to + (5 * _stride), lanes);
        distance.Compress(to + (6 * _stride), lanes);
        time.Compress(to + (7 * _stride), lanes);
        load.R.Compress(to + (LoadColumn * _stride), lanes);
        load.G.Compress(to + ((LoadColumn + 1) * _stride), lanes);
        load.B.Compress(to + ((LoadColumn + 2) * _stride), lanes);
        more.Compress(to + ((LoadColumn + 3) * _stride), lanes);
        if (scene.World.Instances is not null)
        {
            instance.Compress((uint*)to + (InstanceColumn * _stride), lanes);
            inner.X.Compress(to + ((InstanceColumn + 1) * _stride), lanes);
            inner.Y.Compress(to + ((InstanceColumn + 2) * _stride), lanes);
            inner.Z.Compress(to + ((InstanceColumn + 3) * _stride), lanes);
        }

        owner.Compress(_owners.Pointer + Count, lanes);
        int added = BitOperations.PopCount(lanes);
        new Span<int>(_lightOf.Pointer + Count, added).Fill(light);
        Count += added;
    }

    /// <summary>A number of a ray's load.</summary>
    public float Load(int number, int ray) => _rays.Pointer[((LoadColumn + number) * _stride) + ray];

    /// <summary>Traces all rays through what <see cref="PrimitiveList.Occlude"/> does not ask: trees and instances.</summary>
    public void Trace()
    {
        float* rays = _rays.Pointer;
        World world = scene.World;
        if (world.Itself.Tree is null)
        {
            new Span<int>(_hits.Pointer, Count).Fill(-1);
        }
        else
        {
            world.Itself.Tree.AnyHit(RayStream.OfColumns(rays, _stride, _hits.Pointer, Count));
        }

        for (int i = 0; world.Instances is not null && i < Count; i++)
        {
            if (_hits.Pointer[i] < 0)
            {
                SpaceRay ray = new(Column(0, i), Column(3, i)) { StartInstance = ((int*)rays)[(InstanceColumn * _stride) + i], InnerStart = Column(InstanceColumn + 1, i) };
                (int instance, int primitive) = _lightOf.Pointer[i] is >= 0 and int light ? (_lights[light].Instance, _lights[light].Primitive) : (0, -1);
                _hits.Pointer[i] = world.Instances.AnyHit(ray, rays[(7 * _stride) + i], rays[(6 * _stride) + i], instance, primitive) ? 0 : -1;
            }
        }
    }

    /// <summary>Forgets all rays.</summary>
    public void Clear() => Count = 0;

    private Vector3 Column(int column, int ray)
    {
        float* first = _rays.Pointer + ((long)column * _stride) + ray;
        return new(first[0], first[_stride], first[2 * _stride]);
    }
}
