using System.Numerics;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;

namespace RayTracer.Rendering;

/// <summary>
/// Repeats what vertices ask of lights, with the same random numbers, to say what each factor was and why nothing arrives. Whether it does, and how
/// much, is the renderer's own word; nothing here is part of a rendering.
/// </summary>
/// <param name="scene">The scene.</param>
internal sealed unsafe class LightQuestions(Scene scene)
{
    private readonly LightSource[] _lights = [.. scene.SampledLights];
    private readonly bool _isReport = scene.Render.Integrator.Has(Description.IntegratorTraits.WeakenedShadows);
    private readonly bool _isOfSubpaths = scene.Render.Integrator.Has(Description.IntegratorTraits.TracesLight);
    private readonly VertexSamples _samples = new(scene.Sampler) { SharedKey = scene.SharedKey, Splitting = scene.Splitting };
    private readonly ShadowProbe _probe = new(scene);

    /// <summary>The random numbers of the vertices.</summary>
    public VertexSamples Samples => _samples;

    /// <summary>Turns to vertices.</summary>
    public void Begin(ShadingGroup? group, in UIntW pixelKey, in UIntW sample, in UIntW vertex)
    {
        _samples.SharesLights = _isReport || group?.Traits.Specular is null or SpecularLobe.None;
        _samples.Begin(pixelKey, sample, vertex);
    }

    /// <summary>What surfaces ask.</summary>
    /// <param name="group">Their group.</param>
    /// <param name="material">Their material.</param>
    /// <param name="surface">The surfaces.</param>
    /// <param name="time">Times in seconds.</param>
    /// <returns>For each lane its questions, in the order of the renderer's.</returns>
    public List<LightQuestion>[] AtSurfaces(ShadingGroup group, Material material, in SurfaceW surface, in FloatW time)
    {
        SurfaceW at = surface;
        bool isLiteral = group.MayBeLiteral && scene.IsLiteral;
        bool transmits = !_isReport && group.Traits.Transmits;
        bool leaves = _isOfSubpaths || transmits || isLiteral;
        Vec3W side = group.MayLeak ? surface.Inside.Select(-surface.Normal, surface.Normal) : surface.Facing;
        Vec3W from = leaves ? surface.Point : Vec3W.MultiplyAdd(side, surface.Offset, surface.Point);
        Vec3W normal = transmits ? default : surface.Facing;
        List<LightQuestion>[] asked = Sample(from, normal, time, _isOfSubpaths ? 1 : scene.PointsOfFirst, (int light, in ShapeSampleW sample, in RgbW radiance, MaskW lanes, List<LightQuestion>[] lists) =>
        {
            RgbW bsdf;
            FloatW pdf = 0f;
            if (_isReport)
            {
                material.Brdf(at, out bsdf);
            }
            else
            {
                material.Evaluate(at, sample.Direction, out bsdf, out pdf);
            }

            FloatW cosine = Vec3W.Dot(sample.Direction, at.Facing);
            MaskW behind = transmits ? MaskW.None : cosine <= 0f;
            behind = _isOfSubpaths ? behind & IsDark(bsdf) : behind;
            MaskW leaks = _isOfSubpaths ? SurfaceShader.Dropped(at, sample.Direction)
                : transmits ? isLiteral ? MaskW.None : SurfaceShader.Leaks(at, sample.Direction)
                : group.MayLeak && !isLiteral ? Vec3W.Dot(sample.Direction, side) <= 0f : MaskW.None;
            MaskW unlit = sample.InversePdf <= 0f;
            unlit = _isOfSubpaths && !_lights[light].IsDelta ? unlit | (sample.Cosine <= 0f) : unlit;
            Add(light, sample, radiance, bsdf, FloatW.Abs(cosine), pdf, unlit, behind, leaks, lanes, lists);
        });
        Vec3W start = leaves ? surface.Point : from;
        return Placed(asked, start, surface.Facing, surface.Offset, leaves, time);
    }

    /// <summary>What is asked in media.</summary>
    public List<LightQuestion>[] InMedia(in Vec3W point, in Vec3W incoming, in UIntW media, in FloatW time)
    {
        Vec3W arriving = incoming;
        (Vec3W place, UIntW stack) = (point, media);
        List<LightQuestion>[] asked = Sample(point, default, time, 1, (int light, in ShapeSampleW sample, in RgbW radiance, MaskW lanes, List<LightQuestion>[] lists) =>
        {
            FloatW phase = scene.Media.Phase(stack, place, arriving, sample.Direction);
            Add(light, sample, radiance, new(phase, phase, phase), 1f, phase, sample.InversePdf <= 0f, MaskW.None, MaskW.None, lanes, lists);
        });
        return Placed(asked, point, default, 0f, false, time);
    }

    private delegate void Asking(int light, in ShapeSampleW sample, in RgbW radiance, MaskW lanes, List<LightQuestion>[] lists);

    private List<LightQuestion>[] Sample(in Vec3W from, in Vec3W normal, in FloatW time, int most, Asking ask)
    {
        List<LightQuestion>[] lists = [.. Enumerable.Range(0, FloatW.Count).Select(_ => new List<LightQuestion>())];
        FloatW share = most > 1 ? _samples.IsFirst.Select(1f / most, 1f) : 1f;
        for (int point = 0; point < most; point++)
        {
            MaskW lanes = point == 0 ? MaskW.All : _samples.IsFirst;
            if (scene.LightSelection is null)
            {
                SampleAll(from, time, point, share, lanes, ask, lists);
            }
            else
            {
                SampleChosen(from, normal, time, point, share, lanes, ask, lists);
            }
        }

        return lists;
    }

    private void SampleAll(in Vec3W from, in FloatW time, int point, in FloatW share, MaskW lanes, Asking ask, List<LightQuestion>[] lists)
    {
        for (int light = 0; light < _lights.Length; light++)
        {
            bool isDelta = _lights[light].IsDelta;
            if (isDelta && point > 0)
            {
                continue;
            }

            _samples.Light((point * _lights.Length) + light, out FloatW u, out FloatW v);
            _lights[light].Sample(from, u, v, time, out ShapeSampleW sample, out RgbW radiance);
            sample.InversePdf *= isDelta ? 1f : share;
            ask(light, sample, isDelta ? radiance : radiance * share, lanes, lists);
        }
    }

    private void SampleChosen(in Vec3W from, in Vec3W normal, in FloatW time, int point, in FloatW share, MaskW lanes, Asking ask, List<LightQuestion>[] lists)
    {
        FloatW choice = FloatW.Min((_samples.LightChoice() + point) * share, VertexSamples.LargestBelowOne);
        scene.LightSelection!.Choose(from, normal, choice, out UIntW chosen, out FloatW probability);
        _samples.Light(point, out FloatW u, out FloatW v);
        FloatW inverse = share / probability;
        for (MaskW rest = lanes & probability > 0f; rest.Any;)
        {
            uint light = chosen[BitOperations.TrailingZeroCount(rest.Bits)];
            MaskW same = rest & UIntW.Equal(chosen, light);
            rest = rest.Except(same);
            _lights[light].Sample(from, u, v, time, out ShapeSampleW sample, out RgbW radiance);
            sample.InversePdf *= inverse;
            ask((int)light, sample, radiance * inverse, same, lists);
        }
    }

    private void Add(
        int light, in ShapeSampleW sample, in RgbW radiance, in RgbW bsdf, in FloatW cosine, in FloatW pdf, MaskW unlit, MaskW behind, MaskW leaks, MaskW lanes,
        List<LightQuestion>[] lists)
    {
        bool isShared = !_isReport && !_lights[light].IsDelta;
        FloatW weight = isShared ? DirectLight.Weight(1f, pdf * sample.InversePdf) : 1f;
        MaskW dark = IsDark(bsdf);
        for (uint rest = lanes.Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            bool Is(MaskW mask) => (mask.Bits >> lane & 1) != 0;
            LightOutcome outcome = Is(unlit) ? LightOutcome.Unlit : Is(behind) ? LightOutcome.Behind : Is(leaks) ? LightOutcome.Leaks
                : Is(dark) ? LightOutcome.NotScattered : LightOutcome.Arrives;
            float lightPdf = outcome == LightOutcome.Unlit ? 0 : 1 / sample.InversePdf[lane];
            lists[lane].Add(new(new()
            {
                Light = light,
                Outcome = outcome,
                Direction = new(sample.Direction.X[lane], sample.Direction.Y[lane], sample.Direction.Z[lane]),
                Distance = sample.Distance[lane],
                Radiance = new Rgb(radiance.R[lane], radiance.G[lane], radiance.B[lane]) * lightPdf,
                Pdf = lightPdf,
                ScatterPdf = isShared ? pdf[lane] : null,
                Bsdf = new(bsdf.R[lane], bsdf.G[lane], bsdf.B[lane]),
                Cosine = cosine[lane],
                Weight = weight[lane],
            }));
        }
    }

    private static MaskW IsDark(in RgbW bsdf) => (bsdf.R <= 0f) & (bsdf.G <= 0f) & (bsdf.B <= 0f);

    // Where the shadow rays start, for who looks for what is in their way.
    private List<LightQuestion>[] Placed(List<LightQuestion>[] asked, in Vec3W start, in Vec3W normal, in FloatW offset, bool leaves, in FloatW time)
    {
        for (int lane = 0; lane < asked.Length; lane++)
        {
            Vector3 point = new(start.X[lane], start.Y[lane], start.Z[lane]);
            Vector3 outward = new Vector3(normal.X[lane], normal.Y[lane], normal.Z[lane]) * offset[lane];
            foreach (LightQuestion question in asked[lane])
            {
                bool isBelow = leaves && outward.Dot(question.Answer.Direction) < 0;
                (question.Start, question.Time) = (leaves ? isBelow ? point - outward : point + outward : point, time[lane]);
                question.FindBlocker = () => _probe.Blocker(question.Start, question.Answer.Direction, question.Answer.Distance, question.Time, _lights[question.Answer.Light]);
            }
        }

        return asked;
    }
}

/// <summary>A question that waits for the renderer's answer.</summary>
/// <param name="answer">What is known of it.</param>
internal sealed class LightQuestion(TracedLight answer)
{
    private LitPoint? _point;
    private Rgb _expected;

    /// <summary>What is known of it.</summary>
    public TracedLight Answer { get; private set; } = answer;

    /// <summary>The start of its shadow ray.</summary>
    public Vector3 Start { get; set; }

    /// <summary>Its time.</summary>
    public float Time { get; set; }

    /// <summary>Looks for what is in the way.</summary>
    public Func<SurfaceName> FindBlocker { get; set; } = () => SurfaceName.None;

    /// <summary>Whether the renderer has answered.</summary>
    public bool IsAnswered => _point is not null;

    /// <summary>What it brings to the radiance at the vertex, if nothing is in the way.</summary>
    public Rgb Expected => Answer.Pdf > 0 ? Answer.Radiance * Answer.Bsdf * (Answer.Cosine * Answer.Weight / Answer.Pdf) : Rgb.Black;

    /// <summary>Takes the renderer's word, which may be known later.</summary>
    /// <param name="point">The word.</param>
    /// <param name="expected">The light that it would add if nothing were in the way; what is between them is transmittance.</param>
    public void Wait(LitPoint point, Rgb expected) => (_point, _expected) = (point, expected);

    /// <summary>Takes the weight that the renderer gave.</summary>
    public void Weigh(float weight) => Answer = Answer with { Weight = weight };

    /// <summary>The answer in the end.</summary>
    public TracedLight Settle()
    {
        if (Answer.Outcome != LightOutcome.Arrives)
        {
            return Answer;
        }

        Rgb arrived = _point?.Contribution ?? Rgb.Black;
        return arrived.IsBlack ? Answer with { Outcome = LightOutcome.Blocked, Blocker = FindBlocker() } : Answer with
        {
            Contribution = arrived,
            Transmittance = new(Ratio(arrived.R, _expected.R), Ratio(arrived.G, _expected.G), Ratio(arrived.B, _expected.B)),
        };
    }

    // Rounding is no transmittance.
    private static float Ratio(float part, float whole) => whole == 0 || float.Abs((part / whole) - 1) < 1e-5f ? 1 : part / whole;
}
