using System.Runtime.CompilerServices;
using System.Runtime.Intrinsics;

namespace Lab8;

/// <summary>Eight rays at a time.</summary>
public static class Packets
{
    /// <summary>The number of lanes.</summary>
    public const int Lanes = 8;

    /// <summary>The distances at which eight rays meet a ball in front of them; infinite for none.</summary>
    /// <param name="origin">Where the rays begin.</param>
    /// <param name="direction">Their directions, of the length 1.</param>
    /// <param name="ball">The ball.</param>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public static Vector256<float> Meet(in Vectors origin, in Vectors direction, in Ball ball)
    {
        //? Packets.Meet: as Scalar.Meet, with Vector256.LessThan, Vector256.GreaterThan and Vector256.ConditionalSelect in the place of if.
        Vectors to = Vectors.All(ball.X, ball.Y, ball.Z) - origin;
        Vector256<float> middle = Vectors.Dot(to, direction);
        Vector256<float> square = (middle * middle) - (Vectors.Dot(to, to) - Vector256.Create(ball.Radius * ball.Radius));
        Vector256<float> missed = Vector256.LessThan(square, Vector256<float>.Zero);
        Vector256<float> nothing = Vector256.Create(float.PositiveInfinity);
        Vector256<float> root = Vector256.Sqrt(square);
        Vector256<float> near = middle - root;
        Vector256<float> far = middle + root;
        Vector256<float> beyond = Vector256.ConditionalSelect(Vector256.GreaterThan(far, Vector256<float>.Zero), far, nothing);
        Vector256<float> inFront = Vector256.ConditionalSelect(Vector256.GreaterThan(near, Vector256<float>.Zero), near, beyond);
        return Vector256.ConditionalSelect(missed, nothing, inFront);
        //!
    }

    /// <summary>The nearest balls that eight rays meet: their distances and numbers; infinite and −1 for none. Of two at the same distance, the first.</summary>
    /// <param name="origin">Where the rays begin.</param>
    /// <param name="direction">Their directions, of the length 1.</param>
    /// <param name="balls">The balls.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static (Vector256<float> Distance, Vector256<int> Index) Nearest(in Vectors origin, in Vectors direction, Ball[] balls)
    {
        //? Packets.Nearest: a loop over the balls; where one is nearer, its distance and its number take the place of those before.
        Vector256<float> distance = Vector256.Create(float.PositiveInfinity);
        Vector256<int> index = Vector256.Create(-1);
        for (int i = 0; i < balls.Length; i++)
        {
            Vector256<float> here = Meet(origin, direction, balls[i]);
            Vector256<float> nearer = Vector256.LessThan(here, distance);
            distance = Vector256.ConditionalSelect(nearer, here, distance);
            index = Vector256.ConditionalSelect(nearer.AsInt32(), Vector256.Create(i), index);
        }

        return (distance, index);
        //!
    }

    /// <summary>The nearest ball for each ray of a list, which may have any length.</summary>
    /// <param name="rays">The rays.</param>
    /// <param name="balls">The balls.</param>
    /// <param name="distance">Takes the distance of each; as long as the list.</param>
    /// <param name="index">Takes the ball's number of each.</param>
    [MethodImpl(MethodImplOptions.AggressiveOptimization)]
    public static void NearestOfAll(FloatRay[] rays, Ball[] balls, float[] distance, int[] index)
    {
        //? Packets.NearestOfAll: eight rays at a time, lane by lane from the list; the last packet may have fewer, and only those that exist are written.
        for (int first = 0; first < rays.Length; first += Lanes)
        {
            int count = Math.Min(Lanes, rays.Length - first);
            Load(rays, first, count, out Vectors origin, out Vectors direction);
            (Vector256<float> distances, Vector256<int> indices) = Nearest(origin, direction, balls);
            for (int lane = 0; lane < count; lane++)
            {
                (distance[first + lane], index[first + lane]) = (distances[lane], indices[lane]);
            }
        }
        //!
    }

    // Registers are filled from memory: each coordinate by itself. Lanes without a ray get the last one again.
    private static void Load(FloatRay[] rays, int first, int count, out Vectors origin, out Vectors direction)
    {
        Span<float> numbers = stackalloc float[6 * Lanes];
        for (int lane = 0; lane < Lanes; lane++)
        {
            FloatRay ray = rays[first + Math.Min(lane, count - 1)];
            (numbers[lane], numbers[Lanes + lane], numbers[(2 * Lanes) + lane]) = (ray.X, ray.Y, ray.Z);
            (numbers[(3 * Lanes) + lane], numbers[(4 * Lanes) + lane], numbers[(5 * Lanes) + lane]) = (ray.DirectionX, ray.DirectionY, ray.DirectionZ);
        }

        origin = new(Vector256.Create<float>(numbers), Vector256.Create<float>(numbers[Lanes..]), Vector256.Create<float>(numbers[(2 * Lanes)..]));
        direction = new(Vector256.Create<float>(numbers[(3 * Lanes)..]), Vector256.Create<float>(numbers[(4 * Lanes)..]), Vector256.Create<float>(numbers[(5 * Lanes)..]));
    }
}
