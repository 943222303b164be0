using RayTracer.Description;
using RayTracer.Media;
using RayTracer.Numerics;
using RayTracer.Sampling;

namespace RayTracer.Materials;

/// <summary>Describes an <see cref="InvisibleMaterial"/>.</summary>
[SceneType("invisible", "A surface that all light passes straight through: the boundary of a cloud or of smoke, whose interior "
    + "path, volPath and the integrators that trace light show.")]
public sealed record InvisibleMaterialDescription : MaterialDescription
{
    /// <summary>The medium inside.</summary>
    [Parameter("What fills the (closed) shape; path, volPath and the integrators that trace light show it.")]
    public MediumDescription Interior { get; init; } = new();

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder) => new InvisibleMaterial(builder.Medium(Interior));
}

/// <summary>A boundary that changes no light.</summary>
/// <param name="interior">The medium behind it; null for empty space.</param>
internal sealed class InvisibleMaterial(Medium? interior) : Material
{
    /// <inheritdoc/>
    public override MaterialTraits Traits { get; } = new()
    {
        Specular = SpecularLobe.Delta,
        KeepsEnergy = true,
        IsBoundary = true,
        IsTransparent = true,
        PassesStraight = true,
        Interior = interior,
    };

    /// <inheritdoc/>
    public override void Albedo(in SurfaceW surface, out RgbW albedo) => albedo = Rgb.White;

    /// <inheritdoc/>
    public override void Transparency(in SurfaceW surface, out RgbW transparency) => transparency = Rgb.White;

    /// <inheritdoc/>
    public override void Straight(in SurfaceW surface, out RgbW share) => share = Rgb.White;

    /// <inheritdoc/>
    public override void Scatter(in SurfaceW surface, VertexSamples samples, out ScatterW scatter)
    {
        scatter.Direction = surface.Incoming;
        scatter.Weight = Rgb.White;
        scatter.Specular = MaskW.All;
        scatter.Delta = MaskW.All;
        scatter.Absorbed = MaskW.None;
    }
}
