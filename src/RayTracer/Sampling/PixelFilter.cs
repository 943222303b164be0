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
    private readonly PinnedBuffer<float> _memory = new(3 * (Cells + 1));
    private readonly float* _place;
    private readonly float* _density;
    private readonly float* _share;
    private readonly float _signChange;
    private readonly float _norm;

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

        _signChange = _place[before];
        _norm = (float)(share[Cells] / signedSum);
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
        x = Offset(x) + 0.5f;
        y = Offset(y) + 0.5f;
    }

    /// <summary>The factor on the radiance of samples: 1 in the mean; negative where one of the offsets lies in a negative lobe.</summary>
    /// <param name="u">The first random number that placed them.</param>
    /// <param name="v">The second.</param>
    public FloatW Weight(in FloatW u, in FloatW v) => AxisWeight(u) * AxisWeight(v);

    private FloatW AxisWeight(FloatW u) => (FloatW.Abs(Offset(u)) > _signChange).Select(-_norm, _norm);

    // The inverse of the distribution function: outwards from the middle, on the side that u says.
    private FloatW Offset(FloatW u)
    {
        FloatW side = FloatW.MultiplyAdd(u, 2f, -1f);
        FloatW share = FloatW.Abs(side);
        UIntW cell = 0u;
        for (uint step = Cells / 2; step > 0; step /= 2)
        {
            UIntW next = cell + step;
            cell = (FloatW.Gather(_share, next) <= share).Select(next, cell);
        }

        // Within a cell the density is a + slope·x, and its integral the rest.
        FloatW start = FloatW.Gather(_place, cell);
        FloatW width = FloatW.Gather(_place + 1, cell) - start;
        FloatW a = FloatW.Gather(_density, cell);
        FloatW slope = (FloatW.Gather(_density + 1, cell) - a) / width;
        FloatW rest = share - FloatW.Gather(_share, cell);
        FloatW root = FloatW.Sqrt(FloatW.Max(FloatW.MultiplyAdd(a, a, 2f * slope * rest), 0f));
        FloatW inside = 2f * rest / FloatW.Max(a + root, 1e-30f);
        return FloatW.CopySign(start + FloatW.Min(inside, width), side);
    }
}
