using System.Numerics;
using RayTracer.Cameras;
using RayTracer.Lights;
using RayTracer.Materials;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// Light paths: at each vertex they are connected with the camera, whose picture gets the light as splats, and kept for camera paths to be connected or
/// merged with. Throughput is power here (Veach 1997, chapter 10; adjoint scattering, section 5.3).
/// </summary>
internal sealed unsafe class LightSubpaths : SubpathShader
{
    // Light paths' vertices have random numbers beyond those of all camera paths.
    private const uint FirstGroup = 16384;
    private const int MostRays = 8192;
    private readonly Strategies _strategies;
    private readonly SplatSums _splats;
    private readonly Tile _area;
    private readonly ShadowRays _rays;
    private readonly PinnedBuffer<CameraLinkW> _link = new(1);
    private readonly StrategyRecorder? _recorder;
    private LightStarts _starts = null!;
    private LightVertex[] _vertices = new LightVertex[LightVertices.BlockSize];
    private int _count;
    private long _traced;

    /// <summary>Makes one.</summary>
    /// <param name="context">The context that it works in.</param>
    /// <param name="strategies">The work at the vertices.</param>
    /// <param name="splats">Takes the light of the picture.</param>
    /// <param name="area">The part of the picture that is wanted.</param>
    /// <param name="recorder">Records what reaches the camera; may be null.</param>
    public LightSubpaths(ShaderContext context, Strategies strategies, SplatSums splats, Tile area, StrategyRecorder? recorder)
        : base(context)
    {
        (_strategies, _splats, _area, _recorder) = (strategies, splats, area, recorder);
        _rays = new(Scene, MostRays);
    }

    /// <inheritdoc/>
    internal override long ShadowRays => _traced;

    /// <summary>The vertices of the paths since <see cref="Begin(LightStarts, PathWeights)"/>.</summary>
    public ReadOnlySpan<LightVertex> Vertices => _vertices.AsSpan(0, _count);

    /// <summary>Prepares for a block of paths.</summary>
    /// <param name="starts">Starts them.</param>
    /// <param name="weights">The constants of the pass.</param>
    public void Begin(LightStarts starts, PathWeights weights) => (_starts, Weights, _count) = (starts, weights, 0);

    /// <inheritdoc/>
    internal override void Flush(PathStream next) => TraceSplats();

    /// <inheritdoc/>
    internal override void Miss(PathStream stream, uint* members, int count)
    {
        for (int i = 0; Observer is not null && i < count; i += FloatW.Count)
        {
            Observer.Missed(stream, members + i, MaskW.First(count - i), default);
        }
    }

    /// <inheritdoc/>
    protected override void BeginVertex(in UIntW path, in UIntW vertex) =>
        Vertex.Begin(UIntW.Gather(_starts.PixelKeys, path), UIntW.Gather(_starts.Samples, path), vertex + FirstGroup);

    /// <inheritdoc/>
    protected override void Arrive(ShadingGroup group, PathStream stream, uint* index, MaskW first)
    {
        ref VertexW at = ref At;
        at.Surface.CarriesLight = true;
        if (first.Any)
        {
            Start(group, first, ref at);
        }

        SubpathSumsW sums = at.Sums;
        sums.Arrive(at.Distance * at.Distance, at.Cosine);
        at.Sums.Vcm = first.Select(at.Sums.Vcm, sums.Vcm);
        at.Sums.Vc = sums.Vc;
        at.Sums.Vm = sums.Vm;
    }

    /// <inheritdoc/>
    protected override MaskW Visit(ShadingGroup group, PathStream stream, uint* index, MaskW active)
    {
        ref VertexW at = ref At;
        MaskW mayConnect = active & (at.Number + 1u < MaxDepth);
        if (group.Traits.HasDensity && mayConnect.Any)
        {
            if ((_strategies & Strategies.Camera) != Strategies.None)
            {
                Splat(group, mayConnect);
            }

            Strategies ofVertices = group.IsOfMedia ? Strategies.Connections : Strategies.Connections | Strategies.Merges;
            if ((_strategies & ofVertices) != Strategies.None)
            {
                Keep(group, stream, index, active.Bits);
            }
        }

        return mayConnect;
    }

    /// <inheritdoc/>
    protected override void Choose(ShadingGroup group, ref SurfaceW surface, out ScatterW scatter, out FloatW pdf, out FloatW reversePdf) =>
        Adjoint.Scatter(group.Material, ref surface, Vertex, out scatter, out pdf, out reversePdf);

    // The colour of the wavelength is left to the whole path, for both of its ends may have it.
    private protected override void Disperse(in MaskW first, ref SurfaceW surface, ref RgbW throughput) =>
        Scene.Wavelengths!.Sample(Wavelength(), out surface.Wavelength, out _);

    // The first vertex: the other ways are a camera path that asks the light, and one that meets it.
    private void Start(ShadingGroup group, MaskW first, ref VertexW at)
    {
        FloatW cosine = FloatW.Gather(_starts.Cosines, first.Select(at.Path, 0u));
        FloatW emission = FloatW.Gather(_starts.Densities, first.Select(at.Path, 0u));
        UIntW light = UIntW.Gather(_starts.Lights, first.Select(at.Path, 0u));
        FloatW asked = 0f;
        FloatW met = 0f;
        LightHitW hit = new()
        {
            From = at.Surface.Point,
            Direction = -at.Surface.Incoming,
            Distance = at.Distance,
            Cosine = cosine,
            Time = at.Time,
            Primitive = UIntW.Gather(_starts.Primitives, first.Select(at.Path, 0u)),
        };
        for (uint rest = first.Bits; rest != 0;)
        {
            int number = (int)light[BitOperations.TrailingZeroCount(rest)];
            MaskW same = first & UIntW.Equal(light, (uint)number);
            rest &= ~same.Bits;
            FloatW one = IsFar[number] ? 1f : at.Distance * at.Distance;
            if (!Lights[number].IsDelta)
            {
                Lights[number].Pdf(hit, out FloatW pdf);
                one = pdf * cosine;
                met = same.Select(IsFar[number] ? 1f : cosine, met);
            }

            asked = same.Select(one, asked);
        }

        if (Scene.LightSelection is not null)
        {
            Scene.LightSelection.Probability(at.Surface.Point, group.Traits.Transmits ? default : at.Surface.Facing, light, out FloatW probability);
            asked *= probability;
        }

        at.Sums.Vcm = first.Select(SubpathSumsW.Limited(PathWeights.Power(asked / (emission * at.Cosine) * Weights.PerLightPath)), at.Sums.Vcm);
        at.Sums.Vc = first.Select(SubpathSumsW.Limited(PathWeights.Power(met / emission * Weights.PerLightPath)), at.Sums.Vc);
        at.Sums.Vm = first.Select(at.Sums.Vc * Weights.Connecting, at.Sums.Vm);
    }

    private void Splat(ShadingGroup group, MaskW active)
    {
        ref VertexW at = ref At;
        ref CameraLinkW link = ref *_link.Pointer;
        Scene.Camera.Link(at.Surface.Point, at.Time, Scene.Sampler, UIntW.Gather(_starts.PixelKeys, at.Path), UIntW.Gather(_starts.Samples, at.Path), out link);
        active &= link.Sees;
        if (!active.Any)
        {
            return;
        }

        Vertex.Light(0, out FloatW u, out FloatW v);
        active &= Scene.Camera.Splat(Scene.Filter, link.X, link.Y, u, v, out FloatW x, out FloatW y, out FloatW filtered);
        active &= (x >= _area.X) & (x < (float)(_area.X + _area.Width)) & (y >= _area.Y) & (y < (float)(_area.Y + _area.Height));
        if (!active.Any)
        {
            return;
        }

        Adjoint.Evaluate(group.Material, ref at.Surface, link.Direction, out at.Bsdf, out at.ReversePdf);
        RgbW left = Rgb.White;
        FloatW passed = 1f;
        if (Scene.TracksInteriors)
        {
            Follow(group, active, link.Direction, link.Distance, null, out left, out passed);
        }

        FloatW scale = link.Density * filtered * (Weights.PerLightPath / Weights.CameraPaths);
        FloatW ways = 1f;
        if ((_strategies & ~(Strategies.Camera | Strategies.Seen)) != Strategies.None)
        {
            FloatW seen = link.Density * passed * Meeting(at.Surface, link.Direction) * (1f / Weights.CameraPaths);
            ways = FloatW.MultiplyAdd(PathWeights.Power(seen), at.Sums.Connected(at.ReversePdf, Weights.At(group)), 1f);
            scale /= ways;
        }

        RgbW light = at.Throughput * at.Bsdf * scale;
        RgbW color = Rgb.White;
        if (Scene.Wavelengths is not null)
        {
            color = UIntW.Equal(at.State & PathState.HasWavelength, 0u).Select(Rgb.White, WavelengthColor());
            light *= color;
        }

        active = active.Except((at.Bsdf.R <= 0f) & (at.Bsdf.G <= 0f) & (at.Bsdf.B <= 0f));
        UIntW pixel = (y.ToInt() * (uint)Scene.Render.Width) + x.ToInt();
        if (Scene.TracksInteriors)
        {
            _traced += BitOperations.PopCount(active.Bits);
            light *= left;
            Add(active.Bits, pixel, light);
            _recorder?.Add(active.Bits, pixel, Ways(link, filtered, color, left), light, light * ways);
            return;
        }

        Ask(group, active, link, pixel, light, ways, filtered, color);
    }

    // The number that chooses the path's wavelength: that of the camera paths of its sample.
    private FloatW Wavelength() => Vertex.Wavelength(UIntW.Gather(_starts.PixelKeys, At.Path), (uint)Samples.First);

    // The colour of the path's wavelength.
    private RgbW WavelengthColor()
    {
        Scene.Wavelengths!.Sample(Wavelength(), out _, out RgbW color);
        return color;
    }

    private void Ask(ShadingGroup group, MaskW active, in CameraLinkW link, in UIntW pixel, in RgbW light, FloatW ways, FloatW filtered, in RgbW color)
    {
        ref VertexW at = ref At;
        at.Start = Leave(at.Surface, link.Direction);
        at.Inner = LeaveInside(at.Surface, link.Direction);
        _traced += BitOperations.PopCount(active.Bits);
        Scene.Primitives.Occlude(at.Start, link.Direction, link.Distance, -1, ref active);
        if (active.Any)
        {
            _rays.Add(active.Bits, at.Start, group.IsInstanced ? at.Surface.Instance : 0u, at.Inner, link.Direction, link.Distance, at.Time, -1, light, 0f, pixel);
            _recorder?.Wait(active.Bits, Ways(link, filtered, color, Rgb.White), light * ways);
        }

        if (!_rays.HasRoomFor(FloatW.Count))
        {
            TraceSplats();
        }
    }

    private WaysW Ways(in CameraLinkW link, FloatW filtered, in RgbW color, in RgbW left)
    {
        FloatW cosines = Adjoint.Cosines(At.Surface, link.Direction);
        return new()
        {
            From = At.Number + 2u,
            To = 1u,
            LightPath = UIntW.Gather(_starts.PixelNumbers, At.Path),
            Point = At.Surface.Point,
            Factors = new()
            {
                LightPart = At.Throughput * color,
                LightBsdf = At.Bsdf * (1f / cosines),
                Left = left,
                Geometry = cosines,
                Lens = link.Density * filtered,
                Paths = Weights.PerLightPath / Weights.CameraPaths,
            },
        };
    }

    private void Add(uint lanes, in UIntW pixel, in RgbW light)
    {
        float* numbers = stackalloc float[3 * 16];
        uint* owners = stackalloc uint[16];
        light.R.Compress(numbers, lanes);
        light.G.Compress(numbers + 16, lanes);
        light.B.Compress(numbers + 32, lanes);
        pixel.Compress(owners, lanes);
        _splats.Add(BitOperations.PopCount(lanes), UIntW.Load(owners), new(FloatW.Load(numbers), FloatW.Load(numbers + 16), FloatW.Load(numbers + 32)));
    }

    private void TraceSplats()
    {
        _rays.Trace();
        int count = 0;
        UIntW pixels = 0u;
        float* numbers = stackalloc float[3 * 16];
        uint* owners = stackalloc uint[16];
        for (int i = 0; i < _rays.Count; i++)
        {
            if (_rays.Hits[i] >= 0)
            {
                continue;
            }

            (numbers[count], numbers[16 + count], numbers[32 + count]) = (_rays.Load(0, i), _rays.Load(1, i), _rays.Load(2, i));
            owners[count++] = _rays.Owners[i];
            if (count == FloatW.Count)
            {
                _splats.Add(count, UIntW.Load(owners), new(FloatW.Load(numbers), FloatW.Load(numbers + 16), FloatW.Load(numbers + 32)));
                count = 0;
            }
        }

        if (count > 0)
        {
            _splats.Add(count, UIntW.Load(owners), new(FloatW.Load(numbers), FloatW.Load(numbers + 16), FloatW.Load(numbers + 32)));
        }

        _recorder?.Settle(_rays);
        _rays.Clear();
    }

    private void Keep(ShadingGroup group, PathStream stream, uint* index, uint lanes)
    {
        ref VertexW at = ref At;
        for (; lanes != 0; lanes &= lanes - 1)
        {
            int lane = BitOperations.TrailingZeroCount(lanes);
            if (_count == _vertices.Length)
            {
                Array.Resize(ref _vertices, 2 * _count);
            }

            uint i = index[lane];
            _vertices[_count++] = new()
            {
                Point = new(at.Surface.Point.X[lane], at.Surface.Point.Y[lane], at.Surface.Point.Z[lane]),
                Direction = new(at.Surface.Incoming.X[lane], at.Surface.Incoming.Y[lane], at.Surface.Incoming.Z[lane]),
                Power = new(at.Throughput.R[lane], at.Throughput.G[lane], at.Throughput.B[lane]),
                Vcm = at.Sums.Vcm[lane],
                Vc = at.Sums.Vc[lane],
                Vm = at.Sums.Vm[lane],
                State = at.State[lane] | (group.IsOfMedia ? PathState.IsInMedium : 0),
                Path = _starts.PixelNumbers[at.Path[lane]],
                Origin = new(stream.OriginX[i], stream.OriginY[i], stream.OriginZ[i]),
                Distance = stream.Distance[i],
                Primitive = stream.Primitive[i],
                Instance = Scene.World.Instances is null ? 0 : stream.Instance[i],
                StartInstance = stream.StartInstance[i],
                InnerStart = new(stream.InnerX[i], stream.InnerY[i], stream.InnerZ[i]),
                Wavelength = at.Surface.Wavelength[lane],
                Media = Scene.TracksInteriors ? stream.Media[i] : 0,
            };
        }
    }
}
