using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;

namespace RayTracer.Lights;

/// <summary>
/// Starts light paths: chooses one of the lights with a probability in proportion to its power, in a time that grows with the logarithm of their number,
/// and a ray that leaves it. Any light that has power is chosen at times. Nothing in it changes, so that threads may share one.
/// </summary>
internal sealed class LightEmission
{
    // Beside the strongest.
    private const float Faintest = 1e-12f;
    private readonly World _world;
    private readonly LightSource[] _lights;
    private readonly GridDistribution _choice;

    // Of each light, whether its rays may come through something that has no end, before they are where they start.
    private readonly bool[] _comesFromBehind;

    /// <summary>Prepares the choice.</summary>
    /// <param name="scene">The scene, whose <see cref="Scene.SampledLights"/> are chosen from.</param>
    public LightEmission(Scene scene)
    {
        _world = scene.World;
        _lights = [.. scene.SampledLights];
        (double, double) shutter = (scene.Render.Shutter.X, scene.Render.Shutter.Y);
        _comesFromBehind = [.. _lights.Select(l => !_world.IsFinite && !l.Extent(shutter).Box.IsFinite)];
        float[] powers = [.. _lights.Select(l => l.CanEmit ? l.EmittedPower(shutter) : 0)];
        float largest = powers.Where(float.IsFinite).Append(0).Max();
        _choice = new(Math.Max(_lights.Length, 1), 1, (_, weights) =>
        {
            for (int i = 0; i < powers.Length; i++)
            {
                weights[i] = !(powers[i] > 0) ? 0 : powers[i] < largest ? float.Max(powers[i] / largest, Faintest) : 1;
            }
        });
    }

    /// <summary>The probability with which a light is chosen.</summary>
    /// <param name="light">Its number among the <see cref="Scene.SampledLights"/>.</param>
    public FloatW Probability(in UIntW light)
    {
        _choice.Probability(light, 0u, out FloatW probability);
        return probability;
    }

    /// <summary>Chooses a light and a ray for each light path.</summary>
    /// <param name="sampler">The source of random numbers.</param>
    /// <param name="key">Keys of the paths.</param>
    /// <param name="sample">Numbers of the samples.</param>
    /// <param name="time">Times in seconds; used only where something moves.</param>
    /// <param name="lanes">Lanes in use.</param>
    /// <param name="light">Numbers of the lights.</param>
    /// <param name="ray">The rays, whose power is that of one light over the probability of its choice.</param>
    public void Start(Sampler sampler, in UIntW key, in UIntW sample, in FloatW time, in MaskW lanes, out UIntW light, out EmittedW ray)
    {
        Draw(sampler, key, sample, Dimensions.LightChoice, out FloatW u, out _);
        Draw(sampler, key, sample, Dimensions.LightStart, out FloatW pointU, out FloatW pointV);
        Draw(sampler, key, sample, Dimensions.LightDirection, out FloatW directionU, out FloatW directionV);
        _choice.Choose(u, 0f, out light, out _, out _, out _, out FloatW probability);
        FloatW inverse = 1f / probability;
        ray = default;
        MaskW rest = _lights.Length > 0 ? lanes : MaskW.None;
        while (rest.Any)
        {
            int chosen = (int)light[BitOperations.TrailingZeroCount(rest.Bits)];
            MaskW same = rest & UIntW.Equal(light, (uint)chosen);
            _lights[chosen].Emit(pointU, pointV, directionU, directionV, time, out EmittedW one);
            one.Power *= inverse;
            if (_comesFromBehind[chosen])
            {
                one.Exists &= same;
                Arrive(time, ref one);
            }

            ray.Take(same, one);
            rest = rest.Except(same);
        }
    }

    private static void Draw(Sampler sampler, in UIntW key, in UIntW sample, uint group, out FloatW u, out FloatW v)
    {
        sampler.Begin(key, sample, group, out SamplePoints points);
        sampler.Pair(points, 0, out u, out v);
    }

    // Ends rays from infinitely far away that would have met an infinite surface before the disk on which they start.
    private void Arrive(in FloatW time, ref EmittedW ray)
    {
        Vec3W back = -ray.Direction;
        _world.Itself.Primitives.Occlude(ray.Origin, back, float.PositiveInfinity, -1, ref ray.Exists);
        if (_world.Instances is not { } instances)
        {
            return;
        }

        uint free = ray.Exists.Bits;
        for (uint rest = free; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            if (instances.AnyHit(SpaceRay.Of(ray.Origin, back, lane), time[lane], float.PositiveInfinity, 0, -1))
            {
                ray.Exists = ray.Exists.Except(UIntW.Equal(UIntW.Iota, (uint)lane));
            }
        }
    }
}
