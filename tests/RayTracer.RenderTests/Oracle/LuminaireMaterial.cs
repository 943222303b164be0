namespace RayTracer.RenderTests.Oracle;

/// <summary>Emits colour · multiplier · cos^exponent on the outside; an inner material answers for reflection.</summary>
internal sealed class LuminaireMaterial(Texture texture, double multiplier, double exponent, Material inner) : Material
{
    public override Vec EmittedRadiance(double cosine, Shape shape, Vec point) =>
        cosine > 0 ? multiplier * Math.Pow(cosine, exponent) * texture.Value(shape, point) : default;

    public override Vec AmbientResponse(HitRecord hit) => inner.AmbientResponse(hit);

    public override Vec ExplicitBrdf(HitRecord hit) => inner.ExplicitBrdf(hit);

    public override Scatter? DiffuseDirection(HitRecord hit, RandomNumbers random) => inner.DiffuseDirection(hit, random);
}
