using System.Numerics;
using RayTracer.Materials;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Textbook;
using Vector = RayTracer.Textbook.Vector;

namespace RayTracer.Adapters;

/// <summary>A material of the fast edition that is asked for one ray at a time, as the textbook edition's are: with all lanes alike.</summary>
/// <param name="material">The material.</param>
internal sealed class LaneMaterial(Material material) : IMaterial
{
    // The yellow line of helium, at which refractive indices are given.
    private const float Wavelength = 0.5876f;
    private readonly VertexSamples _samples = new(new Sampling.IndependentSampler(1));

    /// <inheritdoc/>
    public Textbook.Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight)
    {
        material.Bsdf(Surface(hit, toViewer), World(hit, toLight), out RgbW bsdf);
        return Color(bsdf);
    }

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to)
    {
        material.Pdf(Surface(hit, from), World(hit, to), out FloatW pdf);
        return pdf[0];
    }

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        SurfaceW surface = Surface(hit, from);
        _samples.Begin((uint)(sampler.Next() * uint.MaxValue), 0u, 0u);
        material.Scatter(surface, _samples, out ScatterW scatter);
        if (Is(scatter.Absorbed))
        {
            return null;
        }

        Vector to = hit.Frame.ToLocal(Lanes.Vector(scatter.Direction, 0));
        Lobe lobe = Is(scatter.Delta) ? Lobe.Mirror : Is(scatter.Specular) ? Lobe.Glossy : Lobe.Matt;
        surface.CarriesLight = true;
        material.Scatter(surface, _samples, out ScatterW ofLight);
        return new Scattering(to, Color(scatter.Weight), lobe == Lobe.Mirror ? 0 : Pdf(hit, from, to), lobe) { ParticleWeight = Color(ofLight.Weight) };
    }

    private SurfaceW Surface(in Hit hit, Vector from)
    {
        Vec3W normal = Single(hit.Normal);
        SurfaceW surface = default;
        surface.Normal = surface.Shading = normal;
        surface.Facing = hit.Inside ? -normal : normal;
        surface.Incoming = -World(hit, from);
        surface.Cosine = (float)from.Z;
        surface.Inside = hit.Inside ? MaskW.All : MaskW.None;
        (surface.U, surface.V, surface.Distance) = ((float)hit.U, (float)hit.V, (float)hit.Distance);
        (surface.Wavelength, surface.ExteriorIndex, surface.Tint) = (Wavelength, 1f, Numerics.Rgb.White);
        Onb.FromNormal(normal, out Onb frame);
        (surface.Tangent, surface.AlongU, surface.AlongV) = (frame.U, frame.U, frame.V);
        material.Prepare(ref surface);
        return surface;
    }

    private static bool Is(MaskW mask) => (mask.Bits & 1) != 0;

    private static Vec3W World(in Hit hit, Vector local) => Single(hit.Frame.ToWorld(local));

    private static Vec3W Single(Vector v) => new Vector3((float)v.X, (float)v.Y, (float)v.Z);

    private static Textbook.Rgb Color(in RgbW color) => new(color.R[0], color.G[0], color.B[0]);
}
