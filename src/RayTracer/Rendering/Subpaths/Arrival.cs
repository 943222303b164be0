using System.Numerics;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>Light that a path brings to a pixel.</summary>
/// <param name="From">The number of vertices from the light.</param>
/// <param name="To">The number of vertices from the camera.</param>
/// <param name="IsMerge">True if the last of both are one.</param>
/// <param name="LightPath">The number of the light path in its pass, where vertices are connected.</param>
/// <param name="Point">The last vertex from the light, where there is one.</param>
/// <param name="Light">The light with its weight.</param>
/// <param name="Alone">The light without.</param>
/// <param name="Factors">What the light without its weight is a product of.</param>
internal readonly record struct Arrival(uint From, uint To, bool IsMerge, uint LightPath, Vector3 Point, Rgb Light, Rgb Alone, WayFactors Factors);

/// <summary>Takes the light that paths bring, from any thread.</summary>
internal interface IArrivals
{
    /// <summary>Takes light.</summary>
    /// <param name="pixel">The pixel's number, row by row.</param>
    /// <param name="arrival">The light.</param>
    void Add(uint pixel, in Arrival arrival);
}

/// <summary>The ways in which a packet of paths was made.</summary>
internal struct WaysW
{
    /// <summary>Numbers of vertices from the lights.</summary>
    public UIntW From;

    /// <summary>Numbers of vertices from the camera.</summary>
    public UIntW To;

    /// <summary>Whether the last of both are one.</summary>
    public bool IsMerge;

    /// <summary>Numbers of the light paths in the pass, where vertices are connected.</summary>
    public UIntW LightPath;

    /// <summary>The last vertices from the lights, where there are such.</summary>
    public Vec3W Point;

    /// <summary>The factors of what they bring.</summary>
    public WayFactorsW Factors;
}
