using System.Numerics;
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
    private readonly float[] _red, _green, _blue, _first, _second, _length;

    /// <summary>Makes room.</summary>
    public MovingHistory(MovingPlanes like)
    {
        Like = like;
        (_red, _green, _blue, _first, _second, _length) =
            (new float[like.Size], new float[like.Size], new float[like.Size], new float[like.Size], new float[like.Size], new float[like.Size]);
        Seen = new(like.Width, like.Height);
        Things = new int[like.Width * like.Height];
    }

    /// <summary>Planes of the same size.</summary>
    public MovingPlanes Like { get; }

    /// <summary>What was seen then.</summary>
    public SeenPlanes Seen { get; }

    /// <summary>The things' numbers.</summary>
    public int[] Things { get; }

    /// <summary>How many pictures a pixel has gathered.</summary>
    public float LengthAt(int x, int y) => _length[Like.At(x, y)];

    /// <summary>Nothing is carried over.</summary>
    public void Forget() => Array.Clear(_length);

    /// <summary>Keeps smoother light for the next picture.</summary>
    public void Keep(MovingPlanes light)
    {
        light.Red.CopyTo(_red);
        light.Green.CopyTo(_green);
        light.Blue.CopyTo(_blue);
    }

    /// <summary>Mixes the new light of some rows with the old.</summary>
    /// <param name="before">What was gathered before.</param>
    /// <param name="light">The new light, which becomes the mean; its variance is found.</param>
    /// <param name="where">Finds where in the earlier picture a pixel was, and the point that was there.</param>
    /// <param name="square">The row of squares.</param>
    /// <param name="most">The most earlier pictures that count.</param>
    public void Mix(MovingHistory before, MovingPlanes light, IEarlierPlace where, int square, float most)
    {
        int bottom = Math.Min(Like.Height, (square + 1) * Square);
        for (int left = 0; left < Like.Width; left += Square)
        {
            int right = Math.Min(Like.Width, left + Square);
            Statistics statistics = default;
            for (int y = square * Square; y < bottom; y++)
            {
                for (int x = left; x < right; x++)
                {
                    Find(before, where, x, y);
                    statistics.Add(light, _first, _length, Like.At(x, y));
                }
            }

            float trust = statistics.Trust(Trusted);
            for (int y = square * Square; y < bottom; y++)
            {
                for (int x = left; x < right; x++)
                {
                    Mix(light, x, y, Math.Min(most, Longest) * trust, statistics.Variance);
                }
            }
        }
    }

    private void Mix(MovingPlanes light, int x, int y, float most, float variance)
    {
        int at = Like.At(x, y);
        float length = Math.Min(_length[at], most) + 1;
        float share = 1 / length;
        Vector3 color = Vector3.Lerp(new(_red[at], _green[at], _blue[at]), new(light.Red[at], light.Green[at], light.Blue[at]), share);
        float luminance = MovingPlanes.Luminance(new(light.Red[at], light.Green[at], light.Blue[at]));
        _first[at] += (luminance - _first[at]) * share;
        _second[at] += ((luminance * luminance) - _second[at]) * share;
        _length[at] = length;
        (light.Red[at], light.Green[at], light.Blue[at]) = (color.X, color.Y, color.Z);

        // A short history knows little of its noise: that of the square is taken.
        float own = Math.Max(0, _second[at] - (_first[at] * _first[at]));
        float known = Math.Clamp((length - 2) / 4, 0, 1);
        light.Variance[at] = Things[(y * Like.Width) + x] == 0 ? 0 : ((own * known) + (variance * (1 - known))) * share;
    }

    // Takes the history of a pixel from where it was, a mean of the four pixels around.
    private void Find(MovingHistory before, IEarlierPlace where, int x, int y)
    {
        int pixel = (y * Like.Width) + x;
        int at = Like.At(x, y);
        (Vector3 color, float first, float second, float length, float sum) = (default, 0, 0, 0, 0);
        if (where.Of(x, y, out Vector2 place, out Vector3 point))
        {
            (float fx, float fy) = (place.X - 0.5f, place.Y - 0.5f);
            (int x0, int y0) = ((int)MathF.Floor(fx), (int)MathF.Floor(fy));
            (fx, fy) = (fx - x0, fy - y0);
            for (int i = 0; i < 4; i++)
            {
                (int px, int py) = (x0 + (i & 1), y0 + (i >> 1));
                float weight = ((i & 1) == 0 ? 1 - fx : fx) * (i < 2 ? 1 - fy : fy);
                if (weight == 0 || px < 0 || py < 0 || px >= Like.Width || py >= Like.Height || !IsSame(before, pixel, (py * Like.Width) + px, point))
                {
                    continue;
                }

                int from = Like.At(px, py);
                color += new Vector3(before._red[from], before._green[from], before._blue[from]) * weight;
                first += before._first[from] * weight;
                second += before._second[from] * weight;
                length += before._length[from] * weight;
                sum += weight;
            }
        }

        float scale = sum > 0.02f ? 1 / sum : 0;
        (_red[at], _green[at], _blue[at]) = (color.X * scale, color.Y * scale, color.Z * scale);
        (_first[at], _second[at], _length[at]) = (first * scale, second * scale, length * scale);
    }

    private bool IsSame(MovingHistory before, int pixel, int other, Vector3 point)
    {
        if (Things[pixel] != before.Things[other])
        {
            return false;
        }

        if (Things[pixel] == 0)
        {
            return true;
        }

        // Within a part of the distance of the plane of its surface.
        Vector3 normal = Seen.Normal[pixel];
        float size = (Seen.Point[pixel] - Seen.Eye).Length();
        return Vector3.Dot(normal, before.Seen.Normal[other]) > 0.8f && MathF.Abs(Vector3.Dot(before.Seen.Point[other] - point, normal)) < 0.02f * size;
    }

    private ref struct Statistics
    {
        private float _new, _square, _old, _both, _count;

        public readonly float Variance => _count > 0 ? Math.Max(0, (_square / _count) - (_new / _count * _new / _count)) : 0;

        public void Add(MovingPlanes light, float[] old, float[] length, int at)
        {
            float luminance = MovingPlanes.Luminance(new(light.Red[at], light.Green[at], light.Blue[at]));
            (_new, _square, _count) = (_new + luminance, _square + (luminance * luminance), _count + 1);
            if (length[at] > 0)
            {
                (_old, _both) = (_old + luminance - old[at], _both + 1);
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
internal interface IEarlierPlace
{
    /// <summary>Finds where what a pixel shows was.</summary>
    /// <param name="x">The pixel's column.</param>
    /// <param name="y">Its row.</param>
    /// <param name="place">The place in the earlier picture, in pixels.</param>
    /// <param name="point">The point that the thing had there then.</param>
    /// <returns>False if it was not in the picture.</returns>
    bool Of(int x, int y, out Vector2 place, out Vector3 point);
}
