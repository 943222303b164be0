using RayTracer.Description;
using RayTracer.Numerics;

namespace RayTracer.Sampling;

/// <summary>
/// Places samples around the middle of their pixel with a density in proportion to the magnitude of a filter's curve (Ernst, Stamminger &amp;
/// Greiner, Filter importance sampling, 2006). A pixel's colour is then the plain mean of its own samples, each times
/// its <see cref="Weight"/>: nothing is written into other pixels, and films stay sums. The curve is replaced by straight lines between
/// <see cref="Cells"/> + 1 places, and the weights are those of the straight lines: white stays white.
/// </summary>
internal sealed unsafe class PixelFilter
{
    private const uint Cells = 256;
    private const int CellsBeforeChange = 192;

    // In pixels: of what is narrower, all samples are taken in the middle.
    private const float LeastRadius = 1f / 64;
    private readonly PinnedBuffer<float> _memory = new(3 * (Cells + 1));
    private readonly float* _place;
    private readonly float* _density;
    private readonly float* _share;
    private readonly PinnedBuffer<uint> _guides = new(Cells + 1);
    private readonly float _signChange;
    private readonly float _norm;
    private readonly float _radius;
    private readonly float _cellsPerPixel;
    private readonly float _outerCellsPerPixel;
    private readonly float _cellsBefore;
    private readonly int _reached;

    private PixelFilter(FilterCurve curve)
    {
        _place = _memory.Pointer;
        _density = _place + Cells + 1;
        _share = _density + Cells + 1;
        HasWeights = curve.SignChange < curve.Radius;
        int before = HasWeights ? CellsBeforeChange : (int)Cells;
        double[] density = new double[Cells + 1];
        double[] share = new double[Cells + 1];
        double signedSum = 0;
        for (int i = 0; i <= Cells; i++)
        {
            double x = i <= before ? curve.SignChange * i / before : curve.SignChange + ((curve.Radius - curve.SignChange) * (i - before) / (Cells - before));
            density[i] = HasWeights && i == before ? 0 : double.Abs(curve.At(x));
            _place[i] = (float)x;
            if (i > 0)
            {
                double area = 0.5 * (_place[i] - _place[i - 1]) * (density[i] + density[i - 1]);
                share[i] = share[i - 1] + area;
                signedSum += i <= before ? area : -area;
            }
        }

        for (int i = 0; i <= Cells; i++)
        {
            _density[i] = (float)(density[i] / share[Cells]);
            _share[i] = (float)(share[i] / share[Cells]);
        }

        // A share of 1 is of the last cell, also where the cells before it hold nothing.
        GuideTable.Fill(_share, (int)Cells, _guides.Pointer);
        _guides.Pointer[Cells] = Cells - 1;
        _signChange = _place[before];
        _norm = (float)(share[Cells] / signedSum);
        _radius = _place[Cells];
        _cellsBefore = before;
        _cellsPerPixel = (float)(before / curve.SignChange);
        _outerCellsPerPixel = HasWeights ? (float)((Cells - before) / (curve.Radius - curve.SignChange)) : 0;
        _reached = (int)(2 * curve.Radius) + 1;
    }

    /// <summary>True where <see cref="Weight"/> may differ from 1: where the curve has negative lobes.</summary>
    public bool HasWeights { get; }

    /// <summary>Makes the filter that a description asks for; null for the mean over the pixel's own square, which needs none.</summary>
    public static PixelFilter? Create(FilterDescription filter) =>
        filter is { Shape: FilterShape.Box, Radius: 0 or 0.5f } ? null : new(new(filter));

    /// <summary>Places samples.</summary>
    /// <param name="x">In: a random number. Out: the distance from the pixel's left edge, in pixels.</param>
    /// <param name="y">In: another random number. Out: the distance from the pixel's top edge.</param>
    public void Place(ref FloatW x, ref FloatW y)
    {
        x = _radius < LeastRadius ? 0.5f : Offset(x) + 0.5f;
        y = _radius < LeastRadius ? 0.5f : Offset(y) + 0.5f;
    }

    /// <summary>The factor on the radiance of samples: 1 in the mean; negative where one of the offsets lies in a negative lobe.</summary>
    /// <param name="u">The first random number that placed them.</param>
    /// <param name="v">The second.</param>
    public FloatW Weight(in FloatW u, in FloatW v) => AxisWeight(u) * AxisWeight(v);

    /// <summary>How far beyond its own square a pixel reaches, in pixels.</summary>
    public static float Margin(FilterDescription filter) => float.Max(0, (float)new FilterCurve(filter).Radius - 0.5f);

    /// <summary>
    /// Chooses, along one axis, one of the pixels whose filter reaches a place, with probabilities in proportion to the magnitudes of
    /// their filters there. The factor makes the mean into each pixel its filter's value at the place, where the filter's integral is 1:
    /// for light that is not sampled for a pixel but comes to a place of the picture.
    /// </summary>
    /// <param name="filter">The filter; null for the mean over the pixel's own square.</param>
    /// <param name="place">The places, in pixels from the edge of the picture.</param>
    /// <param name="u">Random numbers.</param>
    /// <param name="pixel">Numbers of the pixels from that edge; also such as lie beyond the edges.</param>
    /// <param name="weight">The factors, below 0 in negative lobes; 0 where no filter reaches.</param>
    public static void Splat(PixelFilter? filter, in FloatW place, in FloatW u, out FloatW pixel, out FloatW weight)
    {
        pixel = FloatW.Floor(place);
        weight = 1f;
        filter?.Choose(place, u, ref pixel, out weight);
    }

    /// <summary>
    /// The number of samples per pixel's area at points of the picture, where <see cref="Place"/> places one for each pixel. It multiplies
    /// the density of the camera's rays where the ways to sample a path are weighed against each other.
    /// Pixels beyond the edges are counted as if they existed: within a radius of an edge the result is too large. The picture stays right:
    /// a pixel's value is the integral, over paths, of its filter times their light. Of that integral each way of sampling gives the part
    /// that its weight says, by <see cref="Place"/> and <see cref="Weight"/> as by <see cref="Splat"/>; and the parts make up the whole
    /// if the weights of each path sum to 1 (Veach 1997, section 9.2.1). They do whatever this function of the path is, if all ways
    /// use the same.
    /// </summary>
    /// <param name="x">Columns, in pixels from the left edge.</param>
    /// <param name="y">Rows, in pixels from the top edge.</param>
    public FloatW RayDensity(in FloatW x, in FloatW y) => AxisDensity(x) * AxisDensity(y);

    private void Choose(in FloatW place, in FloatW u, ref FloatW pixel, out FloatW weight)
    {
        FloatW density = AxisDensity(place);
        FloatW first = First(place);
        FloatW left = u * density;
        for (int i = 0; i < _reached; i++)
        {
            FloatW candidate = first + i;
            FloatW magnitude = Magnitude(place, candidate);

            // After the chosen one nothing is left; what rounding leaves falls to the last.
            pixel = ((magnitude > 0f) & (left >= 0f)).Select(candidate, pixel);
            left -= magnitude;
        }

        weight = density * WeightAt(Distance(place, pixel));
    }

    private FloatW AxisDensity(in FloatW place)
    {
        FloatW first = First(place);
        FloatW sum = 0f;
        for (int i = 0; i < _reached; i++)
        {
            sum += Magnitude(place, first + i);
        }

        return sum;
    }

    // The first pixel whose filter reaches a place.
    private FloatW First(in FloatW place) => -FloatW.Floor(_radius + 0.5f - place);

    private static FloatW Distance(in FloatW place, in FloatW pixel) => FloatW.Abs(place - pixel - 0.5f);

    // The density with which Place puts a pixel's samples there, along one axis.
    private FloatW Magnitude(in FloatW place, in FloatW pixel)
    {
        FloatW distance = Distance(place, pixel);
        FloatW outer = FloatW.MultiplyAdd(distance - _signChange, _outerCellsPerPixel, _cellsBefore);
        FloatW cells = (distance < _signChange).Select(distance * _cellsPerPixel, outer);
        UIntW cell = FloatW.Min(cells, Cells - 1).ToIntInRange();
        FloatW.Gather(_place, cell, out FloatW start, out FloatW end);
        FloatW.Gather(_density, cell, out FloatW near, out FloatW far);
        FloatW part = (distance - start) / (end - start);
        FloatW density = FloatW.MultiplyAdd(far - near, part, near);
        return (distance < _radius).Select(FloatW.Max(0.5f * density, 0f), 0f);
    }

    private FloatW AxisWeight(FloatW u) => WeightAt(FloatW.Abs(Offset(u)));

    private FloatW WeightAt(FloatW distance) => (distance > _signChange).Select(-_norm, _norm);

    // The inverse of the distribution function: outwards from the middle, on the side that u says.
    private FloatW Offset(FloatW u)
    {
        FloatW side = FloatW.MultiplyAdd(u, 2f, -1f);
        FloatW share = FloatW.Abs(side);
        UIntW cell = GuideTable.Find(_share, _guides.Pointer, 0u, (int)Cells, share);

        // Within a cell the density is a + slope·x, and its integral the rest.
        FloatW.Gather(_place, cell, out FloatW start, out FloatW end);
        FloatW.Gather(_density, cell, out FloatW a, out FloatW b);
        FloatW width = end - start;
        FloatW slope = (b - a) / width;
        FloatW rest = share - FloatW.Gather(_share, cell);
        FloatW root = FloatW.Sqrt(FloatW.Max(FloatW.MultiplyAdd(a, a, 2f * slope * rest), 0f));
        FloatW inside = 2f * rest / FloatW.Max(a + root, 1e-30f);
        return FloatW.CopySign(start + FloatW.Min(inside, width), side);
    }
}
