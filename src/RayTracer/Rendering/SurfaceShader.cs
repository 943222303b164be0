using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Rendering;

/// <summary>
/// What happens where paths meet a surface (report, listing 6.3): emission, ambient light, light from the sources, and
/// the choice of the next ray.
/// </summary>
internal sealed unsafe class SurfaceShader(Scene scene, FinishedPaths finished, ShadowQueue? queue, PathRecorder? recorder)
{
    private readonly DirectLight _directLight = new(scene, queue);
    private readonly VertexSamples _vertex = new(scene.Sampler);
    private RayGenerator _generator = null!;
    private SampleRange _samples;

    public long ShadowRays => _directLight.ShadowRays;

    /// <summary>Prepares for a tile.</summary>
    public void Begin(RayGenerator generator, SampleRange samples)
    {
        _generator = generator;
        _samples = samples;
    }

    /// <summary>Ends the paths that left the scene.</summary>
    public void Miss(PathStream stream, uint* members, int count)
    {
        RgbW background = scene.Background;
        for (int i = 0; i < count; i += FloatW.Count)
        {
            uint* index = members + i;
            RgbW radiance = RgbW.MultiplyAdd(stream.PickThroughput(index), background, stream.PickRadiance(index));

            // A direction that is not a number meets nothing; it must not pass for a ray into the open.
            Vec3W direction = stream.PickDirection(index);
            FloatW fault = Vec3W.Dot(direction, direction) * 0f;
            radiance += new RgbW(fault, fault, fault);
            recorder?.Missed(stream, index, MaskW.First(count - i));
            finished.Append(MaskW.First(count - i).Bits, radiance, UIntW.Pick(stream.Path, index));
        }
    }

    /// <summary>Shades all hits of one group.</summary>
    /// <param name="group">The group.</param>
    /// <param name="stream">The paths.</param>
    /// <param name="next">Takes the paths that go on.</param>
    /// <param name="members">Indices of the group's paths in the stream, padded to whole packets.</param>
    /// <param name="count">Number of the group's paths.</param>
    public void Shade(ShadingGroup group, PathStream stream, PathStream next, uint* members, int count)
    {
        for (int i = 0; i < count; i += FloatW.Count)
        {
            ShadePacket(group, stream, next, members + i, MaskW.First(count - i));
        }
    }

    /// <summary>Adds what waits to the paths that went on to the next stream, or ended.</summary>
    public void Flush(PathStream next) => queue?.Flush(finished, next);

    /// <summary>Describes where paths met the surfaces of a group: all that a material needs.</summary>
    /// <param name="scene">The scene.</param>
    /// <param name="group">The group.</param>
    /// <param name="stream">The paths.</param>
    /// <param name="index">Indices of a packet of paths in the stream.</param>
    /// <param name="needsUv">Whether uv is wanted.</param>
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

        if (group.HasShadingNormals)
        {
            Smooth(ref surface);
        }

        if (!group.HasTint)
        {
            surface.Tint = Rgb.White;
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
        PrimitiveIndex primitives = group.OnlyIndex >= 0
            ? new(group.OnlyIndex, stride)
            : new(UIntW.Pick(stream.Primitive, index) - (uint)group.Batch.FirstPrimitive, stride);
        group.Batch.Describe(primitives, needsUv, ref surface);
    }

    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static void TurnToRay(ref SurfaceW surface)
    {
        FloatW along = Vec3W.Dot(surface.Incoming, surface.Normal);
        surface.Inside = along > 0f;
        surface.Facing = surface.Inside.Select(-surface.Normal, surface.Normal);
        surface.Cosine = FloatW.Min(FloatW.Abs(along), 1f);
    }

    private void ShadePacket(ShadingGroup group, PathStream stream, PathStream next, uint* index, MaskW active)
    {
        // Random numbers first: their long chain of multiplications then overlaps with the description of the surface.
        UIntW path = UIntW.Pick(stream.Path, index);
        UIntW state = UIntW.Pick(stream.State, index);
        PathNumber.Split(path, _samples, out UIntW pixel, out UIntW sample);
        UIntW diffuseDepth = state & PathState.DepthMask;
        UIntW specularDepth = (state >> PathState.SpecularShift) & PathState.DepthMask;
        _vertex.Begin(UIntW.Gather(_generator.PixelKeys, pixel), sample, diffuseDepth + specularDepth);
        Describe(scene, group, stream, index, group.UsesUv, out SurfaceW surface);
        FloatW time = scene.IsTimed ? FloatW.Pick(stream.Time, index) : 0f;
        RgbW throughput = stream.PickThroughput(index);
        RgbW radiance = stream.PickRadiance(index);

        // Light that the surface itself sends towards the ray's origin.
        Material material = group.Material;
        if (group.Emits)
        {
            AddEmission(material, surface, throughput, state, ref radiance);
        }

        recorder?.Emitted(path, active, radiance);

        if (!scene.Ambient.IsBlack)
        {
            material.AmbientResponse(surface, out RgbW response);
            radiance = RgbW.MultiplyAdd(throughput * response, scene.Ambient, radiance);
        }

        recorder?.Brightened(path, active, radiance);

        // Light from the sources.
        if (group.IsLit)
        {
            material.Brdf(surface, out RgbW brdf);
            if (queue is { IsFull: true })
            {
                queue.Flush(finished, next);
            }

            _directLight.Add(surface, group.HasShadingNormals, _vertex, time, active, throughput * brdf, ref radiance);
        }

        // Where the path goes on.
        material.Scatter(surface, _vertex, out ScatterW scatter);
        throughput *= scatter.Weight;
        UIntW limit = scatter.Specular.Select((UIntW)(uint)scene.Render.MaxSpecularDepth, (uint)scene.Render.MaxDiffuseDepth);
        MaskW goesOn = scatter.Specular.Select(specularDepth, diffuseDepth) < limit;

        // Written so that a path whose throughput is not a number goes on, and is counted at its end.
        MaskW isDark = (throughput.R <= 0f) & (throughput.G <= 0f) & (throughput.B <= 0f);
        MaskW alive = active.Except(scatter.Absorbed).Except(isDark) & goesOn;
        if (group.HasShadingNormals)
        {
            alive = alive.Except(Leaks(surface, scatter.Direction));
        }

        recorder?.Scattered(stream, index, active, alive, material, surface, scatter);
        uint ended = active.Except(alive).Bits;
        uint going = alive.Bits;
        if (queue is not null && group.IsLit)
        {
            queue.End(ended, finished.Count, going, next.Count);
        }

        if (ended != 0)
        {
            finished.Append(ended, radiance, path);
        }

        if (going != 0)
        {
            UIntW step = scatter.Specular.Select((UIntW)PathState.OneSpecular, PathState.OneDiffuse);
            UIntW emission = scatter.Specular.Select((UIntW)PathState.CountsEmission, 0u);
            Vec3W origin = Leave(surface, scatter.Direction);
            if (scene.IsTimed)
            {
                next.SetTime(going, time);
            }

            next.Append(going, origin, scatter.Direction, throughput, radiance, path, ((state & 0xffffu) + step) | emission);
        }
    }

    // As DescribePlain, in the space that each lane's instance shows.
    private static void DescribeInstanced(Scene scene, ShadingGroup group, PathStream stream, uint* index, bool needsUv, out SurfaceW surface)
    {
        Unsafe.SkipInit(out surface);
        float* memory = stackalloc float[InstanceMaps.Floats];
        InstanceMaps maps = new(memory);
        maps.Fill(scene.World.Instances!, UIntW.Pick(stream.Instance, index), scene.IsTimed ? FloatW.Pick(stream.Time, index) : 0f);
        surface.Incoming = stream.PickDirection(index);
        surface.Distance = FloatW.Pick(stream.Distance, index);
        surface.Point = Vec3W.MultiplyAdd(maps.VectorBack(surface.Incoming), surface.Distance, maps.PointBack(stream.PickOrigin(index)));
        DescribeTable(group, stream, index, needsUv, ref surface);
        maps.Describe(group.HasShadingNormals, ref surface);
        TurnToRay(ref surface);
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

    // Directions that lie on different sides of the surface and of the plane that it is shaded as: what is reflected would come through
    // it, and what is refracted would not (Veach 1997, section 5.3). They carry no light.
    private static MaskW Leaks(in SurfaceW surface, in Vec3W direction)
    {
        FloatW side = Vec3W.Dot(direction, surface.Inside.Select(-surface.Normal, surface.Normal));
        return side * Vec3W.Dot(direction, surface.Facing) <= 0f;
    }

    private static void AddEmission(Material material, in SurfaceW surface, in RgbW throughput, UIntW state, ref RgbW radiance)
    {
        MaskW counts = ~UIntW.Equal(state & PathState.CountsEmission, 0u);
        FloatW cosine = FloatW.Min(FloatW.Abs(Vec3W.Dot(surface.Incoming, surface.Normal)), 1f);
        cosine = surface.Inside.Select(-cosine, cosine);
        material.Emission(cosine, surface.U, surface.V, out RgbW emitted);
        radiance = counts.Select(RgbW.MultiplyAdd(throughput, emitted, radiance), radiance);
    }

    // Off the surface, on the side where the ray goes.
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    private static Vec3W Leave(in SurfaceW surface, in Vec3W direction)
    {
        FloatW side = FloatW.CopySign(surface.Offset, Vec3W.Dot(direction, surface.Normal));
        return Vec3W.MultiplyAdd(surface.Normal, side, surface.Point);
    }
}
