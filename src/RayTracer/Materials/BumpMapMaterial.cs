using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Materials;

/// <summary>Describes a <see cref="BumpMapMaterial"/>.</summary>
[SceneType("bumpMap", "Another material whose surface looks uneven: a texture gives its height.")]
public sealed record BumpMapMaterialDescription : MaterialDescription
{
    /// <summary>The heights.</summary>
    [Parameter("The heights: the red channel counts. Pictures are read raw unless they say otherwise, and should not have the "
        + "interpolation \"nearest\".", Required = true)]
    public TextureDescription Map { get; init; } = new SolidTextureDescription();

    /// <summary>Factor on the heights.</summary>
    [Parameter("Factor on the heights; negative turns hills into hollows.", Unit = "scene units")]
    public float Scale { get; init; } = 1;

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
    public override Material Build(SceneBuilder builder) =>
        new BumpMapMaterial(WrapperMaterial.Part(builder, this, nameof(Material), Material), builder.NumberTexture(Map), Scale) { Turned = Turned, SoftensShadow = SoftensShadow };
}

/// <summary>Tilts normals as those of a surface that is moved outwards by a height (Blinn 1978).</summary>
/// <param name="inner">The material that scatters light.</param>
/// <param name="map">The heights; the red channel counts.</param>
/// <param name="scale">Factor on the heights.</param>
internal sealed class BumpMapMaterial(Material inner, Texture map, float scale) : PerturbedMaterial(inner)
{
    // Half the distance of what is subtracted, in uv.
    private const float Step = 1f / 4096;

    /// <inheritdoc/>
    protected override void Perturb(in SurfaceW surface, in Vec3W outward, out Vec3W normal)
    {
        Slopes(surface, out FloatW slopeU, out FloatW slopeV);
        Vec3W alongU = Move(surface.AlongU, outward, slopeU);
        Vec3W alongV = Move(surface.AlongV, outward, slopeV);

        // Scaled to about 1, so that no product is too small or too large a number.
        alongU *= 1f / FloatW.Sqrt(Vec3W.Dot(alongU, alongU));
        alongV *= 1f / FloatW.Sqrt(Vec3W.Dot(alongV, alongV));
        normal = Vec3W.Cross(alongU, alongV);
        normal *= FloatW.CopySign(1f, Vec3W.Dot(normal, outward));
    }

    // The vector within the surface of the normal, and the height that it climbs.
    private static Vec3W Move(in Vec3W along, in Vec3W outward, FloatW slope) =>
        Vec3W.MultiplyAdd(outward, slope - Vec3W.Dot(outward, along), along);

    private void Slopes(in SurfaceW surface, out FloatW slopeU, out FloatW slopeV)
    {
        if (map.HasSlope)
        {
            map.Slope(surface, out slopeU, out slopeV);
            slopeU *= scale;
            slopeV *= scale;
            return;
        }

        slopeU = Slope(surface, surface.AlongU, Step, 0f);
        slopeV = Slope(surface, surface.AlongV, 0f, Step);
    }

    // The difference of two heights, one step of u or v before and behind.
    private FloatW Slope(in SurfaceW surface, in Vec3W along, float du, float dv)
    {
        SurfaceW after = Moved(surface, along, du, dv);
        SurfaceW before = Moved(surface, along, -du, -dv);
        map.Evaluate(after, out RgbW high);
        map.Evaluate(before, out RgbW low);

        // What the coordinates really are apart, once they are rounded.
        FloatW distance = (after.U - before.U) + (after.V - before.V);
        return (distance > 0f).Select((high.R - low.R) * scale / distance, 0f);
    }

    private static SurfaceW Moved(in SurfaceW surface, in Vec3W along, float du, float dv)
    {
        SurfaceW moved = surface;
        moved.U += du;
        moved.V += dv;
        Vec3W step = along * (du + dv);
        moved.Point += step;
        moved.Local += step;
        return moved;
    }
}
