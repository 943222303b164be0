using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Lights;

/// <summary>The light of a clear or hazy sky by day and of the ground below it, in thousands of candela per square metre.</summary>
internal sealed class DaylightSky
{
    // How much haze scatters forwards: the mean cosine (Henyey & Greenstein 1941).
    private const float Forwards = 0.76f;

    // Directions along the horizon, evenly by the cosine with the sun's, between which light is linear but for the phase functions.
    private const int Sides = 9;
    private readonly Atmosphere _air;
    private readonly Vector3 _toSun;

    /// <summary>Computes the light in the air.</summary>
    /// <param name="turbidity">The haze of the air: 2 is very clear, 10 hazy.</param>
    /// <param name="toSun">Unit direction to the sun, not below the horizon; y is up.</param>
    /// <param name="ground">The colour of the ground.</param>
    public DaylightSky(float turbidity, Vector3 toSun, Rgb ground)
    {
        (_air, _toSun) = (new(turbidity, toSun.Y, ground.Luminance), toSun);
        Sun = Visible(_air.Sun());
    }

    /// <summary>The sun's light on a surface that faces it, in thousands of lux.</summary>
    public Rgb Sun { get; }

    /// <summary>A picture of all directions, as <see cref="ImageEnvironment"/> takes them: the sky down to the horizon, and then the ground in its
    /// light.</summary>
    /// <param name="height">Rows, an odd number; twice as many columns, less two.</param>
    /// <param name="ground">The colour of the ground.</param>
    /// <param name="sunScale">Factor on the sun that lights the ground.</param>
    public Picture Paint(int height, Rgb ground, float sunScale)
    {
        int width = 2 * (height - 1);
        int horizon = height / 2;
        Picture picture = new(width, height);
        Rgb[] light = new Rgb[3 * Sides * (horizon + FloatW.Count)];
        for (int row = 0; row <= horizon; row += FloatW.Count)
        {
            See(row, height, light);
        }

        Rgb received = Sun * (_toSun.Y * sunScale);
        for (int row = 0; row < height; row++)
        {
            LaneMath.SinCosTurn(row / (2f * (height - 1)), out float sin, out float cos);
            cos = float.Max(cos, 0);
            for (int column = 0; column < width; column++)
            {
                LaneMath.SinCosTurn((column + 0.5f) / width, out float x, out float z);
                Rgb color = row > horizon
                    ? received * ground * (1 / float.Pi)
                    : Of(light.AsSpan(3 * Sides * row, 3 * Sides), new(sin * x, cos, -sin * z), sin);
                received += row > horizon ? Rgb.Black : color * (cos * sin * (2 * float.Pi * float.Pi / (width * (height - 1f))));
                int at = 3 * ((row * width) + column);
                (picture.Pixels[at], picture.Pixels[at + 1], picture.Pixels[at + 2]) = (color.R, color.G, color.B);
            }
        }

        return picture;
    }

    // Deep colours of a low sun lie outside of sRGB's gamut: cut off.
    private static Rgb Visible(Rgb color) => new(float.Max(color.R, 0), float.Max(color.G, 0), float.Max(color.B, 0));

    // The light of some rows, for each side.
    private void See(int row, int height, Rgb[] light)
    {
        LaneMath.SinCosTurn((FloatW.Iota + row) * (1 / (2f * (height - 1))), out FloatW sin, out FloatW cos);
        cos = FloatW.Max(cos, 0f);
        float sunSine = float.Sqrt((_toSun.X * _toSun.X) + (_toSun.Z * _toSun.Z));
        for (int side = 0; side < Sides; side++)
        {
            FloatW level = sin * (sunSine * ((2f * side / (Sides - 1)) - 1));
            _air.See(cos, FloatW.MultiplyAdd(cos, _toSun.Y, level), out Atmosphere.LightW seen);
            for (int lane = 0; lane < FloatW.Count; lane++)
            {
                Span<Rgb> to = light.AsSpan(3 * (((row + lane) * Sides) + side), 3);
                (to[0], to[1], to[2]) = (Pick(seen.Molecules), Pick(seen.Haze), Pick(seen.Again));

                Rgb Pick(in RgbW color) => new(color.R[lane], color.G[lane], color.B[lane]);
            }
        }
    }

    // The colour of a direction, of the light for each side.
    private Rgb Of(ReadOnlySpan<Rgb> light, Vector3 direction, float sine)
    {
        float cosine = direction.Dot(_toSun);
        float level = (direction.X * _toSun.X) + (direction.Z * _toSun.Z);
        float longest = sine * float.Sqrt((_toSun.X * _toSun.X) + (_toSun.Z * _toSun.Z));
        float place = longest > 0 ? float.Clamp(((level / longest) + 1) * ((Sides - 1) / 2f), 0, Sides - 1.001f) : 0;
        int side = (int)place;
        float byMolecules = 3 / (16 * float.Pi) * (1 + (cosine * cosine));
        float spread = 1 + (Forwards * Forwards) - (2 * Forwards * cosine);
        float byHaze = (1 - (Forwards * Forwards)) / (4 * float.Pi * spread * float.Sqrt(spread));
        return Visible((Sum(light[(3 * side)..]) * (side + 1 - place)) + (Sum(light[(3 * (side + 1))..]) * (place - side)));

        Rgb Sum(ReadOnlySpan<Rgb> parts) => (parts[0] * byMolecules) + (parts[1] * byHaze) + parts[2];
    }
}
