using System.Numerics;
using RayTracer.Cameras;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Lights;

/// <summary>Describes a <see cref="ProjectorLight"/>.</summary>
[SceneType("projector", "A light at a point, without extent, that throws a picture: a projector of slides with a pinhole. No ray meets it. Transforms move and turn it but "
    + "do not change its strength; where they mirror, they mirror the picture.")]
public sealed record ProjectorLightDescription : PunctualLightDescription
{
    /// <summary>Its position.</summary>
    [Parameter("Where it stands.", Unit = "scene units")]
    public Vector3 Position { get; init; }

    /// <summary>The direction in which it shines.</summary>
    [Parameter("The direction in which it throws the picture's middle, of any length.")]
    public Vector3 Direction { get; init; } = new(0, -1, 0);

    /// <summary>What is upwards in the picture.</summary>
    [Parameter("What is upwards in the picture, roughly.")]
    public Vector3 Up { get; init; } = new(0, 0, -1);

    /// <summary>The picture.</summary>
    [Parameter("The picture: a texture, of which what lies between 0 and 1 in uv is thrown.")]
    public TextureDescription Picture { get; init; } = new SolidTextureDescription { Color = Rgb.White };

    /// <summary>Its strength.</summary>
    [Parameter("Radiant intensity along the direction, where the picture is white.", Unit = "power per steradian", Minimum = 0)]
    public Rgb Intensity { get; init; } = Rgb.White;

    /// <summary>Full angle of the picture over <see cref="FieldOfViewAxis"/>.</summary>
    [Parameter("Full angle of the picture over the field-of-view axis.", Unit = "degrees", Minimum = 0.001f, Maximum = 179)]
    public float FieldOfView { get; init; } = 45;

    /// <summary>Which extent of the picture the field of view spans.</summary>
    [Parameter("Which extent of the picture the field of view spans.")]
    public FieldOfViewAxis FieldOfViewAxis { get; init; } = FieldOfViewAxis.Horizontal;

    /// <summary>Width over height; null for that of the picture.</summary>
    [Parameter("The picture's width over its height. Without it, that of the picture's file, or 1 for other textures.", Minimum = 0.001f, Maximum = 1000)]
    public float? Aspect { get; init; }

    /// <summary>True where a wall is lit as the picture says.</summary>
    [Parameter("Whether a wall across the direction is lit as evenly as the picture is, as by projectors one can buy: towards the picture's edges they send more "
        + "light. Otherwise the picture says what goes into each direction, and walls are darker towards its edges.")]
    public bool EvenOnWalls { get; init; } = true;

    /// <inheritdoc/>
    public override Vector3 Middle => Position;

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) =>
        this with { Position = view.At(view.Above), Direction = -view.Above.Unit(), Up = view.Up, Intensity = view.Intensity };

    /// <inheritdoc/>
    public override ShapeDescription Moved(in ShapeMove move) =>
        this with { Position = move.Point(Position), Direction = move.Direction(Direction), Up = move.Direction(Up) };

    /// <inheritdoc/>
    public override void Check(in Transform place, SceneBuilder builder)
    {
        base.Check(place, builder);
        CheckPosition(nameof(Position), Position, place, builder);
        CheckDirection(nameof(Direction), Direction, place, builder);
        CheckUp(nameof(Up), Direction, Up, builder);
    }

    /// <inheritdoc/>
    public override Texture BuildPicture(SceneBuilder builder) => builder.EmittedTexture(this, nameof(Picture), Picture);

    /// <inheritdoc/>
    public override LightSource Create(Motion motion, Texture? picture)
    {
        float aspect = Aspect ?? picture!.Aspect;
        LaneMath.SinCosTurn(FieldOfView / 720, out float sin, out float cos);
        float height = sin / (cos * ViewPlane.Extent(FieldOfViewAxis, aspect, 1));
        Vector3 axis = Direction.Unit();
        return new ProjectorLight(Position, axis, Intensity, new(picture!, axis, Up, height * aspect, height, motion), EvenOnWalls, motion);
    }
}

/// <summary>A light at a point that throws a picture.</summary>
internal sealed class ProjectorLight : PunctualLight
{
    private readonly Rgb _intensity;
    private readonly PicturePlane _plane;
    private readonly bool _isEvenOnWalls;
    private readonly float _strength;

    /// <summary>Makes one.</summary>
    /// <param name="position">The position in its space.</param>
    /// <param name="axis">The unit direction of the picture's middle in its space.</param>
    /// <param name="intensity">Radiant intensity along the axis, where the picture is white: power per steradian.</param>
    /// <param name="plane">The picture.</param>
    /// <param name="isEvenOnWalls">True where a wall across the axis is lit as the picture says, and not directions.</param>
    /// <param name="motion">The motion of its space in the world.</param>
    public ProjectorLight(Vector3 position, Vector3 axis, Rgb intensity, PicturePlane plane, bool isEvenOnWalls, Motion motion)
        : base(position, axis, motion)
    {
        (_intensity, _plane, _isEvenOnWalls) = (intensity, plane, isEvenOnWalls);

        // An area of the rectangle takes cos³ of it as a solid angle, which what is even on walls makes up for.
        float mean = plane.Mean(cosine => isEvenOnWalls ? 1 : cosine * cosine * cosine);
        _strength = intensity.Luminance * mean * plane.Area / (4 * float.Pi);
    }

    /// <inheritdoc/>
    public override LightExtent Extent((double Open, double Close) shutter) => new(BoundsOfPosition(shutter), _strength);

    /// <inheritdoc/>
    public override void Sample(in Vec3W from, in FloatW u, in FloatW v, in FloatW time, out ShapeSampleW sample, out RgbW radiance)
    {
        Place(time, out Vec3W place, out Vec3W axis);
        Towards(place - from, out sample, out FloatW inverseSquare);
        RgbW strength = Strength(-sample.Direction, time, axis);
        sample.InversePdf = (strength.R + strength.G + strength.B > 0f).Select(sample.InversePdf, 0f);
        radiance = strength * inverseSquare;
    }

    /// <inheritdoc/>
    internal override bool CanEmit => true;

    /// <summary>Directions go through places that are uniform in the picture.</summary>
    internal override void Emit(in FloatW u1, in FloatW v1, in FloatW u2, in FloatW v2, in FloatW time, out EmittedW ray)
    {
        Place(time, out Vec3W place, out Vec3W axis);
        Vec3W direction = _plane.Direction(u2, v2, time, axis);
        FloatW pdf = _plane.Pdf(direction, time, axis);
        EmittedW.OfDirection(direction, pdf, Strength(direction, time, axis) * (pdf > 0f).Select(1f / pdf, 0f), out ray);
        ray.Origin = place;
    }

    /// <inheritdoc/>
    internal override void EmissionPdf(in LightHitW hit, out FloatW point, out FloatW direction)
    {
        Place(hit.Time, out _, out Vec3W axis);
        point = 1f;
        direction = _plane.Pdf(-hit.Direction, hit.Time, axis);
    }

    // The radiant intensity in a direction.
    private RgbW Strength(in Vec3W direction, in FloatW time, in Vec3W axis)
    {
        _plane.Look(direction, time, axis, out RgbW color, out FloatW cosine);
        RgbW strength = color * _intensity;
        return _isEvenOnWalls ? strength * (cosine > 0f).Select(1f / (cosine * cosine * cosine), 0f) : strength;
    }
}
