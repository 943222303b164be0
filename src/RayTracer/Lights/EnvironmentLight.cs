using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Lights;

/// <summary>Light from infinitely far away, in all directions: what rays see that leave the scene.</summary>
public abstract class EnvironmentLight() : LightSource(0, -1)
{
    /// <summary>The radiance that comes from a direction.</summary>
    /// <param name="direction">Unit vector to where it comes from.</param>
    /// <param name="radiance">The radiance.</param>
    public abstract void Evaluate(in Vec3W direction, out RgbW radiance);

    /// <summary>The density, per steradian, with which a direction is chosen; the same for all lit points.</summary>
    /// <param name="direction">Unit vector to where the light comes from.</param>
    /// <param name="pdf">The density; above zero wherever there is light.</param>
    public abstract void Pdf(in Vec3W direction, out FloatW pdf);

    /// <inheritdoc/>
    public sealed override void Pdf(in LightHitW hit, out FloatW pdf) => Pdf(hit.Direction, out pdf);

    /// <inheritdoc/>
    internal sealed override bool CanEmit => true;

    /// <inheritdoc/>
    internal override float EmittedPower((double Open, double Close) shutter) => 4 * Extent(shutter).Strength * World!.Ball.Area;

    /// <inheritdoc/>
    internal sealed override void Emit(in FloatW u1, in FloatW v1, in FloatW u2, in FloatW v2, in FloatW time, out EmittedW ray)
    {
        SceneBall ball = World!.Ball;
        Sample(ball.Center, u2, v2, time, out ShapeSampleW sample, out RgbW irradiance);
        FloatW pdf = (sample.InversePdf > 0f).Select(1f / sample.InversePdf, 0f);
        ball.Emit(-sample.Direction, pdf, irradiance, u1, v1, out ray);
    }

    /// <inheritdoc/>
    internal sealed override void EmissionPdf(in LightHitW hit, out FloatW point, out FloatW direction)
    {
        point = World!.Ball.PointPdf(hit.From, -hit.Direction);
        Pdf(hit.Direction, out direction);
    }

    /// <summary>A sample of a direction: infinitely far away.</summary>
    private protected static void Of(in Vec3W direction, FloatW inversePdf, out ShapeSampleW sample)
    {
        sample.Direction = direction;
        sample.Distance = float.PositiveInfinity;
        sample.Cosine = 1f;
        sample.InversePdf = inversePdf;
        sample.U = sample.V = default;
    }
}
