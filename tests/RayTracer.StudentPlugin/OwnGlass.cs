using RayTracer.Adapters;
using RayTracer.Description;
using RayTracer.Textbook;
using Rgb = RayTracer.Textbook.Rgb;

namespace RayTracer.StudentPlugin;

/// <summary>Describes <see cref="OwnGlass"/>.</summary>
[SceneType("ownGlass", "Clear glass.")]
public sealed record OwnGlassDescription : TextbookMaterialDescription
{
    /// <summary>The refractive index.</summary>
    [Parameter("The refractive index of the inside over that of the outside.", Minimum = 0.1, Maximum = 10)]
    public float Index { get; init; } = 1.5f;

    /// <inheritdoc/>
    public override IMaterial Make(TextureMaker texture) => new OwnGlass(Index);
}

/// <summary>Clear glass, of which one of both directions is chosen evenly.</summary>
/// <param name="index">The refractive index of the inside over that of the outside.</param>
public sealed class OwnGlass(double index) : IMaterial
{
    /// <inheritdoc/>
    public Rgb Evaluate(in Hit hit, Vector toViewer, Vector toLight) => default;

    /// <inheritdoc/>
    public double Pdf(in Hit hit, Vector from, Vector to) => 0;

    /// <inheritdoc/>
    public IReadOnlyList<Scattering> Mirrors(in Hit hit, Vector from)
    {
        double eta = hit.Inside ? index : 1 / index;
        Vector up = Refraction.Reflect(from);
        if (Refraction.Refract(from, eta) is not { } down)
        {
            return [new(up, Rgb.White, 0, Lobe.Mirror)];
        }

        double share = Refraction.Fresnel(from.Z, -down.Z, eta);
        return [new(up, new(share), 0, Lobe.Mirror), new(down, new((1 - share) * eta * eta), 0, Lobe.Mirror) { ParticleWeight = new(1 - share) }];
    }

    /// <inheritdoc/>
    public Scattering? Sample(in Hit hit, Vector from, ISampler sampler)
    {
        IReadOnlyList<Scattering> both = Mirrors(hit, from);
        Scattering chosen = both[(int)(sampler.Next() * both.Count)];
        return chosen with { Weight = chosen.Weight * both.Count, ParticleWeight = chosen.ParticleWeight * both.Count };
    }
}
