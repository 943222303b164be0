namespace RayTracer.RenderTests.Oracle;

/// <summary>Reflects or refracts at random, by Fresnel's equations or Schlick's approximation; absorbs inside by Beer's law.</summary>
internal sealed class DielectricMaterial(double index, Vec extinction, bool isSchlick) : Material
{
    public override Scatter? DiffuseDirection(HitRecord hit, RandomNumbers random)
    {
        // Index on the ray's side, and on the other.
        (double n1, double n2) = hit.Inside ? (index, 1.0) : (1.0, index);
        Vec left = hit.Inside
            ? new(Math.Exp(-extinction.X * hit.Distance), Math.Exp(-extinction.Y * hit.Distance), Math.Exp(-extinction.Z * hit.Distance))
            : Vec.One;
        double c1 = hit.Cosine;
        double c2Squared = 1 - ((n1 / n2) * (n1 / n2) * (1 - (c1 * c1)));
        if (c2Squared <= 0 || random.Next() < Reflectance(n1, n2, c1, Math.Sqrt(c2Squared)))
        {
            return new(hit.Mirrored.Unit, left, Specular: true);
        }

        // What is parallel to the surface grows as the sines do; radiance is proportional to the square of the index.
        Vec parallel = (n1 / n2) * (hit.Incoming + (c1 * hit.Facing));
        return new((parallel - (Math.Sqrt(c2Squared) * hit.Facing)).Unit, (n1 / n2) * (n1 / n2) * left, Specular: true);
    }

    private double Reflectance(double n1, double n2, double c1, double c2)
    {
        if (isSchlick)
        {
            // The angle is that on the side of the lower index.
            double r0 = (n1 - n2) / (n1 + n2) * ((n1 - n2) / (n1 + n2));
            return r0 + ((1 - r0) * Math.Pow(1 - Math.Min(1, n1 > n2 ? c2 : c1), 5));
        }

        double perpendicular = ((n1 * c1) - (n2 * c2)) / ((n1 * c1) + (n2 * c2));
        double parallel = ((n2 * c1) - (n1 * c2)) / ((n2 * c1) + (n1 * c2));
        return 0.5 * ((perpendicular * perpendicular) + (parallel * parallel));
    }
}
