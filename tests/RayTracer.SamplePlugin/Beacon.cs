using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.SamplePlugin;

/// <summary>Describes a <see cref="Beacon"/>.</summary>
[SceneType("beacon", "A light at a point that shines upwards only.")]
public sealed record BeaconDescription : PunctualLightDescription
{
    /// <summary>Where it stands.</summary>
    [Parameter("Where it stands.", Unit = "scene units")]
    public Vector3 Position { get; init; }

    /// <summary>Radiant intensity.</summary>
    [Parameter("Radiant intensity towards the upper half.", Unit = "power per steradian", Minimum = 0)]
    public Rgb Intensity { get; init; } = Rgb.White;

    /// <inheritdoc/>
    public override void Check(in Transform place, SceneBuilder builder)
    {
        base.Check(place, builder);
        CheckPosition(nameof(Position), Position, place, builder);
    }

    /// <inheritdoc/>
    public override LightSource Create(Motion motion, Texture? picture) => new Beacon(Position, Intensity, motion);
}

/// <summary>A light at a point that shines upwards only.</summary>
public sealed class Beacon(Vector3 position, Rgb intensity, Motion motion) : PunctualLight(position, Vector3.UnitY, motion)
{
    /// <inheritdoc/>
    public override LightExtent Extent((double Open, double Close) shutter) => new(BoundsOfPosition(shutter), intensity.Luminance / 2);

    /// <inheritdoc/>
    public override void Sample(in Vec3W from, in FloatW u, in FloatW v, in FloatW time, out ShapeSampleW sample, out RgbW radiance)
    {
        Place(time, out Vec3W place, out Vec3W up);
        Towards(place - from, out sample, out FloatW inverseSquare);
        radiance = (Vec3W.Dot(sample.Direction, up) < 0f).Select((RgbW)intensity * inverseSquare, default);
    }
}
