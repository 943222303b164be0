using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;

namespace RayTracer.Lights;

/// <summary>Describes a <see cref="ConstantEnvironment"/>.</summary>
[SceneType("constant", "The same light from all directions.")]
public sealed record ConstantEnvironmentDescription : EnvironmentDescription
{
    /// <summary>The radiance.</summary>
    [Parameter("The radiance.", Minimum = 0)]
    public Rgb Radiance { get; init; } = Rgb.White;

    /// <inheritdoc/>
    public override EnvironmentLight Build(SceneBuilder builder)
    {
        Turn(builder);
        return new ConstantEnvironment(Radiance);
    }
}

/// <summary>The same light from all directions, which are chosen uniformly.</summary>
/// <param name="light">The radiance.</param>
internal sealed class ConstantEnvironment(Rgb light) : EnvironmentLight
{
    /// <inheritdoc/>
    public override void Evaluate(in Vec3W direction, out RgbW radiance) => radiance = light;

    /// <inheritdoc/>
    public override void Pdf(in Vec3W direction, out FloatW pdf) => pdf = 1 / (4 * float.Pi);

    /// <inheritdoc/>
    public override LightExtent Extent((double Open, double Close) shutter) => new(Bounds.Infinite, float.Pi * light.Luminance);

    /// <inheritdoc/>
    public override void Sample(in Vec3W from, in FloatW u, in FloatW v, in FloatW time, out ShapeSampleW sample, out RgbW radiance)
    {
        Of(Warp.UniformSphere(u, v), 4 * float.Pi, out sample);
        radiance = light * (4 * float.Pi);
    }
}
