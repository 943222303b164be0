namespace RayTracer.RenderTests.Oracle;

/// <summary>Lambert's law: BRDF = colour/π.</summary>
internal sealed class DiffuseMaterial(Texture texture) : Material
{
    public override Vec AmbientResponse(HitRecord hit) => texture.Value(hit.Shape, hit.Point);

    public override Vec ExplicitBrdf(HitRecord hit) => texture.Value(hit.Shape, hit.Point) / Math.PI;

    // A point of the unit sphere that stands on the surface is seen at a cosine-distributed angle.
    public override Scatter? DiffuseDirection(HitRecord hit, RandomNumbers random) =>
        new((hit.Facing + random.Direction()).Unit, texture.Value(hit.Shape, hit.Point), Specular: false);
}
