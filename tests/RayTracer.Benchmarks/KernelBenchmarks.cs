using System.Numerics;
using BenchmarkDotNet.Attributes;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Sampling;

namespace RayTracer.Benchmarks;

/// <summary>The kernels that a render spends its time in, each on a thousand packets of lanes.</summary>
public class KernelBenchmarks
{
    private const int Packets = 1000;
    private readonly Vec3W[] _directions = new Vec3W[Packets];
    private readonly FloatW[] _numbers = new FloatW[Packets];
    private PrimitiveList _primitives = null!;

    /// <summary>Which sampler is measured.</summary>
    [ParamsSource(nameof(Samplers))]
    public SamplerKind Sampler { get; set; } = SamplerKind.Sobol;

    /// <summary>All of them.</summary>
    public static IEnumerable<SamplerKind> Samplers => SamplerKind.Known.All;

    private Sampler _sampler = null!;

    [GlobalSetup]
    public void Setup()
    {
        Scene scene = new SceneBuilder((_, _) => throw new NotSupportedException()).Build(PrototypeScene.Create(Sampler, 16))!;
        _primitives = scene.Primitives;
        _sampler = scene.Sampler;
        for (int i = 0; i < Packets; i++)
        {
            _sampler.Begin(Hash.PixelKey(1, (uint)i), UIntW.Iota, Dimensions.FirstVertex, out SamplePoints points);
            _sampler.Pair(points, 0, out FloatW u, out FloatW v);
            _directions[i] = Vec3W.Normalize(new(u - 0.5f, v * -0.5f, 1f));
            _numbers[i] = u + 0.01f;
        }
    }

    [Benchmark]
    public float ClosestHit()
    {
        FloatW sum = 0f;
        Vec3W eye = new Vector3(0, 3, -9);
        foreach (Vec3W direction in _directions)
        {
            _primitives.ClosestHit(eye, direction, out FloatW distance, out _);
            sum += distance;
        }

        return sum[0];
    }

    [Benchmark]
    public uint Occlude()
    {
        uint free = 0;
        Vec3W eye = new Vector3(0, 3, -9);
        foreach (Vec3W direction in _directions)
        {
            MaskW open = MaskW.All;
            _primitives.Occlude(eye, direction, 12f, -1, ref open);
            free += open.Bits;
        }

        return free;
    }

    [Benchmark]
    public float Pair()
    {
        FloatW sum = 0f;
        for (uint i = 0; i < Packets; i++)
        {
            _sampler.Begin(UIntW.Iota + i, UIntW.Iota, Dimensions.FirstVertex, out SamplePoints points);
            _sampler.Pair(points, 1, out FloatW u, out FloatW v);
            sum += u + v;
        }

        return sum[0];
    }

    [Benchmark]
    public float Pow()
    {
        FloatW sum = 0f;
        foreach (FloatW x in _numbers)
        {
            sum += LaneMath.Pow(x, 0.3f);
        }

        return sum[0];
    }
}
