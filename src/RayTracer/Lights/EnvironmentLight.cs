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
