using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// The random numbers of one vertex of each lane's path. An object that is used again for every packet, not a struct: a struct
/// with a reference in it would have the caller's whole stack frame cleared at every call.
/// </summary>
/// <param name="sampler">Where the numbers come from.</param>
public sealed class VertexSamples(Sampler sampler)
{
    private UIntW _pixelKey;
    private UIntW _sample;
    private UIntW _group;
    private SamplePoints _points;

    /// <summary>Turns to a vertex.</summary>
    /// <param name="pixelKey">Keys of the pixels.</param>
    /// <param name="sample">Numbers of the samples.</param>
    /// <param name="vertex">Number of the vertex on its path, from 0.</param>
    public void Begin(in UIntW pixelKey, in UIntW sample, in UIntW vertex)
    {
        _pixelKey = pixelKey;
        _sample = sample;
        _group = (vertex * Dimensions.GroupsPerVertex) + Dimensions.FirstVertex;
        sampler.Begin(pixelKey, sample, _group, out _points);
    }

    /// <summary>The two numbers that choose the direction of scattering.</summary>
    public void Direction(out FloatW u, out FloatW v) => sampler.Pair(_points, Dimensions.Direction, out u, out v);

    /// <summary>The number that chooses between lobes.</summary>
    public FloatW Choice()
    {
        Decisions(out FloatW u, out _);
        return u;
    }

    /// <summary>The number that decides whether a path goes on.</summary>
    public FloatW Roulette()
    {
        Decisions(out _, out FloatW v);
        return v;
    }

    /// <summary>The two numbers that choose a point on a light.</summary>
    /// <param name="light">The light's number.</param>
    /// <param name="u">First number.</param>
    /// <param name="v">Second number.</param>
    public void Light(int light, out FloatW u, out FloatW v) =>
        sampler.Pair(_points, Dimensions.FirstLight + (uint)light, out u, out v);

    /// <summary>The two numbers that decide how far a path flies through a medium.</summary>
    /// <param name="crossings">How many boundaries it has crossed since the vertex.</param>
    /// <param name="u">First number.</param>
    /// <param name="v">Second number.</param>
    public void Flight(UIntW crossings, out FloatW u, out FloatW v)
    {
        sampler.Begin(_pixelKey, _sample, (_group << 8) + Dimensions.FirstFlight + crossings, out SamplePoints points);
        sampler.Pair(points, 0, out u, out v);
    }

    private void Decisions(out FloatW u, out FloatW v)
    {
        sampler.Begin(_pixelKey, _sample, _group + 1u, out SamplePoints points);
        sampler.Pair(points, 0, out u, out v);
    }
}
