using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Tests.Sampling;

/// <summary>A random decision of a path, drawn as the renderer draws it.</summary>
/// <param name="Name">What is decided.</param>
/// <param name="IsPair">Whether it takes two numbers.</param>
/// <param name="Draw">Draws them, for some pixels (by key) and samples.</param>
internal sealed record PathDimension(string Name, bool IsPair, PathDimension.Drawing Draw)
{
    /// <summary>The decisions that a path's first vertices, a late one, and lights on both sides of a batch of eight take.</summary>
    public static readonly PathDimension[] All =
    [
        OfCamera("pixel", Dimensions.Pixel),
        OfCamera("lens", Dimensions.Lens),
        OfCamera("third coordinate of the eye", Dimensions.Camera),
        Direction(0),
        Light(0, 0),
        Light(0, 1),
        Light(0, 8),
        Choice(0),
        Direction(1),
        Light(1, 0),
        Choice(1),
        Direction(2),
        Direction(20),
    ];

    /// <summary>Draws two numbers for each lane; those who take one leave the second at the first's value.</summary>
    public delegate void Drawing(Sampler sampler, in UIntW key, in UIntW sample, out FloatW u, out FloatW v);

    /// <summary>A decision by its name.</summary>
    public static PathDimension Named(string name) => All.Single(d => d.Name == name);

    /// <inheritdoc/>
    public override string ToString() => Name;

    private static PathDimension OfCamera(string name, uint group) => new(name, IsPair: true, (Sampler sampler, in UIntW key, in UIntW sample, out FloatW u, out FloatW v) =>
    {
        sampler.Begin(key, sample, group, out SamplePoints points);
        sampler.Pair(points, 0, out u, out v);
    });

    private static PathDimension Direction(uint vertex) =>
        new($"direction of vertex {vertex}", IsPair: true, (Sampler sampler, in UIntW key, in UIntW sample, out FloatW u, out FloatW v) =>
            Vertex(sampler, key, sample, vertex).Direction(out u, out v));

    private static PathDimension Light(uint vertex, int light) =>
        new($"light {light} of vertex {vertex}", IsPair: true, (Sampler sampler, in UIntW key, in UIntW sample, out FloatW u, out FloatW v) =>
            Vertex(sampler, key, sample, vertex).Light(light, out u, out v));

    private static PathDimension Choice(uint vertex) =>
        new($"choice of vertex {vertex}", IsPair: false, (Sampler sampler, in UIntW key, in UIntW sample, out FloatW u, out FloatW v) =>
            u = v = Vertex(sampler, key, sample, vertex).Choice());

    private static VertexSamples Vertex(Sampler sampler, in UIntW key, in UIntW sample, uint vertex)
    {
        VertexSamples samples = new(sampler);
        samples.Begin(key, sample, vertex);
        return samples;
    }
}

/// <summary>Numbers of one decision as plain arrays.</summary>
/// <param name="U">First numbers.</param>
/// <param name="V">Second numbers; the first ones again where the decision takes one only.</param>
internal sealed record DrawnNumbers(float[] U, float[] V)
{
    /// <summary>Makes a sampler.</summary>
    public static Sampler Sampler(SamplerKind kind, int samples) =>
        kind.Create(samples);

    /// <summary>One draw for each of many pixels.</summary>
    /// <param name="sampler">The sampler.</param>
    /// <param name="dimension">The decision.</param>
    /// <param name="count">How many draws.</param>
    /// <param name="key">The pixel key of a draw.</param>
    /// <param name="sample">The sample number of a draw.</param>
    public static DrawnNumbers Of(Sampler sampler, PathDimension dimension, int count, Func<int, uint> key, Func<int, uint> sample)
    {
        DrawnNumbers numbers = new(new float[count], new float[count]);
        Span<uint> keys = stackalloc uint[FloatW.Count];
        Span<uint> samples = stackalloc uint[FloatW.Count];
        for (int i = 0; i < count; i += FloatW.Count)
        {
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                keys[lane] = key(i + lane);
                samples[lane] = sample(i + lane);
            }

            dimension.Draw(sampler, new UIntW(new(keys)), new UIntW(new(samples)), out FloatW u, out FloatW v);
            for (int lane = 0; lane < FloatW.Count && i + lane < count; lane++)
            {
                numbers.U[i + lane] = u[lane];
                numbers.V[i + lane] = v[lane];
            }
        }

        return numbers;
    }

    /// <summary>All samples of one pixel.</summary>
    public static DrawnNumbers OfPixel(Sampler sampler, PathDimension dimension, uint key) =>
        Of(sampler, dimension, sampler.SamplesPerPixel, _ => key, i => (uint)Math.Min(i, sampler.SamplesPerPixel - 1));

    /// <summary>The numbers, one array after the other.</summary>
    public IEnumerable<float[]> Coordinates(PathDimension dimension) => dimension.IsPair ? [U, V] : [U];
}
