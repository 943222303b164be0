using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>Starts the light paths of a block, at lights that are chosen by their power, and keeps what is known of each start.</summary>
/// <param name="scene">The scene.</param>
/// <param name="interiors">Knows in what they start; null where paths do not track that.</param>
internal sealed unsafe class LightStarts(Scene scene, LightInteriors? interiors) : PathSource
{
    private readonly LightEmission _emission = new(scene);
    private readonly PinnedBuffer<uint> _keys = new(LightVertices.BlockSize);
    private readonly PinnedBuffer<uint> _numbers = new(LightVertices.BlockSize);
    private readonly PinnedBuffer<uint> _samples = new(LightVertices.BlockSize);
    private readonly PinnedBuffer<uint> _lights = new(LightVertices.BlockSize);
    private readonly PinnedBuffer<float> _cosines = new(LightVertices.BlockSize);
    private readonly PinnedBuffer<float> _densities = new(LightVertices.BlockSize);
    private readonly PinnedBuffer<uint> _primitives = new(LightVertices.BlockSize);
    private readonly PinnedBuffer<EmittedW> _ray = new(1);
    private int _sample;
    private int _issued;
    private int _total;

    /// <inheritdoc/>
    public override uint* PixelKeys => _keys.Pointer;

    /// <inheritdoc/>
    public override uint* PixelNumbers => _numbers.Pointer;

    /// <inheritdoc/>
    public override int Total => _total;

    /// <summary>Of each path, how many its pixel has had before.</summary>
    public uint* Samples => _samples.Pointer;

    /// <summary>Of each path, the number of its light among <see cref="Scene.SampledLights"/>.</summary>
    public uint* Lights => _lights.Pointer;

    /// <summary>Of each path, the cosine between the light's normal and its first ray.</summary>
    public float* Cosines => _cosines.Pointer;

    /// <summary>Of each path, the density of its first ray: of light, point and direction.</summary>
    public float* Densities => _densities.Pointer;

    /// <summary>Of each path, the primitive from which it starts.</summary>
    public uint* Primitives => _primitives.Pointer;

    /// <summary>
    /// Prepares for the paths of a block of pixels. In one of 2ᵏ samples each pixel has a path, chosen at random: were it every 2ᵏth, it would always go
    /// with the same stratum of the camera's samples. The random numbers of a pixel's paths are consecutive, as they are stratified so.
    /// </summary>
    /// <param name="firstPixel">Number of the first of them.</param>
    /// <param name="count">Their number.</param>
    /// <param name="sample">The sample.</param>
    /// <param name="rarity">k.</param>
    /// <param name="seed">Selects the random numbers.</param>
    public void Begin(int firstPixel, int count, int sample, int rarity, uint seed)
    {
        (_sample, _issued, _total) = (sample, 0, 0);
        uint turn = (uint)sample >> rarity;
        uint ofTurn = (uint)sample & ((1u << rarity) - 1);
        for (uint pixel = (uint)firstPixel; pixel < firstPixel + count; pixel++)
        {
            uint key = Hash.PixelKey(seed, pixel);
            if (rarity == 0 || Hash.PixelKey(key, turn) >> (32 - rarity) == ofTurn)
            {
                _numbers.Pointer[_total] = pixel;
                _keys.Pointer[_total] = key;
                _samples.Pointer[_total++] = turn;
            }
        }
    }

    /// <inheritdoc/>
    public override void Fill(PathStream stream, int room)
    {
        ref EmittedW ray = ref *_ray.Pointer;
        while (_issued < _total && stream.Count < room)
        {
            int count = Math.Min(Math.Min(FloatW.Count, _total - _issued), room - stream.Count);
            UIntW key = UIntW.Load(_keys.Pointer + _issued);
            FloatW time = scene.IsTimed ? scene.Time(key, (uint)_sample) : scene.Render.Shutter.X;
            _emission.Start(scene.Sampler, key, UIntW.Load(_samples.Pointer + _issued), time, MaskW.First(count), out UIntW light, out ray);
            light.Store(_lights.Pointer + _issued);
            ray.Cosine.Store(_cosines.Pointer + _issued);
            (ray.PointPdf * ray.DirectionPdf * _emission.Probability(light)).Store(_densities.Pointer + _issued);
            ray.Primitive.Store(_primitives.Pointer + _issued);
            uint lanes = (ray.Exists & MaskW.First(count)).Bits;
            if (scene.IsTimed)
            {
                stream.SetTime(lanes, time);
            }

            if (interiors is not null)
            {
                stream.SetMedia(lanes, interiors.Of(lanes, light, ray.Origin, time), 0f);
            }

            stream.Append(lanes, ray.Origin, ray.Direction, ray.Power, default, UIntW.Iota + (uint)_issued, 0u);
            if (scene.World.Instances is not null)
            {
                stream.SetStart(lanes, ray.Instance, ray.InnerOrigin);
            }

            _issued += count;
        }
    }
}
