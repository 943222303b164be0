using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;
using RayTracer.Textures;

namespace RayTracer.Lights;

/// <summary>Describes a <see cref="SpotLight"/>.</summary>
[SceneType("spot", "A light at a point, without extent, that shines into a cone: at full strength within its beam, and weaker from there "
    + "to the cone's edge. No ray meets it. Transforms move and turn it but do not change its strength or width.")]
public sealed record SpotLightDescription : PunctualLightDescription
{
    /// <summary>Its position.</summary>
    [Parameter("Where it stands.", Unit = "scene units")]
    public Vector3 Position { get; init; }

    /// <summary>The point at which it shines.</summary>
    [Parameter("The direction in which it shines, of any length.")]
    public Vector3 Direction { get; init; } = new(0, -1, 0);

    /// <summary>Radiant intensity within the beam.</summary>
    [Parameter("Radiant intensity within the beam: a surface that faces it there at distance d receives an irradiance of this over d².",
        Unit = "power per steradian", Minimum = 0)]
    public Rgb Intensity { get; init; } = Rgb.White;

    /// <summary>Angle from the axis to the edge of the cone.</summary>
    [Parameter("The angle between the direction and the edge of the cone, beyond which there is no light.",
        Unit = "degrees", Minimum = 0, MinimumIsExclusive = true, Maximum = 180)]
    public float CutoffAngle { get; init; } = 20;

    /// <summary>
    /// Angle from the axis up to which it is as strong as along it; null for three quarters of <see cref="CutoffAngle"/>.
    /// </summary>
    [Parameter("The angle between the direction and the edge of the beam, within which the light has its full strength; at most the cutoff "
        + "angle. Without it, three quarters of that.", Unit = "degrees", Minimum = 0, Maximum = 180)]
    public float? BeamWidth { get; init; }

    /// <summary>The falloff between the two.</summary>
    [Parameter("How the light falls off from the edge of the beam to that of the cone: in proportion to the angle; as glTF's spot "
        + "lights do, by the square of a number that falls with the angle's cosine; or, as pbrt's do, by a smooth step of that number.")]
    public SpotFalloff Falloff { get; init; }

    /// <summary>A picture that colours its light; null for none.</summary>
    [Parameter("A picture that colours its light: a texture, of which what lies between 0 and 1 in uv is a square around the cone, as seen by somebody who stands behind the light.")]
    public TextureDescription? Picture { get; init; }

    /// <summary>What is upwards in the picture.</summary>
    [Parameter("What is upwards in the picture, roughly.")]
    public Vector3 PictureUp { get; init; } = new(0, 0, -1);

    /// <inheritdoc/>
    public override Vector3 Middle => Position;

    /// <inheritdoc/>
    public override ShapeDescription Sketch(SketchView view) =>
        this with { Position = view.At(view.Above), Direction = -view.Above.Unit(), Intensity = view.Intensity, CutoffAngle = 30 };

    /// <inheritdoc/>
    public override ShapeDescription Moved(in ShapeMove move) => this with { Position = move.Point(Position), Direction = move.Direction(Direction), PictureUp = move.Direction(PictureUp) };

    /// <inheritdoc/>
    public override void Check(in Transform place, SceneBuilder builder)
    {
        base.Check(place, builder);
        CheckPosition(nameof(Position), Position, place, builder);
        CheckDirection(nameof(Direction), Direction, place, builder);
        if (BeamWidth > CutoffAngle)
        {
            builder.Error(this, nameof(BeamWidth), $"the beam cannot be wider than the cone: it must be at most the \"cutoffAngle\" of {CutoffAngle}, but is {BeamWidth}");
        }

        if (Picture is null)
        {
            return;
        }

        CheckUp(nameof(PictureUp), Direction, PictureUp, builder);
        if (CutoffAngle >= 90)
        {
            builder.Error(this, nameof(Picture), $"a square around a cone needs a \"cutoffAngle\" below 90, but it is {CutoffAngle}");
        }
    }

    /// <inheritdoc/>
    public override Texture? BuildPicture(SceneBuilder builder) => Picture is null ? null : builder.EmittedTexture(this, nameof(Picture), Picture);

    /// <inheritdoc/>
    public override LightSource Create(Motion motion, Texture? picture)
    {
        LaneMath.SinCosTurn(CutoffAngle / 360, out float sin, out float cos);
        return new SpotLight(Position, Direction, Intensity, CutoffAngle, BeamWidth ?? 0.75f * CutoffAngle, Falloff, motion)
        {
            Picture = picture is null ? null : new(picture, Direction.Unit(), PictureUp, sin / cos, sin / cos, motion),
        };
    }
}

/// <summary>A light at a point that shines into a cone.</summary>
internal sealed class SpotLight : PunctualLight
{
    // Instead of infinity where the beam reaches up to the edge: finite, so that nothing times it is nothing.
    private const float Steepest = 1e9f;
    private const float Radians = float.Pi / 180;
    private readonly Rgb _intensity;
    private readonly bool _isSmooth;
    private readonly bool _isStep;

    // The mean of the picture.
    private readonly float _dimmed = 1;

    // Of the sphere of directions, that within the angle halfway down.
    private readonly float _share;

    // The angle, or its cosine, where the light ends, and the factor that brings the beam's edge to 1 from there.
    private readonly float _end;
    private readonly float _slope;

    // 1 − cosine of either angle, the exponent of the density between them, and the integral of this density by 1 − cosine, were it 1 in the beam.
    private readonly float _beamHeight;
    private readonly float _edgeHeight;
    private readonly int _exponent;
    private readonly float _spread;

    /// <summary>Makes one.</summary>
    /// <param name="position">The position in its space.</param>
    /// <param name="direction">The direction of its light in its own space, of any length above zero.</param>
    /// <param name="intensity">Radiant intensity within the beam: power per steradian.</param>
    /// <param name="cutoffAngle">Angle between the direction and the edge, in degrees.</param>
    /// <param name="beamWidth">Angle between the direction and where it begins to fall, in degrees.</param>
    /// <param name="falloff">The curve of its falloff.</param>
    /// <param name="motion">The motion of its space in the world.</param>
    public SpotLight(Vector3 position, Vector3 direction, Rgb intensity, float cutoffAngle, float beamWidth, SpotFalloff falloff, Motion motion)
        : base(position, direction.Unit(), motion)
    {
        _intensity = intensity;
        _isSmooth = falloff != SpotFalloff.Linear;
        _isStep = falloff == SpotFalloff.Smoothstep;
        LaneMath.SinCos(0.25f * (cutoffAngle + beamWidth) * Radians, out float half, out _);
        _share = half * half;
        _end = cutoffAngle * Radians;
        float beam = beamWidth * Radians;
        if (_isSmooth)
        {
            LaneMath.SinCos(_end, out _, out _end);
            LaneMath.SinCos(beam, out _, out beam);
        }

        (_beamHeight, _edgeHeight) = (Height(beamWidth), Height(cutoffAngle));
        _exponent = _isSmooth ? 2 : 1;
        _spread = _beamHeight + ((_edgeHeight - _beamHeight) / (_exponent + 1));
        _slope = beam == _end ? (_isSmooth ? Steepest : -Steepest) : 1 / (beam - _end);
    }

    /// <summary>The picture that colours its light; null for none.</summary>
    public PicturePlane? Picture
    {
        get;
        init
        {
            field = value;
            _dimmed = value?.Mean(_ => 1) ?? 1;
        }
    }

    /// <inheritdoc/>
    public override LightExtent Extent((double Open, double Close) shutter) => new(BoundsOfPosition(shutter), _intensity.Luminance * (_share * _dimmed));

    /// <inheritdoc/>
    public override void Sample(in Vec3W from, in FloatW u, in FloatW v, in FloatW time, out ShapeSampleW sample, out RgbW radiance)
    {
        Place(time, out Vec3W place, out Vec3W axis);
        Towards(place - from, out sample, out FloatW inverseSquare);
        FloatW falloff = Strength(axis, sample.Direction);
        sample.InversePdf = (falloff > 0f).Select(sample.InversePdf, 0f);
        radiance = (RgbW)_intensity * (falloff * inverseSquare);
        Color(-sample.Direction, time, axis, ref radiance);
    }

    /// <inheritdoc/>
    internal override bool CanEmit => true;

    /// <summary>
    /// Directions are uniform in the beam; from there to the edge, their density falls as the smooth falloff does, or, where that is linear in the angle,
    /// in proportion to the cosine.
    /// </summary>
    internal override void Emit(in FloatW u1, in FloatW v1, in FloatW u2, in FloatW v2, in FloatW time, out EmittedW ray)
    {
        Place(time, out Vec3W place, out Vec3W axis);
        float ring = _spread - _beamHeight;
        FloatW below = u2 * _spread;
        FloatW rest = ring > 0 ? FloatW.Min(FloatW.Max((_spread - below) * (1 / ring), 0f), 1f) : 1f;
        FloatW part = _isSmooth ? LaneMath.Pow(rest, 1f / 3) : FloatW.Sqrt(rest);
        FloatW height = (below < _beamHeight).Select(below, FloatW.MultiplyAdd(part, _beamHeight - _edgeHeight, _edgeHeight));
        Onb.FromNormal(axis, out Onb frame);
        Vec3W direction = frame.ToWorld(Warp.UniformCone(1f, v2, height));
        FloatW pdf = Density(axis, direction);
        FloatW weight = (pdf > 0f).Select(Strength(axis, -direction) / pdf, 0f);
        RgbW power = (RgbW)_intensity * weight;
        Color(direction, time, axis, ref power);
        EmittedW.OfDirection(direction, pdf, power, out ray);
        ray.Origin = place;
    }

    /// <inheritdoc/>
    internal override void EmissionPdf(in LightHitW hit, out FloatW point, out FloatW direction)
    {
        Place(hit.Time, out _, out Vec3W axis);
        point = 1f;
        direction = Density(axis, -hit.Direction);
    }

    // Multiplies light in directions by what the picture shows there.
    private void Color(in Vec3W direction, in FloatW time, in Vec3W axis, ref RgbW light)
    {
        if (Picture is { } picture)
        {
            picture.Look(direction, time, axis, out RgbW color, out _);
            light *= color;
        }
    }

    // 1 − cos of an angle, as 2 sin² of its half.
    private static float Height(float degrees)
    {
        LaneMath.SinCos(0.5f * degrees * Radians, out float sin, out _);
        return 2 * sin * sin;
    }

    // The density, per steradian, of a direction in which light is emitted. Half the squared distance of unit vectors is 1 − cosine, without cancellation.
    private FloatW Density(in Vec3W axis, in Vec3W direction)
    {
        Vec3W apart = direction - axis;
        float ring = _edgeHeight - _beamHeight;
        FloatW below = _edgeHeight - (Vec3W.Dot(apart, apart) * 0.5f);
        FloatW part = FloatW.Max(FloatW.Min(below * (ring > 0 ? 1 / ring : Steepest), 1f), 0f);
        return (_isSmooth ? part * part : part) * (1 / (2 * float.Pi * _spread));
    }

    // The share of the full intensity that goes against a direction.
    private FloatW Strength(in Vec3W axis, in Vec3W back)
    {
        FloatW cosine = -Vec3W.Dot(axis, back);
        if (_isSmooth)
        {
            FloatW part = FloatW.Max(FloatW.Min((cosine - _end) * _slope, 1f), 0f);
            return _isStep ? part * part * FloatW.NegatedMultiplyAdd(part, 2f, 3f) : part * part;
        }

        // By both sine and cosine: near the axis, the cosine alone would round narrow beams to steps.
        Vec3W across = Vec3W.Cross(axis, back);
        FloatW angle = LaneMath.Atan2(FloatW.Sqrt(Vec3W.Dot(across, across)), cosine);
        return FloatW.Max(FloatW.Min((angle - _end) * _slope, 1f), 0f);
    }
}

/// <summary>The ways in which the intensity of a spot light falls between its beam and its edge.</summary>
public enum SpotFalloff
{
    /// <summary>In proportion to the angle.</summary>
    Linear,

    /// <summary>As the square of a number that falls in proportion to the angle's cosine (glTF's KHR_lights_punctual).</summary>
    Smooth,

    /// <summary>As 3t² − 2t³ of a number t that falls in proportion to the angle's cosine (pbrt's spot lights).</summary>
    Smoothstep,
}
