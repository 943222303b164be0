using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Lights;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Shadow rays that wait to be traced together, for a tree is searched faster by many rays than by few. What they bring is added to the
/// radiance of their paths where those have gone meanwhile, in the same order and with the same roundings as if it had been at once.
/// </summary>
internal sealed unsafe class ShadowQueue
{
    private const int MaxPackets = 1024;
    private const int Columns = 16;
    private const uint IsFinished = 0x80000000;
    private const uint IsNowhere = uint.MaxValue;
    private readonly Scene _scene;
    private readonly PathObserver? _observer;
    private readonly LightSource[] _lights;
    private readonly int _lightsOfPoint;
    private readonly int _capacity;
    private readonly int _stride;

    // Of rays: origin, direction, distance, time, radiance, cosine, and where there are instances, that of the start, and where in its space; then the lane that each is for, the light it comes from, and what it
    // hits.
    private readonly PinnedBuffer<float> _rays;
    private readonly PinnedBuffer<uint> _lanes;
    private readonly PinnedBuffer<uint> _lightOf;
    private readonly PinnedBuffer<int> _hits;

    // Of packets, six numbers a lane: what arriving light is multiplied by, and what has arrived; and where the lane's path went.
    private readonly PinnedBuffer<float> _weights;
    private readonly PinnedBuffer<float> _arrived;
    private readonly PinnedBuffer<uint> _slots;
    private int _count;
    private int _packets;

    public ShadowQueue(Scene scene, PathObserver? observer)
    {
        _scene = scene;
        _observer = observer;
        _lights = [.. scene.SampledLights];
        _lightsOfPoint = scene.LightSelection is null ? _lights.Length : 1;
        _capacity = Math.Max(8192, _lightsOfPoint * FloatW.Count);
        _stride = _capacity + 48;
        _rays = new((long)Columns * _stride);
        _lanes = new(_stride);
        _lightOf = new(_stride);
        _hits = new(_stride);
        _weights = new(3L * MaxPackets * FloatW.Count);
        _arrived = new(3L * MaxPackets * FloatW.Count);
        _slots = new((long)MaxPackets * FloatW.Count);
    }

    /// <summary>There is no room for another packet.</summary>
    public bool IsFull => _packets == MaxPackets || _count + (_lightsOfPoint * FloatW.Count) > _capacity;

    /// <summary>Starts a packet.</summary>
    /// <param name="weight">Throughput times BRDF.</param>
    public void Begin(in RgbW weight)
    {
        Store(_weights.Pointer, weight);
        Store(_arrived.Pointer, default);
        _packets++;
    }

    /// <summary>Adds rays of the packet.</summary>
    /// <param name="lanes">The lanes.</param>
    /// <param name="origin">The points from which they start.</param>
    /// <param name="instance">The instances on which they start; 0 for none.</param>
    /// <param name="inner">Those points in the instances' spaces.</param>
    /// <param name="direction">Their unit directions.</param>
    /// <param name="distance">The distances to the light.</param>
    /// <param name="time">Their times in seconds; used only where something moves.</param>
    /// <param name="light">Number of the light.</param>
    /// <param name="radiance">What they bring, if they are free.</param>
    /// <param name="cosine">What that is multiplied by.</param>
    public void Add(
        uint lanes, in Vec3W origin, in UIntW instance, in Vec3W inner, in Vec3W direction, in FloatW distance, in FloatW time, int light,
        in RgbW radiance, in FloatW cosine)
    {
        float* to = _rays.Pointer + _count;
        origin.X.Compress(to, lanes);
        origin.Y.Compress(to + _stride, lanes);
        origin.Z.Compress(to + (2 * _stride), lanes);
        direction.X.Compress(to + (3 * _stride), lanes);
        direction.Y.Compress(to + (4 * _stride), lanes);
        direction.Z.Compress(to + (5 * _stride), lanes);
        distance.Compress(to + (6 * _stride), lanes);
        time.Compress(to + (7 * _stride), lanes);
        radiance.R.Compress(to + (8 * _stride), lanes);
        radiance.G.Compress(to + (9 * _stride), lanes);
        radiance.B.Compress(to + (10 * _stride), lanes);
        cosine.Compress(to + (11 * _stride), lanes);
        if (_scene.World.Instances is not null)
        {
            instance.Compress((uint*)to + (12 * _stride), lanes);
            inner.X.Compress(to + (13 * _stride), lanes);
            inner.Y.Compress(to + (14 * _stride), lanes);
            inner.Z.Compress(to + (15 * _stride), lanes);
        }

        (UIntW.Iota + (uint)((_packets - 1) * FloatW.Count)).Compress(_lanes.Pointer + _count, lanes);
        ((UIntW)(uint)light).Store(_lightOf.Pointer + _count);
        _count += BitOperations.PopCount(lanes);
    }

    /// <summary>Says where the paths of the packet went.</summary>
    /// <param name="ended">The lanes that ended.</param>
    /// <param name="firstFinished">Where among the finished paths the first of them is.</param>
    /// <param name="going">The lanes that have a next ray.</param>
    /// <param name="firstNext">Where in the next stream the first of them is.</param>
    public void End(uint ended, int firstFinished, uint going, int firstNext)
    {
        uint* slots = _slots.Pointer + ((_packets - 1) * FloatW.Count);
        for (int lane = 0; lane < FloatW.Count; lane++)
        {
            slots[lane] = (ended >> lane & 1) != 0 ? (uint)firstFinished++ | IsFinished : (going >> lane & 1) != 0 ? (uint)firstNext++ : IsNowhere;
        }
    }

    /// <summary>Traces all rays, and adds what they bring.</summary>
    public void Flush(FinishedPaths finished, PathStream next)
    {
        Trace();
        _observer?.Settle(_hits.Pointer);
        float* rays = _rays.Pointer;
        for (int i = 0; i < _count; i++)
        {
            if (_hits.Pointer[i] < 0)
            {
                float cosine = rays[(11 * _stride) + i];
                uint lane = _lanes.Pointer[i];
                float* arrived = _arrived.Pointer + (lane / (uint)FloatW.Count * 3 * (uint)FloatW.Count) + (lane % (uint)FloatW.Count);
                for (int channel = 0; channel < 3; channel++, arrived += FloatW.Count)
                {
                    *arrived = float.FusedMultiplyAdd(rays[((8 + channel) * _stride) + i], cosine, *arrived);
                }
            }
        }

        for (int lane = 0; lane < _packets * FloatW.Count; lane++)
        {
            uint slot = _slots.Pointer[lane];
            if (slot != IsNowhere)
            {
                AddTo(finished, next, slot, lane);
            }
        }

        (_count, _packets) = (0, 0);
    }

    private void AddTo(FinishedPaths finished, PathStream next, uint slot, int lane)
    {
        bool isFinished = (slot & IsFinished) != 0;
        int index = (int)(slot & ~IsFinished);
        float* radiance = isFinished ? finished.Radiance + index : next.RadianceR + index;
        long stride = isFinished ? finished.Stride : next.RadianceG - next.RadianceR;
        int at = (lane / FloatW.Count * 3 * FloatW.Count) + (lane % FloatW.Count);
        for (int channel = 0; channel < 3; channel++, radiance += stride, at += FloatW.Count)
        {
            *radiance = float.FusedMultiplyAdd(_weights.Pointer[at], _arrived.Pointer[at], *radiance);
        }
    }

    private void Store(float* to, in RgbW color)
    {
        to += _packets * 3 * FloatW.Count;
        color.R.Store(to);
        color.G.Store(to + FloatW.Count);
        color.B.Store(to + (2 * FloatW.Count));
    }

    private Vector3 Column(int column, int ray)
    {
        float* first = _rays.Pointer + ((long)column * _stride) + ray;
        return new(first[0], first[_stride], first[2 * _stride]);
    }

    private void Trace()
    {
        float* rays = _rays.Pointer;
        World world = _scene.World;
        if (world.Itself.Tree is null)
        {
            new Span<int>(_hits.Pointer, _count).Fill(-1);
        }
        else
        {
            world.Itself.Tree.AnyHit(RayStream.OfColumns(rays, _stride, _hits.Pointer, _count));
        }

        for (int i = 0; world.Instances is not null && i < _count; i++)
        {
            if (_hits.Pointer[i] < 0)
            {
                SpaceRay ray = new(Column(0, i), Column(3, i)) { StartInstance = ((int*)rays)[(12 * _stride) + i], InnerStart = Column(13, i) };
                LightSource light = _lights[_lightOf.Pointer[i]];
                _hits.Pointer[i] = world.Instances.AnyHit(ray, rays[(7 * _stride) + i], rays[(6 * _stride) + i], light.Instance, light.Primitive) ? 0 : -1;
            }
        }
    }
}
