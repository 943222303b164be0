using System.Diagnostics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>What a thread is busy with while it renders.</summary>
internal enum Stage
{
    /// <summary>Loops between the stages, passes, and whatever has no stage of its own.</summary>
    Rest,

    /// <summary>New paths: the place in the pixel, and the camera's ray.</summary>
    Generate,

    /// <summary>The nearest hits of a stream.</summary>
    Intersect,

    /// <summary>Sorting hits by what is shaded together.</summary>
    Sort,

    /// <summary>Point, normals and coordinates of what was hit.</summary>
    Describe,

    /// <summary>Random numbers, but for those of new paths.</summary>
    Random,

    /// <summary>Points of lights, and what the material makes of their light.</summary>
    Light,

    /// <summary>Shadow rays.</summary>
    Shadow,

    /// <summary>The choice of the next ray.</summary>
    Scatter,

    /// <summary>Shading apart from that: state that is read and written, emission, media, rays that left the scene.</summary>
    Shade,

    /// <summary>Samples added up, and handed over to the film.</summary>
    Film,
}

/// <summary>Measures what one thread spends on each <see cref="Stage"/>. Each reading takes some time itself, as much as a few operations on a packet.</summary>
internal sealed class StageClock
{
    private readonly long[] _ticks = new long[Enum.GetValues<Stage>().Length];
    private readonly long[] _readings = new long[Enum.GetValues<Stage>().Length];
    private Stage _stage;
    private long _since;

    /// <summary>Begins a measurement.</summary>
    public void Start()
    {
        Array.Clear(_ticks);
        Array.Clear(_readings);
        _stage = Stage.Rest;
        _since = Stopwatch.GetTimestamp();
    }

    /// <summary>Turns to a stage.</summary>
    /// <returns>The stage before, which goes on later.</returns>
    public Stage Enter(Stage stage)
    {
        long now = Stopwatch.GetTimestamp();
        (Stage before, _stage) = (_stage, stage);
        _ticks[(int)before] += now - _since;
        _readings[(int)before]++;
        _since = now;
        return before;
    }

    /// <summary>The time in seconds that each stage took, to be asked after the last reading. The sum is that of a render without a clock.</summary>
    /// <param name="plain">What that render took: the rest is what the readings took, each as much as the others.</param>
    public IReadOnlyDictionary<Stage, double> Seconds(double plain)
    {
        double ticksOfReading = double.Max(_ticks.Sum() - (plain * Stopwatch.Frequency), 0) / _readings.Sum();
        Dictionary<Stage, double> left = Enum.GetValues<Stage>().ToDictionary(s => s, s => double.Max(_ticks[(int)s] - (_readings[(int)s] * ticksOfReading), 0));
        double sum = left.Values.Sum();
        return left.ToDictionary(s => s.Key, s => s.Value / sum * plain);
    }

    /// <summary>The same samples, with their time as <see cref="Stage.Random"/>.</summary>
    public SamplerKind Timed(SamplerKind kind) => new Kind(kind, this);

    private sealed class Kind(SamplerKind kind, StageClock clock) : SamplerKind(kind.Name)
    {
        public override bool DependsOnCount => kind.DependsOnCount;

        public override string? Complaint(int samplesPerPixel) => kind.Complaint(samplesPerPixel);

        public override Sampler Create(int samplesPerPixel) => new Timer(kind.Create(samplesPerPixel), clock);
    }

    private sealed class Timer(Sampler sampler, StageClock clock) : Sampler(sampler.SamplesPerPixel)
    {
        public override void Begin(in UIntW pixelKey, in UIntW sample, in UIntW group, out SamplePoints points)
        {
            Stage before = Enter();
            sampler.Begin(pixelKey, sample, group, out points);
            clock.Enter(before);
        }

        public override void Begin(in UIntW pixelKey, in UIntW sample, uint group, out SamplePoints points)
        {
            Stage before = Enter();
            sampler.Begin(pixelKey, sample, group, out points);
            clock.Enter(before);
        }

        public override void Pair(in SamplePoints points, uint pair, out FloatW u, out FloatW v)
        {
            Stage before = Enter();
            sampler.Pair(points, pair, out u, out v);
            clock.Enter(before);
        }

        // Those of new paths belong to them.
        private Stage Enter() => clock._stage == Stage.Generate ? clock.Enter(Stage.Generate) : clock.Enter(Stage.Random);
    }
}
