using RayTracer.Acceleration;
using RayTracer.Description;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Shapes;

namespace RayTracer.Lights;

/// <summary>A shape that shines, as a source to be sampled.</summary>
/// <param name="shape">The shape, of finite area.</param>
/// <param name="primitive">Its number among the scene's primitives, so that it does not shadow itself.</param>
internal sealed class AreaLight(Shape shape, int primitive) : LightSource(0, primitive)
{
    private readonly LuminaireMaterial _luminaire = (LuminaireMaterial)shape.Material;

    // A sphere of one colour is the common light: its uv would cost more than all the rest.
    private readonly Sphere? _plainSphere = ((LuminaireMaterial)shape.Material).ConstantColor is null ? null : shape as Sphere;
    private readonly Rgb _plainColor = ((LuminaireMaterial)shape.Material).ConstantColor ?? Rgb.Black;

    /// <summary>The shape.</summary>
    public Shape Shape => shape;

    /// <summary>The batch that the shape is in; null for a light that only takes samples.</summary>
    internal SurfaceTable? Table { get; init; }

    /// <inheritdoc/>
    internal override bool CanEmit => Table is not null && shape.SampleSurface(0.5f, 0.5f, out _);

    /// <inheritdoc/>
    public override void Pdf(in LightHitW hit, out FloatW pdf) => shape.SamplePdf(hit.From, hit.Distance, hit.Cosine, out pdf);

    /// <inheritdoc/>
    public override LightExtent Extent((double Open, double Close) shutter) => new(shape.Bounds, _luminaire.MeanIntensity * shape.Area);

    /// <inheritdoc/>
    public override void Sample(in Vec3W from, in FloatW u, in FloatW v, in FloatW time, out ShapeSampleW sample, out RgbW radiance)
    {
        if (_plainSphere is null)
        {
            shape.SamplePoint(from, u, v, out sample);
            _luminaire.Emission(sample.Cosine, sample.U, sample.V, out radiance);
            radiance *= sample.InversePdf;
            return;
        }

        _plainSphere.SampleDirection(from, u, v, out sample);
        radiance = (RgbW)_plainColor * (_luminaire.Falloff(sample.Cosine) * sample.InversePdf);
    }

    /// <summary>Chooses a point of the light for each lit point.</summary>
    /// <param name="from">The lit points.</param>
    /// <param name="u">First random number.</param>
    /// <param name="v">Second random number.</param>
    /// <param name="sample">Direction and distance; an inverse pdf of zero where the light cannot be seen.</param>
    /// <param name="radiance">Radiance from the chosen point over the pdf per solid angle.</param>
    public void Sample(in Vec3W from, in FloatW u, in FloatW v, out ShapeSampleW sample, out RgbW radiance) =>
        Sample(from, u, v, 0f, out sample, out radiance);

    /// <inheritdoc/>
    internal override void Emit(in FloatW u1, in FloatW v1, in FloatW u2, in FloatW v2, in FloatW time, out EmittedW ray)
    {
        SurfaceW surface = default;
        shape.SampleSurface(u1, v1, out surface.Point);
        Table!.Describe(new PrimitiveIndex(Primitive - Table.FirstPrimitive, Table.Stride), _luminaire.ConstantColor is null, ref surface);
        LuminaireEmission.Emit(_luminaire, surface, 1 / shape.Area, u2, v2, out ray);
        ray.Primitive = (uint)Primitive;
    }

    /// <inheritdoc/>
    internal override void EmissionPdf(in LightHitW hit, out FloatW point, out FloatW direction)
    {
        point = (hit.Cosine > 0f).Select(1 / shape.Area, 0f);
        direction = _luminaire.EmissionPdf(hit.Cosine);
    }
}
