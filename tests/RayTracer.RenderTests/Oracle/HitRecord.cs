namespace RayTracer.RenderTests.Oracle;

/// <summary>Where a ray meets a surface (report, section 6.2.1).</summary>
/// <param name="Shape">What was met.</param>
/// <param name="Point">Where.</param>
/// <param name="Incoming">Unit direction of the ray.</param>
/// <param name="Distance">Length of the ray.</param>
internal sealed record HitRecord(Shape Shape, Vec Point, Vec Incoming, double Distance)
{
    public Material Material => Shape.Material;

    /// <summary>The shape's own unit normal, outward.</summary>
    public Vec Normal { get; } = Shape.Normal(Point);

    /// <summary>Whether the ray comes from inside, against the shape's own normal.</summary>
    public bool Inside => Vec.Dot(Incoming, Normal) > 0;

    /// <summary>The normal on the ray's side.</summary>
    public Vec Facing => Inside ? -Normal : Normal;

    /// <summary>Cosine between the ray and the normal on its side.</summary>
    public double Cosine => Math.Abs(Vec.Dot(Incoming, Normal));

    /// <summary>Direction of the mirrored ray.</summary>
    public Vec Mirrored => Incoming - (2 * Vec.Dot(Incoming, Normal) * Normal);
}
