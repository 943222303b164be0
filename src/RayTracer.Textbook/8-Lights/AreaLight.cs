namespace RayTracer.Textbook;

/// <summary>How a surface shines, on the side of its normal (report, section 6.2.6, the luminaire).</summary>
/// <param name="color">The colour.</param>
/// <param name="multiplier">A factor on it.</param>
/// <param name="exponent">Radiance falls with the cosine to this power: 0 is even, 1 the report's spot light.</param>
public sealed class Luminaire(ITexture color, double multiplier, double exponent)
{
    /// <summary>The exponent of the cosine.</summary>
    public double Exponent => exponent;

    /// <summary>The radiance that leaves a point.</summary>
    /// <param name="u">The place on the texture.</param>
    /// <param name="v">The place on the texture.</param>
    /// <param name="cosine">Cosine of the angle between direction and normal; below 0 from behind, where it is dark.</param>
    public Rgb Radiance(double u, double v, double cosine) => cosine > 0 ? color.At(u, v) * (multiplier * Math.Pow(cosine, exponent)) : default;
}

/// <summary>A shape that shines.</summary>
/// <param name="shape">The shape.</param>
/// <param name="luminaire">How it shines.</param>
public sealed class AreaLight(IShape shape, Luminaire luminaire) : ILight
{
    /// <inheritdoc/>
    public bool IsPoint => false;

    /// <summary>The exitance, radiance times 2π/(n + 2), of the middle of the texture, from all of the area.</summary>
    public double Power => luminaire.Radiance(0.5, 0.5, 1).Luminance * shape.Area * 2 * Math.PI / (luminaire.Exponent + 2);

    /// <inheritdoc/>
    public LightSample? Sample(Vector from, (double U, double V) random)
    {
        (SurfacePoint point, double pdf) = shape.PointSeenFrom(from, random);
        Vector to = point.Point - from;
        double distance = to.Length;
        Vector direction = to * (1 / distance);
        double cosine = -Vector.Dot(direction, point.Normal);
        return pdf > 0 && cosine > 0 ? new LightSample(direction, distance, luminaire.Radiance(point.U, point.V, cosine), pdf) : null;
    }

    /// <summary>The density, per steradian, with which <see cref="Sample"/> chooses the direction of a hit.</summary>
    /// <param name="from">The place that is lit.</param>
    /// <param name="hit">Where a ray from there meets the light.</param>
    public double Pdf(Vector from, in Hit hit) => shape.SeenPdf(from, hit);

    /// <summary>The radiance that a ray finds.</summary>
    /// <param name="incoming">The ray's direction.</param>
    /// <param name="hit">Where it meets the light.</param>
    public Rgb Radiance(Vector incoming, in Hit hit) => luminaire.Radiance(hit.U, hit.V, -Vector.Dot(incoming, hit.Normal));

    /// <summary>A point by area; a direction in proportion to radiance · cosine.</summary>
    public (Ray Ray, Rgb Power)? Emit(ISampler sampler)
    {
        SurfacePoint point = shape.PointAt(sampler.Next2());
        double exponent = luminaire.Exponent + 1;
        Vector local = Warp.CosinePower(sampler.Next2(), exponent);
        double pdf = point.Pdf * Warp.CosinePowerPdf(local.Z, exponent);
        Hit start = new() { Point = point.Point, Normal = point.Normal };
        Rgb power = luminaire.Radiance(point.U, point.V, local.Z) * (local.Z / pdf);
        return pdf > 0 ? (start.Leave(new Frame(point.Normal).ToWorld(local)), power) : null;
    }
}
