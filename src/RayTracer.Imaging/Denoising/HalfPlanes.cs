using RayTracer.Numerics;
using RayTracer.Rendering;
using RayTracer.Textures;

namespace RayTracer.Imaging;

/// <summary>One half of a picture's samples as a denoiser compares it.</summary>
internal sealed class HalfPlanes
{
    /// <summary>Makes empty ones.</summary>
    public HalfPlanes(int width, int height)
    {
        PaddedPlane[] Three() => [new(width, height), new(width, height), new(width, height)];
        (Color, Normal, Albedo) = (Three(), Three(), Three());
        (Spread, Counts) = (new(width, height), new(width, height));
    }

    /// <summary>Red, green and blue.</summary>
    public PaddedPlane[] Color { get; }

    /// <summary>The variance of the mean of each pixel's samples, were they independent; 0 where it is not known.</summary>
    public PaddedPlane Spread { get; }

    /// <summary>The numbers of samples.</summary>
    public PaddedPlane Counts { get; }

    /// <summary>The normals' coordinates.</summary>
    public PaddedPlane[] Normal { get; }

    /// <summary>The surfaces' colours.</summary>
    public PaddedPlane[] Albedo { get; }

    /// <summary>Reads a half.</summary>
    public static HalfPlanes Of(HalfRender half)
    {
        Film film = half.Film;
        HalfPlanes planes = new(film.Width, film.Height);
        Parallel.For(0, film.Height, y =>
        {
            double[] row = new double[3 * film.Width];
            for (int x = 0; x < film.Width; x++)
            {
                (planes.Color[0][x, y], planes.Color[1][x, y], planes.Color[2][x, y]) = film.Mean(x, y);
                planes.Counts[x, y] = film.SampleCount(x, y);
                planes.Spread[x, y] = film.MeanVariance(x, y);
            }

            Read(half.Features, HalfRender.Kinds[0], y, row, planes.Normal);
            Read(half.Features, HalfRender.Kinds[1], y, row, planes.Albedo);
        });
        planes.Extend();
        return planes;
    }

    /// <summary>Reads a picture as if it were both halves; numbers that are not finite are black.</summary>
    /// <exception cref="ArgumentException">The sizes differ.</exception>
    public static HalfPlanes Of(Picture picture, Picture? albedo, Picture? normal)
    {
        HalfPlanes planes = new(picture.Width, picture.Height);
        Read(picture, planes.Color);
        Read(albedo ?? new(picture.Width, picture.Height), planes.Albedo);
        planes.Counts.Fill((_, _) => 1f);
        if (normal is not null)
        {
            Read(normal, planes.Normal);
        }
        else if (albedo is not null)
        {
            // Every pixel shows a surface, as far as is known.
            planes.Normal[0].Fill((_, _) => 1f);
        }

        planes.Extend();
        return planes;
    }

    /// <summary>Lets the edges go on in the margins.</summary>
    public void Extend() => Array.ForEach([.. Color, Spread, Counts, .. Normal, .. Albedo], p => p.Extend());

    /// <summary>The same at half the size: means over squares of four pixels, of those that have samples.</summary>
    public HalfPlanes Halved()
    {
        PaddedPlane sampled = Counts.With((x, y) => (Counts.Load(x, y) > 0f).Select(1f, 0f));
        PaddedPlane share = sampled.Halved(sampled, 4);
        HalfPlanes half = new((Spread.Width + 1) / 2, (Spread.Height + 1) / 2);
        PaddedPlane[] from = [.. Color, .. Normal, .. Albedo, Spread, Counts];
        PaddedPlane[] to = [.. half.Color, .. half.Normal, .. half.Albedo, half.Spread, half.Counts];
        Parallel.For(0, from.Length, i => to[i].Fill(from[i].Halved(sampled, 1).Load));

        // The variance of a mean of n numbers is an n-th of theirs.
        half.Spread.Fill((x, y) => half.Spread.Load(x, y) / FloatW.Max(1f, 4f * share.Load(x, y)));
        return half;
    }

    private static void Read(Picture picture, PaddedPlane[] to)
    {
        if ((picture.Width, picture.Height) != (to[0].Width, to[0].Height))
        {
            throw new ArgumentException($"A guide of {picture.Width}×{picture.Height} pixels is not of a picture of {to[0].Width}×{to[0].Height}.", nameof(picture));
        }

        for (int i = 0; i < picture.Pixels.Length; i++)
        {
            float value = picture.Pixels[i];
            to[i % to.Length][i / to.Length % picture.Width, i / to.Length / picture.Width] = float.IsFinite(value) ? value : 0;
        }
    }

    private static void Read(AovFilm film, AuxiliaryImage kind, int y, double[] row, PaddedPlane[] to)
    {
        film.ReadRow(kind, y, row);
        for (int i = 0; i < row.Length; i++)
        {
            to[i % to.Length][i / to.Length, y] = (float)row[i];
        }
    }
}
