using RayTracer.Numerics;
using RayTracer.Spectra;

namespace RayTracer.Lights;

/// <summary>
/// The air of a round earth, in which molecules, haze and ozone scatter and absorb the sun's light; lanes are rays. Lengths are in km, and
/// amounts of air are fractions of what lies above a point of the ground.
/// </summary>
/// <remarks>
/// Optical depths of molecules, haze and ozone as in Preetham, Shirley &amp; Smits 1999, appendix A.1. How they are spread over the heights,
/// the march along rays and the light that is scattered more than once are after Hillaire 2020, with wavelengths in place of three channels.
/// </remarks>
internal sealed unsafe class Atmosphere
{
    /// <summary>The number of wavelengths: 400 to 700 nm.</summary>
    public const int Wavelengths = 16;
    private const int Interval = 20;
    private const int Steps = 32;
    private const int SunSteps = 16;
    private const int Levels = 16;
    private const int Directions = 16;
    private const float Radius = 6360;
    private const float Top = 80;

    // What haze scatters of the light that it takes away.
    private const float HazeAlbedo = 0.9f;

    // The sun's light outside the air at each wavelength, in W/(m² nm) (ASTM E490), and what a centimetre of ozone absorbs (Preetham, Shirley &
    // Smits 1999, table 2).
    private static readonly float[] s_sun =
    [
        1.72765f, 1.6887f, 1.91198f, 2.02042f, 1.93377f, 1.91686f, 1.8685f, 1.85149f,
        1.8341f, 1.8147f, 1.7533f, 1.68194f, 1.6048f, 1.55622f, 1.474f, 1.41018f,
    ];

    private static readonly float[] s_ozone =
        [0, 0, 0.002f, 0.006f, 0.014f, 0.030f, 0.048f, 0.075f, 0.103f, 0.120f, 0.125f, 0.105f, 0.079f, 0.057f, 0.036f, 0.023f];

    private readonly float[] _molecules = new float[Wavelengths];
    private readonly float[] _haze = new float[Wavelengths];
    private readonly float[] _ozone = new float[Wavelengths];
    private readonly Rgb[] _colors = new Rgb[Wavelengths];
    private readonly PinnedBuffer<float> _scattered = new(Wavelengths * Levels);
    private readonly PinnedBuffer<StepW> _steps = new(Steps);
    private readonly float _sunCosine;

    /// <summary>Computes how much light is scattered more than once.</summary>
    /// <param name="turbidity">The haze of the air.</param>
    /// <param name="sunCosine">Cosine of the sun's angle from the zenith.</param>
    /// <param name="ground">The fraction of light that the ground reflects.</param>
    public Atmosphere(float turbidity, float sunCosine, float ground)
    {
        _sunCosine = sunCosine;
        Rgb sun = Rgb.Black;
        for (int i = 0; i < Wavelengths; i++)
        {
            int nanometres = 400 + (Interval * i);
            float micrometres = nanometres * 1e-3f;
            _molecules[i] = 0.008735f * LaneMath.Pow(micrometres, -4.08f);
            _haze[i] = ((0.04608f * turbidity) - 0.04586f) * LaneMath.Pow(micrometres, -1.3f);
            _ozone[i] = 0.35f * s_ozone[i];
            _colors[i] = Color(nanometres) * (s_sun[i] * (0.683f * Interval));
            sun += _colors[i];
        }

        // Eyes and cameras are used to daylight: the sun outside the air is white.
        Rgb white = new(sun.Luminance / sun.R, sun.Luminance / sun.G, sun.Luminance / sun.B);
        for (int i = 0; i < Wavelengths; i++)
        {
            _colors[i] *= white;
        }

        Scatter(ground);
    }

    /// <summary>The sun's light on a surface that faces it, in thousands of lux.</summary>
    public Rgb Sun()
    {
        Column(0f, _sunCosine, out AirW column);
        Rgb sum = Rgb.Black;
        for (int i = 0; i < Wavelengths; i++)
        {
            sum += _colors[i] * LaneMath.Exp(-Depth(column, i))[0];
        }

        return sum;
    }

    /// <summary>The light that comes to the ground along rays: for each 1/sr of the phase functions of molecules and of haze, and what was scattered
    /// more than once.</summary>
    /// <param name="cosine">Cosine of the angle from the zenith, not negative.</param>
    /// <param name="toSun">Cosine of the angle to the sun.</param>
    /// <param name="light">The three colours.</param>
    public void See(FloatW cosine, FloatW toSun, out LightW light)
    {
        light = default;
        Walk(0f, cosine, toSun, out _);
        for (int i = 0; i < Wavelengths; i++)
        {
            March(i, out MarchW march);
            light.Molecules = RgbW.MultiplyAdd(_colors[i], march.Molecules, light.Molecules);
            light.Haze = RgbW.MultiplyAdd(_colors[i], march.Haze, light.Haze);
            light.Again = RgbW.MultiplyAdd(_colors[i], march.Again, light.Again);
        }
    }

    // Linear sRGB (IEC 61966-2-1, annex) of a thousandth of the light of a wavelength, in lumens.
    private static Rgb Color(int nanometres)
    {
        int row = (nanometres - CieTables.First) / CieTables.Step;
        (float x, float y, float z) = ((float)CieTables.X[row], (float)CieTables.Y[row], (float)CieTables.Z[row]);
        return new(
            (3.2406f * x) - (1.5372f * y) - (0.4986f * z),
            (-0.9689f * x) + (1.8758f * y) + (0.0415f * z),
            (0.0557f * x) - (0.2040f * y) + (1.0570f * z));
    }

    // How dense the air is: each part has a column of 1 over the ground.
    private static void Density(FloatW height, out AirW density)
    {
        density.Molecules = LaneMath.Exp(height * (-1 / 8f)) * (1 / 8f);
        density.Haze = LaneMath.Exp(height * (-1 / 1.2f)) * (1 / 1.2f);
        density.Ozone = FloatW.Max(1f - (FloatW.Abs(height - 25f) * (1 / 15f)), 0f) * (1 / 15f);
    }

    // The height at a distance along a ray, without cancellation.
    private static FloatW Height(FloatW start, FloatW cosine, FloatW distance)
    {
        FloatW from = start + Radius;
        FloatW rise = distance * (distance + (from * cosine * 2f));
        return FloatW.Max(start + (rise / (FloatW.Sqrt(FloatW.Max((from * from) + rise, 0f)) + from)), 0f);
    }

    // How far a ray goes until it leaves the air or meets the ground.
    private static FloatW Length(FloatW start, FloatW cosine, out MaskW meetsGround)
    {
        FloatW from = start + Radius;
        FloatW along = from * cosine;
        FloatW toGround = (along * along) - (start * (from + Radius));
        meetsGround = (cosine < 0f) & (toGround > 0f);
        FloatW toTop = FloatW.Sqrt((along * along) + ((Top - start) * (from + (Radius + Top)))) - along;
        return meetsGround.Select(-along - FloatW.Sqrt(FloatW.Max(toGround, 0f)), toTop);
    }

    // The air between a height and the sun; endless behind the ground.
    private static void Column(FloatW start, FloatW cosine, out AirW column)
    {
        column = default;
        FloatW length = Length(start, cosine, out MaskW isDark);
        for (int i = 0; i < SunSteps; i++)
        {
            FloatW step = length * (((2 * i) + 1f) / (SunSteps * SunSteps));
            Density(Height(start, cosine, length * ((i + 0.5f) * (i + 0.5f) / (SunSteps * SunSteps))), out AirW density);
            column.Molecules = FloatW.MultiplyAdd(density.Molecules, step, column.Molecules);
            column.Haze = FloatW.MultiplyAdd(density.Haze, step, column.Haze);
            column.Ozone = FloatW.MultiplyAdd(density.Ozone, step, column.Ozone);
        }

        column.Molecules = isDark.Select(1e4f, column.Molecules);
    }

    private FloatW Depth(in AirW air, int i) =>
        FloatW.MultiplyAdd(air.Molecules, _molecules[i], FloatW.MultiplyAdd(air.Haze, _haze[i], air.Ozone * _ozone[i]));

    // Cuts rays into steps that grow with the distance, and finds the air in each and between it and the sun.
    private void Walk(FloatW start, FloatW cosine, FloatW toSun, out MaskW meetsGround)
    {
        FloatW length = Length(start, cosine, out meetsGround);
        FloatW from = start + Radius;
        for (int i = 0; i < Steps; i++)
        {
            FloatW distance = length * ((i + 0.5f) * (i + 0.5f) / (Steps * Steps));
            FloatW height = Height(start, cosine, distance);
            StepW* step = _steps.Pointer + i;
            step->Length = length * (((2 * i) + 1f) / (Steps * Steps));
            step->Level = FloatW.Min(FloatW.Sqrt(height * (1 / Top)) * (Levels - 1), Levels - 1.001f);
            Density(height, out step->Density);
            Column(height, FloatW.MultiplyAdd(toSun, distance, from * _sunCosine) / (height + Radius), out step->ToSun);
        }
    }

    // Sums up what comes along the rays at a wavelength, where the sun's light outside the air is 1.
    private void March(int wavelength, out MarchW march)
    {
        march = default;
        march.Passed = 1f;
        float* scattered = _scattered.Pointer + (wavelength * Levels);
        for (int i = 0; i < Steps; i++)
        {
            ref StepW step = ref _steps.Pointer[i];
            FloatW depth = Depth(step.Density, wavelength) * step.Length;
            FloatW passed = LaneMath.Exp(-depth);

            // (1 − exp(−depth))/depth, whose difference cancels where there is little air.
            FloatW mean = (depth > 0.03f).Select((1f - passed) / depth, 1f - (depth * (0.5f - (depth * (1 / 6f)))));
            FloatW seen = march.Passed * mean * step.Length;
            FloatW byMolecules = seen * step.Density.Molecules * _molecules[wavelength];
            FloatW byHaze = seen * step.Density.Haze * (HazeAlbedo * _haze[wavelength]);
            FloatW sun = LaneMath.Exp(-Depth(step.ToSun, wavelength));
            UIntW level = step.Level.ToIntInRange();
            FloatW.Gather(scattered, level, out FloatW below, out FloatW above);
            FloatW again = FloatW.Mix(below, above, step.Level - level.ToFloat());
            march.Molecules = FloatW.MultiplyAdd(byMolecules, sun, march.Molecules);
            march.Haze = FloatW.MultiplyAdd(byHaze, sun, march.Haze);
            march.Again = FloatW.MultiplyAdd(byMolecules + byHaze, again, march.Again);
            march.Passed *= passed;
        }
    }

    // The mean of all light that was scattered before, at each height (Hillaire 2020, section 5.5): of what was scattered once, and of the share
    // that is scattered again and again, as if to all sides.
    private void Scatter(float ground)
    {
        Column(0f, _sunCosine, out AirW column);
        new Span<float>(_scattered.Pointer, Wavelengths * Levels).Fill(1);
        float[] result = new float[Wavelengths * Levels];
        for (int level = 0; level < Levels; level++)
        {
            double[] once = new double[Wavelengths];
            double[] share = new double[Wavelengths];
            for (int first = 0; first < Directions; first += FloatW.Count)
            {
                FloatW cosine = FloatW.MultiplyAdd(FloatW.Iota + (first + 0.5f), 2f / Directions, -1f);
                Walk(Top * level * level / ((Levels - 1) * (Levels - 1)), cosine, cosine * _sunCosine, out MaskW meetsGround);
                for (int i = 0; i < Wavelengths; i++)
                {
                    March(i, out MarchW march);
                    FloatW reflected = meetsGround.Select(march.Passed * ground, 0f);
                    FloatW ofSun = reflected * LaneMath.Exp(-Depth(column, i)) * (_sunCosine / float.Pi);
                    FloatW light = FloatW.MultiplyAdd(march.Molecules + march.Haze, 1 / (4 * float.Pi), ofSun);
                    for (int lane = 0; lane < FloatW.Count; lane++)
                    {
                        once[i] += light[lane] / Directions;
                        share[i] += (march.Again + reflected)[lane] / Directions;
                    }
                }
            }

            for (int i = 0; i < Wavelengths; i++)
            {
                result[(i * Levels) + level] = (float)(once[i] / (1 - share[i]));
            }
        }

        result.CopyTo(new Span<float>(_scattered.Pointer, result.Length));
    }

    /// <summary>What light comes along rays.</summary>
    internal struct LightW
    {
        /// <summary>Scattered once, by molecules and by haze, and more than once.</summary>
        public RgbW Molecules, Haze, Again;
    }

    private struct AirW
    {
        public FloatW Molecules, Haze, Ozone;
    }

    private struct StepW
    {
        public AirW Density, ToSun;
        public FloatW Length, Level;
    }

    private struct MarchW
    {
        public FloatW Molecules, Haze, Again, Passed;
    }
}
