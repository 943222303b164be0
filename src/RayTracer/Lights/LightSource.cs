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

    /// <summary>The density, per steradian, with which <see cref="Sample"/> chooses the direction of a ray that meets this light.</summary>
    /// <param name="hit">Where rays meet the light.</param>
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
}

/// <summary>A light as known from afar.</summary>
/// <param name="Box">A box around it while the shutter is open; infinite where it shines from infinitely far away.</param>
/// <param name="Strength">Its mean radiant intensity over all directions; or the irradiance that one infinitely far away brings. In
/// luminance.</param>
public readonly record struct LightExtent(Bounds Box, float Strength);
