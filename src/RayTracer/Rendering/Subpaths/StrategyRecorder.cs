using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Brings what a thread's paths contribute to a <see cref="StrategyFilm"/>. A thread has one only where that is wanted; elsewhere it is null.</summary>
/// <param name="scene">The scene.</param>
/// <param name="film">Takes the light.</param>
internal sealed unsafe class StrategyRecorder(Scene scene, StrategyFilm film)
{
    private readonly List<(int Layer, Rgb Alone)> _waiting = [];
    private readonly bool _hasWeights = scene.Filter is { HasWeights: true };
    private PathSource? _cameraPaths;
    private SampleRange _samples;

    /// <summary>Prepares for camera paths. Until then, light is for pixels, by their numbers in the picture.</summary>
    /// <param name="source">Starts them.</param>
    /// <param name="samples">Their samples.</param>
    public void Begin(PathSource source, SampleRange samples) => (_cameraPaths, _samples) = (source, samples);

    /// <summary>Light has arrived.</summary>
    /// <param name="lanes">The lanes.</param>
    /// <param name="owner">Numbers of the camera paths.</param>
    /// <param name="from">Numbers of vertices from the lights.</param>
    /// <param name="to">Numbers of vertices from the camera.</param>
    /// <param name="isMerge">Whether the last of both are one.</param>
    /// <param name="light">The light with its weight.</param>
    /// <param name="alone">The light without.</param>
    public void Add(uint lanes, in UIntW owner, in UIntW from, in UIntW to, bool isMerge, in RgbW light, in RgbW alone)
    {
        for (; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitOperations.TrailingZeroCount(lanes);
            Put(owner[lane], film.LayerOf(from[lane], to[lane], isMerge), Lane(light, lane), Lane(alone, lane));
        }
    }

    /// <summary>Rays wait that bring light; there is a call for each time that some are added.</summary>
    /// <param name="lanes">The lanes.</param>
    /// <param name="from">Numbers of vertices from the lights.</param>
    /// <param name="to">Numbers of vertices from the camera.</param>
    /// <param name="alone">The light without its weight.</param>
    public void Wait(uint lanes, in UIntW from, in UIntW to, in RgbW alone)
    {
        for (; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitOperations.TrailingZeroCount(lanes);
            _waiting.Add((film.LayerOf(from[lane], to[lane], false), Lane(alone, lane)));
        }
    }

    /// <summary>The rays that waited have been traced.</summary>
    public void Settle(ShadowRays rays)
    {
        for (int i = 0; i < rays.Count; i++)
        {
            if (rays.Hits[i] < 0)
            {
                Put(rays.Owners[i], _waiting[i].Layer, new(rays.Load(0, i), rays.Load(1, i), rays.Load(2, i)), _waiting[i].Alone);
            }
        }

        _waiting.Clear();
    }

    private static Rgb Lane(in RgbW color, int lane) => new(color.R[lane], color.G[lane], color.B[lane]);

    private void Put(uint owner, int layer, Rgb light, Rgb alone)
    {
        if (_cameraPaths is null)
        {
            film.Add(layer, owner, light, alone);
            return;
        }

        PathNumber.Split(owner, _samples, out UIntW pixel, out UIntW sample);
        uint place = pixel[0];
        float weight = _hasWeights ? RayGenerator.Weight(scene, _cameraPaths.PixelKeys[place], sample)[0] : 1;
        film.Add(layer, _cameraPaths.PixelNumbers[place], light * weight, alone * weight);
    }
}
