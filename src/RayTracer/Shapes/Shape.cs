using System.Numerics;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Shapes;

/// <summary>
/// A surface with a material. A shape holds its own numbers; rays are traced against all shapes of one kind at a time by
/// the kind's <see cref="ShapeBatch"/>.
/// </summary>
/// <param name="material">The surface's material.</param>
/// <param name="name">A name for messages; may be empty.</param>
public abstract class Shape(Material material, string name)
{
    /// <summary>The material of the surface.</summary>
    public Material Material { get; } = material;

    /// <summary>A name for messages; may be empty.</summary>
    public string Name { get; } = name;

    /// <summary>The record that it was made from; null where that is not kept.</summary>
    internal Description.ShapeDescription? Source { get; set; }

    /// <summary>The label that distinguishes it from other lights; null where there is none.</summary>
    internal Description.LightGroupLabel? Label { get; set; }

    /// <summary>The smallest box around the surface, parallel to the axes; infinite where the surface is.</summary>
    public abstract Bounds Bounds { get; }

    /// <summary>Area of the surface; infinite where the surface is.</summary>
    public abstract float Area { get; }

    /// <summary>Makes an empty batch of this kind of shape.</summary>
    /// <param name="shapes">The scene's shapes of this kind.</param>
    public abstract ShapeBatch CreateBatch(IReadOnlyList<Shape> shapes);

    /// <summary>
    /// A random point of the surface as a light source seen from <paramref name="from"/> (report: RandomPoint). Only for surfaces of finite
    /// area.
    /// </summary>
    /// <param name="from">The points that are lit.</param>
    /// <param name="u">First random number.</param>
    /// <param name="v">Second random number.</param>
    /// <param name="sample">The chosen points.</param>
    public abstract void SamplePoint(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample);

    /// <summary>
    /// A random point of the whole surface, uniformly by area, from which light leaves it. It is as near to the surface as a hit is that was computed
    /// along a ray. False where the shape knows no such points.
    /// </summary>
    /// <param name="u">First random number.</param>
    /// <param name="v">Second random number.</param>
    /// <param name="point">The chosen points.</param>
    internal virtual bool SampleSurface(in FloatW u, in FloatW v, out Vec3W point)
    {
        point = default;
        return false;
    }

    /// <summary>The point itself that <see cref="SamplePoint"/> chooses for a lit point.</summary>
    private protected bool SampleSeen(in Vec3W from, in FloatW u, in FloatW v, out Vec3W point)
    {
        SamplePoint(from, u, v, out ShapeSampleW sample);
        point = Vec3W.MultiplyAdd(sample.Direction, sample.Distance, from);
        return true;
    }

    /// <summary>The density, per steradian, with which <see cref="SamplePoint"/> chooses a point of the shape.</summary>
    /// <param name="from">The lit points.</param>
    /// <param name="distance">Distance to the point.</param>
    /// <param name="cosine">Cosine between the outward normal there and the direction back to the lit point.</param>
    /// <param name="pdf">The density; zero where the point is seen from behind.</param>
    public virtual void SamplePdf(in Vec3W from, in FloatW distance, in FloatW cosine, out FloatW pdf) => pdf = AreaSample.Pdf(distance, cosine, Area);

    /// <summary>
    /// The shape that this one becomes by a map, uv and front included; null where it would be of another kind: rays are then transformed
    /// instead.
    /// </summary>
    /// <param name="by">The map.</param>
    public virtual Shape? Transformed(Transform by) => null;

    /// <summary>The lines that show the shape in views from elsewhere; without a drawing of its own, the box around it.</summary>
    /// <param name="middle">The middle of all that has an end.</param>
    /// <param name="reach">The distance from there to which shapes without an end are drawn.</param>
    public virtual IEnumerable<Vector3[]> Wires(Vector3 middle, float reach) => WireLines.Box(Bounds);

    /// <summary>Says how a shape is called in messages.</summary>
    public override string ToString() => Name.Length > 0 ? $"{GetType().Name.ToLowerInvariant()} \"{Name}\"" : GetType().Name.ToLowerInvariant();
}

/// <summary>Random points of a light source, seen from the points that are lit.</summary>
public struct ShapeSampleW
{
    /// <summary>Unit direction from the lit point to the light.</summary>
    public Vec3W Direction;

    /// <summary>Distance to the chosen point.</summary>
    public FloatW Distance;

    /// <summary>Cosine between the light's outward normal and the direction back to the lit point.</summary>
    public FloatW Cosine;

    /// <summary>One over the pdf per solid angle at the lit point; zero where no point could be chosen.</summary>
    public FloatW InversePdf;

    /// <summary>Surface coordinates of the chosen point.</summary>
    public FloatW U, V;
}
