using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="NormalMapMaterial"/>.</summary>
[SceneType("normalMap", "Another material whose surface looks embossed: a picture tells the normals, as other programs write it.")]
public sealed record NormalMapMaterialDescription : MaterialDescription
{
    /// <summary>The normals.</summary>
    [Parameter("The normals as colours: red, green and blue from 0 to 1 are from −1 to 1 along u, perpendicular to u, and outwards. A picture is read raw unless it says otherwise; [0.5, 0.5, 1] is a flat surface.", Required = true)]
    public TextureDescription Map { get; init; } = new SolidTextureDescription { Color = new(0.5f, 0.5f, 1) };

    /// <summary>Factor on the slopes.</summary>
    [Parameter("Factor on the slopes: 1 as the map tells, 0 is flat.", Minimum = 0, Maximum = 100)]
    public float Strength { get; init; } = 1;

    /// <summary>What scatters light.</summary>
    [Parameter("What scatters light: a material of any type but a luminaire.", Required = true)]
    public MaterialDescription Material { get; init; } = new DiffuseMaterialDescription();

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder)
    {
        if (Map is ImageTextureDescription { Raw: false, Picture: null } image && !(image.File.EndsWith(".pfm", StringComparison.OrdinalIgnoreCase) || image.File.EndsWith(".exr", StringComparison.OrdinalIgnoreCase)))
        {
            builder.Warn(this, nameof(Map), "a normal map's numbers are directions, not colours: its picture should have \"raw\": true");
        }

        return new NormalMapMaterial(WrapperMaterial.Part(builder, this, nameof(Material), Material), builder.NumberTexture(Map), Strength);
    }
}

/// <summary>Turns normals to what a texture tells, in the frame of the tangent along u, the normal × that, and the normal.</summary>
/// <param name="inner">What scatters light.</param>
/// <param name="map">The normals.</param>
/// <param name="strength">Factor on the slopes.</param>
public sealed class NormalMapMaterial(Material inner, Texture map, float strength) : PerturbedMaterial(inner)
{
    /// <inheritdoc/>
    protected override void Perturb(in SurfaceW surface, in Vec3W outward, out Vec3W normal)
    {
        map.Evaluate(surface, out RgbW color);
        Onb frame = new(surface.Tangent, Vec3W.Cross(outward, surface.Tangent), outward);
        FloatW x = FloatW.MultiplyAdd(color.R, 2f, -1f) * strength;
        FloatW y = FloatW.MultiplyAdd(color.G, 2f, -1f) * strength;
        normal = frame.ToWorld(new(x, y, FloatW.MultiplyAdd(color.B, 2f, -1f)));
    }
}
