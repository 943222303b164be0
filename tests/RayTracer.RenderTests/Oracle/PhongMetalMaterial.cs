namespace RayTracer.RenderTests.Oracle;

/// <summary>Scatters with a density proportional to the cosine to the mirror direction, to the power of an exponent.</summary>
internal sealed class PhongMetalMaterial(Texture texture, double exponent) : Material
{
    public override Vec AmbientResponse(HitRecord hit) => texture.Value(hit.Shape, hit.Point);

    public override Scatter? DiffuseDirection(HitRecord hit, RandomNumbers random)
    {
        Vec d = random.Around(Math.Pow(1 - random.Next(), 1 / (exponent + 1)));
        Vec direction = hit.Mirrored.Unit.ToWorld(d.X, d.Y, d.Z);
        return Vec.Dot(direction, hit.Facing) > 0 ? new(direction, texture.Value(hit.Shape, hit.Point), Specular: true) : null;
    }
}
