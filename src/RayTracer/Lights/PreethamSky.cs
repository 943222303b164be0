using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Lights;

/// <summary>
/// The light of a clear or hazy sky by day (Preetham, Shirley &amp; Smits 1999, appendix A): its luminance and colour by Perez's formula, in thousands of
/// candela per square metre; and that of the sun's disk behind the air.
/// </summary>
internal sealed class PreethamSky
{
    // The sun's disk from outside the air: 133.1 klx over its solid angle.
    private const float SunLuminance = 1.96e6f;

    // Angles from the zenith beyond which the formula's 1/cos grows without bound.
    private const float SmallestCosine = 1e-3f;
    private readonly float _turbidity;
    private readonly float _sunAngle;
    private readonly Vector3 _toSun;
    private readonly (Perez Formula, float Zenith) _luminance;
    private readonly (Perez Formula, float Zenith) _x;
    private readonly (Perez Formula, float Zenith) _y;

    /// <summary>Evaluates what is the same for all directions.</summary>
    /// <param name="turbidity">How hazy the air is: 2 is very clear, 10 hazy.</param>
    /// <param name="toSun">Unit direction to the sun, not below the horizon; y is up.</param>
    public PreethamSky(float turbidity, Vector3 toSun)
    {
        float t = turbidity;
        _turbidity = t;
        _toSun = toSun;
        _sunAngle = LaneMath.Atan2(float.Sqrt((toSun.X * toSun.X) + (toSun.Z * toSun.Z)), toSun.Y);
        float a = _sunAngle;
        float chi = ((4f / 9f) - (t / 120f)) * (float.Pi - (2 * a));
        _luminance = (
            new((0.1787f * t) - 1.4630f, (-0.3554f * t) + 0.4275f, (-0.0227f * t) + 5.3251f, (0.1206f * t) - 2.5771f, (-0.0670f * t) + 0.3703f),
            float.Max((((4.0453f * t) - 4.9710f) * LaneMath.Tan(chi)) - (0.2155f * t) + 2.4192f, 0));
        _x = (
            new((-0.0193f * t) - 0.2592f, (-0.0665f * t) + 0.0008f, (-0.0004f * t) + 0.2125f, (-0.0641f * t) - 0.8989f, (-0.0033f * t) + 0.0452f),
            Cubic(0.00166f, -0.00375f, 0.00209f, 0) * t * t + Cubic(-0.02903f, 0.06377f, -0.03202f, 0.00394f) * t + Cubic(0.11693f, -0.21196f, 0.06052f, 0.25886f));
        _y = (
            new((-0.0167f * t) - 0.2608f, (-0.0950f * t) + 0.0092f, (-0.0079f * t) + 0.2102f, (-0.0441f * t) - 1.6537f, (-0.0109f * t) + 0.0529f),
            Cubic(0.00275f, -0.00610f, 0.00317f, 0) * t * t + Cubic(-0.04214f, 0.08970f, -0.04153f, 0.00516f) * t + Cubic(0.15346f, -0.26756f, 0.06670f, 0.26688f));

        float Cubic(float third, float second, float first, float constant) => (((((third * a) + second) * a) + first) * a) + constant;
    }

    /// <summary>The sky's colour in a direction; black below the horizon.</summary>
    /// <param name="direction">Unit vector.</param>
    public Rgb At(Vector3 direction)
    {
        if (direction.Y < 0)
        {
            return Rgb.Black;
        }

        float cosine = float.Max(direction.Y, SmallestCosine);
        float toSun = LaneMath.Atan2(direction.Cross(_toSun).Norm(), direction.Dot(_toSun));
        float luminance = Of(_luminance);
        float x = Of(_x);
        float y = Of(_y);
        return FromYxy(luminance, x, y);

        float Of((Perez Formula, float Zenith) value) => value.Zenith * value.Formula.At(cosine, toSun) / value.Formula.At(1, _sunAngle);
    }

    /// <summary>
    /// The sun's colour behind the air: what Rayleigh scattering, aerosols and ozone leave, at the wavelengths 610, 550 and 465 nm that
    /// stand for the channels (Preetham, Shirley &amp; Smits 1999, appendix A.1). From outside the air it is taken as white.
    /// </summary>
    public Rgb Sun()
    {
        float degrees = _sunAngle * (180 / float.Pi);
        float mass = 1 / (float.Max(_toSun.Y, 0) + (0.15f * LaneMath.Pow(93.885f - degrees, -1.253f)));
        float haze = (0.04608f * _turbidity) - 0.04586f;
        return new(Behind(0.610f, 0.120f), Behind(0.550f, 0.085f), Behind(0.465f, 0.0075f));

        float Behind(float micrometres, float ozone)
        {
            float rayleigh = 0.008735f * LaneMath.Pow(micrometres, -4.08f);
            float aerosols = haze * LaneMath.Pow(micrometres, -1.3f);
            return SunLuminance * LaneMath.Exp(-mass * (rayleigh + aerosols + (0.35f * ozone)));
        }
    }

    /// <summary>A picture of all directions, as <see cref="ImageEnvironment"/> takes them.</summary>
    /// <param name="height">Rows; twice as many columns, less two.</param>
    public Picture Paint(int height)
    {
        int width = 2 * (height - 1);
        Picture picture = new(width, height);
        for (int row = 0; row < height; row++)
        {
            LaneMath.SinCosTurn(row / (2f * (height - 1)), out float sin, out float cos);
            for (int column = 0; column < width; column++)
            {
                LaneMath.SinCosTurn((column + 0.5f) / width, out float x, out float z);
                Rgb color = At(new(sin * x, cos, -sin * z));
                (picture.Pixels[3 * ((row * width) + column)], picture.Pixels[(3 * ((row * width) + column)) + 1], picture.Pixels[(3 * ((row * width) + column)) + 2]) =
                    (color.R, color.G, color.B);
            }
        }

        return picture;
    }

    // CIE xyY to linear sRGB (IEC 61966-2-1, annex; colours outside its gamut are cut off).
    private static Rgb FromYxy(float luminance, float x, float y)
    {
        float bigX = luminance * x / y;
        float bigZ = luminance * (1 - x - y) / y;
        return new(
            float.Max((3.2406f * bigX) - (1.5372f * luminance) - (0.4986f * bigZ), 0),
            float.Max((-0.9689f * bigX) + (1.8758f * luminance) + (0.0415f * bigZ), 0),
            float.Max((0.0557f * bigX) - (0.2040f * luminance) + (1.0570f * bigZ), 0));
    }

    // Perez, Seals & Michalsky 1993, eq. 1.
    private readonly record struct Perez(float A, float B, float C, float D, float E)
    {
        public float At(float cosine, float toSun)
        {
            LaneMath.SinCos(toSun, out _, out float cos);
            return (1 + (A * LaneMath.Exp(B / cosine))) * (1 + (C * LaneMath.Exp(D * toSun)) + (E * cos * cos));
        }
    }
}
