using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Lights;

/// <summary>Describes a <see cref="DirectionalLight"/>.</summary>
[SceneType("directional", "Light from infinitely far away along one direction, like a sun without extent: its shadows are sharp. No ray "
    + "meets it. Transforms turn it but do not change its strength.")]
public sealed record DirectionalLightDescription : PunctualLightDescription
{
    /// <summary>The direction in which the light travels.</summary>
    [Parameter("The direction in which the light travels, of any length.")]
    public Vector3 Direction { get; init; } = new(0, -1, 0);

    /// <summary>Irradiance.</summary>
    [Parameter("Irradiance on a surface that faces the light.", Unit = "power per area", Minimum = 0)]
    public Rgb Irradiance { get; init; } = Rgb.White;

    /// <summary>A sun that brings onto a white floor about what lamps bring onto what is near them.</summary>
    public override ShapeDescription Sketch(SketchView view) => this with { Direction = new(-1, -2, -1), Irradiance = new(3, 3, 3) };

    /// <inheritdoc/>
    public override ShapeDescription Moved(in ShapeMove move) => this with { Direction = move.Direction(Direction) };

    /// <inheritdoc/>
    public override void Check(in Transform place, SceneBuilder builder)
    {
        base.Check(place, builder);
        CheckDirection(nameof(Direction), Direction, place, builder);
    }

    /// <inheritdoc/>
    public override LightSource Create(Motion motion, Texture? picture) => new DirectionalLight(Direction, Irradiance, motion);
}

/// <summary>Light from infinitely far away, along one direction.</summary>
/// <param name="direction">The direction of travel in its own space, of any length above zero.</param>
/// <param name="irradiance">Irradiance on a surface that faces it: power per area.</param>
/// <param name="motion">The motion of its space in the world.</param>
internal sealed class DirectionalLight(Vector3 direction, Rgb irradiance, Motion motion) : PunctualLight(Vector3.Zero, direction.Unit(), motion)
{
    /// <inheritdoc/>
    public override LightExtent Extent((double Open, double Close) shutter) => new(Bounds.Infinite, irradiance.Luminance);

    /// <inheritdoc/>
    public override void Sample(in Vec3W from, in FloatW u, in FloatW v, in FloatW time, out ShapeSampleW sample, out RgbW radiance)
    {
        Place(time, out _, out Vec3W along);
        sample.Direction = -along;
        sample.Distance = float.PositiveInfinity;
        sample.Cosine = 1f;
        sample.InversePdf = 1f;
        sample.U = sample.V = default;
        radiance = irradiance;
    }

    /// <inheritdoc/>
    internal override bool CanEmit => true;

    /// <inheritdoc/>
    internal override float EmittedPower((double Open, double Close) shutter) => irradiance.Luminance * World!.Ball.Area;

    /// <inheritdoc/>
    internal override void Emit(in FloatW u1, in FloatW v1, in FloatW u2, in FloatW v2, in FloatW time, out EmittedW ray)
    {
        Place(time, out _, out Vec3W along);
        World!.Ball.Emit(along, 1f, irradiance, u1, v1, out ray);
    }

    /// <inheritdoc/>
    internal override void EmissionPdf(in LightHitW hit, out FloatW point, out FloatW direction)
    {
        point = World!.Ball.PointPdf(hit.From, -hit.Direction);
        direction = 1f;
    }
}
