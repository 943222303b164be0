namespace RayTracer.Textbook;

/// <summary>
/// Rough metal, of tiny mirrors: f = F·D·G₁(v)·G₁(l)/(4·cos·cos) (Torrance &amp; Sparrow 1967; Walter et al., Microfacet models for refraction through
/// rough surfaces, 2007, eq. 20), whose tilts have the distribution GGX (eq. 33).
/// </summary>
/// <param name="alpha">Roughness; its red channel counts.</param>
/// <param name="reflectance">How much the tiny mirrors reflect.</param>
public sealed class Ggx(ITexture alpha, Reflectance reflectance) : IMaterial
{
    // Smoother ones are mirrors for all that can be seen, and 0 would divide by it.
    private const double Smoothest = 1e-4;

    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight)
    {
        if (toViewer.Z <= 0 || toLight.Z <= 0)
        {
            return default;
        }

        double a = Alpha(hit);
        Vector tilt = (toViewer + toLight).Unit;
        double lobe = Tilts(tilt, a) * Seen(toViewer, a) * Seen(toLight, a) / (4 * toViewer.Z * toLight.Z);
        return reflectance.At(hit, Vector.Dot(toViewer, tilt)) * lobe;
    }

    /// <summary>The density of tilts that are seen, of which mirrors make directions: those are spread four times the cosine as wide.</summary>
    public double Pdf(in Hit hit, Vector from, Vector to)
    {
        double a = Alpha(hit);
        return from.Z <= 0 || to.Z <= 0 ? 0 : Tilts((from + to).Unit, a) * Seen(from, a) / (4 * from.Z);
    }

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        Vector tilt = SeenTilt(from, Alpha(hit), sampler.Next2());
        Vector to = (2 * Vector.Dot(from, tilt) * tilt) - from;
        double pdf = Pdf(hit, from, to);
        return pdf > 0 ? new Scattering(to, Evaluate(hit, from, to) * (to.Z / pdf), pdf, Lobe.Glossy) : null;
    }

    /// <inheritdoc/>
    public Rgb Ambient(in Hit hit, Vector toViewer) => reflectance.At(hit, toViewer.Z);

    // D, of Walter's equation 33: the slopes' distribution.
    private static double Tilts(Vector tilt, double a)
    {
        double x = ((tilt.X * tilt.X) + (tilt.Y * tilt.Y)) / (a * a) + (tilt.Z * tilt.Z);
        return 1 / (Math.PI * a * a * x * x);
    }

    // G₁, of Walter's equation 34: the share of the tiny mirrors that others do not hide.
    private static double Seen(Vector direction, double a)
    {
        double tan2 = ((direction.X * direction.X) + (direction.Y * direction.Y)) / (direction.Z * direction.Z);
        return 2 / (1 + Math.Sqrt(1 + (a * a * tan2)));
    }

    // Heitz, Sampling the GGX distribution of visible normals, 2018: stretched so that the surface is a half-ball, of which a point is chosen that is seen.
    private static Vector SeenTilt(Vector from, double a, (double U, double V) random)
    {
        Vector stretched = new Vector(a * from.X, a * from.Y, from.Z).Unit;
        (double x, double y) = Warp.Disk(random);

        // The half-ball seen askew: one half of the disk is cut by the ground, along the direction that is level and the one across it.
        Vector level = stretched.Z < 1 ? new Vector(-stretched.Y, stretched.X, 0).Unit : new Vector(1, 0, 0);
        Vector across = Vector.Cross(stretched, level);
        double edge = Math.Sqrt(1 - (x * x));
        double share = 0.5 * (1 + stretched.Z);
        y = ((1 - share) * edge) + (share * y);
        Vector point = (x * level) + (y * across) + (Math.Sqrt(Math.Max(0, 1 - (x * x) - (y * y))) * stretched);
        return new Vector(a * point.X, a * point.Y, Math.Max(1e-12, point.Z)).Unit;
    }

    private double Alpha(in Hit hit) => Math.Max(alpha.At(hit.U, hit.V).R, Smoothest);
}
