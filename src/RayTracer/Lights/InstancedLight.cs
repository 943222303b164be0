using RayTracer.Acceleration;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Lights;

/// <summary>
/// A shape that shines inside an instance. It is sampled in its own space, from where the lit point lies in it. Directions, and the
/// solid angles around them, are then mapped into the world: for a map A, by |det A| / |A·ω|³.
/// </summary>
/// <param name="shape">The shape, of finite area.</param>
/// <param name="table">The batch that the shape is in.</param>
/// <param name="primitive">The shape's number among the scene's primitives.</param>
/// <param name="instances">The scene's instances.</param>
/// <param name="instance">The instance in which it stands.</param>
internal sealed unsafe class InstancedLight(Shape shape, SurfaceTable table, int primitive, InstanceTable instances, int instance)
    : LightSource(instance, primitive)
{
    private readonly LuminaireMaterial _luminaire = (LuminaireMaterial)shape.Material;

    /// <inheritdoc/>
    public override void Pdf(in LightHitW hit, out FloatW pdf)
    {
        float* memory = stackalloc float[InstanceMaps.Floats];
        InstanceMaps maps = new(memory);
        maps.Fill(instances, Instance, hit.Time);
        Vec3W inside = maps.PointBack(hit.From);
        Vec3W along = maps.VectorBack(hit.Direction);

        // Lengths in the world over lengths in the space, along the ray.
        FloatW stretch = 1f / FloatW.Sqrt(Vec3W.Dot(along, along));
        Vec3W direction = along * stretch;
        FloatW distance = hit.Distance / stretch;
        FloatW cosine = FloatW.CopySign(Vec3W.Dot(direction, NormalAt(Vec3W.MultiplyAdd(direction, distance, inside))), hit.Cosine);
        shape.SamplePdf(inside, distance, cosine, out FloatW pdfInside);
        pdf = pdfInside * (stretch * stretch * stretch) / FloatW.Abs(maps.Determinant());
    }

    /// <inheritdoc/>
    public override LightExtent Extent((double Open, double Close) shutter)
    {
        // Areas grow about as the two thirds' power of volumes.
        float volume = (float)double.Abs(instances.PlaceOf(Instance).Determinant);
        return new(instances.BoundsOf(Instance, shape.Bounds, shutter), _luminaire.MeanIntensity * shape.Area * LaneMath.Pow(volume, 2f / 3f));
    }

    /// <inheritdoc/>
    public override void Sample(in Vec3W from, in FloatW u, in FloatW v, in FloatW time, out ShapeSampleW sample, out RgbW radiance)
    {
        float* memory = stackalloc float[InstanceMaps.Floats];
        InstanceMaps maps = new(memory);
        maps.Fill(instances, Instance, time);
        Vec3W inside = maps.PointBack(from);
        shape.SamplePoint(inside, u, v, out sample);

        // The point chosen, and the normal there as the world sees it.
        Vec3W normal = NormalAt(Vec3W.MultiplyAdd(sample.Direction, sample.Distance, inside));
        Vec3W along = maps.Vector(sample.Direction);
        FloatW stretch = FloatW.Sqrt(Vec3W.Dot(along, along));
        sample.InversePdf *= FloatW.Abs(maps.Determinant()) / (stretch * stretch * stretch);
        sample.Direction = along * (1f / stretch);
        sample.Distance *= stretch;
        sample.Cosine = -Vec3W.Dot(sample.Direction, Vec3W.Normalize(maps.NormalOut(normal)));
        _luminaire.Emission(sample.Cosine, sample.U, sample.V, out RgbW emitted);
        radiance = emitted * sample.InversePdf;
    }

    /// <inheritdoc/>
    internal override bool CanEmit => shape.SampleSurface(0.5f, 0.5f, out _);

    /// <inheritdoc/>
    internal override void Emit(in FloatW u1, in FloatW v1, in FloatW u2, in FloatW v2, in FloatW time, out EmittedW ray)
    {
        float* memory = stackalloc float[InstanceMaps.Floats];
        InstanceMaps maps = new(memory);
        maps.Fill(instances, Instance, time);
        SurfaceW surface = default;
        shape.SampleSurface(u1, v1, out surface.Point);
        Describe(_luminaire.ConstantColor is null, ref surface);
        FloatW area = maps.AreaFactor(surface.Normal) * shape.Area;
        maps.Describe(hasShading: false, hasTangents: false, ref surface);
        LuminaireEmission.Emit(_luminaire, surface, 1f / area, u2, v2, out ray);
        ray.Primitive = (uint)Primitive;
        ray.Instance = (uint)Instance;
    }

    /// <inheritdoc/>
    internal override void EmissionPdf(in LightHitW hit, out FloatW point, out FloatW direction)
    {
        float* memory = stackalloc float[InstanceMaps.Floats];
        InstanceMaps maps = new(memory);
        maps.Fill(instances, Instance, hit.Time);
        Vec3W normal = NormalAt(maps.PointBack(Vec3W.MultiplyAdd(hit.Direction, hit.Distance, hit.From)));
        point = (hit.Cosine > 0f).Select(1f / (maps.AreaFactor(normal) * shape.Area), 0f);
        direction = _luminaire.EmissionPdf(hit.Cosine);
    }

    private Vec3W NormalAt(Vec3W point)
    {
        SurfaceW surface = default;
        surface.Point = point;
        Describe(needsUv: false, ref surface);
        return surface.Normal;
    }

    private void Describe(bool needsUv, ref SurfaceW surface) =>
        table.Describe(new PrimitiveIndex(Primitive - table.FirstPrimitive, table.Stride), needsUv, ref surface);
}
