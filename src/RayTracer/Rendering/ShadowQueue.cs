using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Shadow rays that wait to be traced together, for a tree is searched faster by many rays than by few. What they bring is added to the
/// radiance of their paths where those have gone meanwhile, in the same order and with the same roundings as if it had been at once.
/// </summary>
internal sealed unsafe class ShadowQueue
{
    private const int MaxPackets = 1024;
    private const int LeastRays = 8192;
    private const uint IsFinished = 0x80000000;
    private const uint IsNowhere = uint.MaxValue;
    private readonly PathObserver? _observer;
    private readonly int _lightsOfPoint;
    private readonly ShadowRays _rays;

    // Of packets, six numbers a lane: what arriving light is multiplied by, and what has arrived; and where the lane's path went.
    private readonly PinnedBuffer<float> _weights;
    private readonly PinnedBuffer<float> _arrived;
    private readonly PinnedBuffer<uint> _slots;
    private int _packets;

    public ShadowQueue(Scene scene, PathObserver? observer)
    {
        _observer = observer;
        _lightsOfPoint = scene.PointsOfFirst * (scene.LightSelection is null ? scene.SampledLights.Count : 1);
        _rays = new(scene, Math.Max(LeastRays, _lightsOfPoint * FloatW.Count));
        _weights = new(3L * MaxPackets * FloatW.Count);
        _arrived = new(3L * MaxPackets * FloatW.Count);
        _slots = new((long)MaxPackets * FloatW.Count);
    }

    /// <summary>There is no room for another packet.</summary>
    public bool IsFull => _packets == MaxPackets || !_rays.HasRoomFor(_lightsOfPoint * FloatW.Count);

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
    /// <param name="radiance">The light that they bring, if they are free.</param>
    /// <param name="cosine">The factor on that.</param>
    public void Add(
        uint lanes, in Vec3W origin, in UIntW instance, in Vec3W inner, in Vec3W direction, in FloatW distance, in FloatW time, int light,
        in RgbW radiance, in FloatW cosine) =>
        _rays.Add(lanes, origin, instance, inner, direction, distance, time, light, radiance, cosine, UIntW.Iota + (uint)((_packets - 1) * FloatW.Count));

    /// <summary>Says where the paths of the packet went.</summary>
    /// <param name="ended">The lanes that ended.</param>
    /// <param name="firstFinished">The index of the first of them among the finished paths.</param>
    /// <param name="going">The lanes that have a next ray.</param>
    /// <param name="firstNext">The index of the first of them in the next stream.</param>
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
        _rays.Trace();
        _observer?.Settle(_rays.Hits);
        for (int i = 0; i < _rays.Count; i++)
        {
            if (_rays.Hits[i] < 0)
            {
                float cosine = _rays.Load(3, i);
                uint lane = _rays.Owners[i];
                float* arrived = _arrived.Pointer + (lane / (uint)FloatW.Count * 3 * (uint)FloatW.Count) + (lane % (uint)FloatW.Count);
                for (int channel = 0; channel < 3; channel++, arrived += FloatW.Count)
                {
                    *arrived = float.FusedMultiplyAdd(_rays.Load(channel, i), cosine, *arrived);
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

        _rays.Clear();
        _packets = 0;
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
}
