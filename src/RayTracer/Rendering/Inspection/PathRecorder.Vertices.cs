using System.Numerics;
using RayTracer.Description;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <content>What is known of a vertex beside what the renderer reports: computed once more, with its random numbers.</content>
internal sealed unsafe partial class PathRecorder
{
    // Where rounding alone makes the difference, a weight is the product of its factors.
    private const float Rounding = 1e-3f;
    private readonly uint _maxDepth = scene.Render.Integrator is DirectIntegrator ? 2 : scene.Render.MaxDepth < 0 ? RenderDescription.LongestPath : (uint)scene.Render.MaxDepth;

    private bool IsReport => scene.Render.Integrator is ReportIntegrator;

    private void Begin(ShadingGroup? group, PathStream stream, uint* index)
    {
        UIntW state = UIntW.Pick(stream.State, index);
        UIntW vertex = IsReport ? (state & PathState.DepthMask) + (state >> PathState.SpecularShift & PathState.DepthMask) : state & PathState.VertexMask;
        _questions.Begin(group, _pixelKey, UIntW.Pick(stream.Path, index) + (uint)_samples.First, vertex);
    }

    // What surfaces ask the lights; returns the colours of the wavelengths that paths get there.
    private RgbW Questions(ShadingGroup group, Material material, in SurfaceW surface, PathStream stream, uint* index, out List<LightQuestion>[] asked)
    {
        RgbW dispersion = Rgb.White;
        asked = [];
        if (!asks)
        {
            return dispersion;
        }

        Begin(group, stream, index);
        if (group.Traits.Disperses)
        {
            scene.Wavelengths!.Sample(_questions.Samples.Wavelength(), out _, out RgbW color);
            dispersion = UIntW.Equal(UIntW.Pick(stream.State, index) & PathState.HasWavelength, 0u).Select(color, dispersion);
        }

        if (IsReport ? group.Traits.IsLit : group.Traits.HasDensity)
        {
            asked = _questions.AtSurfaces(group, material, surface, scene.IsTimed ? FloatW.Pick(stream.Time, index) : 0f);
        }

        return dispersion;
    }

    private bool AsksLights(PathVertex vertex, uint state)
    {
        Integrator integrator = scene.Render.Integrator;
        return asks && integrator.Has(IntegratorTraits.Light) && (IsReport || vertex.Number + 1 < _maxDepth)
            && (integrator is not LightTracingIntegrator light || (light.Strategies & Strategies.Lights) != Strategies.None) && !IsInPhotons(state);
    }

    // Beyond the first place where they scatter, paths that gather photons ask nothing.
    private bool IsInPhotons(uint state) =>
        scene.Render.Integrator is LightTracingIntegrator light && (light.Strategies & (Strategies.Camera | Strategies.Merges)) == Strategies.Merges && (state & PathState.HasScattered) != 0;

    // Which of the questions the renderer has answered, and how.
    private List<LightQuestion> Answer(Path path, List<LightQuestion>[] asked, int lane, PathVertex vertex, uint state)
    {
        if (asked.Length == 0 || !AsksLights(vertex, state))
        {
            return [];
        }

        bool isExact = !scene.TracksInteriors && !scene.WeakensShadows;
        Rgb factor = vertex.Throughput * vertex.Dispersion;
        foreach (LitPoint lit in path.Lit)
        {
            LightQuestion? question = asked[lane].Find(q => q is { IsAnswered: false, Answer.Outcome: LightOutcome.Arrives } && q.Answer.Light == lit.Light
                && (!isExact || IsNear(lit.Radiance * lit.Weight, q.Expected * factor)));
            question?.Wait(lit, question.Expected * factor);
        }

        return asked[lane];
    }

    private TracedEmission Met(Path path, PathVertex vertex, ShadingGroup group, PathStream stream, uint i, Rgb sent)
    {
        int light = _emitters.Find(group, (uint)vertex.Instance, (uint)vertex.Primitive);
        float weight = Share(path.Emitted, vertex.Throughput * sent);
        if (IsReport || scene.Render.Integrator is LightTracingIntegrator || light < 0 || (stream.State[i] & PathState.CountsEmission) != 0)
        {
            return new(light, sent, null, null, weight);
        }

        float travelled = scene.TracksInteriors ? stream.Travelled[i] : 0;
        LightHitW hit = new()
        {
            From = new(stream.OriginX[i] - (travelled * stream.DirectionX[i]), stream.OriginY[i] - (travelled * stream.DirectionY[i]), stream.OriginZ[i] - (travelled * stream.DirectionZ[i])),
            FromNormal = scene.LightSelection is null ? default : new(stream.NormalX[i], stream.NormalY[i], stream.NormalZ[i]),
            Direction = new(stream.DirectionX[i], stream.DirectionY[i], stream.DirectionZ[i]),
            Distance = stream.Distance[i] + travelled,
            Cosine = CosineOf(vertex, group, stream, i),
            Time = scene.IsTimed ? stream.Time[i] : 0f,
            Primitive = stream.Primitive[i],
        };
        _emitters.Pdf(group, (uint)vertex.Instance, hit, MaskW.First(1), out FloatW pdf);
        return new(light, sent, stream.Pdf[i], pdf[0] * (vertex.Number == 1 ? scene.PointsOfFirst : 1), weight);
    }

    private FloatW CosineOf(PathVertex vertex, ShadingGroup group, PathStream stream, uint i)
    {
        uint* index = stackalloc uint[16];
        new Span<uint>(index, 16).Fill(i);
        SurfaceShader.Describe(scene, group, stream, index, group.Traits.UsesUv, out SurfaceW surface);
        return SurfaceShader.CosineOfEmission(surface);
    }

    // Why a path ends that could have been scattered.
    private PathEnd EndOf(PathVertex vertex, uint state, bool leaks)
    {
        bool isForLight = scene.Render.Integrator is LightTracingIntegrator { Strategies: Strategies.Seen | Strategies.Camera };
        Rgb left = vertex.Throughput * vertex.Dispersion * vertex.Weight;
        return !IsReport && vertex.Number + 1 >= _maxDepth ? PathEnd.Depth
            : left.R <= 0 && left.G <= 0 && left.B <= 0 ? PathEnd.Dark
            : leaks ? PathEnd.Leaks
            : asks && (isForLight || IsInPhotons(state)) ? PathEnd.Gathered
            : IsReport || vertex.Number + 1 <= scene.Render.RouletteDepth ? PathEnd.Depth : PathEnd.Roulette;
    }

    private int InstanceOf(PathStream stream, uint i) => scene.World.Instances is null ? 0 : (int)stream.Instance[i];

    private static float Share(Rgb part, Rgb whole) => whole.Luminance == 0 ? 0 : part.Luminance / whole.Luminance is var share && float.Abs(share - 1) < 1e-5f ? 1 : share;

    private static bool IsProduct(Rgb weight, Rgb bsdf, float factor) =>
        float.Abs(weight.R - (bsdf.R * factor)) <= Rounding * weight.R && float.Abs(weight.G - (bsdf.G * factor)) <= Rounding * weight.G
        && float.Abs(weight.B - (bsdf.B * factor)) <= Rounding * weight.B;

    private static bool IsNear(Rgb a, Rgb b) => IsProduct(a, b, 1);

    private void Gathered(PathStream stream, uint* index, MaskW lanes, in RgbW radiance, bool isEmission)
    {
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            Path path = _paths[stream.Path[index[lane]]];
            path.AfterAmbient = Lane(radiance, lane);
            path.AfterEmission = isEmission ? path.AfterAmbient : path.AfterEmission;
        }
    }

    private static PathVertex Arrival(PathStream stream, uint i, PathEvent met)
    {
        Rgb before = new(stream.RadianceR[i], stream.RadianceG[i], stream.RadianceB[i]);
        return new()
        {
            Event = met,
            Origin = new(stream.OriginX[i], stream.OriginY[i], stream.OriginZ[i]),
            Direction = new(stream.DirectionX[i], stream.DirectionY[i], stream.DirectionZ[i]),
            Throughput = new(stream.ThroughputR[i], stream.ThroughputG[i], stream.ThroughputB[i]),
            Before = before,
            AfterEmission = before,
            AfterAmbient = before,
            Number = stream.State[i] & PathState.VertexMask,
        };
    }

    private static Vector3 Lane(in Vec3W v, int lane) => new(v.X[lane], v.Y[lane], v.Z[lane]);

    private static Rgb Lane(in RgbW c, int lane) => new(c.R[lane], c.G[lane], c.B[lane]);

    private sealed class Path
    {
        // What it carried when it left its last vertex; null at the camera.
        private Rgb? _left;

        public List<PathVertex> Vertices { get; } = [];

        public List<List<LightQuestion>> Questions { get; } = [];

        public List<LitPoint> Lit { get; } = [];

        public TracedEmission? Emission { get; set; }

        public Rgb Emitted { get; set; }

        public Rgb Radiance { get; private set; }

        public Rgb AfterEmission { get; set; }

        public Rgb AfterAmbient { get; set; }

        public void Add(PathVertex vertex, List<LightQuestion> questions)
        {
            Rgb passed = _left is { } left ? new(Ratio(vertex.Throughput.R, left.R), Ratio(vertex.Throughput.G, left.G), Ratio(vertex.Throughput.B, left.B)) : Rgb.White;
            Vertices.Add(vertex with { Emission = Emission, Passed = passed });
            Questions.Add(questions);
            Emission = null;
            Emitted = Rgb.Black;
            Lit.Clear();
        }

        // Where nothing is met, all that is added is the background.
        public void Close(Rgb radiance, Rgb? left)
        {
            Radiance = radiance;
            PathVertex last = Vertices[^1];
            Vertices[^1] = last.Event == PathEvent.Missed
                ? last with { AfterEmission = radiance, AfterAmbient = radiance, After = radiance }
                : last with { After = radiance, Survival = left is { } on ? SurvivalOf(last.Throughput * last.Dispersion * last.Weight, on) : 1 };
            _left = left;
        }

        private static float SurvivalOf(Rgb before, Rgb after)
        {
            float chance = after.Luminance > 0 ? before.Luminance / after.Luminance : 1;
            return float.Abs(chance - 1) < 1e-5f ? 1 : chance;
        }

        private static float Ratio(float part, float whole) => whole == 0 || float.Abs((part / whole) - 1) < 1e-6f ? 1 : part / whole;
    }
}

/// <summary>The renderer's word on a point of a light.</summary>
/// <param name="light">The light's number.</param>
/// <param name="radiance">What arrives, if nothing is in the way.</param>
/// <param name="weight">The factor on that.</param>
internal sealed class LitPoint(int light, Rgb radiance, Rgb weight)
{
    /// <summary>The light's number.</summary>
    public int Light => light;

    /// <summary>What arrives, if nothing is in the way.</summary>
    public Rgb Radiance => radiance;

    /// <summary>The factor on that.</summary>
    public Rgb Weight => weight;

    /// <summary>The light that is added.</summary>
    public Rgb Contribution => IsFree ? radiance * weight : Rgb.Black;

    private bool IsFree { get; set; } = true;

    /// <summary>Takes what has been found out of rays that had to wait.</summary>
    public void Settle(bool isFree) => IsFree = isFree;
}
