using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// Places the samples of a pixel in the unit square of each pair of dimensions. A sampler has no state: the numbers are a
/// function of the pixel's key (which holds the seed), the sample and the pair, all in [0, 1).
/// <see cref="Dimensions"/> says which pair decides what.
/// </summary>
/// <param name="samplesPerPixel">The number of samples that a pixel will have.</param>
public abstract class Sampler(int samplesPerPixel)
{
    /// <summary>The number of samples that a pixel will have.</summary>
    public int SamplesPerPixel { get; } = samplesPerPixel;

    /// <summary>Prepares a group of pairs for each lane.</summary>
    /// <param name="pixelKey">Keys of the pixels (<see cref="Hash.PixelKey(uint, uint)"/>).</param>
    /// <param name="sample">Numbers of the samples, from 0.</param>
    /// <param name="group">Numbers of the groups (<see cref="Dimensions"/>).</param>
    /// <param name="points">The state for <see cref="Pair"/>.</param>
    public abstract void Begin(in UIntW pixelKey, in UIntW sample, in UIntW group, out SamplePoints points);

    /// <summary>
    /// As <see cref="Begin(in UIntW, in UIntW, in UIntW, out SamplePoints)"/>, for one of the camera's groups, the same in all lanes.
    /// </summary>
    public virtual void Begin(in UIntW pixelKey, in UIntW sample, uint group, out SamplePoints points) =>
        Begin(pixelKey, sample, (UIntW)group, out points);

    /// <summary>One point of the unit square for each lane.</summary>
    /// <param name="points">The group.</param>
    /// <param name="pair">Number of the pair in its group.</param>
    /// <param name="u">First coordinate.</param>
    /// <param name="v">Second coordinate.</param>
    public abstract void Pair(in SamplePoints points, uint pair, out FloatW u, out FloatW v);
}

/// <summary>The place of each lane in a group of pairs; the meaning of the numbers is up to the sampler.</summary>
public struct SamplePoints
{
    /// <summary>The group's key.</summary>
    public UIntW Key;

    /// <summary>The sample, or its place in the first coordinate.</summary>
    public UIntW First;

    /// <summary>Its place in the second coordinate.</summary>
    public UIntW Second;
}

/// <summary>
/// Which random numbers decide what. Pairs are gathered in groups. Different groups are independent of one another and
/// stratified separately; the pairs of one group may share the order in which their strata are visited. So what is
/// multiplied (a path's successive vertices, the lens and the pixel, a lobe and its direction) comes from different groups; what is only
/// added (the lights of one vertex, and the light that comes by the scattered ray) may come from one. No number is used
/// twice (the report used its own again down the recursion, which correlates the samples).
/// </summary>
public static class Dimensions
{
    /// <summary>Group of one pair: the position within the pixel.</summary>
    public const uint Pixel = 0;

    /// <summary>Group of one pair: the position on the lens.</summary>
    public const uint Lens = 1;

    /// <summary>Group of one pair: what else the camera needs, the third coordinate of the report's eye jitter.</summary>
    public const uint Camera = 2;

    /// <summary>
    /// Group of one pair, of which the first number counts: the time while the shutter is open. Beyond the groups of any vertex.
    /// </summary>
    public const uint Time = 1 << 16;

    /// <summary>Group of one pair, of which the first number counts: the path's wavelength, where it comes to depend on one.</summary>
    public const uint Wavelength = Time + 1;

    /// <summary>Group of one pair: the point of a light from which a light path starts. Beyond the groups of any vertex.</summary>
    internal const uint LightStart = 1 << 17;

    /// <summary>Group of one pair, of which the first number counts: the light that a light path starts from.</summary>
    internal const uint LightChoice = LightStart + 1;

    /// <summary>Group of one pair: the direction in which a light path starts; with the point, four dimensions.</summary>
    internal const uint LightDirection = LightStart + SecondOfFour;

    /// <summary>Groups of one pair each, 256 to a vertex and more: flights through media. Beyond all others.</summary>
    public const uint FirstFlight = 1 << 24;

    /// <summary>Groups of any count of numbers, by which rays are followed through media that vary. Beyond all others.</summary>
    internal const uint FirstStream = 1u << 31;

    /// <summary>
    /// The digit of a group's number that says that it and the group two before, where that digit is zero, may be the halves of points in four dimensions:
    /// the vertices of a path by twos, for instance a direction and the light where it leads.
    /// </summary>
    public const uint SecondOfFour = 2;

    /// <summary>The first group of the first vertex.</summary>
    public const uint FirstVertex = 4;

    /// <summary>Groups of a vertex: its directions, and the choice of a lobe.</summary>
    public const uint GroupsPerVertex = 2;

    /// <summary>In a vertex's first group: the direction of scattering.</summary>
    public const uint Direction = 0;

    /// <summary>In a vertex's first group: the point on the first light; the other lights follow.</summary>
    public const uint FirstLight = 1;
}
