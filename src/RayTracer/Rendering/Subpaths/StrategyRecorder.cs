using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Brings what a thread's paths contribute to those who ask for it. A thread has one only where somebody does; elsewhere it is null.</summary>
/// <param name="scene">The scene.</param>
/// <param name="arrivals">Takes the light.</param>
internal sealed unsafe class StrategyRecorder(Scene scene, IArrivals arrivals)
{
    private readonly List<Arrival> _waiting = [];
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
    /// <param name="ways">The ways by which the paths were made.</param>
    /// <param name="light">The light with its weight.</param>
    /// <param name="alone">The light without.</param>
    public void Add(uint lanes, in UIntW owner, in WaysW ways, in RgbW light, in RgbW alone)
    {
        for (; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitOperations.TrailingZeroCount(lanes);
            Put(owner[lane], Lane(ways, lane, Lane(light, lane), Lane(alone, lane)));
        }
    }

    /// <summary>Rays wait that bring light; there is a call for each time that some are added.</summary>
    /// <param name="lanes">The lanes.</param>
    /// <param name="ways">The ways by which the paths were made.</param>
    /// <param name="alone">The light without its weight.</param>
    public void Wait(uint lanes, in WaysW ways, in RgbW alone)
    {
        for (; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitOperations.TrailingZeroCount(lanes);
            _waiting.Add(Lane(ways, lane, default, Lane(alone, lane)));
        }
    }

    /// <summary>The rays that waited have been traced.</summary>
    public void Settle(ShadowRays rays)
    {
        for (int i = 0; i < rays.Count; i++)
        {
            if (rays.Hits[i] < 0)
            {
                Put(rays.Owners[i], _waiting[i] with { Light = new(rays.Load(0, i), rays.Load(1, i), rays.Load(2, i)) });
            }
        }

        _waiting.Clear();
    }

    private static Rgb Lane(in RgbW color, int lane) => new(color.R[lane], color.G[lane], color.B[lane]);

    private static Arrival Lane(in WaysW ways, int lane, Rgb light, Rgb alone) => new(
        ways.From[lane], ways.To[lane], ways.IsMerge, ways.LightPath[lane], new(ways.Point.X[lane], ways.Point.Y[lane], ways.Point.Z[lane]), light, alone, ways.Factors[lane]);

    private void Put(uint owner, in Arrival arrival)
    {
        if (_cameraPaths is null)
        {
            arrivals.Add(owner, arrival);
            return;
        }

        PathNumber.Split(owner, _samples, out UIntW pixel, out UIntW sample);
        uint place = pixel[0];
        float weight = _hasWeights ? RayGenerator.Weight(scene, _cameraPaths.PixelKeys[place], sample)[0] : 1;
        arrivals.Add(_cameraPaths.PixelNumbers[place], arrival with { Light = arrival.Light * weight, Alone = arrival.Alone * weight, Factors = arrival.Factors with { Filter = weight } });
    }
}
