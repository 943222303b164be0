using System.Numerics;
using RayTracer.Description;
using RayTracer.Numerics;
using RayTracer.Sampling;
using RayTracer.Shapes;

namespace RayTracer.Lights;

/// <summary>Describes a <see cref="SkyEnvironment"/>.</summary>
[SceneType("sky", "A clear or hazy daytime sky, its sun, and the ground below the horizon in their light (after Hillaire 2020).")]
public sealed record SkyEnvironmentDescription : EnvironmentDescription
{
    // The sun's angular radius as seen from the earth.
    private const float SunRadius = 0.2665f;

    /// <summary>The haziness of the air.</summary>
    [Parameter("How hazy the air is: 2 is very clear, 3 clear, 6 warm and moist, 10 hazy.", Minimum = 2, Maximum = 10)]
    public float Turbidity { get; init; } = 3;

    /// <summary>The height of the sun.</summary>
    [Parameter("The sun's height above the horizon.", Unit = "degrees", Minimum = 0, Maximum = 90)]
    public float SunElevation { get; init; } = 40;

    /// <summary>The direction of the sun.</summary>
    [Parameter("The sun's direction along the horizon: 0 is over −z, 90 over +x.", Unit = "degrees")]
    public float SunAzimuth { get; init; } = 45;

    /// <summary>Factor on all.</summary>
    [Parameter("Factor on sky and sun: the radiance that corresponds to a luminance of 1,000 candela per square metre. A white floor in "
        + "the sun has about 30 of these.", Minimum = 0)]
    public float Scale { get; init; } = 0.03f;

    /// <summary>Factor on the sun.</summary>
    [Parameter("Factor on the sun alone; 0 is a sky without a sun.", Minimum = 0)]
    public float SunScale { get; init; } = 1;

    /// <summary>The colour of the ground.</summary>
    [Parameter("The colour of the ground below the horizon, matt and endlessly far away, which also brightens the sky; [0, 0, 0] is a "
        + "black one.", Minimum = 0, Maximum = 1)]
    public Rgb Ground { get; init; } = new(0.3f, 0.3f, 0.3f);

    /// <summary>The size of the sun.</summary>
    [Parameter("The sun's diameter as a multiple of the real one (0.533°), with the same total light: larger ones make softer shadows.",
        Minimum = 0.1, Maximum = 100)]
    public float SunSize { get; init; } = 1;

    /// <inheritdoc/>
    public override EnvironmentLight? Build(SceneBuilder builder)
    {
        Transform turn = Turn(builder);
        LaneMath.SinCosTurn(SunElevation / 360, out float up, out float level);
        float turns = SunAzimuth / 360;
        LaneMath.SinCosTurn(turns - float.Floor(turns), out float x, out float z);
        Vector3 toSun = new(level * x, up, -level * z);
        DaylightSky sky = new(Turbidity, toSun, Ground);
        float height = ConeHeight(SunRadius * SunSize);
        Rgb sun = sky.Sun * (Scale * SunScale / (2 * float.Pi * height));
        if (!(sun.R <= ImageEnvironment.Brightest) || !(Scale * 1000 <= ImageEnvironment.Brightest))
        {
            builder.Error(this, nameof(Scale), "the sky and sun become too bright to compute with");
            return null;
        }

        ImageEnvironment picture = new(sky.Paint(SkyEnvironment.Rows, Ground, SunScale), Scale, turn);
        return sun.IsBlack ? picture : new SkyEnvironment(picture, turn.Vector(toSun).Unit(), height, sun);
    }

    // 1 − cos of an angle, as 2 sin² of its half.
    private static float ConeHeight(float degrees)
    {
        LaneMath.SinCosTurn(degrees / 720, out float sin, out _);
        return 2 * sin * sin;
    }
}

/// <summary>A sky, and a sun of even radiance before it. Directions are chosen from either.</summary>
internal sealed class SkyEnvironment : EnvironmentLight
{
    /// <summary>Rows of the sky's picture; the horizon is one.</summary>
    internal const int Rows = 257;

    private readonly ImageEnvironment _sky;
    private readonly Vector3 _toSun;
    private readonly float _height;
    private readonly Rgb _sun;
    private readonly float _share;
    private readonly float _sunPdf;

    /// <summary>Makes one.</summary>
    /// <param name="sky">The sky.</param>
    /// <param name="toSun">Unit direction to the middle of the sun.</param>
    /// <param name="height">1 − cosine of the sun's angular radius.</param>
    /// <param name="sun">The sun's radiance.</param>
    public SkyEnvironment(ImageEnvironment sky, Vector3 toSun, float height, Rgb sun)
    {
        (_sky, _toSun, _height, _sun) = (sky, toSun, height, sun);
        double power = sun.Luminance * 2 * double.Pi * height;

        // By power, but neither is forgotten where the other is hidden.
        _share = (float)double.Clamp(power / (power + sky.Power), 0.25, 0.75);
        _sunPdf = _share / (2 * float.Pi * height);
    }

    /// <inheritdoc/>
    public override void Evaluate(in Vec3W direction, out RgbW radiance)
    {
        _sky.Evaluate(direction, out radiance);
        radiance = IsSun(direction).Select(radiance + _sun, radiance);
    }

    /// <inheritdoc/>
    public override void Pdf(in Vec3W direction, out FloatW pdf)
    {
        _sky.Pdf(direction, out FloatW ofSky);
        pdf = FloatW.MultiplyAdd(ofSky, 1 - _share, IsSun(direction).Select(_sunPdf, 0f));
    }

    /// <inheritdoc/>
    public override LightExtent Extent((double Open, double Close) shutter) =>
        new(Bounds.Infinite, _sky.Extent(shutter).Strength + (_sun.Luminance * 2 * float.Pi * _height));

    /// <inheritdoc/>
    public override void Sample(in Vec3W from, in FloatW u, in FloatW v, in FloatW time, out ShapeSampleW sample, out RgbW radiance)
    {
        MaskW choosesSun = u < _share;
        FloatW rest = FloatW.Min(choosesSun.Select(u * (1 / _share), (u - _share) * (1 / (1 - _share))), float.BitDecrement(1));
        _sky.Sample(from, rest, v, time, out ShapeSampleW ofSky, out _);
        Onb.FromNormal(_toSun, out Onb frame);
        Vec3W inSun = frame.ToWorld(Warp.UniformCone(rest, v, _height));
        Vec3W direction = choosesSun.Select(inSun, ofSky.Direction);
        Pdf(direction, out FloatW pdf);
        Of(direction, (pdf > 0f).Select(1f / pdf, 0f), out sample);
        Evaluate(direction, out radiance);
        radiance *= sample.InversePdf;
    }

    /// <inheritdoc/>
    internal override float EmittedPower((double Open, double Close) shutter) =>
        ((float)_sky.Power + (_sun.Luminance * 2 * float.Pi * _height)) * World!.Ball.Area;

    // Half the squared distance of unit vectors is 1 − cosine, without cancellation.
    private MaskW IsSun(in Vec3W direction)
    {
        Vec3W apart = direction - _toSun;
        return Vec3W.Dot(apart, apart) <= 2 * _height;
    }
}
