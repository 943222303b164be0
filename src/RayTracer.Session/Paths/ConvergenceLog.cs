using System.Numerics;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>Keeps what a picture looked like after 1, 2, 4, 8 … samples: some of its pixels, spread evenly.</summary>
public sealed class ConvergenceLog
{
    private const int MostPixels = 1 << 16;
    private readonly List<(int Samples, Rgb[] Means)> _kept = [];

    /// <summary>Forgets all.</summary>
    public void Clear() => _kept.Clear();

    /// <summary>Keeps the picture, if its number of samples is a power of two.</summary>
    /// <param name="film">The picture.</param>
    /// <param name="area">Its pixels that have samples.</param>
    /// <param name="samples">The number of samples of each pixel.</param>
    public void Add(Film film, Tile area, int samples)
    {
        if (BitOperations.IsPow2(samples))
        {
            _kept.Add((samples, Pixels(film, area)));
        }
    }

    /// <summary>The error after each number of samples.</summary>
    /// <param name="film">The newest picture.</param>
    /// <param name="area">Its pixels that have samples.</param>
    /// <param name="samples">The number of samples of each pixel.</param>
    public Convergence Errors(Film film, Tile area, int samples) => Convergence.Of(_kept, Pixels(film, area), samples);

    private Rgb[] Pixels(Film film, Tile area)
    {
        int step = Math.Max(1, (int)Math.Ceiling(Math.Sqrt((double)area.Pixels / MostPixels)));
        List<Rgb> pixels = [];
        for (int y = area.Y; y < area.Y + area.Height; y += step)
        {
            for (int x = area.X; x < area.X + area.Width; x += step)
            {
                pixels.Add(film.Mean(x, y));
            }
        }

        return [.. pixels];
    }
}
