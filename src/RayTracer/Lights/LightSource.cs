using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Lights;

/// <summary>Something that shines, as a source to be sampled.</summary>
/// <param name="instance">The instance in which it stands; 0 for the world itself.</param>
/// <param name="primitive">Its number among the scene's primitives, so that it does not shadow itself; −1 where it may.</param>
public abstract class LightSource(int instance, int primitive)
{
    /// <summary>The instance in which the light stands; 0 for the world itself.</summary>
    public int Instance => instance;

    /// <summary>
    /// The light's number among the scene's primitives, which casts no shadow of this light; −1 where there is none such.
    /// </summary>
    public int Primitive => primitive;

    /// <summary>The light's number among the shapes of the world itself; −1 where it is none of them.</summary>
    internal int OwnPrimitive { get; } = instance == 0 ? primitive : -1;

    /// <summary>The label that sets it apart from other lights; null where it has none.</summary>
    internal LightGroupLabel? Label { get; set; }

    /// <summary>The light comes from single points or directions, which no ray meets by chance.</summary>
    public virtual bool IsDelta => false;

    /// <summary>The world that it lights; set once it stands in a scene.</summary>
    internal World? World { get; set; }

    /// <summary>True where light can be traced from it: it has <see cref="Emit"/> and <see cref="EmissionPdf(in LightHitW, out FloatW, out FloatW)"/>.</summary>
    internal virtual bool CanEmit => false;

    /// <summary>The density, per steradian, with which <see cref="Sample"/> chooses the direction of a ray that meets this light.</summary>
    /// <param name="hit">The points at which rays meet the light.</param>
    /// <param name="pdf">The density; zero where the light is seen from behind.</param>
    public abstract void Pdf(in LightHitW hit, out FloatW pdf);

    /// <summary>Its place and strength, by which one of many lights is chosen.</summary>
    /// <param name="shutter">When the shutter opens and closes, in seconds.</param>
    public abstract LightExtent Extent((double Open, double Close) shutter);

    /// <summary>Chooses a point of the light for each lit point.</summary>
    /// <param name="from">The lit points.</param>
    /// <param name="u">First random number.</param>
    /// <param name="v">Second random number.</param>
    /// <param name="time">The times in seconds; used only where something moves.</param>
    /// <param name="sample">Direction and distance; an inverse pdf of zero where the light cannot be seen.</param>
    /// <param name="radiance">Radiance from the chosen point over the pdf per solid angle.</param>
    public abstract void Sample(in Vec3W from, in FloatW u, in FloatW v, in FloatW time, out ShapeSampleW sample, out RgbW radiance);

    /// <summary>Its power, about: the mean of <see cref="EmittedW.Power"/>, in luminance.</summary>
    /// <param name="shutter">When the shutter opens and closes, in seconds.</param>
    internal virtual float EmittedPower((double Open, double Close) shutter) => 4 * float.Pi * Extent(shutter).Strength;

    /// <summary>Chooses rays that leave the light.</summary>
    /// <param name="u1">First random number for the point.</param>
    /// <param name="v1">Second random number for the point.</param>
    /// <param name="u2">First random number for the direction.</param>
    /// <param name="v2">Second random number for the direction.</param>
    /// <param name="time">The times in seconds; used only where something moves.</param>
    /// <param name="ray">The rays.</param>
    internal virtual void Emit(in FloatW u1, in FloatW v1, in FloatW u2, in FloatW v2, in FloatW time, out EmittedW ray) => ray = default;

    /// <summary>
    /// The densities with which <see cref="Emit"/> chooses the ray that travels from the light to a lit point: back along a ray that met the light.
    /// </summary>
    /// <param name="hit">The points at which rays meet the light, or would meet it if it had an extent.</param>
    /// <param name="point">As <see cref="EmittedW.PointPdf"/>; zero where the ray cannot be chosen.</param>
    /// <param name="direction">As <see cref="EmittedW.DirectionPdf"/>.</param>
    internal virtual void EmissionPdf(in LightHitW hit, out FloatW point, out FloatW direction) => point = direction = 0f;

    /// <summary>The same for points of the light that <see cref="Sample"/> chose.</summary>
    /// <param name="from">The lit points.</param>
    /// <param name="sample">The samples as they were chosen.</param>
    /// <param name="time">The times in seconds; used only where something moves.</param>
    /// <param name="point">As <see cref="EmittedW.PointPdf"/>; zero where the ray cannot be chosen.</param>
    /// <param name="direction">As <see cref="EmittedW.DirectionPdf"/>.</param>
    internal virtual void EmissionPdf(in Vec3W from, in ShapeSampleW sample, in FloatW time, out FloatW point, out FloatW direction)
    {
        LightHitW hit = default;
        hit.From = from;
        (hit.Direction, hit.Distance, hit.Cosine) = (sample.Direction, sample.Distance, sample.Cosine);
        hit.Time = time;
        EmissionPdf(hit, out point, out direction);
    }
}

/// <summary>A light as known from afar.</summary>
/// <param name="Box">A box around it while the shutter is open; infinite where it shines from infinitely far away.</param>
/// <param name="Strength">Its mean radiant intensity over all directions; or the irradiance that one infinitely far away brings. In
/// luminance.</param>
public readonly record struct LightExtent(Bounds Box, float Strength);
