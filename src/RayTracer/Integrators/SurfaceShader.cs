using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>The surroundings of a shader: the scene, and where its light goes.</summary>
public sealed class ShaderContext
{
    internal ShaderContext(Scene scene, FinishedPaths finished, ShadowQueue? queue, PathObserver? observer, LightPass? light = null) =>
        (Scene, Finished, Queue, Observer, Light) = (scene, finished, queue, observer, light);

    /// <summary>The scene.</summary>
    public Scene Scene { get; }

    internal FinishedPaths Finished { get; }

    // Takes shadow rays that wait until the whole stream is shaded; null where none do.
    internal ShadowQueue? Queue { get; }

    // Sees what happens to the paths; null where nobody asks.
    internal PathObserver? Observer { get; }

    // Measures the stages; null where nobody looks.
    internal StageClock? Clock { get; init; }

    // The light paths of the pass; null where the integrator traces none.
    internal LightPass? Light { get; }
}

/// <summary>
/// What happens where paths meet a surface, a class for each <see cref="Integrator"/>; and what all of them share: how a surface is described,
/// and how a ray leaves it.
/// </summary>
/// <param name="context">The context that it works in.</param>
public abstract unsafe class SurfaceShader(ShaderContext context)
{
    // Registers that lie across two cache lines are slow to store and load: the runtime does not align its stack for them.
    private readonly PinnedBuffer<PacketW> _packet = new(1);

    /// <summary>The number of shadow rays that were traced.</summary>
    internal virtual long ShadowRays => 0;

    /// <summary>The scene.</summary>
    protected Scene Scene { get; } = context.Scene;

    /// <summary>Takes the paths that end.</summary>
    protected FinishedPaths Finished { get; } = context.Finished;

    private protected PathObserver? Observer { get; } = context.Observer;

    private protected StageClock? Clock { get; } = context.Clock;

    /// <summary>The random numbers of the vertex that is shaded.</summary>
    protected VertexSamples Vertex { get; } = new(context.Scene.Sampler) { SharedKey = context.Scene.SharedKey, Splitting = context.Scene.Splitting };

    private protected SampleRange Samples { get; private set; }

    private protected PathSource Source { get; private set; } = null!;

    /// <summary>The paths of a stream are rays that samples share (<see cref="Splitting"/>): they are numbered by <see cref="PathSource.Rays"/>.</summary>
    internal bool Splits { get; set; }

    /// <summary>As how many samples a path of the stream goes on.</summary>
    private protected int SamplesOfPath => Splits ? Scene.Splitting!.Ways : 1;

    /// <summary>Room for what is known of the packet that is shaded.</summary>
    private protected ref PacketW Packet => ref *_packet.Pointer;

    /// <summary>Prepares for a tile.</summary>
    internal virtual void Begin(PathSource source, SampleRange samples)
    {
        Source = source;
        Samples = samples;
    }

    /// <summary>Ends the paths that left the scene.</summary>
    internal virtual void Miss(PathStream stream, uint* members, int count)
    {
        for (int i = 0; i < count; i += FloatW.Count)
        {
            uint* index = members + i;
            MaskW active = MaskW.First(count - i);
            ref Vec3W direction = ref Packet.Surface.Incoming;
            ref RgbW arriving = ref Packet.Arriving;
            ref RgbW radiance = ref Packet.Radiance;
            ref UIntW path = ref Packet.Path;
            path = UIntW.Pick(stream.Path, index);
            direction = stream.PickDirection(index);
            Arrive(stream, index, direction, out arriving);
            radiance = RgbW.MultiplyAdd(stream.PickThroughput(index), arriving, stream.PickRadiance(index));

            // A direction that is not a number meets nothing; it must not pass for a ray into the open.
            FloatW fault = Vec3W.Dot(direction, direction) * 0f;
            radiance += new RgbW(fault, fault, fault);
            Observer?.Missed(stream, index, active, arriving);
            End(active, radiance);
        }
    }

    // Ends the paths of the packet, or all the samples that share its rays.
    private void End(in MaskW active, in RgbW radiance)
    {
        if (Splits)
        {
            SplitPath(Packet.Path);
        }

        for (int way = 0; way < SamplesOfPath; way++)
        {
            MaskW lanes = active;
            TurnTo(way, ref lanes);
            Finished.Append(lanes.Bits, radiance, Packet.Path);
        }
    }

    /// <summary>Shades all hits of one group.</summary>
    /// <param name="group">The group.</param>
    /// <param name="stream">The paths.</param>
    /// <param name="next">Takes the paths that have a next ray.</param>
    /// <param name="members">Indices of the group's paths in the stream, padded to whole packets.</param>
    /// <param name="count">Number of the group's paths.</param>
    internal void Shade(ShadingGroup group, PathStream stream, PathStream next, uint* members, int count)
    {
        for (int i = 0; i < count; i += FloatW.Count)
        {
            MaskW active = MaskW.First(count - i);
            Observer?.Met(group, stream, members + i, active);
            ShadePacket(group, stream, next, members + i, active);
        }
    }

    /// <summary>Lets media scatter rays before they reach what they would meet.</summary>
    internal virtual void SampleMedia(PathStream stream)
    {
    }

    /// <summary>Shades what media have scattered.</summary>
    /// <param name="stream">The paths.</param>
    /// <param name="next">Takes the paths that have a next ray.</param>
    /// <param name="members">Indices of those paths in the stream, padded to whole packets.</param>
    /// <param name="count">Their number.</param>
    internal virtual void Scatter(PathStream stream, PathStream next, uint* members, int count)
    {
    }

    /// <summary>Adds what waits to the paths that went on to the next stream, or ended.</summary>
    internal virtual void Flush(PathStream next)
    {
    }

    /// <summary>Called when all paths have ended.</summary>
    internal virtual void End()
    {
    }

    /// <summary>Describes where paths met the surfaces of a group: all that a material needs.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="group">The group.</param>
    /// <param name="stream">The paths.</param>
    /// <param name="index">Indices of a packet of paths in the stream.</param>
    /// <param name="needsUv">True if uv is wanted.</param>
    /// <param name="surface">The surfaces.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static void Describe(Scene scene, ShadingGroup group, PathStream stream, uint* index, bool needsUv, out SurfaceW surface)
    {
        if (group.IsInstanced)
        {
            DescribeInstanced(scene, group, stream, index, needsUv, out surface);
        }
        else
        {
            DescribePlain(group, stream, index, needsUv, out surface);
        }

        surface.CarriesLight = false;
        surface.Rules = scene.IsLiteral ? group.LiteralRules : group.MendedRules;
        Face(ref surface);
        if (group.LacksTint)
        {
            surface.Tint = Rgb.White;
        }

        if (group.LacksSecondTint)
        {
            surface.SecondTint = Rgb.White;
        }

        if (group.IsNested)
        {
            // Where paths do not track what they are in, nothing is around.
            surface.ExteriorIndex = 1f;
        }

        if (group.Traits.Disperses)
        {
            // The yellow line of helium, at which refractive indices are given: where no path chooses its wavelength (Disperse).
            surface.Wavelength = 0.5876f;
        }

        group.Material.Prepare(ref surface);
        if (group.HasTint)
        {
            surface.DiffuseColor *= surface.Tint;
        }
    }

    private static void DescribePlain(ShadingGroup group, PathStream stream, uint* index, bool needsUv, out SurfaceW surface)
    {
        Unsafe.SkipInit(out surface);
        surface.Incoming = stream.PickDirection(index);
        surface.Distance = FloatW.Pick(stream.Distance, index);
        surface.Point = Vec3W.MultiplyAdd(surface.Incoming, surface.Distance, stream.PickOrigin(index));
        DescribeTable(group, stream, index, needsUv, ref surface);
        TurnToRay(ref surface);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void DescribeTable(ShadingGroup group, PathStream stream, uint* index, bool needsUv, ref SurfaceW surface)
    {
        int stride = group.Batch.Stride;
        surface.Primitives = group.OnlyIndex >= 0
            ? new(group.OnlyIndex, stride)
            : new(UIntW.Pick(stream.Primitive, index) - (uint)group.Batch.FirstPrimitive, stride);
        group.Batch.Describe(surface.Primitives, needsUv, ref surface);
        if (group.UsesLocal)
        {
            surface.Local = surface.Point;
        }

        if (group.Traits.UsesTangent)
        {
            group.Batch.DescribeTangents(surface.Primitives, ref surface);
        }
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void TurnToRay(ref SurfaceW surface)
    {
        FloatW along = Vec3W.Dot(surface.Incoming, surface.Normal);
        surface.Inside = along > 0f;
        surface.Facing = surface.Inside.Select(-surface.Normal, surface.Normal);
        surface.Cosine = FloatW.Min(FloatW.Abs(along), 1f);
    }

    /// <summary>
    /// Shades a packet of hits of one group: paths end in <see cref="Finished"/>, or get their next rays in the next stream.
    /// </summary>
    /// <param name="group">The group.</param>
    /// <param name="stream">The paths.</param>
    /// <param name="next">Takes the paths that have a next ray.</param>
    /// <param name="index">Indices of the packet's paths in the stream.</param>
    /// <param name="active">The lanes in use.</param>
    protected abstract void ShadePacket(ShadingGroup group, PathStream stream, PathStream next, uint* index, in MaskW active);

    /// <summary>The radiance that arrives where rays meet nothing.</summary>
    protected virtual void Arrive(PathStream stream, uint* index, in Vec3W direction, out RgbW arriving)
    {
        arriving = Scene.Background;
        Scene.Environment?.Evaluate(direction, out arriving);
    }

    /// <summary>Turns to the random numbers of vertices.</summary>
    /// <param name="path">Numbers of the paths.</param>
    /// <param name="vertex">Numbers of the vertices on them, from 0.</param>
    protected virtual void BeginVertex(in UIntW path, in UIntW vertex)
    {
        if (Splits)
        {
            SplitPath(path);
            Vertex.BeginRays(UIntW.Gather(Source.PixelKeys, Packet.Pixel), Packet.Ray);
            return;
        }

        PathNumber.Split(path, Samples, out UIntW pixel, out UIntW sample);
        Vertex.Begin(UIntW.Gather(Source.PixelKeys, pixel), sample, vertex);
    }

    /// <summary>Turns a packet of rays to one of the samples that share each, if they are such rays.</summary>
    /// <param name="way">Number of the sample among those that share the ray.</param>
    /// <param name="lanes">Lanes in use; those stay where there is such a sample.</param>
    private protected void TurnTo(int way, ref MaskW lanes)
    {
        if (!Splits)
        {
            return;
        }

        UIntW sample = Scene.Splitting!.FirstOf(Packet.Ray) + (uint)way;
        lanes = lanes.Except(sample < (uint)Samples.First) & (sample < (uint)Samples.End) & Scene.Splitting.Has(Packet.Ray, way);
        Packet.Path = (Packet.Pixel * (uint)Samples.Count) + sample - (uint)Samples.First;
        Vertex.Turn(sample);
    }

    private void SplitPath(in UIntW path)
    {
        PathNumber.Split(path, Source.Rays!.Value, out UIntW pixel, out UIntW ray);
        (Packet.Pixel, Packet.Ray) = (pixel, ray);
    }

    /// <summary>
    /// Gives paths their wavelengths at a surface that disperses light: from the first one on, they have the colour of a single wavelength.
    /// </summary>
    /// <param name="first">The lanes of paths that have none yet.</param>
    /// <param name="surface">The surface, which gets the wavelengths.</param>
    /// <param name="throughput">The paths' throughput.</param>
    private protected virtual void Disperse(in MaskW first, ref SurfaceW surface, ref RgbW throughput)
    {
        Scene.Wavelengths!.Sample(Vertex.Wavelength(), out surface.Wavelength, out RgbW weight);
        throughput = first.Select(throughput * weight, throughput);
    }

    /// <summary>The part of a path's state after a surface that marks it as standing for a single wavelength.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private protected UIntW WavelengthAfter(ShadingGroup group, UIntW state) => Scene.Wavelengths is null ? 0u
        : group.Traits.Disperses ? PathState.HasWavelength : state & PathState.HasWavelength;

    // As DescribePlain, in the space that each lane's instance shows.
    private static void DescribeInstanced(Scene scene, ShadingGroup group, PathStream stream, uint* index, bool needsUv, out SurfaceW surface)
    {
        Unsafe.SkipInit(out surface);
        float* memory = stackalloc float[InstanceMaps.Floats];
        InstanceMaps maps = new(memory);
        surface.Instance = UIntW.Pick(stream.Instance, index);
        maps.Fill(scene.World.Instances!, surface.Instance, scene.IsTimed ? FloatW.Pick(stream.Time, index) : 0f);
        surface.Incoming = stream.PickDirection(index);
        surface.Distance = FloatW.Pick(stream.Distance, index);
        MaskW isOwn = UIntW.Equal(surface.Instance, UIntW.Pick(stream.StartInstance, index));
        Vec3W start = isOwn.Select(stream.PickInnerStart(index), maps.PointBack(stream.PickOrigin(index)));
        surface.Point = Vec3W.MultiplyAdd(maps.VectorBack(surface.Incoming), surface.Distance, start);
        DescribeTable(group, stream, index, needsUv, ref surface);
        maps.Describe(group.HasShadingNormals, group.Traits.UsesTangent, ref surface);
        TurnToRay(ref surface);
    }

    /// <summary>Turns surfaces that face their rays to the normals with which they are shaded, but for those of maps.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    internal static void Face(ref SurfaceW surface)
    {
        if ((surface.Rules & NormalRules.Literal) != NormalRules.None)
        {
            TakeLiterally(ref surface);
        }
        else if ((surface.Rules & NormalRules.Smooth) != NormalRules.None)
        {
            Smooth(ref surface);
        }

        if ((surface.Rules & NormalRules.HasTangent) != NormalRules.None)
        {
            surface.SetTangent();
        }
    }

    // Turns to the shading normal, on the ray's side of the surface: which of its two directions that is, is only asked here, in the
    // world, since a transform that stretches may take it across. Where the ray would come from behind it, near outlines, the
    // normal is mirrored across the plane perpendicular to the ray, so that it does not: it stays a unit vector, on the ray's
    // side of the surface, and nothing jumps.
    private static void Smooth(ref SurfaceW surface)
    {
        Vec3W shading = (Vec3W.Dot(surface.Shading, surface.Facing) < 0f).Select(-surface.Shading, surface.Shading);
        FloatW along = Vec3W.Dot(surface.Incoming, shading);
        surface.Facing = Vec3W.NegatedMultiplyAdd(surface.Incoming, FloatW.Max(along, 0f) * 2f, shading);
        surface.Cosine = FloatW.Min(FloatW.Abs(along), 1f);
    }

    // The side from which the surface is seen is that of its shading normal, whatever side of the triangle the ray comes from.
    private static void TakeLiterally(ref SurfaceW surface)
    {
        FloatW along = Vec3W.Dot(surface.Incoming, surface.Shading);
        surface.Inside = along > 0f;
        surface.Facing = surface.Inside.Select(-surface.Shading, surface.Shading);
        surface.Cosine = FloatW.Min(FloatW.Abs(along), 1f);
    }

    // Directions that lie on different sides of the surface and of the plane that it is shaded as: what is reflected would come through
    // it, and what is refracted would not (Veach 1997, section 5.3). They carry no light.
    internal static MaskW Leaks(in SurfaceW surface, in Vec3W direction)
    {
        FloatW side = Vec3W.Dot(direction, surface.Inside.Select(-surface.Normal, surface.Normal));
        return side * Vec3W.Dot(direction, surface.Facing) <= 0f;
    }

    // Those of them that the surface's rules drop.
    internal static MaskW Dropped(in SurfaceW surface, in Vec3W direction) =>
        (surface.Rules & NormalRules.DropsLeaks) == NormalRules.None ? MaskW.None : Leaks(surface, direction);

    /// <summary>The cosine between the shape's own normal and the way back along the ray; negative from behind.</summary>
    internal static FloatW CosineOfEmission(in SurfaceW surface)
    {
        FloatW cosine = -Vec3W.Dot(surface.Incoming, surface.Normal);
        return FloatW.Max(FloatW.Min(cosine, 1f), -1f);
    }

    /// <summary>Finds the media of a ray that leaves a surface, by those of the ray that came.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="surface">The surface.</param>
    /// <param name="direction">The ray's direction.</param>
    /// <param name="interior">Number of the medium inside; 0 for none.</param>
    /// <param name="media">The media of the ray that came.</param>
    /// <param name="along">The media of the ray that leaves.</param>
    internal static void MediaAlong(Scene scene, in SurfaceW surface, in Vec3W direction, uint interior, in UIntW media, out UIntW along)
    {
        if (interior == 0)
        {
            along = media;
            return;
        }

        FloatW outwards = Vec3W.Dot(direction, surface.Normal);
        along = scene.Cross(media, interior, outwards * Vec3W.Dot(surface.Incoming, surface.Normal) > 0f, outwards < 0f);
    }

    /// <summary>
    /// Where a boundary is none, since what is inside it does not count on either side: another dielectric of a higher priority is there
    /// (the false intersections of Schmidt &amp; Budge 2002).
    /// </summary>
    internal static MaskW IsUnreal(UIntW before, UIntW after) => UIntW.Equal(MediumStack.Innermost(before), MediumStack.Innermost(after));

    /// <summary>
    /// The lanes whose rays come from inside of the surface itself, whatever its shading normals say (<see cref="SurfaceW.Inside"/>).
    /// </summary>
    internal static MaskW ComesFromInside(in SurfaceW surface) => Vec3W.Dot(surface.Incoming, surface.Normal) > 0f;

    /// <summary>Returns where a ray starts that leaves a surface: off it, on the side where the ray goes.</summary>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vec3W Leave(in SurfaceW surface, in Vec3W direction)
    {
        FloatW side = FloatW.CopySign(surface.Offset, Vec3W.Dot(direction, surface.Normal));
        return Vec3W.MultiplyAdd(surface.Normal, side, surface.Point);
    }

    /// <summary>The same in the space of the instance that shows the surface, for the rays that the instance itself meets.</summary>
    internal static Vec3W LeaveInside(in SurfaceW surface, in Vec3W direction)
    {
        FloatW side = FloatW.CopySign(surface.InnerOffset, Vec3W.Dot(direction, surface.Normal));
        return Vec3W.MultiplyAdd(surface.InnerNormal, side, surface.InnerPoint);
    }

    /// <summary>The values that shading works with, beside those of the stream.</summary>
    private protected struct PacketW
    {
        public ScatterW Scatter;
        public RgbW Throughput;
        public RgbW Radiance;
        public RgbW Arriving;
        public UIntW Path;
        public UIntW Pixel;
        public UIntW Ray;
        public UIntW Vertex;
        public UIntW Media;
        public FloatW Time;
        public FloatW Pdf;
        public Vec3W Origin;
        public SurfaceW Surface;
    }
}
