using System.Numerics;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>
/// Traces the camera rays of tiles as <see cref="FirstHits"/> does, but through mirrors and clear glass, to the first surface that scatters most of the light
/// to many directions: that is what a denoiser sees in a reflection. Each thread has its own.
/// </summary>
internal sealed unsafe class SeenThrough : InteriorShader
{
    // A path that is still between mirrors ends there.
    private const uint MostMirrors = 8;

    // Per steradian: of lobes that are at most some two degrees wide, in which things are still made out.
    private const float LeastDensity = 500;
    private readonly RayGenerator _generator;
    private readonly Stages _stages;

    // Chooses what is more likely: chance would only be noise of the features.
    private readonly VertexSamples _middle = new(new Middle());
    private readonly PinnedBuffer<FlightW> _flight = new(1);
    private AovFilm? _film;
    private SeenPlanes? _planes;
    private (Vector3 Origin, Vector3 Direction, float Length)[] _firsts = [];

    // From a row of pixels to the next.
    private int _width;
    private Tile _tile;

    public SeenThrough(Scene scene, int streamSize, int maxTilePixels)
        : base(new(scene, null!, null, null))
    {
        _generator = new(scene, maxTilePixels);
        _stages = new(scene, streamSize, this);
    }

    /// <summary>Adds some samples of every pixel of a tile.</summary>
    /// <param name="film">The images; no other thread may use the tile's pixels.</param>
    /// <param name="tile">The pixels.</param>
    /// <param name="samples">The samples, at most <see cref="SampleAccumulator.MaxSamples"/>.</param>
    public void Add(AovFilm film, in Tile tile, SampleRange samples)
    {
        (_film, _tile, _width) = (film, tile, film.Width);
        _generator.Begin(tile, samples);
        _stages.Follow(_generator, samples);
    }

    /// <summary>Gives its memory back; it follows no more paths.</summary>
    public void Close() => _stages.Close();

    /// <summary>Puts a sample of some pixels into planes.</summary>
    /// <param name="planes">The planes; no other thread may use the pixels.</param>
    /// <param name="pixels">The pixels' numbers in the picture, row by row.</param>
    /// <param name="sample">The number of the sample.</param>
    public void Take(SeenPlanes planes, ReadOnlySpan<int> pixels, int sample)
    {
        _planes = planes;
        Array.Resize(ref _firsts, Math.Max(_firsts.Length, pixels.Length));
        SampleRange samples = new(sample, sample + 1);
        _generator.Begin(pixels, samples, (uint)Scene.Render.Seed);
        _stages.Follow(_generator, samples);
    }

    /// <summary>Returns the lanes whose light mostly comes from one direction, as in a mirror or clear glass.</summary>
    /// <param name="material">The material.</param>
    /// <param name="surface">The surfaces.</param>
    /// <param name="scatter">That direction.</param>
    public MaskW IsClear(Material material, in SurfaceW surface, out ScatterW scatter)
    {
        _middle.Begin(0u, 0u, 0u);
        material.Scatter(surface, _middle, out scatter);
        if (!material.Traits.HasDensity)
        {
            return scatter.Delta;
        }

        material.Pdf(surface, scatter.Direction, out FloatW pdf);
        return scatter.Delta | (pdf > LeastDensity);
    }

    /// <inheritdoc/>
    internal override void Miss(PathStream stream, uint* members, int count)
    {
        for (int i = 0; i < count; i++)
        {
            int ray = (int)members[i];
            if (_planes is { } planes)
            {
                Extend(stream, ray);
                (Vector3 origin, Vector3 direction, _) = _firsts[stream.Path[ray]];
                planes.TakeNothing(planes.Rows.At(_generator.PixelNumbers[stream.Path[ray]]), origin, direction);
                continue;
            }

            FirstHit nothing = Hit(stream, ray, out long pixel) with { Primitive = 0 };
            _film!.Count(pixel, isHit: false);
            _film.Add(pixel, nothing, isDescribed: false);
        }
    }

    /// <summary>
    /// Media that scatter or send light hide what is behind them, as much as they weaken it: what they hide counts as nothing. What they leave is computed, since
    /// chance would be noise. In planes, where the light is a single sample, they hide nothing.
    /// </summary>
    internal override void SampleMedia(PathStream stream)
    {
        for (int i = 0; Scene.HasMedia && _planes is null && i < stream.Count; i += FloatW.Count)
        {
            UIntW media = MaskW.First(stream.Count - i).Select(UIntW.Load(stream.Media + i), 0u);
            UIntW vertex = UIntW.Load(stream.State + i) & PathState.VertexMask;
            Vec3W direction = new(FloatW.Load(stream.DirectionX + i), FloatW.Load(stream.DirectionY + i), FloatW.Load(stream.DirectionZ + i));
            FloatW distance = FloatW.Load(stream.Distance + i);
            MaskW isFirst = UIntW.Equal(vertex, 0u) & UIntW.Equal(MediumStack.Crossings(media), 0u);
            FloatW passed = isFirst.Select(1f, FloatW.Load(stream.Passed + i));
            passed *= Scene.Media.MeanPassing(media, MediumTable.Transmittance(Scene.Media.Extinction(media, direction), distance));
            if (Scene.HasVaryingMedia)
            {
                Vec3W origin = new(FloatW.Load(stream.OriginX + i), FloatW.Load(stream.OriginY + i), FloatW.Load(stream.OriginZ + i));
                Weaken(media, origin, direction, distance, ref passed);
            }

            passed.Store(stream.Passed + i);
        }
    }

    /// <inheritdoc/>
    protected override void Carry(PathStream stream, PathStream next, uint* index, uint going)
    {
        if (Scene.HasMedia)
        {
            next.SetPassed(going, FloatW.Pick(stream.Passed, index));
        }
    }

    /// <inheritdoc/>
    protected override void ShadePacket(ShadingGroup group, PathStream stream, PathStream next, uint* index, in MaskW active)
    {
        ref PacketW packet = ref Packet;
        ref SurfaceW surface = ref packet.Surface;
        Describe(Scene, group, stream, index, group.Traits.UsesUv, out surface);
        for (uint rest = _planes is null ? 0 : active.Bits; rest != 0; rest &= rest - 1)
        {
            Extend(stream, (int)index[BitOperations.TrailingZeroCount(rest)]);
        }

        packet.Media = Scene.TracksInteriors ? UIntW.Pick(stream.Media, index) : 0u;
        MaskW unreal = Scene.HasMedia && group.Traits.IsBoundary ? active : MaskW.None;
        if (Scene.HasNesting && group.IsNested)
        {
            UIntW beyond = Scene.Cross(packet.Media, group.Interior, MaskW.All, ~ComesFromInside(surface));
            unreal = active & IsUnreal(packet.Media, beyond);
            Scene.Media.Index(ComesFromInside(surface).Select(beyond, packet.Media), surface.Wavelength, out surface.ExteriorIndex);
        }

        Cross(group, surface, stream, next, index, unreal);
        MaskW lanes = active.Except(unreal);
        MaskW through = GoThrough(group, ref packet, stream, next, index, lanes);
        group.Material.Albedo(surface, out RgbW albedo);
        albedo *= stream.PickThroughput(index);
        Vec3W normal = surface.Facing;
        if (Scene.HasMedia && _planes is null)
        {
            FloatW passed = FloatW.Pick(stream.Passed, index);
            (albedo, normal) = (albedo * passed, normal * passed);
        }

        for (uint rest = lanes.Except(through).Bits; rest != 0; rest &= rest - 1)
        {
            int lane = BitOperations.TrailingZeroCount(rest);
            int ray = (int)index[lane];
            if (_planes is { } planes)
            {
                (Vector3 origin, Vector3 direction, float length) = _firsts[stream.Path[ray]];
                planes.Take(
                    planes.Rows.At(_generator.PixelNumbers[stream.Path[ray]]), origin + (direction * length), FirstHits.At(normal, lane),
                    new(albedo.R[lane], albedo.G[lane], albedo.B[lane]), SeenPlanes.SurfaceOf(Scene, stream, ray));
                continue;
            }

            FirstHit hit = Hit(stream, ray, out long pixel) with
            {
                Point = FirstHits.At(surface.Point, lane),
                Normal = FirstHits.At(normal, lane),
                Albedo = new(albedo.R[lane], albedo.G[lane], albedo.B[lane]),
            };
            _film!.Count(pixel, isHit: true);
            _film.Add(pixel, hit, isDescribed: false);
            _film.Add(pixel, hit, isDescribed: true);
        }
    }

    // Sends on what a mirror reflects or glass lets through, whichever is more, and returns those lanes.
    private MaskW GoThrough(ShadingGroup group, ref PacketW packet, PathStream stream, PathStream next, uint* index, MaskW active)
    {
        ref SurfaceW surface = ref packet.Surface;
        UIntW path = UIntW.Pick(stream.Path, index);
        UIntW vertex = UIntW.Pick(stream.State, index) & PathState.VertexMask;
        MaskW isClear = IsClear(group.Material, surface, out packet.Scatter);
        MaskW through = (active & isClear & (vertex < MostMirrors)).Except(packet.Scatter.Absorbed).Except(Dropped(surface, packet.Scatter.Direction));
        uint going = through.Bits;
        if (going == 0)
        {
            return through;
        }

        if (Scene.IsTimed)
        {
            next.SetTime(going, FloatW.Pick(stream.Time, index));
        }

        if (Scene.TracksInteriors)
        {
            MediaAlong(Scene, surface, packet.Scatter.Direction, group.Interior, packet.Media, out UIntW media);
            next.SetMedia(going, media, 0f);
        }

        Carry(stream, next, index, going);
        next.Append(
            going, Leave(surface, packet.Scatter.Direction), packet.Scatter.Direction, stream.PickThroughput(index) * packet.Scatter.Weight, default, path, vertex + 1u);
        if (group.IsInstanced)
        {
            next.SetStart(going, surface.Instance, LeaveInside(surface, packet.Scatter.Direction));
        }

        return through;
    }

    // What media that vary leave of what rays have passed so far: by sums over places at even distances. What is left out between them matters less than noise would.
    private void Weaken(UIntW media, in Vec3W origin, in Vec3W direction, FloatW distance, ref FloatW passed)
    {
        ref FlightW flight = ref *_flight.Pointer;
        foreach ((uint number, VaryingMedium medium) in Scene.Media.Varying)
        {
            MaskW inside = UIntW.Equal(MediumStack.Innermost(media), number);
            MaskW meets = inside.Any && (medium.Scatters || medium.Emits) ? inside & flight.Begin(medium, origin, direction, distance) : MaskW.None;
            if (!meets.Any)
            {
                continue;
            }

            (int x, int y, int z) = medium.CellCounts;
            int steps = int.Max(x, int.Max(y, z));
            FloatW step = flight.End * (1f / steps);
            RgbW depth = Rgb.Black;
            for (int i = 0; i < steps; i++)
            {
                flight.At = step * (i + 0.5f);
                medium.Extinction(flight.Place(), flight.Direction, out RgbW extinction);
                depth += extinction;
            }

            RgbW left = MediumTable.Transmittance(depth, step);
            passed *= meets.Select((left.R + left.G + left.B) * (1f / 3), 1f);
        }
    }

    private FirstHit Hit(PathStream stream, int ray, out long pixel) => FirstHits.Hit(stream, ray, _tile, Samples, _width, out pixel);

    // How far a path has gone, along its first ray: what a mirror shows stands as far behind it.
    private void Extend(PathStream stream, int ray)
    {
        ref (Vector3 Origin, Vector3 Direction, float Length) first = ref _firsts[stream.Path[ray]];
        first = (stream.State[ray] & PathState.VertexMask) == 0
            ? (new(stream.OriginX[ray], stream.OriginY[ray], stream.OriginZ[ray]), new(stream.DirectionX[ray], stream.DirectionY[ray], stream.DirectionZ[ray]), stream.Distance[ray])
            : first with { Length = first.Length + stream.Distance[ray] };
    }

    private sealed class Middle() : Sampler(1)
    {
        public override void Begin(in UIntW pixelKey, in UIntW sample, in UIntW group, out SamplePoints points) => points = default;

        public override void Pair(in SamplePoints points, uint pair, out FloatW u, out FloatW v) => u = v = 0.5f;
    }
}
