using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Lights;

/// <summary>Describes a <see cref="PointLight"/>.</summary>
[SceneType("point", "A light at a point, without extent: it shines equally in all directions, or as a picture of them says, and its shadows are sharp. No ray meets it. "
    + "Transforms move it, and turn its picture, but do not change its strength.")]
public sealed record PointLightDescription : PunctualLightDescription
{
    /// <summary>Its position.</summary>
    [Parameter("Where it stands.", Unit = "scene units")]
    public Vector3 Position { get; init; }

    /// <summary>Radiant intensity.</summary>
    [Parameter("Radiant intensity in every direction: a surface that faces it at distance d receives an irradiance of this over d².",
        Unit = "power per steradian", Minimum = 0)]
    public Rgb Intensity { get; init; } = Rgb.White;

    /// <summary>What goes into each direction; null for the same into all.</summary>
    [Parameter("Factors on the intensity, by the direction: a texture, of which what lies between 0 and 1 in uv is all directions (a goniometric light). By latitude and longitude, "
        + "its middle column is towards +z and its left half towards +x; in an octahedral one, the middle is straight up, its right half is towards +x and its upper half towards +z. "
        + "Pictures from files need the wrapping \"clamp\" there.")]
    public TextureDescription? Picture { get; init; }

    /// <summary>How the picture shows directions.</summary>
    [Parameter("How the picture shows directions: by latitude and longitude, or as an octahedron unfolded into a square, each of whose pixels is an equally large part of the sphere.")]
    public DirectionMapping Mapping { get; init; }

    /// <inheritdoc/>
    public override Vector3 Middle => Position;

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) => this with { Position = view.At(view.Above), Intensity = view.Intensity };

    /// <inheritdoc/>
    public override ShapeDescription Moved(in ShapeMove move) => this with { Position = move.Point(Position) };

    /// <inheritdoc/>
    public override void Check(in Transform place, SceneBuilder builder)
    {
        base.Check(place, builder);
        CheckPosition(nameof(Position), Position, place, builder);
    }

    /// <inheritdoc/>
    public override Texture? BuildPicture(SceneBuilder builder) => Picture is null ? null : builder.EmittedTexture(this, nameof(Picture), Picture);

    /// <inheritdoc/>
    public override LightSource Create(Motion motion, Texture? picture) =>
        new PointLight(Position, Intensity, motion) { Picture = picture is null ? null : new(picture, Mapping, motion) };
}

/// <summary>A light at a point that shines alike in all directions, or as a picture says.</summary>
/// <param name="position">The position in its space.</param>
/// <param name="intensity">Radiant intensity: power per steradian.</param>
/// <param name="motion">The motion of its space in the world.</param>
internal sealed class PointLight(Vector3 position, Rgb intensity, Motion motion) : PunctualLight(position, Vector3.UnitZ, motion)
{
    /// <summary>Factors by the direction; null for none.</summary>
    public PictureSphere? Picture { get; init; }

    /// <inheritdoc/>
    public override LightExtent Extent((double Open, double Close) shutter) => new(BoundsOfPosition(shutter), intensity.Luminance * (Picture?.Mean ?? 1));

    /// <inheritdoc/>
    public override void Sample(in Vec3W from, in FloatW u, in FloatW v, in FloatW time, out ShapeSampleW sample, out RgbW radiance)
    {
        Place(time, out Vec3W place, out _);
        Towards(place - from, out sample, out FloatW inverseSquare);
        radiance = (RgbW)intensity * inverseSquare;
        if (Picture is not null)
        {
            Picture.Look(-sample.Direction, time, out RgbW color);
            sample.InversePdf = (color.R + color.G + color.B > 0f).Select(sample.InversePdf, 0f);
            radiance *= color;
        }
    }

    /// <inheritdoc/>
    internal override bool CanEmit => true;

    /// <inheritdoc/>
    internal override void Emit(in FloatW u1, in FloatW v1, in FloatW u2, in FloatW v2, in FloatW time, out EmittedW ray)
    {
        EmittedW.OfDirection(Warp.UniformSphere(u2, v2), 1 / (4 * float.Pi), intensity * (4 * float.Pi), out ray);
        Place(time, out ray.Origin, out _);
        if (Picture is not null)
        {
            Picture.Look(ray.Direction, time, out RgbW color);
            ray.Power *= color;
        }
    }

    /// <inheritdoc/>
    internal override void EmissionPdf(in LightHitW hit, out FloatW point, out FloatW direction)
    {
        point = 1f;
        direction = 1 / (4 * float.Pi);
    }
}
