using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>An auxiliary image of what camera rays meet first. Its sums are exact, so that threads and order cannot change a bit.</summary>
public abstract record FirstHitImage : AuxiliaryImage
{
    /// <summary>The parts of <see cref="FirstHit"/> that cost time, and are there only where an image needs them.</summary>
    public virtual FirstHitParts Needs => FirstHitParts.None;

    /// <summary>The samples whose mean a pixel has.</summary>
    public virtual MeanOver Mean => MeanOver.Samples;

    /// <summary>The number of pixels without such samples.</summary>
    public virtual double Nothing => 0;

    /// <summary>Takes the numbers of a sample.</summary>
    /// <param name="hit">The thing that its ray meets.</param>
    /// <param name="values">Takes one number for each of <see cref="AuxiliaryImage.Letters"/>; zeros at first.</param>
    public abstract void Read(in FirstHit hit, Span<double> values);
}

/// <summary>The first meeting of a camera ray.</summary>
public readonly record struct FirstHit
{
    /// <summary>The number of the sample in its pixel, from 0.</summary>
    public uint Sample { get; init; }

    /// <summary>The number, from 1, of the shape or triangle that is met; 0 where nothing is.</summary>
    public uint Primitive { get; init; }

    /// <summary>The instance that shows it; 0 for none.</summary>
    public uint Instance { get; init; }

    /// <summary>The distance along the ray, in scene units.</summary>
    public float Distance { get; init; }

    /// <summary>The ray's direction, a unit vector.</summary>
    public Vector3 Direction { get; init; }

    /// <summary>The number of nodes visited and triangles tested to find what the ray meets (<see cref="FirstHitParts.Cost"/>).</summary>
    public long Cost { get; init; }

    /// <summary>The point in the world (<see cref="FirstHitParts.Surface"/>).</summary>
    public Vector3 Point { get; init; }

    /// <summary>The unit normal that shading uses, in the world and on the ray's side (<see cref="FirstHitParts.Surface"/>).</summary>
    public Vector3 Normal { get; init; }

    /// <summary>The fraction of the light that the surface sends on (<see cref="FirstHitParts.Surface"/>).</summary>
    public Rgb Albedo { get; init; }

    /// <summary>The surface coordinates (<see cref="FirstHitParts.Uv"/>).</summary>
    public Vector2 Uv { get; init; }

    /// <summary>The way that it goes in the picture while the shutter is open, in pixels (<see cref="FirstHitParts.Motion"/>).</summary>
    public Vector2 Motion { get; init; }
}

/// <summary>The parts of <see cref="FirstHit"/> that cost time.</summary>
[Flags]
public enum FirstHitParts
{
    /// <summary>None of them.</summary>
    None = 0,

    /// <summary>The description of the surface.</summary>
    Surface = 1,

    /// <summary>The surface coordinates, with <see cref="Surface"/>.</summary>
    Uv = 2,

    /// <summary>The cost of the ray.</summary>
    Cost = 4,

    /// <summary>The way that it goes in the picture, with <see cref="Surface"/>.</summary>
    Motion = 8,
}

/// <summary>The samples whose numbers make a pixel's.</summary>
public enum MeanOver
{
    /// <summary>All samples; those that meet nothing have the numbers of an empty <see cref="FirstHit"/>.</summary>
    Samples,

    /// <summary>The samples that meet something.</summary>
    Hits,

    /// <summary>The pixel's first sample alone.</summary>
    First,
}
