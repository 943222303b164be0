using System.Numerics;
using System.Runtime.CompilerServices;
using RayTracer.Numerics;
using RayTracer.Rendering;

namespace RayTracer.Session;

/// <summary>
/// Carries what earlier pictures have gathered over to the next one of a moving view: each point is looked up where it was seen before, and what shows
/// another thing, another side or another place there is rejected. Where the light itself has changed, less of it counts.
/// </summary>
[SkipLocalsInit]
internal sealed unsafe class MovingHistory
{
    /// <summary>The height of the blocks in which old and new light are compared.</summary>
    public const int Block = 8;

    // The width of a block, of whole registers.
    private const int Across = 16;

    // So many pictures at most are averaged.
    private const float Longest = 32;

    // Standard errors by which the old mean of a block may differ from the new one.
    private const float Trusted = 2;

    // Points are of one surface within a part of the distance, along its normal.
    private const float Near = 0.02f;
    private const float LeastCosine = 0.8f;
    private const float LeastWeight = 0.02f;
    private readonly PaddedRows _rows;
    private readonly PinnedBuffer<float> _gathered;

    // The offset of the plane that touches the surface: point · normal.
    private readonly PinnedBuffer<float> _offsets;

    /// <summary>Makes room.</summary>
    /// <param name="rows">How pixels lie in the planes.</param>
    public MovingHistory(PaddedRows rows) => (_rows, Guides, _gathered, _offsets) = (rows, new(rows), new(Gathered.Planes * (long)rows.Size), new(rows.Size));

    /// <summary>What is seen.</summary>
    public MovingGuides Guides { get; }

    /// <summary>Keeps smoother light for the next picture.</summary>
    public void Keep(MovingPlanes light) => new Span<float>(light.Red, 3 * _rows.Size).CopyTo(new(_gathered.Pointer, 3 * _rows.Size));

    /// <summary>Mixes the new light of a row of blocks with the old.</summary>
    /// <param name="before">What was gathered before.</param>
    /// <param name="light">The new light, which becomes the mean; its variance is found.</param>
    /// <param name="where">Finds where in the earlier picture a pixel was, and the point that was there.</param>
    /// <param name="block">The row of blocks.</param>
    /// <param name="most">The most earlier pictures that count.</param>
    public void Mix(MovingHistory before, MovingPlanes light, in EarlierPlace where, int block, float most)
    {
        (int top, int bottom) = (block * Block, Math.Min(_rows.Height, (block + 1) * Block));
        Gathered* olds = stackalloc Gathered[Block * Across / FloatW.Count];
        for (int left = 0; left < _rows.Width; left += Across)
        {
            int right = Math.Min(_rows.Width, left + Across);
            Statistics statistics = default;
            Gathered* old = olds;
            for (int y = top; y < bottom; y++)
            {
                for (int x = left; x < right; x += FloatW.Count)
                {
                    MaskW active = MaskW.First(right - x);
                    Find(before, where, x, y, active, out *old);
                    statistics.Add(light[_rows.At(x, y)].Luminance, *old++, active);
                }
            }

            (float trusted, float variance) = (Math.Min(most, Longest) * statistics.Trust(Trusted), statistics.Variance);
            old = olds;
            for (int y = top; y < bottom; y++)
            {
                for (int x = left; x < right; x += FloatW.Count)
                {
                    Mix(light, *old++, _rows.At(x, y), trusted, variance);
                }
            }
        }
    }

    // What lanes beside the picture write lies in its margin.
    private void Mix(MovingPlanes light, in Gathered old, int at, float most, float variance)
    {
        RgbW color = light[at];
        FloatW luminance = color.Luminance;
        FloatW length = FloatW.Min(old.Length, most) + 1f;
        FloatW share = 1f / length;
        Gathered mixed = new()
        {
            Light = (old.Light * (1f - share)) + (color * share),
            Length = length,
            Mean = old.Mean + ((luminance - old.Mean) * share),
            Square = old.Square + (((luminance * luminance) - old.Square) * share),
        };
        mixed.Store(_gathered, _rows, at);
        light[at] = mixed.Light;

        // A short history knows little of its noise: that of the block is taken.
        FloatW own = FloatW.Max(mixed.Square - (mixed.Mean * mixed.Mean), 0f);
        FloatW known = FloatW.Min(FloatW.Max((length - 2f) * 0.25f, 0f), 1f);
        FloatW noise = ((own * known) + (variance * (1f - known))) * share;
        UIntW.Equal(UIntW.Load(Guides.Things + at), 0u).Select(0f, noise).Store(light.Variance + at);
    }

    // Takes the history of pixels from where they were, means of the four pixels around each place.
    private void Find(MovingHistory before, in EarlierPlace where, int x, int y, in MaskW active, out Gathered old)
    {
        old = default;
        int at = _rows.At(x, y);
        SeenPlanes seen = Guides.Seen;
        (UIntW thing, Vec3W here) = (UIntW.Load(Guides.Things + at), seen.Point(at));
        Vec3W.Dot(here, seen.Normal(at)).Store(_offsets.Pointer + at);
        MaskW known = active & where.Of(x, y, thing, here, out FloatW across, out FloatW down, out Vec3W point);
        (FloatW left, FloatW top) = (FloatW.Floor(across), FloatW.Floor(down));

        // Beside the picture there is room for a pixel, which shows nothing.
        known &= (left >= -1f) & (left < _rows.Width) & (top >= -1f) & (top < _rows.Height);
        if (!known.Any)
        {
            return;
        }

        Vec3W away = here - seen.Eye;
        Place place = new(thing, seen.Normal(at), point, FloatW.Sqrt(Vec3W.Dot(away, away)) * Near);
        Taps corner = new(known.Select((top.ToInt() * (uint)_rows.Stride) + left.ToInt() + (uint)_rows.At(0, 0), (uint)_rows.At(0, 0)));
        (across, down) = (across - left, down - top);
        FloatW sum = 0f;
        for (int row = 0; row < 2; row++)
        {
            FloatW weight = known.Select(row == 0 ? 1f - down : down, 0f);
            Taps taps = corner.Next((uint)(row * _rows.Stride));
            before.Has(place, taps, out MaskW atLeft, out MaskW atRight);
            (FloatW leftWeight, FloatW rightWeight) = (atLeft.Select(weight * (1f - across), 0f), atRight.Select(weight * across, 0f));
            FloatW both = leftWeight + rightWeight;
            if ((both > 0f).Any)
            {
                old.Add(before._gathered, _rows, taps, leftWeight, rightWeight);
                sum += both;
            }
        }

        old.Scale((sum > LeastWeight).Select(1f / sum, 0f));
    }

    // Whether pixels and their neighbours to the right show what is sought.
    private void Has(in Place place, in Taps at, out MaskW left, out MaskW right)
    {
        SeenPlanes seen = Guides.Seen;
        at.Of((float*)Guides.Things, out FloatW leftThing, out FloatW rightThing);
        (left, right) = (UIntW.Equal(leftThing.AsUInt(), place.Thing), UIntW.Equal(rightThing.AsUInt(), place.Thing));
        if (!(left | right).Any)
        {
            return;
        }

        at.Of(seen.Normals(0), out FloatW leftX, out FloatW rightX);
        at.Of(seen.Normals(1), out FloatW leftY, out FloatW rightY);
        at.Of(seen.Normals(2), out FloatW leftZ, out FloatW rightZ);
        at.Of(_offsets.Pointer, out FloatW leftOffset, out FloatW rightOffset);
        left &= place.IsIn(new(leftX, leftY, leftZ), leftOffset);
        right &= place.IsIn(new(rightX, rightY, rightZ), rightOffset);
    }

    // Pieces of surfaces.
    private readonly record struct Place(UIntW Thing, Vec3W Normal, Vec3W Point, FloatW Near)
    {
        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public MaskW IsIn(in Vec3W normal, in FloatW offset) =>
            UIntW.Equal(Thing, 0u) | ((Vec3W.Dot(Normal, normal) > LeastCosine) & (FloatW.Abs(Vec3W.Dot(Point, normal) - offset) < Near));
    }

    // Places of pixels in the planes, each with its neighbour to the right. Most often neighbours were neighbours before.
    private readonly struct Taps
    {
        private readonly UIntW _at;
        private readonly uint _first;
        private readonly bool _isRow;

        public Taps(UIntW at)
        {
            (_at, _first) = (at, at[0]);
            _isRow = UIntW.Equal(at, UIntW.Iota + _first).Bits == MaskW.All.Bits;
        }

        private Taps(UIntW at, uint first, bool isRow) => (_at, _first, _isRow) = (at, first, isRow);

        public Taps Next(uint step) => new(_at + step, _first + step, _isRow);

        [MethodImpl(MethodImplOptions.AggressiveInlining)]
        public void Of(float* plane, out FloatW left, out FloatW right)
        {
            if (_isRow)
            {
                (left, right) = (FloatW.Load(plane + _first), FloatW.Load(plane + _first + 1));
            }
            else
            {
                FloatW.Gather(plane, _at, out left, out right);
            }
        }

        // Not inlined: where it was, the compiler gave up within it, and the filter took 12 ms instead of 10.
        [MethodImpl(MethodImplOptions.NoInlining)]
        public FloatW Sum(float* plane, in FloatW leftWeight, in FloatW rightWeight)
        {
            Of(plane, out FloatW left, out FloatW right);
            return (left * leftWeight) + (right * rightWeight);
        }
    }

    // What pixels have gathered: light, the number of pictures, and the means of the luminance and of its square.
    private struct Gathered
    {
        public const int Planes = 6;
        public RgbW Light;
        public FloatW Length, Mean, Square;

        public void Add(PinnedBuffer<float> planes, PaddedRows rows, in Taps at, in FloatW left, in FloatW right)
        {
            float* p = planes.Pointer;
            nint size = rows.Size;
            Light += new RgbW(at.Sum(p, left, right), at.Sum(p + size, left, right), at.Sum(p + (2 * size), left, right));
            Length += at.Sum(p + (3 * size), left, right);
            Mean += at.Sum(p + (4 * size), left, right);
            Square += at.Sum(p + (5 * size), left, right);
        }

        public void Scale(in FloatW scale)
        {
            Light *= scale;
            (Length, Mean, Square) = (Length * scale, Mean * scale, Square * scale);
        }

        public readonly void Store(PinnedBuffer<float> planes, PaddedRows rows, int at)
        {
            float* p = planes.Pointer + at;
            nint size = rows.Size;
            Light.R.Store(p);
            Light.G.Store(p + size);
            Light.B.Store(p + (2 * size));
            Length.Store(p + (3 * size));
            Mean.Store(p + (4 * size));
            Square.Store(p + (5 * size));
        }
    }

    private ref struct Statistics
    {
        private FloatW _new, _square, _difference, _both, _count;

        public readonly float Variance
        {
            get
            {
                (float mean, float square) = (Sum(_new) / Sum(_count), Sum(_square) / Sum(_count));
                return Math.Max(0, square - (mean * mean));
            }
        }

        public void Add(in FloatW luminance, in Gathered old, in MaskW active)
        {
            MaskW both = active & (old.Length > 0f);
            (_new, _square) = (_new + active.Select(luminance, 0f), _square + active.Select(luminance * luminance, 0f));
            _difference += both.Select(luminance - old.Mean, 0f);
            (_count, _both) = (_count + active.Select(1f, 0f), _both + both.Select(1f, 0f));
        }

        // 1 where old and new light agree up to the noise, 0 where they certainly do not.
        public readonly float Trust(float limit)
        {
            float both = Sum(_both);
            if (both < 16)
            {
                return 1;
            }

            float error = MathF.Sqrt(Variance / both) + (0.02f * Sum(_new) / Sum(_count)) + 1e-5f;
            return Math.Clamp(1 - ((MathF.Abs(Sum(_difference) / both) / error) - limit) / limit, 0, 1);
        }

        private static float Sum(in FloatW lanes) => Vector.Sum(lanes.V);
    }
}
