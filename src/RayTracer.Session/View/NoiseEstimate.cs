using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>The estimate of a picture's remaining noise.</summary>
public static class NoiseEstimate
{
    private const int MostPixels = 1 << 15;

    /// <summary>
    /// Standard error of the pixels' luminance, mean over some pixels, relative to their mean luminance; null where it is not known.
    /// </summary>
    /// <param name="film">The picture.</param>
    /// <param name="area">Its pixels that have samples.</param>
    public static double? Of(Film film, Tile area)
    {
        if (!film.KnowsNoise)
        {
            return null;
        }

        int step = Math.Max(1, (int)Math.Ceiling(Math.Sqrt((double)area.Pixels / MostPixels)));
        (double error, double light) = (0, 0);
        for (int y = area.Y; y < area.Y + area.Height; y += step)
        {
            for (int x = area.X; x < area.X + area.Width; x += step)
            {
                if (film.SampleCount(x, y) < 2)
                {
                    return null;
                }

                error += Math.Sqrt(film.MeanVariance(x, y));
                light += film.Mean(x, y).Luminance;
            }
        }

        return light > 0 ? error / light : null;
    }
}
