using System.Diagnostics;
using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;
using RayTracer.Labs;

namespace Lab8;

/// <summary>The checks of lab 8: lanes have the bits of the scalar code, and are faster.</summary>
public static class Checks
{
    // Eight lanes take about a fifth of the time; a machine that others use, too, is left some room.
    private const double LeastGain = 1.5;

    [Check("eight products", 1)]
    public static void Products(CheckRun run) => run.Compare(new Trial<Packet>
    {
        Draw = draws => new(draws, run.Random),
        Found = p => Vectors.Dot(p.Origin, p.Direction)[p.Lane],
        Expected = p => Scalar.Dot(p.Ray.X, p.Ray.Y, p.Ray.Z, p.Ray.DirectionX, p.Ray.DirectionY, p.Ray.DirectionZ),
        Tolerance = 0,
        Mistakes =
        [
            ("The last bit differs: a fused multiply-add rounds once where a product and a sum round twice. Take products and sums, as Scalar.Dot does.", p => p.Fused(isZLast: true)),
            ("The last bit differs: a fused multiply-add rounds once where a product and a sum round twice. Take products and sums, as Scalar.Dot does.", p => p.Fused(isZLast: false)),
            ("The last bit differs: sums of floats depend on their order. Add in the order of Scalar.Dot.", p => (p.Ray.X * p.Ray.DirectionX) + ((p.Ray.Y * p.Ray.DirectionY) + (p.Ray.Z * p.Ray.DirectionZ))),
        ],
    });

    [Check("a ball for eight rays", 3)]
    public static void Meeting(CheckRun run) => run.Compare(new Trial<Packet>
    {
        Draw = draws => new(draws, run.Random),
        Found = p => Known(Packets.Meet(p.Origin, p.Direction, p.Ball)[p.Lane]),
        Expected = p => Scalar.Meet(p.Ray, p.Ball),
        Tolerance = 0,
        Count = 400,
        Mistakes =
        [
            ("Rays that miss have NaN, the root of a negative number: there select infinity, whatever was computed.", p => p.Misses(p.Lane) ? -1 : Scalar.Meet(p.Ray, p.Ball)),
            ("The first lane decides for all: an if has one answer, but each of the eight rays needs its own. Select.", p => p.Misses(0) ? float.PositiveInfinity : Known(p.Roots(p.Lane))),
            ("The first lane decides for all: an if has one answer, but each of the eight rays needs its own. Select.", p => p.Misses(0) ? float.PositiveInfinity : Scalar.Meet(p.Ray, p.Ball)),
            ("You see balls behind the rays: where the nearer distance is not above 0, take the other one; where that is not either, there is none.", p => p.Near),
            ("You see balls behind the rays: where the nearer distance is not above 0, take the other one; where that is not either, there is none.", p => p.Misses(p.Lane) ? float.PositiveInfinity : p.Near > 0 ? p.Near : p.Far),
            ("Rays that begin within a ball do not see it: there the nearer distance is behind them, and the other one counts.", p => p.Near > 0 ? p.Near : float.PositiveInfinity),
            ("You take the back of the balls: the nearer distance counts where it is above 0.", p => p.Far > 0 ? p.Far : float.PositiveInfinity),
        ],
    });

    [Check("the nearest of many balls", 2)]
    public static void Nearest(CheckRun run) => run.Compare(new Trial<Packet>
    {
        Draw = draws => new(draws, run.Random),
        Found = p => Packets.Nearest(p.Origin, p.Direction, p.Crowd.Balls) is var (distance, index) ? (Known(distance[p.Lane]), index[p.Lane]) : null,
        Expected = p => Scalar.Nearest(p.Ray, p.Crowd.Balls),
        Tolerance = 0,
        Mistakes =
        [
            ("The number is that of the last ball that is met, not of the nearest: select it by the same comparison as the distance.", p => (Scalar.Nearest(p.Ray, p.Crowd.Balls).Distance, p.Met().LastOrDefault(-1))),
            ("The number is that of the last ball of all: select it by the same comparison as the distance.", p => (Scalar.Nearest(p.Ray, p.Crowd.Balls).Distance, p.Crowd.Balls.Length - 1)),
            ("Each ball takes the place of the one before, even if it is farther away.", p => p.Met().Any() ? (Scalar.Meet(p.Ray, p.Crowd.Balls[p.Met().Last()]), p.Met().Last()) : (float.PositiveInfinity, -1)),
        ],
    });

    [Check("a list of rays", 2)]
    public static void Lists(CheckRun run) => run.Compare(new Trial<Listed>
    {
        Draw = draws => new(draws.Whole("rays", 1, 30), draws.Number("place in the list", 0, 0.999), new(run.Random, 5)),
        Found = l => l.Found(),
        Expected = l => Scalar.Nearest(l.Rays[l.At], l.Crowd.Balls),
        Tolerance = 0,
        Mistakes =
        [
            ("The last rays are lost where the list does not end with a packet: the last packet has fewer rays, but they count.", l => l.At < l.Rays.Length / Packets.Lanes * Packets.Lanes ? Scalar.Nearest(l.Rays[l.At], l.Crowd.Balls) : (-1, -1)),
            ("All rays of a packet get the answer of its first one.", l => Scalar.Nearest(l.Rays[l.At / Packets.Lanes * Packets.Lanes], l.Crowd.Balls)),
        ],
    });

    [Check("faster than one by one", 1)]
    public static void Speed(CheckRun run)
    {
        Crowd crowd = new(run.Random, 40);
        (float[] distance, int[] index) = (new float[crowd.Rays.Length], new int[crowd.Rays.Length]);
        (double lanes, double single) = (double.PositiveInfinity, double.PositiveInfinity);

        // The best of many, in turns: what else the machine does is no matter of the student.
        for (int round = 0; round < 30; round++)
        {
            long start = Stopwatch.GetTimestamp();
            Packets.NearestOfAll(crowd.Rays, crowd.Balls, distance, index);
            lanes = Math.Min(lanes, Stopwatch.GetElapsedTime(start).TotalMilliseconds);
            start = Stopwatch.GetTimestamp();
            OneByOne(crowd, distance, index);
            single = Math.Min(single, Stopwatch.GetElapsedTime(start).TotalMilliseconds);
            if (round > 4 && single > 3 * lanes)
            {
                break;
            }
        }

        if (Vector256.IsHardwareAccelerated && single < LeastGain * lanes)
        {
            run.Fail(
                "Your lanes are not faster than one ray at a time: is each lane computed by itself somewhere, or is memory allocated in the loop?",
                expected: $"at most 1/{LeastGain} of the time", found: $"{lanes / single:F2} of the time");
        }
    }

    [Check("a picture", 1)]
    public static void Picture(CheckRun run)
    {
        Crowd crowd = new(run.Random, 30);
        (float[] distance, int[] index) = (new float[crowd.Rays.Length], new int[crowd.Rays.Length]);
        Packets.NearestOfAll(crowd.Rays, crowd.Balls, distance, index);
        Rgb Own(int x, int y) => (y * Crowd.Width) + x is var i && i < index.Length ? crowd.Shade(i, distance[i], index[i]) : Rgb.Black;
        Rgb Reference(int x, int y) => (y * Crowd.Width) + x is var i && i < index.Length && Scalar.Nearest(crowd.Rays[i], crowd.Balls) is var (there, ball) ? crowd.Shade(i, there, ball) : Rgb.Black;
        run.Compare(Crowd.Width, Crowd.Height, Own, Reference);
    }

    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    private static void OneByOne(Crowd crowd, float[] distance, int[] index)
    {
        for (int i = 0; i < crowd.Rays.Length; i++)
        {
            (distance[i], index[i]) = Nearest(crowd.Rays[i], crowd.Balls);
        }

        // As Scalar.Nearest, which may not be optimised yet.
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        static (float Distance, int Index) Nearest(in FloatRay ray, Ball[] balls)
        {
            (float nearest, int number) = (float.PositiveInfinity, -1);
            for (int b = 0; b < balls.Length; b++)
            {
                float here = Scalar.Meet(ray, balls[b]);
                (nearest, number) = here < nearest ? (here, b) : (nearest, number);
            }

            return (nearest, number);
        }
    }

    // What is no number compares with nothing, not even with itself.
    private static float Known(float distance) => float.IsNaN(distance) ? -1 : distance;

    /// <summary>Eight rays, of which one is looked at, and a ball.</summary>
    private sealed class Packet
    {
        private readonly FloatRay[] _rays;

        public Packet(Draws draws, ISampler random)
        {
            Lane = draws.Whole("lane", 0, Packets.Lanes - 1);
            Vector eye = draws.Point("origin", -2, 2);
            Vector direction = draws.Direction("direction");
            Ball = new((float)draws.Number("x of the ball", -1, 1), 0, 0, (float)draws.Number("radius", 0.5, 1.5));
            FloatRay seen = new((float)eye.X, (float)eye.Y, (float)eye.Z, (float)direction.X, (float)direction.Y, (float)direction.Z);
            _rays = [.. Enumerable.Range(0, Packets.Lanes).Select(i => i == Lane ? seen : Any(random))];
            Crowd = new(random, 30);
        }

        public int Lane { get; }

        public Ball Ball { get; }

        public Crowd Crowd { get; }

        public FloatRay Ray => _rays[Lane];

        public Vectors Origin => new(Register(r => r.X), Register(r => r.Y), Register(r => r.Z));

        public Vectors Direction => new(Register(r => r.DirectionX), Register(r => r.DirectionY), Register(r => r.DirectionZ));

        // The two distances, whatever their signs; infinite where the ray misses.
        public float Near => Misses(Lane) ? float.PositiveInfinity : Solve(Lane).Middle - MathF.Sqrt(Solve(Lane).Square);

        public float Far => Misses(Lane) ? float.PositiveInfinity : Solve(Lane).Middle + MathF.Sqrt(Solve(Lane).Square);

        public bool Misses(int lane) => Solve(lane).Square < 0;

        // The distance without a look at whether the ray misses.
        public float Roots(int lane)
        {
            (float middle, float square) = Solve(lane);
            (float near, float far) = (middle - MathF.Sqrt(square), middle + MathF.Sqrt(square));
            return near > 0 ? near : far > 0 ? far : float.PositiveInfinity;
        }

        public IEnumerable<int> Met() => Enumerable.Range(0, Crowd.Balls.Length).Where(i => Scalar.Meet(Ray, Crowd.Balls[i]) < float.PositiveInfinity);

        public double Fused(bool isZLast)
        {
            FloatRay r = Ray;
            return isZLast ? MathF.FusedMultiplyAdd(r.Z, r.DirectionZ, MathF.FusedMultiplyAdd(r.Y, r.DirectionY, r.X * r.DirectionX))
                : MathF.FusedMultiplyAdd(r.X, r.DirectionX, MathF.FusedMultiplyAdd(r.Y, r.DirectionY, r.Z * r.DirectionZ));
        }

        private (float Middle, float Square) Solve(int lane)
        {
            FloatRay r = _rays[lane];
            (float x, float y, float z) = (Ball.X - r.X, Ball.Y - r.Y, Ball.Z - r.Z);
            float middle = Scalar.Dot(x, y, z, r.DirectionX, r.DirectionY, r.DirectionZ);
            return (middle, (middle * middle) - (Scalar.Dot(x, y, z, x, y, z) - (Ball.Radius * Ball.Radius)));
        }

        private Vector256<float> Register(Func<FloatRay, float> number)
        {
            Span<float> numbers = stackalloc float[Packets.Lanes];
            for (int i = 0; i < numbers.Length; i++)
            {
                numbers[i] = number(_rays[i]);
            }

            return Vector256.Create<float>(numbers);
        }

        private static FloatRay Any(ISampler random)
        {
            Vector direction = Warp.Sphere(random.Next2());
            return new((float)(2 * random.Next()), (float)(2 * random.Next()), (float)(2 * random.Next()), (float)direction.X, (float)direction.Y, (float)direction.Z);
        }
    }

    /// <summary>A list of some rays, of which one is looked at.</summary>
    private sealed record Listed(int Count, double Place, Crowd Crowd)
    {
        public FloatRay[] Rays { get; } = [.. Enumerable.Range(0, Count).Select(i => Crowd.Rays[i * 97 % Crowd.Rays.Length])];

        public int At => (int)(Place * Count);

        public Answer Found()
        {
            (float[] distance, int[] index) = (new float[Count], new int[Count]);
            Array.Fill(distance, -1);
            Array.Fill(index, -1);
            Packets.NearestOfAll(Rays, Crowd.Balls, distance, index);
            return (Known(distance[At]), index[At]);
        }
    }
}
