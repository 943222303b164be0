using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="NormalMapMaterial"/>.</summary>
[SceneType("normalMap", "Another material whose surface looks embossed: a picture holds the normals, as other programs write them.")]
public sealed record NormalMapMaterialDescription : MaterialDescription
{
    /// <summary>The normals.</summary>
    [Parameter("The normals as colours: red, green and blue from 0 to 1 are from −1 to 1 along u, perpendicular to u, and outwards. A "
        + "picture is read raw unless it says otherwise; [0.5, 0.5, 1] is a flat surface.", Required = true)]
    public TextureDescription Map { get; init; } = new SolidTextureDescription { Color = new(0.5f, 0.5f, 1) };

    /// <summary>Factor on the slopes.</summary>
    [Parameter("Factor on the slopes: 1 leaves the map as it is, 0 is flat.", Minimum = 0, Maximum = 100)]
    public float Strength { get; init; } = 1;

    /// <summary>Green points to where v grows.</summary>
    [Parameter("Whether green points to where v grows even where pictures are mirrored on the surface, as in glTF files; otherwise it "
        + "points to the left of where u grows.")]
    public bool GreenAlongV { get; init; }

    /// <summary>The treatment of normals that the map turns away from the ray.</summary>
    [Parameter("What happens where the map turns the normal so far that the surface would be seen from behind: the normal is mirrored into "
        + "view, its slopes are reversed, or the back is shown, which is black if the material is one-sided.")]
    public TurnedNormal Turned { get; init; }

    /// <summary>Slopes that turn from light darken softly.</summary>
    [Parameter("Whether light that arrives at a grazing angle is weakened where slopes turn towards it, so that its edge is soft instead "
        + "of following the true surface.")]
    public bool SoftensShadow { get; init; }

    /// <summary>The material that scatters light.</summary>
    [Parameter("What scatters light: a material of any type but a luminaire.", Required = true)]
    public MaterialDescription Material { get; init; } = new DiffuseMaterialDescription();

    /// <inheritdoc/>
    public override Material Build(SceneBuilder builder)
    {
        if (Map is ImageTextureDescription { Raw: false, Picture: null } image && !(image.File.EndsWith(".pfm", StringComparison.OrdinalIgnoreCase) || image.File.EndsWith(".exr", StringComparison.OrdinalIgnoreCase)))
        {
            builder.Warn(this, nameof(Map), "a normal map's numbers are directions, not colours: its picture should have \"raw\": true");
        }

        return new NormalMapMaterial(WrapperMaterial.Part(builder, this, nameof(Material), Material), builder.NumberTexture(Map), Strength) { GreenAlongV = GreenAlongV, Turned = Turned, SoftensShadow = SoftensShadow };
    }
}

/// <summary>Turns normals to those of a texture, in the frame of the tangent along u, the normal × that, and the normal.</summary>
/// <param name="inner">The material that scatters light.</param>
/// <param name="map">The normals.</param>
/// <param name="strength">Factor on the slopes.</param>
internal sealed class NormalMapMaterial(Material inner, Texture map, float strength) : PerturbedMaterial(inner)
{
    /// <summary>Green points to where v grows, and not always to the left of where u grows.</summary>
    public bool GreenAlongV { get; init; }

    /// <inheritdoc/>
    protected override void Perturb(in SurfaceW surface, in Vec3W outward, out Vec3W normal)
    {
        map.Evaluate(surface, out RgbW color);
        Vec3W left = Vec3W.Cross(outward, surface.Tangent);

        // Where a two-sided material shows its back, outwards is not the way of the shape's own normal, and the picture is seen mirrored.
        left *= FloatW.CopySign(1f, Vec3W.Dot(GreenAlongV ? left : outward, GreenAlongV ? surface.AlongV : surface.Normal));
        Onb frame = new(surface.Tangent, left, outward);
        FloatW x = FloatW.MultiplyAdd(color.R, 2f, -1f) * strength;
        FloatW y = FloatW.MultiplyAdd(color.G, 2f, -1f) * strength;
        normal = frame.ToWorld(new(x, y, FloatW.MultiplyAdd(color.B, 2f, -1f)));
    }
}
