namespace RayTracer.RenderTests.Oracle;

/// <summary>Reflects by one of two materials, chosen at random by Schlick's reflectance; lights shine on the first.</summary>
internal sealed class DiffuseSpecularMaterial(Material diffuse, Material specular, double r0) : Material
{
    public override Vec AmbientResponse(HitRecord hit) =>
        ((1 - Reflectance(hit)) * diffuse.AmbientResponse(hit)) + (Reflectance(hit) * specular.AmbientResponse(hit));

    // As in the report, the choice is made once, in DiffuseDirection: where it is the coat's, no light source is asked.
    public override Vec ExplicitBrdf(HitRecord hit) => diffuse.ExplicitBrdf(hit);

    public override Scatter? DiffuseDirection(HitRecord hit, RandomNumbers random) =>
        (random.Next() < Reflectance(hit) ? specular : diffuse).DiffuseDirection(hit, random);

    private double Reflectance(HitRecord hit) => r0 + ((1 - r0) * Math.Pow(1 - Math.Min(1, hit.Cosine), 5));
}
