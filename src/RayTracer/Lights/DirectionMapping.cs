using RayTracer.Numerics;
using RayTracer.Textures;

namespace RayTracer.Lights;

/// <summary>How a picture shows all directions.</summary>
public enum DirectionMapping
{
    /// <summary>By longitude from left to right and latitude from top to bottom.</summary>
    LatitudeLongitude,

    /// <summary>The sphere as an octahedron whose faces are folded open into a square, which keeps areas.</summary>
    Octahedral,
}

/// <summary>The places of directions in pictures, in the frame of the picture, in which y is up.</summary>
internal static class DirectionMap
{
    // Along each side of a texel, where another picture is looked at for it.
    private const int Looks = 4;

    /// <summary>The place of a direction.</summary>
    /// <param name="mapping">How the picture shows directions.</param>
    /// <param name="d">Unit directions.</param>
    /// <param name="u">From left to right, 0 to 1.</param>
    /// <param name="v">From bottom to top, 0 to 1.</param>
    public static void Find(DirectionMapping mapping, in Vec3W d, out FloatW u, out FloatW v)
    {
        if (mapping == DirectionMapping.Octahedral)
        {
            FindOctahedral(d, out u, out v);
            return;
        }

        FloatW turn = LaneMath.Atan2(d.X, -d.Z) * (0.5f / float.Pi);
        u = turn - FloatW.Floor(turn);
        v = 1f - (LaneMath.Atan2(FloatW.Sqrt(FloatW.MultiplyAdd(d.X, d.X, d.Z * d.Z)), d.Y) * (1 / float.Pi));
    }

    /// <summary>
    /// An octahedral picture by latitude and longitude, as <see cref="ImageEnvironment"/> shows it: the mean over the solid angle of each of its texels, of which there are
    /// about as many.
    /// </summary>
    public static Picture Unfolded(Picture square)
    {
        (int width, int height) = (2 * square.Width, square.Width + 1);
        Picture picture = new(width, height);
        Parallel.For(0, height, row =>
        {
            for (int i = 0; i < width; i++)
            {
                (double r, double g, double b, double all) = (0, 0, 0, 0);
                for (int look = 0; look < Looks * Looks; look++)
                {
                    float column = i + (((look % Looks) + 0.5f) / Looks);
                    float down = float.Clamp(row - 0.5f + (((look / Looks) + 0.5f) / Looks), 0, height - 1);
                    Vec3W direction = Direction(column / width, down / (height - 1));
                    float weight = float.Sqrt(float.Max(1 - (direction.Y[0] * direction.Y[0]), 1e-12f));
                    FindOctahedral(direction, out FloatW u, out FloatW v);
                    int x = int.Clamp((int)(u[0] * square.Width), 0, square.Width - 1);
                    int y = int.Clamp((int)((1 - v[0]) * square.Width), 0, square.Width - 1);
                    int texel = 3 * ((y * square.Width) + x);
                    (r, g, b, all) = (r + (weight * square.Pixels[texel]), g + (weight * square.Pixels[texel + 1]), b + (weight * square.Pixels[texel + 2]), all + weight);
                }

                int at = 3 * ((row * width) + i);
                picture.Pixels[at] = (float)(r / all);
                picture.Pixels[at + 1] = (float)(g / all);
                picture.Pixels[at + 2] = (float)(b / all);
            }
        });
        return picture;
    }

    private static Vec3W Direction(float turn, float down)
    {
        LaneMath.SinCosTurn(turn, out float x, out float minusZ);
        LaneMath.SinCosTurn(down / 2, out float level, out float up);
        return new(x * level, up, -minusZ * level);
    }

    // Clarberg, Fast equal-area mapping of the (hemi)sphere using SIMD, 2008: the middle is up, and seen from inside, x is to the right and z to the top.
    private static void FindOctahedral(in Vec3W d, out FloatW u, out FloatW v)
    {
        FloatW radius = FloatW.Sqrt(FloatW.Max(1f - FloatW.Abs(d.Y), 0f));
        FloatW share = LaneMath.Atan2(FloatW.Abs(d.Z), FloatW.Abs(d.X)) * (2 / float.Pi);
        FloatW up = share * radius;
        FloatW right = radius - up;
        MaskW isBelow = d.Y < 0f;
        FloatW x = isBelow.Select(1f - up, right);
        FloatW y = isBelow.Select(1f - right, up);
        u = FloatW.MultiplyAdd(FloatW.CopySign(x, d.X), 0.5f, 0.5f);
        v = FloatW.MultiplyAdd(FloatW.CopySign(y, d.Z), 0.5f, 0.5f);
    }
}
