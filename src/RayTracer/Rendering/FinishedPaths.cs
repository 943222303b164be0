using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Collects the paths that ended, and hands their radiance to the accumulator.</summary>
public sealed unsafe class FinishedPaths
{
    private readonly PinnedBuffer<float> _radiance;
    private readonly PinnedBuffer<uint> _path;
    private readonly SampleAccumulator _accumulator;
    private readonly Scene _scene;
    private readonly RayGenerator _generator;
    private readonly PathObserver? _observer;
    private readonly Backdrop? _backdrop;
    private readonly Backdrop? _withAll;
    private readonly bool _hasWeights;
    private readonly int _stride;
    private SampleRange _samples;
    private int _count;

    /// <summary>Makes it.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="capacity">The most paths of a stream.</param>
    /// <param name="generator">Knows the samples' random numbers.</param>
    /// <param name="accumulator">Takes the samples.</param>
    /// <param name="observer">Sees them; null where nobody asks.</param>
    /// <param name="backdrop">What they see of what is behind everything; null where the film does not know it.</param>
    /// <param name="withAll">
    /// What the same samples see of the scene with all things, where these are those of <see cref="Scene.MattesAlone"/>: only what shadow catchers have of them is added up.
    /// </param>
    internal FinishedPaths(
        Scene scene, int capacity, RayGenerator generator, SampleAccumulator accumulator, PathObserver? observer, Backdrop? backdrop, Backdrop? withAll = null)
    {
        _withAll = withAll;
        _observer = observer;
        _backdrop = backdrop;
        _scene = scene;
        _generator = generator;
        _hasWeights = scene.Filter is { HasWeights: true };
        _stride = capacity + (2 * FloatW.Count);
        _radiance = new(3L * _stride);
        _path = new(_stride);
        _accumulator = accumulator;
    }

    /// <summary>Number of paths that wait to be added up.</summary>
    internal int Count => _count;

    /// <summary>Their radiance: red, and <see cref="Stride"/> further green, and blue.</summary>
    internal float* Radiance => _radiance.Pointer;

    /// <summary>Their numbers in the tile.</summary>
    internal uint* Path => _path.Pointer;

    /// <summary>From one channel to the next.</summary>
    internal int Stride => _stride;

    /// <summary>Prepares for a tile.</summary>
    internal void Begin(SampleRange samples)
    {
        _samples = samples;
        _count = 0;
    }

    /// <summary>Takes the chosen lanes of a packet.</summary>
    /// <param name="lanes">A bit for each lane.</param>
    /// <param name="radiance">The radiance that their paths have gathered.</param>
    /// <param name="path">The numbers of their paths.</param>
    public void Append(uint lanes, in RgbW radiance, in UIntW path)
    {
        radiance.R.Compress(_radiance.Pointer + _count, lanes);
        radiance.G.Compress(_radiance.Pointer + _stride + _count, lanes);
        radiance.B.Compress(_radiance.Pointer + (2 * _stride) + _count, lanes);
        path.Compress(_path.Pointer + _count, lanes);
        _count += BitOperations.PopCount(lanes);
    }

    /// <summary>Forgets all collected paths.</summary>
    internal void Clear() => _count = 0;

    /// <summary>Adds all collected paths up.</summary>
    internal void Drain()
    {
        float* r = _radiance.Pointer;
        float* g = r + _stride;
        float* b = g + _stride;
        for (int i = 0; i < _count; i += FloatW.Count)
        {
            PathNumber.Split(UIntW.Load(_path.Pointer + i), _samples, out UIntW pixel, out UIntW sample);
            RgbW radiance = new(FloatW.Load(r + i), FloatW.Load(g + i), FloatW.Load(b + i));
            RgbW gathered = radiance;
            FloatW weight = 1f;
            if (_hasWeights)
            {
                UIntW key = UIntW.Gather(_generator.PixelKeys, MaskW.First(_count - i).Select(pixel, 0u));
                weight = RayGenerator.Weight(_scene, key, sample);
                radiance *= weight;
            }

            for (int lane = 0; _observer is not null && lane < Math.Min(FloatW.Count, _count - i); lane++)
            {
                _observer.Finish(_path.Pointer[i + lane], (int)pixel[lane], Lane(gathered, lane), Lane(radiance, lane));
            }

            if (_withAll is null)
            {
                _accumulator.Add(Math.Min(FloatW.Count, _count - i), pixel, sample, radiance);
            }

            if (_backdrop is not null)
            {
                AddBackdrop(_backdrop, MaskW.First(_count - i), MaskW.First(_count - i).Select(UIntW.Load(_path.Pointer + i), 0u), pixel, gathered, weight);
            }
        }

        _count = 0;
    }

    private void AddBackdrop(Backdrop backdrop, MaskW inUse, in UIntW path, in UIntW pixel, in RgbW gathered, in FloatW weight)
    {
        MaskW caught = backdrop.Pick(path, gathered, out FloatW through, out RgbW light) & inUse;
        if (_withAll is not null)
        {
            // What the things that throw shadows let through, they let through of both.
            caught &= _withAll.Pick(path, gathered, out FloatW throughAll, out _) & (through > 0f);
            _accumulator.AddAlone(caught, pixel, light * (throughAll / through * weight));
            return;
        }

        _accumulator.AddBackdrop(inUse, pixel, gathered, through * weight, light * weight);
        if (caught.Bits != 0)
        {
            _accumulator.AddCaught(caught, pixel, through * weight, light * weight);
        }
    }

    private static Rgb Lane(in RgbW color, int lane) => new(color.R[lane], color.G[lane], color.B[lane]);
}
