using System.Numerics;

namespace RayTracer.Benchmarks.Precision;

/// <summary>Rays from around a heap of balls towards it, in numbers of one kind; the arithmetic is that of the renderer's spheres.</summary>
internal sealed class BallRays<T>
    where T : struct, IFloatingPointIeee754<T>
{
    public const int Balls = 8;
    public const int Rays = 1 << 18;
    private const double EyeDistance = 10;
    private readonly T[] _balls = new T[3 * Balls];

    // Three rows of origins, three of directions.
    private readonly T[][] _rays = [.. Enumerable.Range(0, 6).Select(_ => new T[Rays])];

    /// <summary>Places everything by the same random numbers, each rounded to the kind of numbers.</summary>
    /// <param name="offset">How far from the origin along x.</param>
    public BallRays(double offset)
    {
        Random random = new(1);
        for (int i = 0; i < _balls.Length; i++)
        {
            _balls[i] = T.CreateChecked((random.NextDouble() * 4) - 2 + (i % 3 == 0 ? offset : 0));
        }

        for (int i = 0; i < Rays; i++)
        {
            double[] eye = OnSphere(random, EyeDistance);
            double[] way = [.. OnSphere(random, 2).Zip(eye, (to, from) => to - from)];
            double length = Math.Sqrt(way.Sum(d => d * d));
            double[] row = [eye[0] + offset, eye[1], eye[2], .. way.Select(d => d / length)];
            for (int k = 0; k < row.Length; k++)
            {
                _rays[k][i] = T.CreateChecked(row[k]);
            }
        }
    }

    /// <summary>Where each ray meets the nearest ball; infinity where it meets none.</summary>
    public T[] Distances { get; } = new T[Rays];

    /// <summary>Intersects all rays with all balls.</summary>
    public void Trace()
    {
        for (int i = 0; i < Rays; i += Vector<T>.Count)
        {
            Vector<T> x = new(_rays[0], i), y = new(_rays[1], i), z = new(_rays[2], i);
            Vector<T> u = new(_rays[3], i), v = new(_rays[4], i), w = new(_rays[5], i);
            Vector<T> nearest = new(T.PositiveInfinity);
            for (int k = 0; k < _balls.Length; k += 3)
            {
                Vector<T> a = x - new Vector<T>(_balls[k]), b = y - new Vector<T>(_balls[k + 1]), c = z - new Vector<T>(_balls[k + 2]);
                Vector<T> along = (a * u) + (b * v) + (c * w);
                Vector<T> p = a - (along * u), q = b - (along * v), r = c - (along * w);
                Vector<T> root = Vector.SquareRoot(Vector<T>.One - ((p * p) + (q * q) + (r * r)));
                Vector<T> t = -along - root;

                // Where the ray misses, the root is NaN and the comparison false.
                nearest = Vector.ConditionalSelect(Vector.LessThan(t, nearest), t, nearest);
            }

            nearest.CopyTo(Distances, i);
        }
    }

    private static double[] OnSphere(Random random, double radius)
    {
        double z = (2 * random.NextDouble()) - 1;
        double turn = 2 * Math.PI * random.NextDouble();
        double r = Math.Sqrt(1 - (z * z));
        return [radius * r * Math.Cos(turn), radius * r * Math.Sin(turn), radius * z];
    }
}
