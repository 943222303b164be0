using System.Runtime.CompilerServices;
using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// The random numbers of one vertex of each lane's path. An object that is used again for every packet, not a struct: a struct
/// with a reference in it would have the caller's whole stack frame cleared at every call.
/// </summary>
/// <param name="sampler">The source of the numbers.</param>
public sealed unsafe class VertexSamples(Sampler sampler)
{
    /// <summary>The largest number below one.</summary>
    internal const float LargestBelowOne = 0.99999994f;


    // Registers that lie across two cache lines are slow to store and load: the runtime aligns neither its stack nor its objects.
    private readonly PinnedBuffer<VertexW> _vertex = new(1);
    private bool _hasRest;

    // Some lanes are at first vertices that samples share; all are, and their samples come later.
    private bool _shares;
    private bool _isOfRays;

    /// <summary>The samples that share the camera's ray; null where none do.</summary>
    internal Splitting? Splitting { get; init; }

    /// <summary>True if those samples share the points of the lights, too, by which the first vertex is lit. To be set before a vertex begins.</summary>
    internal bool SharesLights { get; set; } = true;

    /// <summary>The key of the wavelengths of all paths of a sample; null where each path has its own.</summary>
    internal uint? SharedKey { get; init; }

    /// <summary>Turns to a vertex.</summary>
    /// <param name="pixelKey">Keys of the pixels.</param>
    /// <param name="sample">Numbers of the samples.</param>
    /// <param name="vertex">Number of the vertex on its path, from 0.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Begin(UIntW pixelKey, UIntW sample, UIntW vertex)
    {
        ref VertexW at = ref *_vertex.Pointer;
        at.PixelKey = pixelKey;
        at.Sample = sample;
        at.Group = (vertex * Dimensions.GroupsPerVertex) + Dimensions.FirstVertex;
        sampler.Begin(at.PixelKey, at.Sample, at.Group, out at.Points);
        _hasRest = false;
        _shares = _isOfRays = false;
        if (Splitting is not null && SharesLights)
        {
            Share(vertex);
        }
    }

    /// <summary>Turns to the first vertices of rays that samples share, for the numbers of their lights; <see cref="Turn"/> has those of each sample.</summary>
    /// <param name="pixelKey">Keys of the pixels.</param>
    /// <param name="ray">Numbers of the rays.</param>
    internal void BeginRays(in UIntW pixelKey, in UIntW ray)
    {
        ref VertexW at = ref *_vertex.Pointer;
        at.PixelKey = pixelKey;
        at.Group = Dimensions.FirstVertex;
        at.Ray = ray;
        _shares = _isOfRays = SharesLights;
        Splitting!.Sampler.Begin(at.PixelKey, at.Ray, at.Group, out at.RayPoints);
    }

    /// <summary>Turns to one of the samples that share each ray.</summary>
    /// <param name="sample">Numbers of the samples.</param>
    internal void Turn(in UIntW sample)
    {
        ref VertexW at = ref *_vertex.Pointer;
        at.Sample = sample;
        sampler.Begin(at.PixelKey, at.Sample, at.Group, out at.Points);
        _hasRest = false;
    }

    /// <summary>The lanes at the first vertices of their paths.</summary>
    internal MaskW IsFirst => UIntW.Equal(_vertex.Pointer->Group, Dimensions.FirstVertex);

    /// <summary>The two numbers that choose the direction of scattering.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Direction(out FloatW u, out FloatW v) => Pair(Dimensions.Direction, out u, out v);

    /// <summary>The number that chooses between lobes.</summary>
    public FloatW Choice()
    {
        if (_hasRest)
        {
            return _vertex.Pointer->Rest;
        }

        Decisions(0, out FloatW u, out _);
        return u;
    }

    /// <summary>
    /// Chooses one of two parts. What is left of the number, again spread evenly over [0, 1), then is the parts' own <see cref="Choice"/>:
    /// to be given to each of them by <see cref="Leave"/>.
    /// </summary>
    /// <param name="probability">That of the second part.</param>
    /// <param name="rest">The rest of the number.</param>
    public MaskW Choose(in FloatW probability, out FloatW rest) => Choose(Choice(), probability, out rest);

    /// <summary>Chooses one of two parts by a number, and returns what is left of it.</summary>
    /// <param name="u">The number.</param>
    /// <param name="probability">That of the second part.</param>
    /// <param name="rest">The rest of the number, again spread evenly over [0, 1).</param>
    internal static MaskW Choose(in FloatW u, in FloatW probability, out FloatW rest)
    {
        MaskW second = u < probability;
        rest = second.Select(u / probability, (u - probability) / (1f - probability));
        rest = FloatW.Min(rest, LargestBelowOne);
        return second;
    }

    /// <summary>Sets the number that the next <see cref="Choice"/> of this vertex is.</summary>
    public void Leave(in FloatW rest)
    {
        _vertex.Pointer->Rest = rest;
        _hasRest = true;
    }

    /// <summary>The number that decides whether a path continues.</summary>
    public FloatW Roulette()
    {
        Decisions(0, out _, out FloatW v);
        return v;
    }

    /// <summary>The number that chooses one light of many.</summary>
    public FloatW LightChoice()
    {
        Decisions(1, out FloatW u, out _);
        return u;
    }

    /// <summary>The two numbers that choose a point on a light.</summary>
    /// <param name="light">The light's number.</param>
    /// <param name="u">First number.</param>
    /// <param name="v">Second number.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public void Light(int light, out FloatW u, out FloatW v)
    {
        uint pair = Dimensions.FirstLight + (uint)light;
        if (_shares)
        {
            SharedPair(pair, out u, out v);
        }
        else
        {
            Pair(pair, out u, out v);
        }
    }

    /// <summary>The two numbers that decide how far a path flies through a medium.</summary>
    /// <param name="crossings">The number of boundaries that it has crossed since the vertex.</param>
    /// <param name="u">First number.</param>
    /// <param name="v">Second number.</param>
    public void Flight(UIntW crossings, out FloatW u, out FloatW v)
    {
        sampler.Begin(_vertex.Pointer->PixelKey, _vertex.Pointer->Sample, (_vertex.Pointer->Group << 8) + Dimensions.FirstFlight + crossings, out SamplePoints points);
        sampler.Pair(points, 0, out u, out v);
    }

    /// <summary>The keys of as many numbers as a ray from the vertex may need, without an order among them.</summary>
    /// <param name="ray">Numbers of the rays, in what they are different.</param>
    internal UIntW Stream(in UIntW ray)
    {
        UIntW group = (_vertex.Pointer->Group << 8) + Dimensions.FirstStream;
        return Hash.Mix(Hash.Mix(Hash.GroupKey(_vertex.Pointer->PixelKey, group) + (_vertex.Pointer->Sample * 0x85EBCA6Bu)) + (ray * Hash.Golden));
    }

    /// <summary>The number that chooses the path's wavelength: the same at all of its vertices, and of all paths of a sample where those are merged.</summary>
    public FloatW Wavelength() => Wavelength(_vertex.Pointer->PixelKey, _vertex.Pointer->Sample);

    /// <summary>The number that chooses a path's wavelength.</summary>
    /// <param name="pixelKey">Keys of the pixels.</param>
    /// <param name="sample">Numbers of the samples.</param>
    internal FloatW Wavelength(UIntW pixelKey, UIntW sample)
    {
        sampler.Begin(SharedKey is uint shared ? shared : pixelKey, sample, Dimensions.Wavelength, out SamplePoints points);
        sampler.Pair(points, 0, out FloatW u, out _);
        return u;
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private void Pair(uint pair, out FloatW u, out FloatW v)
    {
        ref VertexW at = ref *_vertex.Pointer;
        sampler.Pair(at.Points, pair, out at.U, out at.V);
        u = at.U;
        v = at.V;
    }

    private void SharedPair(uint pair, out FloatW u, out FloatW v)
    {
        ref VertexW at = ref *_vertex.Pointer;
        Splitting!.Sampler.Pair(at.RayPoints, pair, out u, out v);
        if (!_isOfRays)
        {
            sampler.Pair(at.Points, pair, out at.U, out at.V);
            (u, v) = (at.OfRay.Select(u, at.U), at.OfRay.Select(v, at.V));
        }
    }

    private void Share(in UIntW vertex)
    {
        ref VertexW at = ref *_vertex.Pointer;
        at.OfRay = UIntW.Equal(vertex, 0u);
        _shares = at.OfRay.Any;
        if (_shares)
        {
            at.Ray = Splitting!.RayOf(at.Sample);
            Splitting.Sampler.Begin(at.PixelKey, at.Ray, at.Group, out at.RayPoints);
        }
    }

    private void Decisions(uint pair, out FloatW u, out FloatW v)
    {
        ref VertexW at = ref *_vertex.Pointer;
        at.Next = at.Group + 1u;
        sampler.Begin(at.PixelKey, at.Sample, at.Next, out at.Decisions);
        sampler.Pair(at.Decisions, pair, out at.U, out at.V);
        u = at.U;
        v = at.V;
    }

    private struct VertexW
    {
        public UIntW PixelKey;
        public UIntW Sample;
        public UIntW Group;
        public SamplePoints Points;
        public SamplePoints Decisions;
        public SamplePoints RayPoints;
        public MaskW OfRay;
        public UIntW Ray;
        public UIntW Next;
        public FloatW U, V;
        public FloatW Rest;
    }
}
