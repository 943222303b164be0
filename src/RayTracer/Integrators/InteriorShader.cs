using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;

namespace RayTracer.Rendering;

/// <summary>
/// What happens to paths within things, wherever they come from: media scatter and absorb them on their way, dielectrics absorb them, and they go through
/// boundaries that do not change them.
/// </summary>
/// <param name="context">The context that it works in.</param>
internal abstract unsafe class InteriorShader(ShaderContext context) : SurfaceShader(context)
{
    private readonly VaryingFlights? _flights = context.Scene.HasVaryingMedia ? new() : null;
    private readonly PinnedBuffer<TrackW> _track = new(1);

    /// <summary>
    /// Chooses how far each ray flies before its medium scatters it: by the extinction of a channel that is chosen at random, in proportion to what the path
    /// carries of it, with the density of all three (Wilkie et al. 2014, the balance heuristic for a single path). So the sum over the channels of
    /// what a path carries never grows (the history-aware probabilities of Kutz et al. 2017); channels that are alike would
    /// let a few long paths carry nearly all.
    /// </summary>
    internal override void SampleMedia(PathStream stream)
    {
        for (int i = 0; Scene.HasMedia && Scene.Media.HasEven && i < stream.Count; i += FloatW.Count)
        {
            UIntW media = UIntW.Load(stream.Media + i);
            MaskW inside = MaskW.First(stream.Count - i).Except(UIntW.Equal(MediumStack.Innermost(media), 0u));
            if (inside.Any)
            {
                SampleMedium(stream, i, inside.Select(media, 0u), inside);
            }
        }

        if (_flights is not null)
        {
            foreach ((uint number, VaryingMedium medium) in Scene.Media.Varying)
            {
                Fly(stream, number, medium);
            }
        }

        for (int i = 0; Scene.HasNesting && i < stream.Count; i += FloatW.Count)
        {
            Absorb(stream, i);
        }
    }

    /// <summary>The factor on what is scattered to a direction, of one BSDF: a cosine, but in media.</summary>
    internal static FloatW Cosine(in SurfaceW surface, in Vec3W direction) =>
        surface.Rules == NormalRules.InMedium ? 1f : FloatW.Abs(Vec3W.Dot(direction, surface.Facing));

    /// <summary>
    /// The factor by which the density of a vertex grows with what its ray meets there: the cosine to the shape's own normal; in media, the density per length.
    /// </summary>
    internal static FloatW Meeting(in SurfaceW surface, in Vec3W direction) =>
        surface.Rules == NormalRules.InMedium ? surface.V : FloatW.Abs(Vec3W.Dot(direction, surface.Normal));

    /// <summary>What is around a nested dielectric, on the outer side of its surface.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="group">The group of the surfaces.</param>
    /// <param name="surface">The surfaces.</param>
    /// <param name="media">The media of the rays that met them.</param>
    internal static UIntW Around(Scene scene, ShadingGroup group, in SurfaceW surface, UIntW media) =>
        scene.Cross(media, group.Interior, ComesFromInside(surface), MaskW.None);

    /// <summary>Brings what a path has, and only its shader knows, to the ray behind a boundary.</summary>
    /// <param name="stream">The paths.</param>
    /// <param name="next">Takes them.</param>
    /// <param name="index">Indices of a packet of them.</param>
    /// <param name="going">The lanes in use.</param>
    protected abstract void Carry(PathStream stream, PathStream next, uint* index, uint going);

    /// <summary>A boundary: paths have no vertex there, only other media behind it.</summary>
    protected void Cross(ShadingGroup group, in SurfaceW surface, PathStream stream, PathStream next, uint* index, in MaskW active)
    {
        uint going = active.Bits;
        if (going == 0)
        {
            return;
        }

        Observer?.Crossed(stream, index, active, surface);
        UIntW media = Scene.Cross(UIntW.Pick(stream.Media, index), group.Interior, MaskW.All, ~ComesFromInside(surface));
        Pass(group, surface, stream, next, index, going, media, stream.PickThroughput(index), stream.PickRadiance(index), UIntW.Pick(stream.State, index));
    }

    /// <summary>Sends paths straight on behind a surface, with what they know of where they scattered last.</summary>
    /// <param name="group">The group of the surface.</param>
    /// <param name="surface">The surface.</param>
    /// <param name="stream">The paths.</param>
    /// <param name="next">Takes them.</param>
    /// <param name="index">Indices of a packet of them.</param>
    /// <param name="going">The lanes in use; not none.</param>
    /// <param name="media">The media behind the surface.</param>
    /// <param name="throughput">What they carry on.</param>
    /// <param name="radiance">What they have gathered.</param>
    /// <param name="state">Their state.</param>
    protected void Pass(
        ShadingGroup group, in SurfaceW surface, PathStream stream, PathStream next, uint* index, uint going, in UIntW media, in RgbW throughput, in RgbW radiance,
        in UIntW state)
    {
        Vec3W direction = surface.Incoming;
        if (Scene.IsTimed)
        {
            next.SetTime(going, FloatW.Pick(stream.Time, index));
        }

        Carry(stream, next, index, going);
        if (Scene.LightSelection is not null)
        {
            next.SetNormal(going, stream.PickNormal(index));
        }

        next.SetMedia(going, media, FloatW.Pick(stream.Travelled, index) + FloatW.Pick(stream.Distance, index));
        next.Append(going, Leave(surface, direction), direction, throughput, radiance, UIntW.Pick(stream.Path, index), state);
        if (group.IsInstanced)
        {
            next.SetStart(going, surface.Instance, LeaveInside(surface, direction));
        }
    }

    /// <summary>Where paths scattered last: boundaries on the way are no vertices.</summary>
    protected Vec3W Start(PathStream stream, uint* index, in Vec3W direction)
    {
        Vec3W origin = stream.PickOrigin(index);
        return Scene.TracksInteriors ? Vec3W.MultiplyAdd(direction, -FloatW.Pick(stream.Travelled, index), origin) : origin;
    }

    // Takes what dielectrics that paths track absorb of the light, all the way to what is met.
    private void Absorb(PathStream stream, int i)
    {
        UIntW media = MaskW.First(stream.Count - i).Select(UIntW.Load(stream.Media + i), 0u);
        RgbW left = MediumTable.Transmittance(Scene.Media.Absorption(media), FloatW.Load(stream.Distance + i));
        (left.R * FloatW.Load(stream.ThroughputR + i)).Store(stream.ThroughputR + i);
        (left.G * FloatW.Load(stream.ThroughputG + i)).Store(stream.ThroughputG + i);
        (left.B * FloatW.Load(stream.ThroughputB + i)).Store(stream.ThroughputB + i);
    }

    // Follows all rays in a medium that varies.
    private void Fly(PathStream stream, uint number, VaryingMedium medium)
    {
        ref TrackW track = ref *_track.Pointer;
        for (int i = 0; i < stream.Count; i += FloatW.Count)
        {
            UIntW media = UIntW.Load(stream.Media + i);
            MaskW inside = MaskW.First(stream.Count - i) & UIntW.Equal(MediumStack.Innermost(media), number);
            if (!inside.Any)
            {
                continue;
            }

            Vec3W origin = new(FloatW.Load(stream.OriginX + i), FloatW.Load(stream.OriginY + i), FloatW.Load(stream.OriginZ + i));
            Vec3W direction = new(FloatW.Load(stream.DirectionX + i), FloatW.Load(stream.DirectionY + i), FloatW.Load(stream.DirectionZ + i));
            MaskW meets = inside & track.Flight.Begin(medium, origin, direction, FloatW.Load(stream.Distance + i));
            if (!meets.Any)
            {
                continue;
            }

            UIntW crossings = MediumStack.Crossings(media);
            BeginVertex(inside.Select(UIntW.Load(stream.Path + i), 0u), UIntW.Load(stream.State + i) & PathState.VertexMask);
            Vertex.Flight(crossings, out track.Choice, out FloatW v);
            track.Flight.Depth = FlightW.DepthOf(v);
            track.Flight.Key = Vertex.Stream(crossings);
            track.Flight.Drawn = 0u;
            track.Throughput = new(FloatW.Load(stream.ThroughputR + i), FloatW.Load(stream.ThroughputG + i), FloatW.Load(stream.ThroughputB + i));
            track.Path = UIntW.Iota + (uint)i;
            track.Busy = 1f;
            _flights!.Add(track, meets);
        }

        _flights!.Track(medium, stream, (uint)Scene.World.Count + 1u, Observer);
    }

    private void SampleMedium(PathStream stream, int i, in UIntW media, in MaskW inside)
    {
        MaskW used = MaskW.First(stream.Count - i);
        BeginVertex(used.Select(UIntW.Load(stream.Path + i), 0u), UIntW.Load(stream.State + i) & PathState.VertexMask);
        Vertex.Flight(MediumStack.Crossings(media), out FloatW u, out FloatW v);
        RgbW extinction = Scene.Media.Extinction(media, new(FloatW.Load(stream.DirectionX + i), FloatW.Load(stream.DirectionY + i), FloatW.Load(stream.DirectionZ + i)));
        RgbW albedo = Scene.Media.Albedo(media);
        RgbW throughput = new(FloatW.Load(stream.ThroughputR + i), FloatW.Load(stream.ThroughputG + i), FloatW.Load(stream.ThroughputB + i));
        RgbW share = throughput * (1f / FloatW.Max(throughput.R + throughput.G + throughput.B, float.Epsilon));
        FloatW chosen = (u < share.R).Select(extinction.R, (u < share.R + share.G).Select(extinction.G, extinction.B));
        FloatW flight = (chosen > 0f).Select(-LaneMath.Log(1f - v) / chosen, float.PositiveInfinity);

        FloatW distance = FloatW.Load(stream.Distance + i);
        if (Scene.Media.EvenShine)
        {
            // All that is on the way to what is met, whether the path comes so far or is scattered.
            VaryingFlights.Shine(throughput * Scene.Media.Emission(media) * MediumTable.Seen(extinction, distance), inside, UIntW.Iota + (uint)i, stream, Observer);
        }

        // What scatters nothing needs no chance.
        MaskW scatters = inside & (flight < distance) & (FloatW.Max(albedo.R, FloatW.Max(albedo.G, albedo.B)) > 0f);
        MaskW isByChance = inside & (FloatW.Max(albedo.R, FloatW.Max(albedo.G, albedo.B)) > 0f);
        RgbW left = MediumTable.Transmittance(extinction, FloatW.Min(flight, distance));
        left = isByChance.Select(left, MediumTable.Transmittance(extinction, distance));
        RgbW density = scatters.Select(left * extinction, left);
        FloatW pdf = isByChance.Select(FloatW.MultiplyAdd(density.R, share.R, FloatW.MultiplyAdd(density.G, share.G, density.B * share.B)), 1f);
        RgbW weight = scatters.Select(density * albedo, left) * (pdf > 0f).Select(1f / pdf, 0f);
        weight = inside.Select(weight, Rgb.White);
        (weight.R * throughput.R).Store(stream.ThroughputR + i);
        (weight.G * throughput.G).Store(stream.ThroughputG + i);
        (weight.B * throughput.B).Store(stream.ThroughputB + i);
        scatters.Select(flight, distance).Store(stream.Distance + i);
        scatters.Select((uint)Scene.World.Count + 1u, UIntW.Load(stream.Primitive + i)).Store(stream.Primitive + i);
    }
}
