using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>
/// Carries what earlier pictures have gathered over to the next one of a moving view: each point is looked up where it was seen before, and what shows
/// another thing, another side or another place there is rejected. Where the light itself has changed, less of it counts.
/// </summary>
internal sealed class MovingHistory
{
    /// <summary>The edge of the squares in which old and new light are compared.</summary>
    public const int Square = 8;

    // So many pictures at most are averaged.
    private const float Longest = 32;

    // Standard errors by which the old mean of a square may differ from the new one.
    private const float Trusted = 2;

    // Red, green, blue, and how many pictures have been gathered; the means of the luminance and of its square.
    private readonly Vector4[] _light;
    private readonly Vector2[] _moments;

    /// <summary>Makes room.</summary>
    public MovingHistory(MovingPlanes like)
    {
        Like = like;
        int pixels = like.Width * like.Height;
        (_light, _moments, Things) = (new Vector4[pixels], new Vector2[pixels], new int[pixels]);
        Seen = new(like.Width, like.Height);
    }

    /// <summary>Planes of the same size.</summary>
    public MovingPlanes Like { get; }

    /// <summary>What was seen then.</summary>
    public SeenPlanes Seen { get; }

    /// <summary>The things' numbers.</summary>
    public int[] Things { get; }

    /// <summary>How many pictures a pixel has gathered.</summary>
    public float LengthAt(int x, int y) => _light[(y * Like.Width) + x].W;

    /// <summary>Keeps smoother light for the next picture.</summary>
    public void Keep(MovingPlanes light)
    {
        for (int y = 0; y < Like.Height; y++)
        {
            int at = Like.At(0, y);
            Span<Vector4> to = _light.AsSpan(y * Like.Width, Like.Width);
            Span<float> red = light.Red[at..];
            Span<float> green = light.Green[at..];
            Span<float> blue = light.Blue[at..];
            for (int x = 0; x < to.Length; x++)
            {
                to[x] = new(red[x], green[x], blue[x], to[x].W);
            }
        }
    }

    /// <summary>Mixes the new light of some rows with the old.</summary>
    /// <param name="before">What was gathered before.</param>
    /// <param name="light">The new light, which becomes the mean; its variance is found.</param>
    /// <param name="where">Finds where in the earlier picture a pixel was, and the point that was there.</param>
    /// <param name="square">The row of squares.</param>
    /// <param name="most">The most earlier pictures that count.</param>
    public void Mix(MovingHistory before, MovingPlanes light, in EarlierPlace where, int square, float most)
    {
        (int top, int bottom) = (square * Square, Math.Min(Like.Height, (square + 1) * Square));
        Span<float> red = light.Red;
        Span<float> green = light.Green;
        Span<float> blue = light.Blue;
        for (int left = 0; left < Like.Width; left += Square)
        {
            int right = Math.Min(Like.Width, left + Square);
            Statistics statistics = default;
            for (int y = top; y < bottom; y++)
            {
                for (int x = left; x < right; x++)
                {
                    (int pixel, int at) = ((y * Like.Width) + x, Like.At(x, y));
                    Find(before, where, x, y, pixel);
                    statistics.Add(MovingPlanes.Luminance(new(red[at], green[at], blue[at])), _moments[pixel].X, _light[pixel].W > 0);
                }
            }

            float trust = statistics.Trust(Trusted);
            for (int y = top; y < bottom; y++)
            {
                Mix(light, y, left, right, Math.Min(most, Longest) * trust, statistics.Variance);
            }
        }
    }

    private void Mix(MovingPlanes light, int y, int left, int right, float most, float variance)
    {
        Span<float> red = light.Red;
        Span<float> green = light.Green;
        Span<float> blue = light.Blue;
        Span<float> variances = light.Variance;
        for (int x = left; x < right; x++)
        {
            (int pixel, int at) = ((y * Like.Width) + x, Like.At(x, y));
            Vector4 old = _light[pixel];
            float length = Math.Min(old.W, most) + 1;
            float share = 1 / length;
            Vector3 color = new(red[at], green[at], blue[at]);
            float luminance = MovingPlanes.Luminance(color);
            Vector2 moments = _moments[pixel] + ((new Vector2(luminance, luminance * luminance) - _moments[pixel]) * share);
            Vector3 mixed = old.AsVector3() + ((color - old.AsVector3()) * share);
            (_light[pixel], _moments[pixel]) = (new(mixed, length), moments);
            (red[at], green[at], blue[at]) = (mixed.X, mixed.Y, mixed.Z);

            // A short history knows little of its noise: that of the square is taken.
            float own = Math.Max(0, moments.Y - (moments.X * moments.X));
            float known = Math.Clamp((length - 2) / 4, 0, 1);
            variances[at] = Things[pixel] == 0 ? 0 : ((own * known) + (variance * (1 - known))) * share;
        }
    }

    // Takes the history of a pixel from where it was, a mean of the four pixels around.
    private void Find(MovingHistory before, in EarlierPlace where, int x, int y, int pixel)
    {
        (Vector4 light, Vector2 moments, float sum) = (default, default, 0);
        Vector3 here = Seen.Point[pixel];
        if (where.Of(x, y, Things[pixel], here, out Vector2 place, out Vector3 point))
        {
            (float fx, float fy) = (place.X - 0.5f, place.Y - 0.5f);
            (int x0, int y0) = ((int)MathF.Floor(fx), (int)MathF.Floor(fy));
            (fx, fy) = (fx - x0, fy - y0);
            Place same = new(Things[pixel], Seen.Normal[pixel], point, 0.02f * (here - Seen.Eye).Length());
            for (int i = 0; i < 4; i++)
            {
                (int px, int py) = (x0 + (i & 1), y0 + (i >> 1));
                float weight = ((i & 1) == 0 ? 1 - fx : fx) * (i < 2 ? 1 - fy : fy);
                int other = (py * Like.Width) + px;
                if (weight != 0 && (uint)px < (uint)Like.Width && (uint)py < (uint)Like.Height && same.IsAt(before, other))
                {
                    light += before._light[other] * weight;
                    moments += before._moments[other] * weight;
                    sum += weight;
                }
            }
        }

        float scale = sum > 0.02f ? 1 / sum : 0;
        (_light[pixel], _moments[pixel]) = (light * scale, moments * scale);
    }

    // A piece of a surface: another is the same within a part of the distance, along its normal.
    private readonly ref struct Place(int thing, Vector3 normal, Vector3 point, float near)
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public bool IsAt(MovingHistory before, int pixel) => thing == before.Things[pixel]
            && (thing == 0 || (Vector3.Dot(normal, before.Seen.Normal[pixel]) > 0.8f && MathF.Abs(Vector3.Dot(before.Seen.Point[pixel] - point, normal)) < near));
    }

    private ref struct Statistics
    {
        private float _new, _square, _old, _both, _count;

        public readonly float Variance => _count > 0 ? Math.Max(0, (_square / _count) - (_new / _count * _new / _count)) : 0;

        public void Add(float luminance, float old, bool hasOld)
        {
            (_new, _square, _count) = (_new + luminance, _square + (luminance * luminance), _count + 1);
            if (hasOld)
            {
                (_old, _both) = (_old + luminance - old, _both + 1);
            }
        }

        // 1 where old and new light agree up to the noise, 0 where they certainly do not.
        public readonly float Trust(float limit)
        {
            if (_both < 16)
            {
                return 1;
            }

            float error = MathF.Sqrt(Variance / _both) + (0.02f * _new / _count) + 1e-5f;
            return Math.Clamp(1 - ((MathF.Abs(_old / _both) / error) - limit) / limit, 0, 1);
        }
    }
}

/// <summary>Finds where things were in the picture before.</summary>
/// <param name="before">The camera then; null where nothing is known of it.</param>
/// <param name="camera">The camera now.</param>
/// <param name="things">How the things have moved.</param>
internal readonly struct EarlierPlace(MovingCamera? before, MovingCamera? camera, MovingThings things)
{
    private readonly bool _isStill = !things.HaveMoved && before is not null && camera?.IsAt(before) == true;

    /// <summary>Finds where what a pixel shows was.</summary>
    /// <param name="x">The pixel's column.</param>
    /// <param name="y">Its row.</param>
    /// <param name="thing">The thing that is there.</param>
    /// <param name="now">The point that is seen.</param>
    /// <param name="place">The place in the earlier picture, in pixels.</param>
    /// <param name="point">The point that the thing had there then.</param>
    /// <returns>False if it was not in the picture.</returns>
    [MethodImpl(MethodImplOptions.AggressiveInlining)]
    public bool Of(int x, int y, int thing, Vector3 now, out Vector2 place, out Vector3 point)
    {
        point = things.Before(thing, now);
        place = new(x + 0.5f, y + 0.5f);
        if (_isStill)
        {
            return true;
        }

        if (before is null || camera is null || !before.TryProject(point, out Vector2 there) || !camera.TryProject(now, out Vector2 here))
        {
            return false;
        }

        // The sample's place within its pixel is none of the movement's.
        place += there - here;
        return true;
    }
}
