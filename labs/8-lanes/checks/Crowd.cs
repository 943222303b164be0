using RayTracer.Labs;

namespace Lab8;

/// <summary>Balls, and rays of a camera that looks at them.</summary>
public sealed class Crowd
{
    public const int Width = 120;
    public const int Height = 90;

    // No multiple of eight.
    private const int Missing = 3;

    /// <summary>Makes them.</summary>
    public Crowd(ISampler random, int balls)
    {
        float Next() => (float)((2 * random.Next()) - 1);
        Balls = [.. Enumerable.Range(0, balls).Select(_ => new Ball(3 * Next(), 2 * Next(), 2 * Next(), 0.3f + (0.2f * Next())))];
        Rays = [.. Enumerable.Range(0, (Width * Height) - Missing).Select(i => Through(i % Width, i / Width))];
    }

    /// <summary>The balls.</summary>
    public Ball[] Balls { get; }

    /// <summary>The rays, row by row.</summary>
    public FloatRay[] Rays { get; }

    /// <summary>How bright a ray sees the balls, lit from the eye; black where there is none.</summary>
    public Rgb Shade(int pixel, float distance, int index)
    {
        if (pixel >= Rays.Length || (uint)index >= (uint)Balls.Length || !float.IsFinite(distance))
        {
            return Rgb.Black;
        }

        (FloatRay ray, Ball ball) = (Rays[pixel], Balls[index]);
        double cosine = ((((ball.X - ray.X) * ray.DirectionX) + ((ball.Y - ray.Y) * ray.DirectionY) + ((ball.Z - ray.Z) * ray.DirectionZ)) - distance) / ball.Radius;
        return new Rgb(0.4 + (0.3 * Math.Sin(index)), 0.5, 0.4 + (0.3 * Math.Cos(3 * index))) * cosine;
    }

    private static FloatRay Through(int x, int y)
    {
        Vector direction = new Vector((x + 0.5 - (Width / 2.0)) / Height, ((Height / 2.0) - y - 0.5) / Height, -1).Unit;
        return new(0, 0, 6, (float)direction.X, (float)direction.Y, (float)direction.Z);
    }
}
